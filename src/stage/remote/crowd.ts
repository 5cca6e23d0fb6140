import type { Device } from '../../renderer/gpu/device.ts';
import { DRAWINGS_PER_SECOND } from '../../renderer/frame.ts';
import { FramesInFlight } from '../../renderer/gpu/framesInFlight.ts';
import { Pace, type Turns } from '../frameLoop.ts';
import { Governor } from '../governor.ts';

/** Turns are counted in frames of this rate, on displays of any rate. */
const FRAME_RATE = 60;
/** This many playing stages are drawn in every frame. */
const FEW = 4;
/** A stage is drawn in every frame for this long after an input, milliseconds. */
const TOUCHED_MS = 1_000;
/** In how many frames a stage draws once: at most so many that it draws on twos. */
const PERIODS = Array.from({ length: FRAME_RATE / DRAWINGS_PER_SECOND }, (_, index) => index + 1);

/** The turns of one stage of a crowd. */
export interface CrowdTurns extends Turns {
  /** Records an input of the user: the stage draws in every frame for a while. */
  touch(): void;
}

/**
 * The stages of a thread that share a device. Each frame is for all of them: all steps are taken, and while more than a
 * few stages play and frames arrive late, a share of the stages draws in each frame, in turns.
 */
export class Crowd {
  private readonly inFlight: FramesInFlight;
  private readonly pace = new Pace(FRAME_RATE);
  private readonly governor = new Governor(
    this.pace.intervalMs,
    PERIODS.map((period) => 1 / period),
  );
  private now = -1;
  private isOpen = false;
  private hasDrawn = false;
  private frame = 0;
  /** Stages that play: in this frame so far, and in the frame before. */
  private playing = 0;
  private count = 0;
  /** Of the next stage that asks in this frame. */
  private place = 0;

  constructor(device: Device) {
    this.inFlight = new FramesInFlight(device);
    device.onContext((event) => event === 'restored' && this.inFlight.clear());
  }

  /** Adds a stage. Only the frames in which it plays count, so it need not leave. */
  join(): CrowdTurns {
    let latest = -1;
    let touchedUntil = 0;
    return {
      isClosed: (now) => this.isClosed(now),
      takeTurn: (now) => {
        const turn = this.nextTurn();
        // A stage whose turn was in a frame that it skipped draws now.
        const isDrawn = turn !== latest || now < touchedUntil;
        latest = turn;
        this.hasDrawn ||= isDrawn;
        return isDrawn;
      },
      touch: () => (touchedUntil = this.now + TOUCHED_MS),
    };
  }

  private get isLarge(): boolean {
    return this.count > FEW;
  }

  private isClosed(now: number): boolean {
    if (now !== this.now) this.begin(now);
    this.playing += 1;
    return !this.isOpen;
  }

  private begin(now: number): void {
    this.now = now;
    this.count = this.playing;
    this.playing = 0;
    // The stages have submitted the previous frame.
    if (this.hasDrawn) this.inFlight.add();
    this.hasDrawn = false;
    this.isOpen = !this.inFlight.isFull;
    if (!this.isOpen || !this.pace.isDue(now)) return;
    this.frame += 1;
    this.place = 0;
    if (this.isLarge) this.governor.tick(now);
    else this.governor.pause();
  }

  /**
   * The number of the turn that a stage has in this frame. Neighbours draw in the same frame, which changes a small part
   * of the page.
   */
  private nextTurn(): number {
    const period = this.isLarge ? PERIODS[this.governor.level] : 1;
    const group = Math.floor((this.place++ * period) / Math.max(1, this.count));
    return Math.floor((this.frame + group) / period);
  }
}
