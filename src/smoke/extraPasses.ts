/** Code that few smokes need: it is fetched when one first does, and is there for the whole thread from then on. */
import type { PuffForm } from '../device/puffTextures.ts';
import type { Shaders } from '../device/programsAhead.ts';
import type { DebugView } from '../preset/quality.ts';
import { LoadError } from '../preset/errors.ts';
import { inTime } from '../preset/timeout.ts';
import type { DebugViews } from './debugViews.ts';
import type { ComparisonRenderers, ComparisonSources } from './comparisonRenderers.ts';
import type { FrameExtras } from './smokePasses.ts';
import type { Renderer } from './style.ts';

const imports = {
  billboards: () => import('./billboards.ts'),
  comparisons: () => import('./comparisonRenderers.ts'),
  debugViews: () => import('./debugViews.ts'),
  prismVolumes: () => import('../passes/prismVolumes.ts'),
};

type Name = keyof typeof imports;
type Codes = { [Each in Name]: Awaited<ReturnType<(typeof imports)[Each]>> };

/** What has been fetched. */
export const here: Readonly<Partial<Codes>> = {};

/** What decides which of them a picture needs. */
export interface PictureKind {
  readonly renderer: Renderer;
  readonly form: PuffForm;
  readonly view?: DebugView;
  /** Whether the device does not keep a depth that fragments write. */
  readonly isFlat?: boolean;
}

/** What is fetched for such pictures, and what people call it. */
function needsOf({ renderer, form, view, isFlat }: PictureKind): Partial<Record<Name, string>> {
  return {
    ...(form === 'billboards' && { billboards: 'Billboards' }),
    ...(renderer !== 'nailboards' && {
      billboards: `The renderer ${renderer}`,
      comparisons: `The renderer ${renderer}`,
    }),
    ...(view && { debugViews: `The view ${view}` }),
    ...(isFlat && { prismVolumes: 'Shadows' }),
  };
}

/** Whether all is here that such pictures need. */
export function hasExtras(kind: PictureKind): boolean {
  return missing(kind).length === 0;
}

/**
 * Fetches what such pictures need and is not here; after a failure the next call tries anew.
 * @throws LoadError when it cannot be fetched
 */
export async function fetchExtras(kind: PictureKind): Promise<void> {
  await Promise.all(missing(kind).map(([name, called]) => bring(name, called)));
}

/** Code that must have come. */
export function codeOf<Each extends Name>(name: Each): Codes[Each] {
  const code = here[name];
  if (!code) throw new LoadError(`The code of ${name} was not fetched.`);
  return code;
}

function missing(kind: PictureKind): [Name, string][] {
  return (Object.entries(needsOf(kind)) as [Name, string][]).filter(([name]) => !here[name]);
}

async function bring(name: Name, called: string): Promise<void> {
  try {
    Object.assign(here, { [name]: await inTime<object>(imports[name]()) });
  } catch (error) {
    const reason = (error as Error).message;
    throw new LoadError(`${called} could not be loaded, nailboards are drawn instead: ${reason}`, { cause: error });
  }
}

/** What few smokes draw with, for one of them: each is made when it is first asked for; undefined while its code is not here. */
export class ExtraPasses implements FrameExtras {
  private readonly sources: ComparisonSources;
  private madeComparisons: ComparisonRenderers | undefined;
  private madeViews: DebugViews | undefined;

  constructor(sources: ComparisonSources) {
    this.sources = sources;
  }

  get comparisons(): ComparisonRenderers | undefined {
    if (here.comparisons) this.madeComparisons ??= new here.comparisons.ComparisonRenderers(this.sources);
    return this.madeComparisons;
  }

  get debugViews(): DebugViews | undefined {
    if (here.debugViews) this.madeViews ??= new here.debugViews.DebugViews(this.sources.eye);
    return this.madeViews;
  }

  /** By what puffs of a form are drawn, unless they are lobes. */
  billboardsOf(form: PuffForm): Shaders | undefined {
    return form === 'billboards' ? codeOf('billboards').billboardShaders : undefined;
  }

  /** Lets go of everything; a pass that is drawn again makes its own anew. */
  dispose(): void {
    this.madeComparisons?.dispose();
    this.madeViews?.dispose();
  }
}
