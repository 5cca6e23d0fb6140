/** Passes that few smokes need: their code is fetched when one first does, and is there for the whole thread from then on. */
import type { DebugViewsPass } from '../passes/debugViews.ts';
import type { DebugView } from '../preset/environment.ts';
import { LoadError } from '../preset/errors.ts';
import { inTime } from '../preset/patience.ts';
import type { Rivals, RivalSources } from './rivals.ts';
import type { Renderer } from './style.ts';

const imports = {
  rivals: () => import('./rivals.ts'),
  debugViews: () => import('../passes/debugViews.ts'),
};

type Codes = { [Name in keyof typeof imports]: Awaited<ReturnType<(typeof imports)[Name]>> };

const here: Partial<Codes> = {};

/** What decides which of them a picture needs. */
export interface PictureKind {
  readonly renderer: Renderer;
  readonly view?: DebugView;
}

/** Whether all is here that such pictures need. */
export function hasExtras({ renderer, view }: PictureKind): boolean {
  return (renderer === 'nailboards' || here.rivals !== undefined) && (!view || here.debugViews !== undefined);
}

/**
 * Fetches what such pictures need and is not here; after a failure the next call tries anew.
 * @throws LoadError when it cannot be fetched
 */
export async function fetchExtras({ renderer, view }: PictureKind): Promise<void> {
  try {
    if (renderer !== 'nailboards') here.rivals ??= await inTime(imports.rivals());
    if (view) here.debugViews ??= await inTime(imports.debugViews());
  } catch (error) {
    const what = view && !here.debugViews ? `The view ${view}` : `The renderer ${renderer}`;
    const reason = (error as Error).message;
    throw new LoadError(`${what} could not be loaded, nailboards are drawn instead: ${reason}`, { cause: error });
  }
}

/** Those of one smoke, each made when it is first asked for; undefined while its code is not here. */
export class ExtraPasses {
  private readonly sources: RivalSources;
  private madeRivals: Rivals | undefined;
  private madeViews: DebugViewsPass | undefined;

  constructor(sources: RivalSources) {
    this.sources = sources;
  }

  get rivals(): Rivals | undefined {
    if (here.rivals) this.madeRivals ??= new here.rivals.Rivals(this.sources);
    return this.madeRivals;
  }

  get debugViews(): DebugViewsPass | undefined {
    if (here.debugViews) this.madeViews ??= new here.debugViews.DebugViewsPass(this.sources.eye);
    return this.madeViews;
  }

  /** Lets go of everything; a pass that is drawn again makes its own anew. */
  dispose(): void {
    this.madeRivals?.dispose();
    this.madeViews?.dispose();
  }
}
