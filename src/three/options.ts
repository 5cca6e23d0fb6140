import type { Object3DEventMap, WebGLRenderer } from 'three';
import { fetchValues } from '../parameters/byScene/fetchValues.ts';
import { ParameterError, requireOptions, type SmokeError } from '../base/errors.ts';
import type { ShareLink, Values } from '../parameters/parameter.ts';
import type { GivenValues } from '../parameters/timeline.ts';
import { defaults, validate } from '../parameters/values.ts';
import type { PresetName } from '../parameters/valueTypes.ts';
import { styleOf, type Style } from '../renderer/style.ts';
import type { LoadProgress } from '../simulator/load.ts';
import type { SmokeSpace } from './smokeSpace.ts';
import type { KeyLight } from './keyLight.ts';
import { requireLightReference, type LightReference } from './sceneLight.ts';
import type { ProxyBall } from './proxies.ts';

/** Options of `CartoonSmoke.create`. */
export interface CartoonSmokeOptions {
  /** The host's renderer. It must have a stencil buffer: `new WebGLRenderer({ stencil: true })`. */
  renderer: WebGLRenderer;
  /** The light that shades smoke and that smoke blocks. The host keeps ownership and may move it. */
  keyLight: KeyLight;
  /**
   * What gives the light its colours and its strength: the `style` (default), or the key light and the ambient and
   * hemisphere lights of the `scene`.
   */
  light?: LightSource;
  /** The lights under which smoke has the colours of its style, with `light: 'scene'`. */
  lightReference?: Partial<LightReference>;
  /** Name of a preset, or a share link or its hash: the base for `values`. */
  preset?: PresetName | ShareLink;
  /**
   * Flat values of the parameter table, such as `{ 'emission.rate': 60, 'emitters.0.position.y': 1 }`. What the host's
   * scene determines is ignored here and in `preset`: `scene`, kind, direction, distance and decay of the light, `camera.*`,
   * `style.renderer`, `style.backdrop`.
   */
  values?: GivenValues;
  /**
   * Whether larger simulators are loaded: with true that for objects that smoke pushes, before the promise resolves; with
   * false none. By default `collide` loads one for meshes, or that for objects that smoke pushes, when an object first needs it.
   */
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
  /** A larger simulator is loading, since an object of `collide` needs it. Smoke does not collide with that object before. */
  progress: LoadProgress;
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

/** What gives the light of smoke its colours and its strength. */
export type LightSource = 'style' | 'scene';
const LIGHT_SOURCES = ['style', 'scene'];

/** @throws ParameterError for an unknown space */
export function requireSpace(space: SmokeSpace): void {
  if (!SPACES.includes(space)) throw new ParameterError('space', space, SPACES.join(' or '));
}

/** Keys that only `create` takes. */
const AT_CREATION = ['seed', 'simulation.maxParticles'];

const OPTIONS = [
  'renderer',
  'keyLight',
  'light',
  'lightReference',
  'preset',
  'values',
  'physics',
  'space',
  'onRelight',
];
/** What the host's scene determines. */
const OF_HOST = /^(scene$|light\.(kind|azimuth|elevation|distance|decay)$|camera\.|style\.(renderer|backdrop)$)/;

/** @throws ParameterError for an unknown option or a value out of range */
export function requireCreation(options: CartoonSmokeOptions): void {
  requireOptions('create', options, OPTIONS);
  requireSpace(options.space ?? 'world');
  const { light = 'style', lightReference = {} } = options;
  if (!LIGHT_SOURCES.includes(light)) throw new ParameterError('light', light, LIGHT_SOURCES.join(' or '));
  requireLightReference(lightReference);
  const { timeline, ...values } = options.values ?? {};
  // An object is read, and checked, when its code is loaded.
  validate(timeline && typeof timeline === 'object' ? values : ((options.values as Values | undefined) ?? {}));
}

/** Values of the presets and links that {@link loadPreset} has loaded. */
const loaded = new Map<string, Values>();

/**
 * Loads a preset or a share link for {@link startValues}.
 * @throws ParameterError for an unknown name or a damaged link, LoadError if it cannot be loaded
 */
export async function loadPreset(preset: CartoonSmokeOptions['preset']): Promise<void> {
  if (preset !== undefined && !loaded.has(preset)) loaded.set(preset, await fetchValues(preset));
}

/** The initial values: the defaults, then the small emitter, the loaded preset and the caller's values. */
export function startValues({ preset, values }: Pick<CartoonSmokeOptions, 'preset' | 'values'>): GivenValues {
  const given = ofSmoke({ ...(preset && loaded.get(preset)), ...values });
  return { ...defaults(), ...EMITTER, ...given };
}

/** The values without those that the host's scene determines. */
export function ofSmoke<Given extends GivenValues>(values: Given): Given {
  return Object.fromEntries(Object.entries(values).filter(([key]) => !OF_HOST.test(key))) as Given;
}

/** The values that can change after creation. */
export function changeable<Given extends GivenValues>(values: Given): Given {
  return Object.fromEntries(Object.entries(ofSmoke(values)).filter(([key]) => !AT_CREATION.includes(key))) as Given;
}

/**
 * Validates values that are set after creation.
 * @throws ParameterError for the first value that is out of range, fixed at creation or determined by the host's scene
 */
export function requireChangeable(values: Values): void {
  validate(values);
  for (const [key, value] of Object.entries(values)) {
    if (OF_HOST.test(key)) throw new ParameterError(key, value, 'no value (your scene sets it)');
    if (AT_CREATION.includes(key)) throw new ParameterError(key, value, 'a value at creation only');
  }
}

/** A preset may select another renderer; in a host scene only nailboards are supported. */
export function hostStyle(values: Values): Style {
  return { ...styleOf(values), renderer: 'nailboards' };
}
