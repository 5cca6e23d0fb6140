import type { Stage } from '../../index.ts';
import type { State } from '../../preset.ts';

/** Simulated seconds in which the last puffs end. Smoke that lasts longer fades. */
const LONGEST_REST = 10;

export interface Play {
  readonly state: State;
  /** Bytes of a take, which is replayed. */
  readonly take?: Uint8Array;
  /** Simulated seconds before the first picture. */
  readonly lead: number;
  /** Simulated seconds in which smoke is emitted; may be infinite. */
  readonly seconds: number;
}

/** Plays the smoke of a link once for each call, each time from the start. The canvas is visible only meanwhile. */
export class Player {
  readonly #stage: Stage;
  readonly #canvas: HTMLCanvasElement;
  readonly #play: Play;
  /** Identifies the latest call; earlier ones are superseded. */
  #latest = 0;
  #phase: 'waiting' | 'starting' | 'playing' | 'ending' = 'waiting';

  constructor(stage: Stage, canvas: HTMLCanvasElement, play: Play) {
    this.#stage = stage;
    this.#canvas = canvas;
    this.#play = play;
    stage.visible = false;
    stage.on('frame', ({ time, alive, waiting }) => this.#follow(time, alive + waiting));
  }

  /** Starts a play. One that is not over starts again. */
  async start(): Promise<void> {
    const play = ++this.#latest;
    const { state, take, lead } = this.#play;
    const stage = this.#stage;
    this.#phase = 'waiting';
    await stage.enter(state.values);
    if (play !== this.#latest) return;
    if (take) stage.playTake(take);
    if (lead > 0) await stage.seek(lead);
    if (play !== this.#latest) return;
    this.#phase = 'starting';
    stage.visible = true;
    stage.play();
  }

  #follow(time: number, puffs: number): void {
    const end = this.#play.lead + this.#play.seconds;
    if (this.#phase === 'starting') this.#show('playing');
    if (this.#phase === 'playing' && time >= end) {
      this.#phase = 'ending';
      this.#stage.set({ 'emission.rate': 0 });
    }
    if (this.#phase === 'ending' && (puffs === 0 || time >= end + LONGEST_REST)) {
      this.#stage.pause();
      this.#stage.visible = false;
      this.#show('waiting');
    }
  }

  /** The style sheet fades the canvas by this attribute. */
  #show(phase: 'waiting' | 'playing'): void {
    this.#phase = phase;
    this.#canvas.dataset.phase = phase;
  }
}
