import type { RemoteStage } from '../../stage/remote/contract.ts';
import { ignoreRejection } from './deferred.ts';

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
  private isHeld: boolean;
  private isLinkPaused: boolean;
  private isConsented = false;
  private notified = '';

  /**
   * @param isPaused by the page
   * @param isHeld by the user
   * @param isLinkPaused by the share link, apart from the attribute, which a morph of the page would remove
   * @param notify called at the start and whenever playback starts or stops; pausing out of view does not count
   */
  constructor(
    stage: RemoteStage,
    isPaused: boolean,
    isHeld: boolean,
    isLinkPaused: boolean,
    notify: Playback['notify'],
  ) {
    this.stage = stage;
    this.notify = notify;
    this.isPaused = isPaused;
    this.isHeld = isHeld;
    this.isLinkPaused = isLinkPaused;
  }

  begin(): void {
    this.calm.addEventListener('change', this.update);
    this.update();
  }

  /** Whether the smoke plays, in view or not. */
  get isPlaying(): boolean {
    return !this.isPaused && !this.isHeld && !this.isLinkPaused && !this.isStill;
  }

  set(isPaused: boolean): void {
    this.isPaused = isPaused;
    this.update();
  }

  /** A share link pauses or plays, or a call of play() overrides it. */
  setLinkPaused(isLinkPaused: boolean): void {
    if (isLinkPaused === this.isLinkPaused) return;
    this.isLinkPaused = isLinkPaused;
    this.update();
  }

  /** Pauses by a user action, or starts playback, which overrides the page and reduced motion. */
  setUserPaused(isHeld: boolean): void {
    this.isHeld = isHeld;
    this.isPaused &&= isHeld;
    this.isLinkPaused &&= isHeld;
    this.isConsented ||= !isHeld;
    this.update();
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
    // The button changes the attribute and the user's choice, which is one change.
    const state = `${isPlaying} ${isStill}`;
    if (state === this.notified) return;
    this.notified = state;
    this.notify({ isPlaying, isStill });
  };
}
