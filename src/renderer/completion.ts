import type { LoadError } from '../base/errors.ts';
import type { GivenValues } from '../parameters/timeline.ts';
import { fetchExtras, hasExtras, loaded, type PictureKind } from './extraPasses.ts';

export interface Completion {
  /**
   * Resolves when the next picture can be drawn as its settings require. A failed load is retried on the next call.
   * @throws LoadError if the code cannot be loaded
   */
  wait(): Promise<void>;
  /** Starts loading without a promise for the caller. Errors are reported only while the code is still needed. */
  begin(): void;
}

/**
 * Loads the code that pictures need and that is not loaded yet. Concurrent calls share one request.
 * @param wanted returns the settings of the pictures
 * @param show called after code was loaded
 * @param miss called once with the error of a load that was started by `begin`
 */
export function completionOf(
  wanted: () => readonly PictureKind[],
  show: () => void,
  miss: (error: LoadError) => void,
): Completion {
  let fetching: Promise<void> | undefined;
  let notifying: Promise<void> | undefined;
  const isComplete = () => wanted().every(hasExtras);
  const fetchMissing = async () => {
    while (!isComplete()) {
      await Promise.all(wanted().map(fetchExtras));
      show();
    }
  };
  const wait = () => (fetching ??= fetchMissing().finally(() => (fetching = undefined)));
  const notify = (error: LoadError) => (isComplete() ? undefined : miss(error));
  const begin = () => {
    if (!isComplete())
      notifying ??= wait()
        .catch(notify)
        .finally(() => (notifying = undefined));
  };
  return { wait, begin };
}

/** The smoke whose values change over time. */
interface Owner {
  /** Whether it needs the code of the timeline. */
  isAnimated(): boolean;
  /** Whether it waits for a larger simulator. */
  isWaiting(): boolean;
  /** Sets values. @throws ParameterError for an invalid one */
  set(values: GivenValues): void;
  /** Called when the code is loaded. */
  play(): void;
  /** Starts to load the code. */
  load(): void;
}

/** Lets a smoke wait for the code of its timeline, which is loaded with the first one, and for a larger simulator. */
export class AnimationLoading {
  private readonly owner: Owner;
  /** Whether the code could not be loaded: the smoke goes on without it. */
  private isMissing = false;
  private owed: (() => void)[] = [];
  /** Whether a first timeline waits for its code. */
  private hasOwedTimeline = false;

  constructor(owner: Owner) {
    this.owner = owner;
  }

  /** Whether the smoke can take steps. */
  get isOver(): boolean {
    const isAnimationOver = this.isMissing || loaded.animation !== undefined || !this.isAnimationWanted;
    return isAnimationOver && !this.owner.isWaiting();
  }

  /** Whether the code of the timeline is needed. */
  get isAnimationWanted(): boolean {
    return this.hasOwedTimeline || this.owner.isAnimated();
  }

  /**
   * Sets values; those with the first timeline when its code is loaded.
   * @returns then, a promise that rejects when one is invalid
   * @throws ParameterError for an invalid value; nothing changes then
   */
  set(given: GivenValues): Promise<void> | undefined {
    const act = () => this.owner.set(given);
    if (loaded.animation || !(given as GivenValues | undefined)?.timeline) {
      act();
      return undefined;
    }
    this.hasOwedTimeline = true;
    return new Promise((resolve, reject) => {
      this.owed.push(() => {
        try {
          resolve(act());
        } catch (error) {
          reject(error);
        }
      });
      this.owner.load();
    });
  }

  /** Takes steps now, or when the smoke can. */
  whenOver(act: () => void): void {
    if (this.isOver) return act();
    // What was waited for can have led to something else.
    this.owed.push(() => this.whenOver(act));
    this.owner.load();
  }

  /** Called when code was loaded, or could not be. */
  end(): void {
    this.isMissing = !loaded.animation;
    if (!this.isMissing) this.owner.play();
    this.hasOwedTimeline = false;
    for (const act of this.owed.splice(0)) act();
  }
}
