/** Loads the code of models, which few stages need. */
import { FileError, ParameterError } from '../base/errors.ts';
import { fetched } from '../base/timeout.ts';
import { prepareSurfaces } from '../renderer/prepare.ts';
import { fetchRareForces as fetchMeshes } from '../renderer/extraPasses.ts';
import type { ModelOptions } from './contract.ts';
import type { AddModel } from './model/kit.ts';

/**
 * Reads a model.
 * @throws ParameterError for an invalid option, FileError for a file that cannot be used, LoadError
 */
export async function loadModel(bytes: Uint8Array, options: ModelOptions): Promise<AddModel> {
  const { prepareModel } = await fetched('Models', import('./model/stageModel.ts'));
  return prepareModel(bytes, options, { FileError, ParameterError, fetchMeshes, prepareSurfaces });
}
