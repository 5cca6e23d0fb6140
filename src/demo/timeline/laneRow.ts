import type { Easing } from '../../internal.ts';
import { findParameter, type AnyValues, type Value } from '../../preset.ts';
import { create, iconButton, setAttributes } from '../ui/dom.ts';
import { icon } from '../ui/icons.ts';
import { burstOf, emitterOf, keyframeOf, markOf, marksOf, placeOf, type Mark } from './model.ts';
import type { Session } from './session.ts';
import { shapesOf } from './shape.ts';
import { laneLabel, timeText, valueText, words } from './words.ts';

/** A lane of the timeline: its name with buttons, and its keyframes or bursts on the axis. */
export class LaneRow {
  readonly element: HTMLElement;
  readonly lane: string;
  private readonly session: Session;
  private readonly track = create('div', { class: 'timeline-track' });
  private readonly shapes = create('div', { class: 'timeline-shapes', 'aria-hidden': 'true' });
  private readonly value = create('span', { class: 'timeline-value', 'aria-hidden': 'true' });
  private readonly toggle: HTMLButtonElement;
  /** The elements of the marks in the order of their steps. */
  private readonly marks: HTMLElement[] = [];
  /** What an element shows. */
  private readonly shown = new WeakMap<HTMLElement, string>();
  private drawn: unknown;

  constructor(lane: string, session: Session) {
    this.lane = lane;
    this.session = session;
    const { label, group } = laneLabel(lane);
    const emitter = emitterOf(lane);
    const act = () => (emitter === undefined ? session.toggleKeyframe(lane) : session.addBurst(emitter));
    this.toggle = iconButton('timeline-toggle', '', icon(emitter === undefined ? 'keyframe' : 'add'), act);
    const name = create('button', { type: 'button', class: 'timeline-lane-name', title: words.laneAll(label) });
    name.append(create('span', { class: 'timeline-label' }, label), this.value);
    this.value.title = group;
    name.addEventListener('click', () => session.selectLane(lane));
    const remove = iconButton('timeline-lane-remove', words.laneRemove(label), icon('close'), () =>
      session.removeLane(lane),
    );
    this.track.append(this.shapes);
    const head = create('div', { class: 'timeline-name' }, this.toggle, name, remove);
    const attributes = { class: emitter === undefined ? 'timeline-row' : 'timeline-row is-bursts', role: 'group' };
    this.element = create('div', { ...attributes, 'data-lane': lane }, head, this.track);
  }

  /** The element of a mark. */
  elementOf(mark: Mark): HTMLElement | undefined {
    return this.marks.find(({ dataset }) => dataset.mark === mark);
  }

  show(): void {
    const { session, lane } = this;
    const marks = marksOf(session.timeline, lane);
    const { label } = laneLabel(lane);
    this.element.setAttribute('aria-label', words.lane(label, marks.length, emitterOf(lane) !== undefined));
    while (this.marks.length > marks.length) this.marks.pop()!.remove();
    while (this.marks.length < marks.length) this.addMark();
    marks.forEach((mark, at) => this.showMark(this.marks[at], mark));
    this.showShapes();
  }

  /** Shows the value at the playhead, and whether it is on a keyframe. @param effective values in effect */
  showNow(effective: AnyValues): void {
    const { session, lane } = this;
    const { label, group } = laneLabel(lane);
    const row = findParameter(lane);
    const name = row
      ? words.laneKeyframe(label, keyframeOf(session.timeline, markOf(lane, session.step)) !== undefined)
      : words.laneBurst(label);
    if (this.toggle.title !== name) {
      this.toggle.title = name;
      this.toggle.setAttribute('aria-label', name);
      const isOn = row && name === words.laneKeyframe(label, true);
      this.toggle.classList.toggle('is-on', isOn);
    }
    const value = row ? effective[lane] : undefined;
    const text = row && value !== undefined ? valueText(row, value, false) : group;
    if (this.value.textContent !== text) this.value.textContent = text;
    if (row?.kind === 'color') this.value.style.setProperty('--swatch', String(value));
    this.value.classList.toggle('is-color', row?.kind === 'color');
  }

  private addMark(): void {
    // A slider, because the arrow keys move it in time. The space bar keeps playing and pausing the smoke.
    const mark = create('div', { class: 'timeline-mark', role: 'slider', tabindex: -1 });
    mark.setAttribute('aria-roledescription', emitterOf(this.lane) === undefined ? words.keyframe : words.burst);
    mark.setAttribute('aria-describedby', 'timeline-how');
    mark.setAttribute('aria-valuemin', '0');
    this.marks.push(mark);
    this.track.append(mark);
  }

  private showMark(element: HTMLElement, mark: Mark): void {
    const { session, lane } = this;
    const { step } = placeOf(mark);
    const keyframe = keyframeOf(session.timeline, mark);
    const burst = burstOf(session.timeline, mark);
    const isSelected = session.marks.has(mark);
    const { grid, focused } = session;
    const shown = JSON.stringify([keyframe, burst, isSelected, focused === mark, session.timeline.length, grid]);
    if (this.shown.get(element) === shown) return;
    this.shown.set(element, shown);
    const { label } = laneLabel(lane);
    element.dataset.mark = mark;
    element.className = 'timeline-mark';
    element.classList.add(burst ? 'is-burst' : shapeOf(keyframe!.easing));
    element.classList.toggle('is-selected', isSelected);
    element.style.setProperty('--step', String(step));
    const value = burst ? words.puffs(burst.count) : this.textOf(keyframe!.value);
    if (burst) element.textContent = String(burst.count);
    const parts = [timeText(step, session.grid), value, ...(isSelected ? [words.selected] : [])];
    setAttributes(element, {
      'aria-label': label,
      'aria-valuenow': step,
      'aria-valuemax': Math.max(step, session.timeline.length),
      'aria-valuetext': parts.join(', '),
    });
    element.title = `${label}\n${timeText(step, session.grid)}, ${value}`;
    element.tabIndex = session.focused === mark ? 0 : -1;
  }

  private textOf(value: Value): string {
    return valueText(findParameter(this.lane)!, value);
  }

  private showShapes(): void {
    const lane = this.session.timeline.lanes.find(({ key }) => key === this.lane);
    const key = JSON.stringify(lane?.keyframes);
    if (!lane || key === this.drawn) return;
    this.drawn = key;
    this.shapes.replaceChildren(...shapesOf(lane));
  }
}

/** Keyframes that hold are squares, eased ones are rounded. */
function shapeOf(easing: Easing): string {
  if (easing === 'hold') return 'is-hold';
  return easing === 'linear' ? 'is-linear' : 'is-eased';
}
