import type { Object3DEventMap, WebGLRenderer } from 'three';
import { ParameterError, type SmokeError } from '../preset/errors.ts';
import { fetched } from '../preset/timeout.ts';
import type { Values } from '../preset/parameter.ts';
import { defaults, validate } from '../preset/values.ts';
import { styleOf, type Style } from '../smoke/style.ts';
import type { SmokeSpace } from './frame.ts';
import type { KeyLight } from './keyLight.ts';
import type { ProxyBall } from './proxies.ts';

/** Options of `CartoonSmoke.create`. */
export interface CartoonSmokeOptions {
  /** The host's renderer. It must have a stencil buffer: `new WebGLRenderer({ stencil: true })`. */
  renderer: WebGLRenderer;
  /** The light that shades smoke and that smoke blocks. The host keeps ownership and may move it. */
  keyLight: KeyLight;
  /** Name of a preset, the base for `values`. The preset's light and scene are ignored. */
  preset?: string;
  /** Flat values of the parameter table, such as `{ 'emission.rate': 60, 'emitters.0.position.y': 1 }`. */
  values?: Values;
  /** Whether objects can collide with smoke, which loads the larger simulator. Default true. */
  physics?: boolean;
  /**
   * What the transform of the smoke object does to puffs that exist: in `world` (default) they stay where they are, in
   * `local` they travel with it.
   */
  space?: SmokeSpace;
  /** Called before and after the opaque objects are drawn again in shadow, for shaders with custom lighting. */
  onRelight?: (isInShadow: boolean) => void;
}

/** Events besides those of Object3D: `smoke.addEventListener('error', ({ error }) => {})`. */
export interface CartoonSmokeEvents extends Object3DEventMap {
  /**
   * Something failed that no caller can catch, and smoke continues without it. LoadError: a resource could not be
   * fetched; emitted once each time that values start to require it. UnsupportedError: smoke cannot be drawn into a view;
   * once for each reason. ParameterError: the transform of the smoke is invalid, which keeps the last valid one, or a handle
   * pauses, because its object has a transform that is not finite; once until the object is sound again. SimulatorError: the simulator has stopped.
   */
  error: { readonly error: SmokeError };
}

/** Options for casting shadows. */
export interface CastOptions {
  /** Balls that replace the object's meshes. */
  proxies?: readonly ProxyBall[];
}

/** Counters of a smoke object. */
export interface CartoonSmokeStats {
  /** Steps of 1/60 s since creation. */
  steps: number;
  alive: number;
  /** Particles that wait for free capacity before they spawn. */
  waiting: number;
  /** In the view that was drawn last. */
  bodiesDrawn: number;
  castersDrawn: number;
}

/** Without other values the first emitter is a small disc at the origin that emits upwards. */
const EMITTER: Values = { 'emitters.0.shape': 'disc', 'emitters.0.share': 1 };
const SPACES = ['world', 'local'];

/** @throws ParameterError for an unknown space */
export function requireSpace(space: SmokeSpace): void {
  if (!SPACES.includes(space)) throw new ParameterError('space', space, SPACES.join(' or '));
}

/** Keys that only `create` takes. */
export const AT_CREATION = ['seed', 'simulation.maxParticles'];

/** Values of the presets that {@link loadPreset} has loaded. */
const loaded = new Map<string, Values>();

/**
 * Loads a preset for {@link startValues}.
 * @throws ParameterError for an unknown name, LoadError if the presets cannot be loaded
 */
export async function loadPreset(name: string | undefined): Promise<void> {
  if (name === undefined || loaded.has(name)) return;
  const { findPreset, presets } = await fetched('The presets', import('../preset/presets.ts'));
  const preset = findPreset(name);
  if (!preset) throw new ParameterError('preset', name, presets.map((each) => each.name).join(', '));
  loaded.set(name, preset.values);
}

/** @throws ParameterError for a value out of range, or one that the host's scene determines */
export function requireValues(values: Values): void {
  validate(values);
  requireOpen(values);
}

/** The initial values: the defaults, then the small emitter, the loaded preset and the caller's values. */
export function startValues({ preset = '', values }: Pick<CartoonSmokeOptions, 'preset' | 'values'>): Values {
  return { ...defaults(), ...EMITTER, ...loaded.get(preset), ...values };
}

/**
 * Validates values that are set after creation.
 * @throws ParameterError for the first value that is out of range or fixed at creation
 */
export function requireChangeable(values: Values): void {
  requireValues(values);
  for (const key of AT_CREATION) {
    if (key in values) throw new ParameterError(key, values[key], 'a value at creation only');
  }
}

/** @throws ParameterError for a value that the host's scene determines */
function requireOpen(values: Values): void {
  for (const [key, value] of Object.entries(values)) {
    if (key === 'scene' || key.startsWith('light.'))
      throw new ParameterError(key, value, 'no value (your scene sets it)');
    if (key === 'style.renderer' && value !== 'nailboards') throw new ParameterError(key, value, 'nailboards only');
  }
}

/** A preset may select another renderer; in a host scene only nailboards are supported. */
export function hostStyle(values: Values): Style {
  return { ...styleOf(values), renderer: 'nailboards' };
}
