/**
 * Models of GLB files. The stage loads this module on demand. In the package it is a file of its own, which imports nothing.
 */
import { inPieces, type Work } from '../../base/work.ts';
import type { Scene } from '../../scenes/scene.ts';
import type { ModelOptions } from '../contract.ts';
import type { AddModel, Kit } from './kit.ts';
import { colorsOf, decodeByBrowser, type Decode } from './colors.ts';
import { readModel } from './modelFile.ts';
import { withModel, type SceneWithModel } from './modelScene.ts';

/**
 * Reads a GLB file.
 * @returns a function that adds its model to a scene in pieces of work
 * @throws FileError for a file that cannot be used
 */
export async function openModel(
  bytes: Uint8Array,
  options: ModelOptions,
  decode: Decode = decodeByBrowser,
): Promise<(scene: Scene) => Work<SceneWithModel>> {
  const file = readModel(bytes);
  const notices = new Set(file.notices);
  const colors = await colorsOf(file, decode, notices);
  return (scene) => withModel(scene, file, colors, options, [...notices]);
}

type Check = readonly [accepted: string, passes: (value: unknown) => boolean];

const within = (low: number, high: number): Check => [
  `a number from ${low} to ${high}`,
  (value) => typeof value === 'number' && value >= low && value <= high,
];
const FLAG: Check = ['true or false', (value) => typeof value === 'boolean'];
const FARTHEST = 1_000;
const CHECKS: { readonly [Name in keyof Required<ModelOptions>]: Check } = {
  position: [
    `x, y and z from -${FARTHEST} to ${FARTHEST}`,
    (value) =>
      ['x', 'y', 'z'].every((axis) =>
        within(-FARTHEST, FARTHEST)[1]((value as Record<string, unknown> | null)?.[axis]),
      ),
  ],
  size: within(0.01, 100),
  turn: within(-100, 100),
  animation: ['the name of an animation', (value) => typeof value === 'string'],
  speed: within(0, 10),
  collides: FLAG,
  casts: FLAG,
  inked: FLAG,
};

/**
 * See `loadModel` in modelLoading.ts.
 * @param kit what it uses of the library
 */
export async function prepareModel(bytes: Uint8Array, options: ModelOptions, kit: Kit): Promise<AddModel> {
  const fault = faultOf(options);
  if (fault) throw new kit.ParameterError(`setModel.${fault[0]}`, fault[1], fault[2]);
  const own = ownErrors(kit);
  const add = await own(() => openModel(bytes, options));
  return async (opened) => {
    const { hasRigids, ...added } = await own(() => inPieces(add(opened.scene)));
    const isEnough = !hasRigids || opened.factory.module.bindings.rigidArguments;
    const factory = isEnough ? opened.factory : await kit.fetchMeshes();
    await kit.prepareSurfaces(added.scene.surfaces, 0);
    return { ...added, factory };
  };
}

/** Throws errors as those of the library, whose classes are others if this module is a file of its own. */
function ownErrors({ FileError }: Kit) {
  return async <Result>(act: () => Result): Promise<Awaited<Result>> => {
    try {
      return await act();
    } catch (error) {
      throw new FileError((error as Error).message, { cause: error });
    }
  };
}

/** @returns name, value and accepted values of the first invalid option */
export function faultOf(options: object): [name: string, value: unknown, accepted: string] | undefined {
  for (const [name, value] of Object.entries(options)) {
    const known = Object.hasOwn(CHECKS, name) && CHECKS[name as keyof ModelOptions];
    const [accepted, passes] = known || [`no value: its options are ${Object.keys(CHECKS).join(', ')}`, () => false];
    if (value !== undefined && !passes(value)) return [name, value, accepted];
  }
  return undefined;
}
