/** Code that few smokes need. It is loaded on first use and shared by all smokes of the thread. */
import type { FrameView } from '../device/frameView.ts';
import type { PuffForm, PuffTextures } from '../device/puffTextures.ts';
import type { Shaders } from '../device/programsAhead.ts';
import type { RampTexture } from '../device/ramps.ts';
import type { DebugView } from '../preset/quality.ts';
import type { CountedVolumesPass } from '../passes/countedVolumes.ts';
import type { SellePass } from '../passes/selle.ts';
import type { SimplifyPass } from '../passes/simplify/simplify.ts';
import type { StrokesPass } from '../passes/strokes/strokes.ts';
import type { TiledVolumesPass } from '../passes/tiledVolumes/tiledVolumes.ts';
import { LoadError } from '../preset/errors.ts';
import { LazyModules } from '../preset/timeout.ts';
import type { DebugViews } from './debugViews.ts';
import type { FrameExtras } from './smokePasses.ts';
import type { Renderer, Volumes } from './style.ts';

const modules = new LazyModules({
  caps: () => import('../puffs/bake/lobeCaps.ts'),
  billboards: () => import('./billboards.ts'),
  selle: () => import('../passes/selle.ts'),
  debugViews: () => import('./debugViews.ts'),
  countedVolumes: () => import('../passes/countedVolumes.ts'),
  tiledVolumes: () => import('../passes/tiledVolumes/tiledVolumes.ts'),
  simplify: () => import('../passes/simplify/simplify.ts'),
  strokes: () => import('../passes/strokes/strokes.ts'),
  bites: () => import('./bites.ts'),
});
/** The modules that are loaded. */
export const { loaded } = modules;

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
  /** Number of strokes inside the silhouette, 0..1. */
  readonly strokes: number;
  /** Whether puffs have bites. */
  readonly isEroded: boolean;
  readonly view?: DebugView;
  /** Whether volumes are drawn in tiles, which gives the same picture. */
  readonly isTiled?: boolean;
}

/** Whether a style's light is smoothed or follows the whole form. Other renderers than nailboards do not. */
export function isSimplified({
  renderer,
  simplify,
  plumeForm,
}: Pick<PictureKind, 'renderer' | 'simplify' | 'plumeForm'>): boolean {
  return renderer === 'nailboards' && simplify + plumeForm > 0;
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
  const { renderer, form, isDeformed, volumes, isEroded, view, isTiled } = kind;
  return {
    ...(form === 'lobes' && !isDeformed && { caps: 'Puffs that keep their shape' }),
    ...(form === 'billboards' && { billboards: 'Billboards' }),
    ...(renderer === 'selle' && { billboards: 'The renderer selle', selle: 'The renderer selle' }),
    ...(view && { debugViews: `The view ${view}` }),
    ...(volumes === 'counted' && { countedVolumes: 'Counted volumes' }),
    ...(isSimplified(kind) && { simplify: 'Simplified light' }),
    ...(hasStrokes(kind) && { strokes: 'Strokes' }),
    ...(isEroded && { bites: 'Bites' }),
    ...(isTiled && { tiledVolumes: 'Volumes in tiles' }),
  };
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
  await Promise.all(missing(kind).map(([name, what]) => modules.load(name, what)));
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

function missing(kind: PictureKind): [Name, string][] {
  return (Object.entries(needsOf(kind)) as [Name, string][]).filter(([name]) => !loaded[name]);
}

/** What the optional passes of one smoke share with its other passes. */
interface Sources {
  readonly eye: FrameView;
  readonly puffs: PuffTextures;
  readonly ramps: RampTexture;
}

/** The optional passes of one smoke. Each is created on first use and is undefined while its module is not loaded. */
export class ExtraPasses implements FrameExtras {
  private readonly sources: Sources;
  private madeSelle: SellePass | undefined;
  private madeVolumes: CountedVolumesPass | undefined;
  private madeTiles: TiledVolumesPass | undefined;
  private madeSimplify: SimplifyPass | undefined;
  private madeStrokes: StrokesPass | undefined;
  private requested: Promise<unknown> | undefined;
  private madeViews: DebugViews | undefined;

  constructor(sources: Sources) {
    this.sources = sources;
  }

  get selle(): SellePass | undefined {
    const { eye, puffs, ramps } = this.sources;
    if (loaded.selle) this.madeSelle ??= new loaded.selle.SellePass(eye, puffs, ramps);
    return this.madeSelle;
  }

  get countedVolumes(): CountedVolumesPass | undefined {
    const { eye, puffs } = this.sources;
    if (loaded.countedVolumes) this.madeVolumes ??= new loaded.countedVolumes.CountedVolumesPass(eye, puffs);
    return this.madeVolumes;
  }

  /** Undefined until its module is loaded, which starts on first access. Without it, pictures only take longer. */
  get tiledVolumes(): TiledVolumesPass | undefined {
    const { eye, puffs } = this.sources;
    if (loaded.tiledVolumes) this.madeTiles ??= new loaded.tiledVolumes.TiledVolumesPass(eye, puffs);
    else this.requested ??= modules.load('tiledVolumes', 'Volumes in tiles').catch(() => {});
    return this.madeTiles;
  }

  get simplify(): SimplifyPass | undefined {
    const { eye, ramps } = this.sources;
    if (loaded.simplify) this.madeSimplify ??= new loaded.simplify.SimplifyPass(eye, ramps);
    return this.madeSimplify;
  }

  get strokes(): StrokesPass | undefined {
    const { eye, puffs } = this.sources;
    if (loaded.strokes) this.madeStrokes ??= new loaded.strokes.StrokesPass(eye, puffs);
    return this.madeStrokes;
  }

  get debugViews(): DebugViews | undefined {
    if (loaded.debugViews) this.madeViews ??= new loaded.debugViews.DebugViews(this.sources.eye);
    return this.madeViews;
  }

  /** The shaders of a puff form; undefined for lobes. */
  billboardsOf(form: PuffForm): Shaders | undefined {
    return form === 'billboards' ? codeOf('billboards').billboardShaders : undefined;
  }

  /** Releases render targets until the next frame. */
  rest(): void {
    this.madeSimplify?.rest();
    this.madeStrokes?.rest();
  }

  /** Disposes of all passes. They allocate their resources again when they next draw. */
  dispose(): void {
    this.madeSelle?.dispose();
    this.madeVolumes?.dispose();
    this.madeTiles?.dispose();
    this.madeSimplify?.dispose();
    this.madeStrokes?.dispose();
    this.madeViews?.dispose();
  }
}
