import type { Stage } from '../stage/stage.ts';
import { strings } from './strings.ts';

/** Keeps the canvas's label, for who cannot see it, with the scene that is shown. */
export function describeScene(stage: Stage, canvas: HTMLCanvasElement): void {
  const show = () => {
    const { picture, hand } = strings.scenes[String(stage.get().scene)];
    const label = strings.picture(picture, hand?.thing);
    if (canvas.ariaLabel !== label) canvas.ariaLabel = label;
  };
  stage.on('statechange', show);
  show();
}
