import type { AnyValues, Values } from '../parameters/parameter.ts';
import { findParameter } from '../parameters/table.ts';
import { loaded } from '../renderer/extraPasses.ts';
import type { Held } from '../simulator/heldState.ts';
import type { Simulator } from '../simulator/simulator.ts';
import type { PlayOptions, TimelinePlayer } from '../simulator/timelinePlayer.ts';
import { ofSmoke } from './options.ts';

/** The values of smoke in a scene, and what its timeline makes of them. */
export class Animated {
  /** With those of the timeline that the simulator has; another object after each change. */
  simulated: Values;
  /** Undefined without a timeline, and until its code is loaded. */
  player: TimelinePlayer | undefined;
  private own: Values;
  /** Those of the timeline for the picture. */
  private drawn: AnyValues = {};
  /** When callers last set animated values, in steps. */
  private readonly changes = new Map<string, number>();

  constructor(values: Values) {
    this.own = values;
    this.simulated = values;
    this.play();
  }

  /** As callers have set them. */
  get values(): Values {
    return this.own;
  }

  set values(values: Values) {
    const isOther = values.timeline !== this.own.timeline;
    this.own = values;
    this.simulated = values;
    if (isOther) this.play();
  }

  /** For the picture. */
  get shown(): Values {
    return { ...this.own, ...this.drawn };
  }

  /** Plays the timeline of the values if its code is loaded. */
  play(): void {
    const { timeline } = this.own;
    const code = loaded.timeline;
    this.player =
      timeline && code
        ? new code.TimelinePlayer(code.readTimeline(timeline).timeline, (key, time) => this.lastChange(key, time))
        : undefined;
  }

  /**
   * Lets values that a caller sets hold until the next keyframes of their lanes.
   * @param steps of the simulator
   * @param time drawn, in steps
   */
  hold(changed: AnyValues, steps: number, time: number): void {
    const animated: AnyValues = this.player?.valuesAt(time) ?? {};
    for (const key in changed) {
      if (!this.player?.animates(key) || animated[key] === changed[key]) continue;
      this.changes.set(key, findParameter(key)!.reader === 'simulator' ? steps : Math.floor(time));
    }
  }

  /** After the simulator took another state. @param held as that state has it */
  reset(held: Held = {}): void {
    this.player?.reset();
    this.changes.clear();
    for (const key in held) this.changes.set(key, held[key]);
  }

  /** Gives the simulator the values and bursts of its next step. */
  prepare(simulator: Simulator, { put, ...options }: Required<Pick<PlayOptions, 'put' | 'isSilent'>>): void {
    this.player?.prepare(simulator, {
      ...options,
      put: (values) => {
        this.simulated = { ...this.simulated, ...values };
        put(values);
      },
    });
  }

  /** Follows the timeline to a drawn time, in steps. @returns whether values of the picture have changed */
  follow(time: number): boolean {
    const { drawn } = this;
    this.drawn = ofSmoke(this.player?.valuesAt(time, true) ?? {});
    const keys = Object.keys(this.drawn);
    return keys.length !== Object.keys(drawn).length || keys.some((key) => this.drawn[key] !== drawn[key]);
  }

  private lastChange(key: string, time: number): number | undefined {
    const step = this.changes.get(key);
    return step !== undefined && step <= time ? step : undefined;
  }
}
