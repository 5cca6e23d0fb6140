import { strings } from '../strings.ts';
import { create } from '../ui/dom.ts';
import { icon } from '../ui/icons.ts';
import type { Notices } from '../ui/notices.ts';
import type { TimelinePanel, TimelineParts } from './panel.ts';

/** What opens the timeline. */
export interface OpenerParts extends TimelineParts {
  readonly notices: Notices;
  /** Parent of the panel. */
  readonly container: HTMLElement;
}

/** The button of the timeline. Its code is fetched on first use, or when a smoke has a timeline. */
export class TimelineOpener {
  readonly button = create('button', { type: 'button', class: 'quiet timeline-button', 'aria-expanded': 'false' });
  private readonly onToggle: (isOpen: boolean) => void;
  private parts: OpenerParts | undefined;
  private panel: Promise<TimelinePanel> | undefined;

  /** @param onToggle called before the timeline opens and after it has closed */
  constructor(onToggle: (isOpen: boolean) => void) {
    this.onToggle = onToggle;
    this.button.append(icon('keyframe'), create('span', {}, strings.timeline.title));
    this.button.setAttribute('aria-controls', 'timeline');
    this.button.addEventListener('click', () => void this.toggle());
  }

  /** Call it when the page has its panel of parameters. */
  connect(parts: OpenerParts): void {
    this.parts = parts;
    const { editor } = parts;
    let isFollowed = false;
    const follow = () => {
      if (isFollowed || !editor.state.values.timeline) return;
      isFollowed = true;
      void this.load();
    };
    editor.listen(follow);
    follow();
  }

  get isOpen(): boolean {
    return this.button.getAttribute('aria-expanded') === 'true';
  }

  async toggle(): Promise<void> {
    if (this.isOpen) await this.close();
    else await this.open();
  }

  async open(): Promise<void> {
    const panel = await this.load();
    if (!panel || this.isOpen) return;
    this.onToggle(true);
    this.button.setAttribute('aria-expanded', 'true');
    panel.toggle(true);
    panel.focus();
  }

  async close(): Promise<void> {
    if (!this.isOpen) return;
    const panel = await this.load();
    const hadFocus = panel?.element.contains(document.activeElement);
    this.button.setAttribute('aria-expanded', 'false');
    panel?.toggle(false);
    this.onToggle(false);
    if (hadFocus) this.button.focus();
  }

  private async load(): Promise<TimelinePanel | undefined> {
    const { parts } = this;
    if (!parts) return undefined;
    try {
      return await (this.panel ??= this.create(parts));
    } catch (error) {
      // Allow a retry after a failed fetch.
      this.panel = undefined;
      parts.notices.notify((error as Error).message);
      return undefined;
    }
  }

  private async create(parts: OpenerParts): Promise<TimelinePanel> {
    const { TimelinePanel: Panel } = await import('./panel.ts');
    const panel = new Panel(parts);
    parts.container.append(panel.element);
    return panel;
  }
}
