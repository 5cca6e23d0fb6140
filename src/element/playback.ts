import type { RemoteStage } from '../remote/contract.ts';
import { ignoreRejection } from './ignoreRejection.ts';

/** Whether this visitor's system asks for less motion. */
export const calm = (): MediaQueryList => matchMedia('(prefers-reduced-motion: reduce)');

/**
 * Decides whether the smoke of an element plays: as the page or a person wants it, unless the system asks for stillness
 * and nobody has asked for motion here. That it rests out of sight is the stage's own affair.
 */
export class Playback {
  private readonly stage: RemoteStage;
  private readonly notify: (state: { isPlaying: boolean; isStill: boolean }) => void;
  private readonly calm = calm();
  private isPaused: boolean;
  private isConsented = false;

  /** @param notify called when it begins, and whenever playing begins or ends as people understand it: out of sight it goes on */
  constructor(stage: RemoteStage, isPaused: boolean, notify: Playback['notify']) {
    this.stage = stage;
    this.notify = notify;
    this.isPaused = isPaused;
  }

  begin(): void {
    this.calm.addEventListener('change', this.update);
    this.update();
  }

  /** Whether smoke moves, in sight or out of it. */
  get isPlaying(): boolean {
    return !this.isPaused && !this.isStill;
  }

  set(isPaused: boolean): void {
    this.isPaused = isPaused;
    this.update();
  }

  /** A person asked for motion here and now, which outweighs what the system asks for. */
  consent(): void {
    const wasStill = this.isStill;
    this.isConsented = true;
    if (wasStill) this.update();
  }

  dispose(): void {
    this.calm.removeEventListener('change', this.update);
  }

  /** Whether the system alone keeps it still. */
  private get isStill(): boolean {
    return this.calm.matches && !this.isConsented;
  }

  private readonly update = (): void => {
    const { isPlaying, isStill } = this;
    ignoreRejection(isPlaying ? this.stage.play() : this.stage.pause());
    this.notify({ isPlaying, isStill });
  };
}
