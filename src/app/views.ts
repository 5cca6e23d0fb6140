import { DEBUG_VIEWS, type DebugView } from '../preset/quality.ts';
import type { Stage } from '../stage/stage.ts';
import { create } from './dom.ts';
import { strings } from './strings.ts';

/** What is shown instead of the picture, with its name and how to read it. */
export class Views {
  readonly element = create('p', { class: 'legend card', role: 'status' });
  private readonly stage: Stage;

  constructor(stage: Stage) {
    this.stage = stage;
    stage.on('statechange', () => this.notify());
    this.notify();
  }

  /** Shows the next view, and after the last one the picture. */
  next(): void {
    const order: readonly (DebugView | undefined)[] = [undefined, ...DEBUG_VIEWS];
    this.stage.view = order[(order.indexOf(this.stage.view) + 1) % order.length];
  }

  private notify(): void {
    const { view } = this.stage;
    this.element.textContent = view ? strings.views[view] : '';
    this.element.hidden = !view;
  }
}
