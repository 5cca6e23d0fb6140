import type { FrameView } from '../../renderer/gpu/frameView.ts';
import type { LoadError } from '../../base/errors.ts';
import { LazyModules } from '../../base/timeout.ts';
import type { OwnStencil } from './ownStencil.ts';

const modules = new LazyModules({ ownStencil: () => import('./ownStencil.ts') });
const load = () => modules.load('ownStencil', 'The code for shadow in targets without stencil');

/** The {@link OwnStencil} of one smoke. Its code is loaded when smoke is first drawn into a target without stencil. */
export class LateStencil {
  private readonly eye: FrameView;
  private readonly miss: (error: LoadError) => void;
  private made: OwnStencil | undefined;
  private isNeeded = false;

  /** @param miss called once with the error, if the code cannot be loaded */
  constructor(eye: FrameView, miss: (error: LoadError) => void) {
    this.eye = eye;
    this.miss = miss;
  }

  /** Undefined until the code is loaded, which starts on the first call. */
  loaded(): OwnStencil | undefined {
    const { ownStencil } = modules.loaded;
    if (ownStencil) return (this.made ??= new ownStencil.OwnStencil(this.eye));
    if (!this.isNeeded) load().catch(this.miss);
    this.isNeeded = true;
    return undefined;
  }

  /**
   * Resolves when the code is loaded, if a target needed it. A failed load is retried.
   * @throws LoadError if the code cannot be loaded
   */
  async wait(): Promise<void> {
    if (this.isNeeded) await load();
  }

  /** Frees the GPU resources. The next draw recreates them. */
  dispose(): void {
    this.made?.dispose();
  }
}
