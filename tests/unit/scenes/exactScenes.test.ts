/**
 * No value that reaches the simulator depends on a function whose last bits are implementation-defined: the same scenes
 * run with the engine's functions and with perturbed ones, which differ far more than any two engines.
 */
import { expect, test, vi } from 'vitest';
import type { MovingSceneState, Placement, Scene } from '../../../src/scenes/scene.ts';
import { motionOf, variantOf } from '../../support/sim/presetHashes.ts';
import { random } from '../../visual/random.ts';

const STEPS = 120;
/** Relative. Poses are float32 in the simulator: a perturbation of the last bit only would rarely be visible. */
const BENT = 1 + 2 ** -16;
const NAMES = [
  ...(['sin', 'cos', 'tan', 'asin', 'acos', 'atan', 'atan2', 'sinh', 'cosh', 'tanh', 'asinh', 'acosh'] as const),
  ...(['atanh', 'exp', 'expm1', 'log', 'log2', 'log10', 'log1p', 'pow', 'cbrt', 'hypot'] as const),
];
const engine = Object.fromEntries(NAMES.map((name) => [name, Math[name]]));

function bend(): void {
  for (const name of NAMES) {
    const exact: (...given: number[]) => number = engine[name];
    Object.assign(Math, { [name]: (...given: number[]) => BENT * exact(...given) });
  }
}

/** The result of `make` with freshly loaded modules, with the original or the perturbed functions. */
async function made<T>(isBent: boolean, make: () => Promise<T>): Promise<T> {
  vi.resetModules();
  if (isBent) bend();
  try {
    return await make();
  } finally {
    Object.assign(Math, engine);
  }
}

/** Every scene as in production, with its drops. */
async function scenes(): Promise<[string, Scene][]> {
  const { sceneEntries } = await import('../../../src/scenes/scenes.ts');
  const { withDrops } = await import('../../../src/scenes/drops.ts');
  const entries = Object.entries(sceneEntries);
  return Promise.all(
    entries.map(async ([name, { hasRigids, load }]) => [name, hasRigids ? withDrops(await load()) : await load()]),
  );
}

/** The hash of each preset after two seconds with steering, once for those that move alike. */
async function hashes(): Promise<Record<string, string>> {
  const { presets, presetValues } = await import('../../../src/parameters/presets.ts');
  const { Simulation } = await import('../../../src/stage/simulation.ts');
  const { loadVariant } = await import('../../support/sim/simWasm.ts');
  const byName = new Map(await scenes());
  const found: Record<string, string> = {};
  const seen = new Set<string>();
  for (const preset of presets) {
    const motion = motionOf(preset.name);
    if (seen.has(motion)) continue;
    seen.add(motion);
    const values = presetValues(preset);
    const scene = byName.get(values.scene as string)!;
    const factory = await loadVariant(variantOf(scene.rigids.length > 0, values));
    const simulation = new Simulation(factory, scene, values, 0);
    simulation.advance(STEPS / 4);
    for (const channel of [0, 1, 2]) simulation.input((simulator) => simulator.inputSteer(channel, 0.3 - channel / 2));
    simulation.advance((3 * STEPS) / 4);
    found[preset.name] = simulation.simulator.hash();
    simulation.dispose();
  }
  return found;
}

/** Seeded poses for guides and rules: resting, flying and fallen. */
function moments(): MovingSceneState[] {
  const next = random(3);
  const somewhere = (): Placement => {
    const quaternion = [next() - 0.5, next() - 0.5, next() - 0.5, next() + 0.1] as const;
    const length = Math.sqrt(quaternion.reduce((sum, part) => sum + part * part, 0));
    const [x, y, z, w] = quaternion.map((part) => part / length);
    return { position: [4 * next() - 2, 9 * next() - 7, 4 * next() - 2], rotation: [x, y, z, w] };
  };
  return Array.from({ length: 300 }, (_, index) => {
    const [now, then] = [0, 1].map(() => Array.from({ length: 20 }, somewhere));
    const controls = [0, 1, 2].map(() => 2 * next() - 1);
    return {
      seconds: index / 3.1,
      dt: 1 / 60,
      control: (channel) => controls[channel] ?? 0,
      pose: (rigid) => now[rigid],
      before: (rigid) => then[rigid],
    };
  });
}

/** All numbers that a scene passes to the simulator, in double precision. */
async function numbers(): Promise<Record<string, unknown>> {
  const all = (await scenes()).map(([name, { rig, rigids, emissionSurfaces, guide, rule, parts, ground, handle }]) => [
    name,
    {
      set: { rig, rigids, emissionSurfaces, ground, handle },
      guided: moments().map((moment) => [guide?.(moment), rule?.values(moment)]),
      parts: moments().map(({ seconds }) => parts?.map(({ pose }) => pose(seconds))),
    },
  ]);
  return Object.fromEntries(all) as Record<string, unknown>;
}

test('the numbers of a scene do not depend on the engine', async () => {
  const [straight, bent] = [await made(false, numbers), await made(true, numbers)];
  for (const [name, expected] of Object.entries(straight)) expect(bent[name], name).toStrictEqual(expected);
});

test('the hashes of presets do not depend on the engine', async () => {
  const straight = await made(false, hashes);
  expect(Object.keys(straight).length).toBeGreaterThan(10);
  expect(await made(true, hashes)).toEqual(straight);
});
