import { MAX_STEP } from '../../internal.ts';
import { create } from '../ui/dom.ts';
import { lastStep, STEPS_PER_SECOND, unitOf, type Grid } from './model.ts';
import type { Session } from './session.ts';
import { timeText } from './words.ts';

/** Space before the first step and after the last one, in pixels, so that keyframes there are whole. */
export const MARGIN = 22;
/** Largest width of a step in pixels. */
const MAX_SCALE = 24;
const ZOOM = 1.5;
/** Least distance of labels on the ruler, and of the lines of the grid, in pixels. */
const [LABEL_GAP, LINE_GAP] = [74, 9];
/** The axis goes on behind the last keyframe for this share of its length, and for these steps. */
const [MORE_SHARE, MORE_STEPS] = [0.06, 30];
/** Lines between two labels, in units of the grid. */
const FACTORS = [1, 2, 4, 5, 10, 12, 15, 20, 24, 30, 48, 60, 120, 240, 300, 600, 1200, 1800, 3600, 7200, 18_000];

/** The time axis: zoom, scrolling and the ruler. Positions are pixels from the start of the lanes, times are steps. */
export class Axis {
  readonly labels = create('div', { class: 'timeline-labels', 'aria-hidden': 'true' });
  private readonly scroller: HTMLElement;
  private readonly sheet: HTMLElement;
  private readonly session: Session;
  private scale = 1;
  /** Whether the zoom follows the size of the window and the length of the timeline. */
  private isFit = true;
  private isHeld = false;
  private drawn = '';

  /** @param sheet the scrolled content, whose CSS variables place everything on the axis */
  constructor(scroller: HTMLElement, sheet: HTMLElement, session: Session) {
    this.scroller = scroller;
    this.sheet = sheet;
    this.session = session;
    scroller.addEventListener('scroll', () => this.drawLabels());
    new ResizeObserver(() => this.show()).observe(scroller);
  }

  /** Width of a step in pixels. */
  get pixels(): number {
    return this.scale;
  }

  /** The time at a position in the window, before 0 and after the end included. */
  timeAt(clientX: number): number {
    return (clientX - this.sheet.getBoundingClientRect().left - this.names - MARGIN) / this.scale;
  }

  show(): void {
    if (this.scroller.clientWidth === 0) return;
    const width = this.visible;
    const shown = this.shownEnd();
    if (this.isFit && !this.isHeld) this.scale = this.fitting(shown);
    this.scale = Math.min(Math.max(this.scale, this.fitting(MAX_STEP)), MAX_SCALE);
    const end = Math.min(MAX_STEP, Math.max(shown * (1 + MORE_SHARE) + MORE_STEPS, (width - 2 * MARGIN) / this.scale));
    const style = this.sheet.style;
    style.setProperty('--scale', String(this.scale));
    style.setProperty('--axis', `${Math.max(width, end * this.scale + 2 * MARGIN)}px`);
    style.setProperty('--end', String(this.session.timeline.length));
    style.setProperty('--grid', `${this.lineUnits() * unitOf(this.session.grid) * this.scale}px`);
    this.drawLabels();
  }

  /** Keeps the zoom during a drag, which would otherwise change under the pointer. */
  hold(isHeld: boolean): void {
    this.isHeld = isHeld;
    if (!isHeld) this.show();
  }

  fit(): void {
    this.isFit = true;
    this.scroller.scrollLeft = 0;
    this.show();
  }

  /** @param clientX position in the window that stays in place; by default that of the playhead, or the middle */
  zoom(factor: number, clientX?: number): void {
    const { left } = this.scroller.getBoundingClientRect();
    const playhead = this.xOf(this.session.time) - this.scroller.scrollLeft;
    const middle = playhead > 0 && playhead < this.visible ? playhead : this.visible / 2;
    const x = clientX === undefined ? middle : clientX - left - this.names;
    const time = (this.scroller.scrollLeft + x - MARGIN) / this.scale;
    this.isFit = false;
    this.scale *= factor;
    this.show();
    this.scroller.scrollLeft = this.xOf(time) - x;
    this.drawLabels();
  }

