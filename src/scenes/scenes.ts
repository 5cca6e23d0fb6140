import { ParameterError } from '../base/errors.ts';
import type { Scene } from './scene.ts';

/** A scene whose code is loaded on demand: each is a separate chunk. */
export interface SceneEntry {
  /** Whether the scene needs the simulator with physics, so that both can load in parallel. */
  readonly hasRigids: boolean;
  readonly load: () => Promise<Scene>;
}

/** All scenes by name, in display order. */
export const sceneEntries: Readonly<Record<string, SceneEntry>> = {
  lamp: { hasRigids: true, load: async () => (await import('./lamp.ts')).lamp() },
  airplane: { hasRigids: true, load: async () => (await import('./airplane.ts')).airplane() },
  train: { hasRigids: true, load: async () => (await import('./train.ts')).train() },
  campfire: { hasRigids: false, load: async () => (await import('./campfire.ts')).campfire() },
  rocket: { hasRigids: true, load: async () => (await import('./rocket.ts')).rocket() },
  genie: { hasRigids: true, load: async () => (await import('./genie.ts')).genie() },
  dust: { hasRigids: true, load: async () => (await import('./dust.ts')).dust() },
  cloudscape: { hasRigids: false, load: async () => (await import('./cloudscape.ts')).buildCloudscape() },
  wisp: { hasRigids: false, load: async () => (await import('./wisp.ts')).wisp() },
  firework: { hasRigids: false, load: async () => (await import('./firework.ts')).firework() },
  title: { hasRigids: false, load: async () => (await import('./title.ts')).title() },
  dragon: { hasRigids: false, load: async () => (await import('./dragon.ts')).dragon() },
  teapot: { hasRigids: false, load: async () => (await import('./teapot.ts')).teapot() },
  air: { hasRigids: false, load: async () => (await import('./air.ts')).air() },
};

/** @throws ParameterError for an unknown scene */
export function sceneNamed(name: string): SceneEntry {
  if (!Object.hasOwn(sceneEntries, name)) {
    throw new ParameterError('scene', name, Object.keys(sceneEntries).join(', '));
  }
  return sceneEntries[name];
}
