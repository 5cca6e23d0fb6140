import { LoadError } from '../preset/errors.ts';
import type { Scene } from '../scenes/scene.ts';
import { sceneNamed } from '../scenes/scenes.ts';
import { loadSimulators, type LoadOptions, type SimulatorFactory } from '../sim/load.ts';

/** A scene and the simulators that it needs. */
export interface OpenedScene {
  readonly scene: Scene;
  readonly factory: SimulatorFactory;
}

/**
 * Fetches both at once.
 * @throws ParameterError when there is no scene of that name, LoadError when something cannot be fetched
 */
export async function openScene(name: string, onProgress?: LoadOptions['onProgress']): Promise<OpenedScene> {
  const { hasRigids, load } = sceneNamed(name);
  const [scene, factory] = await Promise.all([fetched(name, load), loadSimulators({ physics: hasRigids, onProgress })]);
  return { scene, factory };
}

async function fetched(name: string, load: () => Promise<Scene>): Promise<Scene> {
  try {
    return await load();
  } catch (error) {
    throw new LoadError(`The scene ${name} could not be loaded: ${(error as Error).message}`, { cause: error });
  }
}
