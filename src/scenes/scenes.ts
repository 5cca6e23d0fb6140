import { ParameterError } from '../preset/errors.ts';
import { lamp } from './lamp.ts';
import type { Scene } from './scene.ts';

const scenes: ReadonlyMap<string, () => Scene> = new Map([['lamp', lamp]]);

/** @throws ParameterError when there is no scene of that name */
export function sceneNamed(name: string): Scene {
  const build = scenes.get(name);
  if (!build) throw new ParameterError('scene', name, [...scenes.keys()].join(', '));
  return build();
}
