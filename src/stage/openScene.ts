import { LoadError } from '../base/errors.ts';
import { inTime } from '../base/timeout.ts';
import type { Scene } from '../scenes/scene.ts';
import { sceneNamed } from '../scenes/scenes.ts';
import { fetchRareForces } from '../renderer/extraPasses.ts';
import { prepareSurfaces } from '../renderer/prepare.ts';
import type { SceneModel } from './model/modelScene.ts';
import { loadSimulators, type LoadOptions, type SimulatorFactory } from '../simulator/load.ts';

/** Scenes in use: stages of the same scene share its models and everything derived from them. */
const shown = new Map<string, WeakRef<Scene>>();
const coming = new Map<string, Promise<Scene>>();

/** A scene and the simulator factory that it needs. */
export interface OpenedScene {
  readonly scene: Scene;
  readonly factory: SimulatorFactory;
  readonly model?: SceneModel;
}

interface OpenOptions extends Pick<LoadOptions, 'onProgress'> {
  /** Whether the smoke has rare forces from the start. */
  hasRareForces?: boolean;
  /** How far the triangles of models will deviate from the finest ones, metres; see `deviationFor`. Default: 0. */
  deviationIn?: (scene: Scene) => number;
}

/**
 * Fetches the scene and the simulator in parallel.
 * @throws ParameterError when the scene does not exist, LoadError when something cannot be fetched
 */
export async function openScene(
  name: string,
  { onProgress, hasRareForces, deviationIn = () => 0 }: OpenOptions = {},
): Promise<OpenedScene> {
  const { hasRigids, load } = sceneNamed(name);
  const whole = hasRigids ? () => withThings(load) : load;
  const [scene, factory] = await Promise.all([
    prepared(fetched(name, whole), deviationIn),
    hasRareForces && !hasRigids ? fetchRareForces(onProgress) : loadSimulators({ physics: hasRigids, onProgress }),
  ]);
  return { scene, factory };
}

async function prepared(fetching: Promise<Scene>, deviationIn: (scene: Scene) => number): Promise<Scene> {
  const scene = await fetching;
  await prepareSurfaces(scene.surfaces, deviationIn(scene));
  return scene;
}

/** Adds droppable objects to scenes with physics. */
async function withThings(load: () => Promise<Scene>): Promise<Scene> {
  const [scene, { withDrops }] = await Promise.all([load(), import('../scenes/drops.ts')]);
  return withDrops(scene);
}

function fetched(name: string, load: () => Promise<Scene>): Promise<Scene> {
  const known = shown.get(name)?.deref();
  if (known) return Promise.resolve(known);
  const scene = coming.get(name) ?? fetchNew(name, load).finally(() => coming.delete(name));
  coming.set(name, scene);
  return scene;
}

async function fetchNew(name: string, load: () => Promise<Scene>): Promise<Scene> {
  try {
    const scene = await inTime(load());
    shown.set(name, new WeakRef(scene));
    return scene;
  } catch (error) {
    throw new LoadError(`The scene ${name} could not be loaded: ${(error as Error).message}`, { cause: error });
  }
}
