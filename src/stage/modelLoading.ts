/** Loads the code of models, which few stages need, and adds models to scenes. */
import { FileError, ParameterError, requireOptions } from '../base/errors.ts';
import { LazyModules } from '../base/timeout.ts';
import { prepareSurfaces } from '../renderer/prepare.ts';
import { loadSimulators, type Variant } from '../simulator/load.ts';
import { meshesWith } from '../simulator/meshes.ts';
import type { ModelOptions } from './contract.ts';
import type { OpenedScene } from './openScene.ts';

const modules = new LazyModules({ stageModel: () => import('./model/stageModel.ts') });
/** One object, by which its loading is known. */
let meshes: Variant | undefined;

/** Adds a model to a scene. */
export type Dress = (opened: OpenedScene) => Promise<OpenedScene>;

/**
 * Reads a model.
 * @throws ParameterError for an invalid option, FileError for a file that cannot be used, LoadError
 */
export async function readModel(bytes: Uint8Array, options: ModelOptions): Promise<Dress> {
  const { bindings, faultOf, OPTIONS, openModel } = await modules.load('stageModel', 'The code of models');
  requireOptions('setModel', options, OPTIONS);
  const fault = faultOf(options);
  if (fault) throw new ParameterError(`setModel.${fault[0]}`, fault[1], fault[2]);
  const dress = await ownError(() => openModel(bytes, options));
  return async (opened) => {
    const { hasRigids, ...dressed } = await ownError(() => dress(opened.scene));
    let { factory } = opened;
    if (hasRigids && !factory.module.bindings.rigidArguments)
      factory = await loadSimulators({ physics: (meshes ??= meshesWith(bindings)) });
    await prepareSurfaces(dressed.scene.surfaces, 0);
    return { ...dressed, factory };
  };
}

/** The module can be a file of its own, with error classes of its own. */
async function ownError<Result>(act: () => Result): Promise<Awaited<Result>> {
  try {
    return await act();
  } catch (error) {
    throw new FileError((error as Error).message, { cause: error });
  }
}
