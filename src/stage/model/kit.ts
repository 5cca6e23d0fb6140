/** What the stage and the code of models know of each other. */
import type { FileError, ParameterError } from '../../base/errors.ts';
import type { prepareSurfaces } from '../../renderer/prepare.ts';
import type { SimulatorFactory } from '../../simulator/load.ts';
import type { OpenedScene } from '../openScene.ts';

/** What the code of models uses of the library: in the package it is a file of its own, which imports nothing. */
export interface Kit {
  readonly FileError: typeof FileError;
  readonly ParameterError: typeof ParameterError;
  /** Loads the simulator with meshes. */
  readonly fetchMeshes: () => Promise<SimulatorFactory>;
  readonly prepareSurfaces: typeof prepareSurfaces;
}

/** Adds a model to a scene. @throws FileError for a model that the scene cannot have, LoadError */
export type AddModel = (opened: OpenedScene) => Promise<OpenedScene>;
