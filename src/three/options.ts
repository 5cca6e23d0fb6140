import type { Object3DEventMap, WebGLRenderer } from 'three';
import { ParameterError, type LoadError } from '../preset/errors.ts';
import { LIST_LIMIT } from '../preset/lists.ts';
import type { Values } from '../preset/parameter.ts';
import { findPreset, presets } from '../preset/presets.ts';
import { defaults, validate } from '../preset/values.ts';
import { styleOf, type Style } from '../smoke/style.ts';
import type { KeyLight } from './keyLight.ts';
import type { ProxyBall } from './proxies.ts';

/** What smoke in a scene of yours is made of. */
export interface CartoonSmokeOptions {
  /** Yours; it must have a stencil buffer: `new WebGLRenderer({ stencil: true })`. */
  renderer: WebGLRenderer;
  /** The light that smoke is shaded by and keeps from what it shadows. It stays yours and may move. */
  keyLight: KeyLight;
  /** The name of a preset, from which `values` differ. Its light and its scene are left to yours. */
  preset?: string;
  /** Flat values of the parameter table, such as `{ 'emission.rate': 60, 'emitters.0.position.y': 1 }`. */
  values?: Values;
  /** Whether objects can collide, which loads the larger simulator. Default true. */
  physics?: boolean;
  /** Called before and after your opaque objects are drawn once more in shadow, for shaders that light themselves. */
  onRelight?: (isInShadow: boolean) => void;
}

/** What smoke tells, beside what three.js tells of every object: `smoke.addEventListener('error', ({ error }) => {})`. */
export interface CartoonSmokeEvents extends Object3DEventMap {
  /** Something could not be fetched, and smoke goes on without it; once each time that values begin to ask for it. */
  error: { readonly error: LoadError };
}

/** How an object throws its shadow. */
export interface CastOptions {
  /** What stands in for the object, instead of its own meshes. */
  proxies?: readonly ProxyBall[];
}

/** What smoke counts. */
export interface CartoonSmokeStats {
  /** Steps of 1/60 s since creation. */
  steps: number;
  alive: number;
  /** Particles that wait to be born until there is room. */
  waiting: number;
  /** Of the latest view that was drawn. */
  bodiesDrawn: number;
  castersDrawn: number;
}

/** Without a value of its own the first emitter is a small disc that blows upwards from the origin. */
const EMITTER: Values = { 'emitters.0.shape': 'disc', 'emitters.0.share': 1 };
const AT_CREATION = ['seed', 'simulation.maxParticles'];

/** Every value that smoke begins with: defaults, a small emitter, the preset, what the caller gave. */
export function startValues({ preset: name, values = {} }: CartoonSmokeOptions): Values {
  const preset = name === undefined ? undefined : findPreset(name);
  if (name !== undefined && !preset)
    throw new ParameterError('preset', name, presets.map((each) => each.name).join(', '));
  validate(values);
  requireOpen(values);
  return { ...defaults(), ...EMITTER, ...preset?.values, ...values };
}

/**
 * Checks values that are to change while smoke lives.
 * @throws ParameterError for the first that is out of range or cannot change
 */
export function requireChangeable(values: Values): void {
  validate(values);
  for (const key of AT_CREATION) {
    if (key in values) throw new ParameterError(key, values[key], 'a value at creation only');
  }
  requireOpen(values);
}

/** @throws ParameterError for the number of an emitter that there is not */
export function requireEmitter(emitter: number): void {
  if (Number.isInteger(emitter) && emitter >= 0 && emitter < LIST_LIMIT) return;
  throw new ParameterError('emitter', emitter, `a whole number from 0 to ${LIST_LIMIT - 1}`);
}

/** @throws ParameterError for what the scene around the smoke decides */
function requireOpen(values: Values): void {
  for (const [key, value] of Object.entries(values)) {
    if (key === 'scene' || key.startsWith('light.'))
      throw new ParameterError(key, value, 'no value (your scene sets it)');
    if (key === 'style.renderer' && value !== 'nailboards') throw new ParameterError(key, value, 'nailboards only');
  }
}

/** A preset may compare renderers; among other things there is only this one. */
export function hostStyle(values: Values): Style {
  return { ...styleOf(values), renderer: 'nailboards' };
}
