import type { RemoteStage } from '../remote/contract.ts';
import { ignoreRejection } from './ignoreRejection.ts';

/** Whether the user's system requests reduced motion. */
export const calm = (): MediaQueryList => matchMedia('(prefers-reduced-motion: reduce)');

/**
 * Decides whether the smoke of an element plays. The page or the user decides, unless the system requests reduced
 * motion and the user has not started playback on this element. The stage itself pauses out of view.
 */
export class Playback {
  private readonly stage: RemoteStage;
  private readonly notify: (state: { isPlaying: boolean; isStill: boolean }) => void;
  private readonly calm = calm();
  private isPaused: boolean;
  private isConsented = false;

  /** @param notify called at the start and whenever playback starts or stops; pausing out of view does not count */
  constructor(stage: RemoteStage, isPaused: boolean, notify: Playback['notify']) {
    this.stage = stage;
    this.notify = notify;
    this.isPaused = isPaused;
  }

  begin(): void {
    this.calm.addEventListener('change', this.update);
    this.update();
  }

  /** Whether the smoke plays, in view or not. */
  get isPlaying(): boolean {
    return !this.isPaused && !this.isStill;
  }

  set(isPaused: boolean): void {
    this.isPaused = isPaused;
    this.update();
  }

  /** Starts playback by a user action, which overrides reduced motion. */
  consent(): void {
    const wasStill = this.isStill;
    this.isConsented = true;
    if (wasStill) this.update();
  }

  dispose(): void {
    this.calm.removeEventListener('change', this.update);
  }

  /** Whether reduced motion alone keeps the smoke still. */
  private get isStill(): boolean {
    return this.calm.matches && !this.isConsented;
  }

  private readonly update = (): void => {
    const { isPlaying, isStill } = this;
    ignoreRejection(isPlaying ? this.stage.play() : this.stage.pause());
    this.notify({ isPlaying, isStill });
  };
}
