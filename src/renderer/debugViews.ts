import type { FrameView } from './gpu/frameView.ts';
import { DebugViewsPass } from './passes/debugViews.ts';
import type { SurfaceDepth } from './passes/surfaceDepth.ts';
import { countVolumes, MAX_COUNT, type ArrangedFrame, type SmokePasses } from './smokePasses.ts';
import type { FrameInput } from './frameInput.ts';

/** Shows intermediate results of the passes instead of the picture. */
export class DebugViews {
  private readonly pass: DebugViewsPass;

  constructor(eye: FrameView) {
    this.pass = new DebugViewsPass(eye);
  }

  /** Draws a view after the surfaces: the passes of the frame up to the viewed result, and then the view. */
  draw(
    passes: SmokePasses,
    { style, view, output }: FrameInput,
    { bodies, casters, grid }: ArrangedFrame,
    surfaceDepth: SurfaceDepth | undefined,
  ): void {
    const { renderer, targets, body, volumes } = passes;
    const rows = bodies.geometry;
    if (view === 'normals') this.pass.drawNormals(renderer, body, rows, surfaceDepth);
    else body.draw(renderer, rows, surfaceDepth);
    if (view === 'counts') {
      if (casters) countVolumes(passes, style, casters.geometry, MAX_COUNT);
      this.pass.copyCounts(renderer);
    }
    if (view === 'overdraw') {
      const shadows = casters ? [{ pass: volumes, rows: casters.geometry }] : [];
      this.pass.countOverdraw(renderer, [{ pass: body, rows }, ...shadows]);
    }
    if (view === 'coverage') this.pass.setGrid(grid);
    this.pass.draw(renderer, targets, view!, output);
  }

  dispose(): void {
    this.pass.dispose();
  }
}
