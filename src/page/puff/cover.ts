import type { Box } from '../plane.ts';
import { styled } from './overlay.ts';
import type { Source } from './target.ts';

const FRAME_STYLE = {
  all: 'initial',
  display: 'block',
  position: 'fixed',
  overflow: 'hidden',
  'pointer-events': 'none',
  contain: 'strict',
};
const CANVAS_STYLE = { all: 'initial', display: 'block', width: '100%', height: '100%', 'pointer-events': 'none' };

/** The canvas of a wipe over the window or over an element, in front of everything, also of dialogs. */
export class Cover {
  canvas: HTMLCanvasElement;
  private readonly source: Source | undefined;
  private readonly frame = styled(document.createElement('div'), FRAME_STYLE);
  private readonly leave = new AbortController();

  /** @param source the window if absent */
  constructor(source: Source | undefined, zIndex = 9999) {
    this.source = source;
    this.frame.setAttribute('aria-hidden', 'true');
    styled(this.frame, { 'z-index': String(zIndex) });
    document.documentElement.append(this.frame);
    if ('popover' in this.frame) {
      this.frame.popover = 'manual';
      this.frame.showPopover();
    }
    this.place();
    this.canvas = this.makeCanvas();
    const follow = { signal: this.leave.signal, capture: true, passive: true };
    for (const type of ['scroll', 'resize']) addEventListener(type, () => this.place(), follow);
  }

  /** Creates the canvas, or another one in its place. */
  makeCanvas(): HTMLCanvasElement {
    this.canvas = styled(document.createElement('canvas'), CANVAS_STYLE);
    this.frame.replaceChildren(this.canvas);
    return this.canvas;
  }

  /** Moves the canvas to where the target is now. */
  place(): void {
    const { left, top, width, height } = this.source?.box() ?? windowBox();
    const size = { left: `${left}px`, top: `${top}px`, width: `${width}px`, height: `${height}px` };
    styled(this.frame, size);
  }

  remove(): void {
    this.leave.abort();
    this.frame.remove();
  }
}

/** The window with its scroll bars, which dialogs and fixed elements cover, too. */
function windowBox(): Box {
  return { left: 0, top: 0, width: innerWidth, height: innerHeight };
}
