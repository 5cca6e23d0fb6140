import type { FrameView } from '../device/frameView.ts';
import { DebugViewsPass } from '../passes/debugViews.ts';
import type { DebugView } from '../preset/quality.ts';
import type { CoverageGrid } from '../sim/view.ts';
import type { FrameInput } from './frameInput.ts';
import type { SmokePasses } from './smokePasses.ts';

/** Shows what the passes work with instead of the picture. */
export class DebugViews {
  private readonly pass: DebugViewsPass;

  constructor(eye: FrameView) {
    this.pass = new DebugViewsPass(eye);
  }

  /** Takes up the grid by which hidden bodies were found, for the view of it. */
  setGrid(grid: CoverageGrid | undefined): void {
    this.pass.setGrid(grid);
  }

  /** Goes on from where the surfaces stand in the targets: as a frame does as far as the view goes, and then the view. */
  draw(view: DebugView, passes: SmokePasses, { style, output }: FrameInput): void {
    const { renderer, targets, body } = passes;
    const volumes = passes.prismVolumes ?? passes.volumes;
    if (view === 'normals') this.pass.drawNormals(renderer, body);
    else body.draw(renderer);
    if (view === 'counts') {
      if (style.shadows) {
        passes.meshVolumes.draw(renderer);
        passes.mask.countOnce(renderer);
        volumes.draw(renderer);
      }
      this.pass.copyCounts(renderer);
    }
    if (view === 'overdraw') this.pass.countOverdraw(renderer, style.shadows ? [body, volumes] : [body]);
    this.pass.draw(renderer, targets, view, output);
  }

  dispose(): void {
    this.pass.dispose();
  }
}
