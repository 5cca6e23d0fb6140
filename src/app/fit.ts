import type { Stage } from '../stage/stage.ts';

// Ink is drawn at the resolution of the screen; beyond two pixels a CSS pixel nobody sees more, but every pixel costs.
const LARGEST_PIXEL_RATIO = 2;

export function pixelRatio(): number {
  return Math.min(devicePixelRatio, LARGEST_PIXEL_RATIO);
}

/** Keeps the stage as large as its canvas on the page, at the pixel ratio of the screen it is on. */
export function fitStage(stage: Stage, canvas: HTMLCanvasElement): void {
  const observer = new ResizeObserver(() => stage.resize(canvas.clientWidth, canvas.clientHeight, pixelRatio()));
  observer.observe(canvas);
}

/** Rests while nobody can see the page, and goes on only if it was playing. */
export function restWhileHidden(stage: Stage): void {
  let goesOn = false;
  document.addEventListener('visibilitychange', () => {
    if (document.hidden) {
      goesOn = stage.playing;
      stage.pause();
    } else if (goesOn) {
      stage.play();
    }
  });
}
