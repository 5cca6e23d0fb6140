import type { GivenValues } from '../parameters/timeline.ts';
import { loaded } from './extraPasses.ts';

/** The smoke whose values change over time. */
interface Owner {
  /** Whether it needs the code. */
  isAnimated(): boolean;
  /** Sets values. @throws ParameterError for an invalid one */
  set(values: GivenValues): void;
  /** Called when the code is loaded. */
  play(): void;
  /** Starts to load the code. */
  load(): void;
}

/** Lets a smoke wait for the code of its timeline, which is loaded with the first one. */
export class AnimationLoading {
  private readonly owner: Owner;
  /** Whether the code could not be loaded: the smoke goes on without it. */
  private isMissing = false;
  private owed: (() => void)[] = [];

  constructor(owner: Owner) {
    this.owner = owner;
  }

  /** Whether the smoke can take steps. */
  get isOver(): boolean {
    return this.isMissing || loaded.animation !== undefined || !this.isWanted;
  }

  /** Whether the code is needed. */
  get isWanted(): boolean {
    return this.owed.length > 0 || this.owner.isAnimated();
  }

  /**
   * Sets values; those with the first timeline when its code is loaded.
   * @returns then, a promise that rejects when one is invalid
   * @throws ParameterError for an invalid value; nothing changes then
   */
  set(given: GivenValues): Promise<void> | undefined {
    const act = () => this.owner.set(given);
    if (loaded.animation || !(given as GivenValues | undefined)?.timeline) return void act();
    return new Promise((resolve, reject) => {
      this.owed.push(() => {
        try {
          resolve(act());
        } catch (error) {
          reject(error as Error);
        }
      });
      this.owner.load();
    });
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
    for (const act of this.owed.splice(0)) act();
  }
}