  zoomIn(): void {
    this.zoom(ZOOM);
  }

  zoomOut(): void {
    this.zoom(1 / ZOOM);
  }

  /** Turns the page when a time that goes on leaves what is shown. */
  follow(time: number): void {
    const x = this.xOf(time) - this.scroller.scrollLeft;
    if (x < 0 || x > this.visible) this.reveal(time);
  }

  /** Moves what is shown so that a time is visible. */
  reveal(time: number): void {
    const x = this.xOf(time);
    const { scrollLeft } = this.scroller;
    if (x < scrollLeft + MARGIN) this.scroller.scrollLeft = x - MARGIN - 40;
    else if (x > scrollLeft + this.visible - MARGIN) this.scroller.scrollLeft = x - MARGIN - 40;
  }

  private get names(): number {
    return this.scroller.querySelector<HTMLElement>('.timeline-corner')?.offsetWidth ?? 0;
  }

  /** Width of the visible part of the lanes. */
  private get visible(): number {
    return this.scroller.clientWidth - this.names;
  }

  private xOf(time: number): number {
    return MARGIN + time * this.scale;
  }

  /** The last step that `fit` shows: everything, and the playhead of a timeline that is still empty. */
  private shownEnd(): number {
    const { timeline, isEmpty, step } = this.session;
    return isEmpty ? Math.min(MAX_STEP, Math.max(timeline.length, step)) : lastStep(timeline);
  }

  private fitting(steps: number): number {
    return Math.max(1, this.visible - 2 * MARGIN) / steps;
  }

  /** Units of the grid between two lines. */
  private lineUnits(): number {
    const unit = unitOf(this.session.grid) * this.scale;
    return factorsOf(this.session.grid).find((factor) => factor * unit >= LINE_GAP) ?? 36_000;
  }

  /** Labels for the visible part. */
  private drawLabels(): void {
    const { grid } = this.session;
    const unit = unitOf(grid);
    const line = this.lineUnits();
    const factor = factorsOf(grid).find((each) => each % line === 0 && each * unit * this.scale >= LABEL_GAP) ?? 36_000;
    const first = Math.max(0, Math.floor((this.scroller.scrollLeft - 80) / (factor * unit * this.scale)));
    const count = Math.ceil((this.visible + 160) / (factor * unit * this.scale));
    const key = [first, count, factor, grid.name, unit, this.scale].join();
    if (key === this.drawn) return;
    this.drawn = key;
    const labels = Array.from({ length: count }, (_, at) => {
      const step = Math.round((first + at) * factor * unit);
      const label = create('span', {}, labelOf(step, grid));
      label.style.setProperty('--step', String(step));
      return step > MAX_STEP ? undefined : label;
    });
    this.labels.replaceChildren(...labels.filter((label) => label !== undefined));
  }
}

/** Multiples of a unit that make round numbers: of seconds, or of bars of four beats. */
function factorsOf(grid: Grid): readonly number[] {
  if (grid.name === 'beats') return [1, 4, 8, 16, 32, 64, 128, 256, 512, 1024, 4096];
  const { rate } = grid;
  const below = FACTORS.filter((factor) => factor < rate && rate % factor === 0);
  return [...below, ...[1, 2, 5, 10, 15, 30, 60, 120, 300, 600].map((seconds) => seconds * rate)];
}

/** Shorter than in sentences: `2.5`, `2:12` for frames, `3.1` for bars and beats. */
function labelOf(step: number, grid: Grid): string {
  if (grid.name === 'beats') {
    const beat = Math.round(step / unitOf(grid));
    return `${Math.floor(beat / 4) + 1}.${(beat % 4) + 1}`;
  }
  if (grid.rate === STEPS_PER_SECOND) return `${Number((step / STEPS_PER_SECOND).toFixed(2))} s`;
  const frames = Math.round(step / unitOf(grid));
  return frames % grid.rate === 0
    ? `${frames / grid.rate} s`
    : timeText(step, grid).replace(/(\d+) s (\d+) f/, '$1:$2');
}
