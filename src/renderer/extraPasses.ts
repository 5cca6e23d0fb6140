/** Code that few smokes need. It is loaded on first use and shared by all smokes of the thread. */
import type { PassSources } from './frameInput.ts';
import type { PuffForm } from './gpu/puffTextures.ts';
import type { Factors } from './gpu/ramps.ts';
import type { Shaders } from './gpu/programsAhead.ts';
import type { DebugView } from '../parameters/quality.ts';
import type { Values } from '../parameters/parameter.ts';
import type { GivenValues } from '../parameters/timeline.ts';
import { LoadError } from '../base/errors.ts';
import { LazyModules } from '../base/timeout.ts';
import type { LoadOptions, SimulatorFactory } from '../simulator/load.ts';
import type { FrameExtras } from './smokePasses.ts';
import type { Renderer, Style, Volumes } from './style.ts';

const modules = new LazyModules({
  caps: () => import('./puffs/bake/lobeCaps.ts'),
  billboards: () => import('./billboards.ts'),
  selle: () => import('./passes/selle.ts'),
  debugViews: () => import('./debugViews.ts'),
  countedVolumes: () => import('./passes/countedVolumes.ts'),
  tiledVolumes: () => import('./passes/tiledVolumes/tiledVolumes.ts'),
  simplify: () => import('./passes/simplify/simplify.ts'),
  patterns: () => import('./patterns.ts'),
  strokes: () => import('./passes/strokes/strokes.ts'),
  bites: () => import('./bites.ts'),
  falloff: () => import('./falloff.ts'),
  additionalLights: () => import('./additionalLights.ts'),
  looks: () => import('./looks.ts'),
  animation: () => import('../simulator/animation.ts'),
  meshes: () => import('../simulator/meshes.ts'),
});
const TIMELINE = 'The timeline';
const MESHES = 'The simulator with flows and meshes';
/** The modules that are loaded, and the simulator with rare forces. */
export const loaded: typeof modules.loaded & { rareForces?: SimulatorFactory } = modules.loaded;

type Name = keyof typeof loaded;

/** The settings of a picture that decide which modules it needs. */
export interface PictureKind {
  readonly renderer: Renderer;
  readonly form: PuffForm;
  /** Whether puffs turn or stretch with the air, or unfold. */
  readonly isDeformed: boolean;
  readonly volumes: Volumes;
  /** Distance over which light is smoothed, CSS pixels. */
  readonly simplify: number;
  /** How far light follows the form of the whole smoke, 0..1. */
  readonly plumeForm: number;
  readonly outlines: boolean;
  /** Marks of a print. */
  readonly pattern?: Style['pattern'];
  /** Number of strokes inside the silhouette, 0..1. */
  readonly strokes: number;
  /** Whether puffs have bites. */
  readonly isEroded: boolean;
  /** The light of a lamp that weakens with distance. */
  readonly lampLight?: Factors;
  /** Whether there are lights besides the key light. */
  readonly hasAdditionalLights?: boolean;
  /** Whether emitters may have looks of their own. */
  readonly hasLooks?: boolean;
  readonly view?: DebugView;
  /** Whether values change over time by a timeline or by a take. */
  readonly isAnimated?: boolean;
  /** Whether the simulator lacks forces. */
  readonly lacksForces?: boolean;
  /** Whether volumes are drawn in tiles, which gives the same picture. */
  readonly isTiled?: boolean;
}

/**
 * Whether tones are chosen after all puffs are drawn, because light is smoothed, follows the whole form or comes from several
 * lights, or has a pattern. Other renderers than nailboards do not.
 */
export function isSimplified(
  kind: Pick<PictureKind, 'renderer' | 'simplify' | 'plumeForm' | 'hasAdditionalLights' | 'pattern'>,
): boolean {
  const { renderer, simplify, plumeForm, hasAdditionalLights = false } = kind;
  return renderer === 'nailboards' && (simplify + plumeForm > 0 || hasAdditionalLights || hasPattern(kind));
}

/** Whether a style has the marks of a print. */
export function hasPattern({ renderer, pattern = 'none' }: Pick<PictureKind, 'renderer' | 'pattern'>): boolean {
  return renderer === 'nailboards' && pattern !== 'none';
}

/** Whether a style has strokes. They are lines, on lobes only. */
export function hasStrokes({
  renderer,
  form,
  outlines,
  strokes,
}: Pick<PictureKind, 'renderer' | 'form' | 'outlines' | 'strokes'>): boolean {
  return renderer === 'nailboards' && form === 'lobes' && outlines && strokes > 0;
}

/** The modules that a picture needs, with their names in error messages. */
function needsOf(kind: PictureKind): Partial<Record<Name, string>> {
  const { renderer, form, isDeformed, volumes, isEroded, lampLight, hasAdditionalLights, hasLooks, view } = kind;
  const { isAnimated, lacksForces, isTiled } = kind;
  return {
    ...(form === 'lobes' && !isDeformed && { caps: 'Puffs that keep their shape' }),
    ...(form === 'billboards' && { billboards: 'Billboards' }),
    ...(renderer === 'selle' && { billboards: 'The renderer selle', selle: 'The renderer selle' }),
    ...(view && { debugViews: `The view ${view}` }),
    ...(volumes === 'counted' && { countedVolumes: 'Counted volumes' }),
    ...(isSimplified(kind) && { simplify: 'Simplified light' }),
    ...(hasPattern(kind) && { patterns: 'Patterns' }),
    ...(hasStrokes(kind) && { strokes: 'Strokes' }),
    ...(isEroded && { bites: 'Bites' }),
    ...(lampLight && { falloff: 'The decay of light' }),
    ...(hasAdditionalLights && { additionalLights: 'More lights' }),
    ...(hasLooks && { looks: 'Looks of emitters' }),
    ...(isAnimated && { animation: TIMELINE }),
    ...(lacksForces && { rareForces: MESHES }),
    ...(isTiled && { tiledVolumes: 'Volumes in tiles' }),
  };
}

