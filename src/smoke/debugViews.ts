import type { FrameView } from '../device/frameView.ts';
import { DebugViewsPass } from '../passes/debugViews.ts';
import type { DebugView } from '../preset/quality.ts';
import type { CoverageGrid } from '../sim/view.ts';
import type { FrameInput } from './frameInput.ts';
import { countVolumes, MAX_COUNT } from './frame.ts';
import type { SmokePasses } from './smokePasses.ts';

/** Shows intermediate results of the passes instead of the picture. */
export class DebugViews {
  private readonly pass: DebugViewsPass;

  constructor(eye: FrameView) {
    this.pass = new DebugViewsPass(eye);
  }

  /** Uploads the grid of the occlusion culling for the coverage view. */
  setGrid(grid: CoverageGrid | undefined): void {
    this.pass.setGrid(grid);
  }

  /** Draws a view after the surfaces: the passes of the frame up to the viewed result, and then the view. */
  draw(view: DebugView, passes: SmokePasses, { style, output }: FrameInput): void {
    const { renderer, targets, body, volumes } = passes;
    if (view === 'normals') this.pass.drawNormals(renderer, body);
    else body.draw(renderer);
    if (view === 'counts') {
      if (style.shadows) countVolumes(passes, style, MAX_COUNT);
      this.pass.copyCounts(renderer);
    }
    if (view === 'overdraw') this.pass.countOverdraw(renderer, style.shadows ? [body, volumes] : [body]);
    this.pass.draw(renderer, targets, view, output);
  }

  dispose(): void {
    this.pass.dispose();
  }
}
