import type { GivenValues } from '../parameters/timeline.ts';
import { fetchTimelineText, loaded } from './extraPasses.ts';

/** The smoke that has a timeline. */
interface Owner {
  isDisposed(): boolean;
  /** The timeline of its values. */
  text(): string | undefined;
  /** Sets values that are checked. */
  set(values: GivenValues): void;
  /** Called when the code of the timeline is loaded. */
  play(): void;
}

/** Lets a smoke wait until the code of its timeline is loaded, which begins with the first timeline. */
export class TimelineLoading {
  private readonly owner: Owner;
  /** A timeline whose code could not be loaded: the smoke goes on without it. */
  private missing: string | undefined;
  /** A timeline that is checked as soon as its code is loaded. */
  private coming: Promise<void> | undefined;
  private owed: (() => void)[] = [];

  constructor(owner: Owner) {
    this.owner = owner;
  }

  /** Whether the smoke can take steps. */
  get isOver(): boolean {
    const timeline = this.owner.text();
    return !this.coming && (!timeline || loaded.timeline !== undefined || timeline === this.missing);
  }

  /**
   * Sets values. If the code is not loaded, a timeline as an object is set later, and a text is checked later.
   * @returns then, a promise that rejects when the timeline is invalid
   * @throws ParameterError for an invalid value; nothing changes then
   */
  set(given: GivenValues): Promise<void> | undefined {
    const { timeline, ...others } = { ...given };
    if (!timeline || loaded.timeline) return void this.owner.set(given);
    this.owner.set(typeof timeline === 'string' ? given : others);
    const coming = fetchTimelineText({ timeline }).then((values) => {
      if (this.coming === coming && !this.owner.isDisposed()) this.owner.set(values);
    });
    this.coming = coming;
    const end = () => {
      if (this.coming === coming) this.coming = undefined;
      this.takeSteps();
    };
    coming.then(end, end);
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

  /** Called when code was loaded. */
  use(): void {
    if (this.owner.text()) this.owner.play();
    this.takeSteps();
  }

  /** Called when code could not be loaded. If it is that of the timeline, the smoke goes on without it. */
  async miss(): Promise<void> {
    const timeline = this.owner.text();
    if (!timeline) return;
    try {
      await fetchTimelineText({ timeline });
      this.use();
    } catch {
      this.missing = timeline;
      this.takeSteps();
    }
  }

  private takeSteps(): void {
    if (this.isOver && !this.owner.isDisposed()) for (const act of this.owed.splice(0)) act();
  }
}
