import type { GivenValues } from '../parameters/timeline.ts';
import { fetchTimelineText, loaded } from './extraPasses.ts';

/** The smoke whose values change over time. */
interface Owner {
  isDisposed(): boolean;
  isAnimated(): boolean;
  /** Sets values that are checked. */
  set(values: GivenValues): void;
  /** Called when the code is loaded. */
  play(): void;
}

/** Lets a smoke wait for the code of its timeline, which is loaded with the first one. */
export class AnimationLoading {
  private readonly owner: Owner;
  /** Whether the code could not be loaded: the smoke goes on without it. */
  private isMissing = false;
  /** A timeline that is checked as soon as its code is loaded. */
  private coming: Promise<void> | undefined;
  private owed: (() => void)[] = [];

  constructor(owner: Owner) {
    this.owner = owner;
  }

  /** Whether the smoke can take steps. */
  get isOver(): boolean {
    return !this.coming && (this.isMissing || loaded.animation !== undefined || !this.owner.isAnimated());
  }

  /**
   * Sets values. If the code is not loaded, a timeline as an object is set later, and a text is checked later.
   * @returns then, a promise that rejects when the timeline is invalid
   * @throws ParameterError for an invalid value; nothing changes then
   */
  set(given: GivenValues): Promise<void> | undefined {
    const { timeline, ...others } = { ...given };
    const isKnown = !timeline || loaded.animation;
    this.owner.set(isKnown || typeof timeline === 'string' ? given : others);
    if (isKnown) return undefined;
    const coming = fetchTimelineText({ timeline })
      .then((values) => {
        if (this.coming === coming) this.owner.set(values);
      })
      .finally(() => {
        if (this.coming === coming) this.coming = undefined;
        this.takeSteps();
      });
    this.coming = coming;
    return coming;
  }

  /** Resolves when a timeline that was set is checked. What is wrong is reported by the call that set it. */
  async wait(): Promise<void> {
    await this.coming?.catch(() => undefined);
  }

  /** Takes steps now, or when the smoke can. */
  whenOver(act: () => void): void {
    if (this.isOver) act();
    else this.owed.push(act);
  }

  /** Called when code was loaded, or could not be. */
  end(): void {
    this.isMissing = !loaded.animation;
    if (!this.isMissing) this.owner.play();
    this.takeSteps();
  }

  private takeSteps(): void {
    if (this.isOver && !this.owner.isDisposed()) for (const act of this.owed.splice(0)) act();
  }
}