/** Names of the modules that a picture needs and that are not loaded. */
export function missingExtras(kind: PictureKind): string {
  return missing(kind)
    .map(([name]) => name)
    .join();
}

/** Whether all modules that a picture needs are loaded. */
export function hasExtras(kind: PictureKind): boolean {
  return missing(kind).length === 0;
}

/**
 * Loads the modules that a picture needs. A failed load is retried on the next call.
 * @throws LoadError if a module cannot be loaded
 */
export async function fetchExtras(kind: PictureKind): Promise<void> {
  const load = ([name, what]: [Name, string]) => (name === 'rareForces' ? fetchRareForces() : modules.load(name, what));
  await Promise.all(missing(kind).map(load));
}

/**
 * Returns a loaded module.
 * @throws LoadError if it is not loaded
 */
export function codeOf<Each extends Name>(name: Each): NonNullable<(typeof loaded)[Each]> {
  const code = loaded[name];
  if (!code) throw new LoadError(`The code of ${name} is not loaded.`);
  return code;
}

/**
 * The values with the timeline as text. While its code is not loaded, a text is not checked.
 * @throws ParameterError for an invalid timeline
 */
export function timelineText(given: GivenValues): Values {
  const code = loaded.animation;
  // What is no object of values is rejected later.
  const timeline = (given as GivenValues | undefined)?.timeline;
  if (!code || !timeline) return given as Values;
  return { ...given, timeline: code.writeTimeline(code.requireTimeline(timeline)) };
}

/**
 * Like {@link timelineText}, but loads the code first.
 * @throws also LoadError if it cannot be loaded
 */
export async function fetchTimelineText(given: GivenValues): Promise<Values> {
  if ((given as GivenValues | undefined)?.timeline) await modules.load('animation', TIMELINE);
  return timelineText(given);
}

/**
 * Loads the simulator with rare forces and meshes. A failed load is retried on the next call.
 * @param onProgress called for each received chunk, also when another call started the download
 * @throws LoadError if it cannot be loaded
 */
export async function fetchRareForces(onProgress?: LoadOptions['onProgress']): Promise<SimulatorFactory> {
  const { loadMeshes } = await modules.load('meshes', MESHES);
  return (loaded.rareForces ??= await loadMeshes(onProgress));
}

function missing(kind: PictureKind): [Name, string][] {
  return (Object.entries(needsOf(kind)) as [Name, string][]).filter(([name]) => !loaded[name]);
}

type PassName = Exclude<keyof FrameExtras, 'billboardsOf' | 'releaseTargets' | 'dispose'>;

/** The optional passes of one smoke. Each is created on first use and is undefined while its module is not loaded. */
export class ExtraPasses implements FrameExtras {
  private readonly sources: PassSources;
  private readonly made: { -readonly [Each in PassName]?: FrameExtras[Each] } = {};
  private requested: Promise<unknown> | undefined;

  constructor(sources: PassSources) {
    this.sources = sources;
  }

  get selle(): FrameExtras['selle'] {
    return this.pass('selle', ({ SellePass }, { eye, puffs, ramps }) => new SellePass(eye, puffs, ramps));
  }

  get countedVolumes(): FrameExtras['countedVolumes'] {
    return this.pass('countedVolumes', ({ CountedVolumesPass }, { eye, puffs }) => new CountedVolumesPass(eye, puffs));
  }

  /** Undefined until its module is loaded, which starts on first access. Without it, pictures only take longer. */
  get tiledVolumes(): FrameExtras['tiledVolumes'] {
    this.requested ??= modules.load('tiledVolumes', 'Volumes in tiles').catch(() => {});
    return this.pass('tiledVolumes', ({ TiledVolumesPass }, { eye, puffs }) => new TiledVolumesPass(eye, puffs));
  }

  get simplify(): FrameExtras['simplify'] {
    return this.pass('simplify', ({ SimplifyPass }, { eye, ramps }) => new SimplifyPass(eye, ramps));
  }

  get strokes(): FrameExtras['strokes'] {
    return this.pass('strokes', ({ StrokesPass }, { eye, puffs }) => new StrokesPass(eye, puffs));
  }

  get patterns(): FrameExtras['patterns'] {
    return this.pass('patterns', ({ PatternPass }, { eye }) => new PatternPass(eye));
  }

  get debugViews(): FrameExtras['debugViews'] {
    return this.pass('debugViews', ({ DebugViews }, { eye }) => new DebugViews(eye));
  }

  /** The shaders of a puff form; undefined for lobes. */
  billboardsOf(form: PuffForm): Shaders | undefined {
    return form === 'billboards' ? codeOf('billboards').billboardShaders : undefined;
  }

  /** Releases render targets until the next frame. */
  releaseTargets(): void {
    this.made.simplify?.releaseTargets();
    this.made.strokes?.releaseTargets();
    this.made.patterns?.releaseTargets();
  }

  /** Disposes of all passes. They allocate their resources again when they next draw. */
  dispose(): void {
    for (const pass of Object.values(this.made)) pass.dispose();
  }

  private pass<Each extends PassName>(
    name: Each,
    make: (code: NonNullable<(typeof loaded)[Each]>, sources: PassSources) => FrameExtras[Each],
  ): FrameExtras[Each] | undefined {
    const code = loaded[name];
    if (code) this.made[name] ??= make(code, this.sources);
    return this.made[name];
  }
}
