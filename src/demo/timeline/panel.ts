import { keyOf, MAX_STEP } from '../../internal.ts';
import { create, iconButton, setAttributes, textButton, uniqueId } from '../ui/dom.ts';
import { icon } from '../ui/icons.ts';
import { Inspector } from './inspector.ts';
import { listenOnLanes } from './laneKeys.ts';
import { consume, Lanes } from './lanes.ts';
import { STEPS_PER_SECOND, type Grid } from './model.ts';
import { RowKeyframes } from './rowKeyframes.ts';
import { Session, type SessionParts } from './session.ts';
import { words } from './words.ts';

export const TIMELINE_ID = 'timeline';

const [MIN_BPM, MAX_BPM, FIRST_BPM] = [20, 400, 120];

/** What the panel of the timeline needs of the page. */
export interface TimelineParts extends SessionParts {
  /** The panel of the parameters. */
  readonly panel: HTMLElement;
  /** Opens the panel of the parameters. */
  showParameters(): void;
  close(): void;
}

/** The timeline: lanes with keyframes, what is selected, and tools. */
export class TimelinePanel {
  readonly element: HTMLElement;
  private readonly session: Session;
  private readonly parts: TimelineParts;
  private readonly lanes: Lanes;
  private readonly inspector: Inspector;
  private readonly rowKeyframes: RowKeyframes;
  private readonly status = create('p', { role: 'status', class: 'read-aloud' });
  private readonly begin: HTMLElement;
  private readonly updates: (() => void)[] = [];

  constructor(parts: TimelineParts) {
    const { stage, panel } = parts;
    this.parts = parts;
    const session = (this.session = new Session(parts));
    session.say = (sentence) => this.announce(sentence);
    this.lanes = new Lanes(session, stage);
    this.inspector = new Inspector(session);
    this.rowKeyframes = new RowKeyframes(panel, session);
    this.begin = this.createBeginning();
    const middle = create('div', { class: 'timeline-middle' }, this.lanes.element, this.begin);
    const body = create('div', { class: 'timeline-body' }, middle, this.inspector.element);
    const how = create('p', { id: 'timeline-how', hidden: true }, words.how);
    const attributes = { id: TIMELINE_ID, class: 'timeline-panel card', 'aria-label': words.title, hidden: true };
    this.element = create('section', attributes, this.createBar(), body, how, this.status);
    this.element.addEventListener('keydown', (event) => this.press(event));
    listenOnLanes(this.lanes, session, () => this.inspector.focusValue());
    session.listen(() => this.show());
    let last = 0;
    stage.on('frame', () => {
      const now = performance.now();
      if (stage.playing && now - last < READOUT_MS) return;
      last = now;
      session.showAnimated();
      this.rowKeyframes.show();
    });
    session.showAnimated();
    this.show();
  }

  /** Shows or hides the panel. */
  toggle(isOpen: boolean): void {
    this.element.hidden = !isOpen;
    if (!isOpen) this.record(false);
    this.show();
  }

  focus(): void {
    this.lanes.focusRuler();
  }

  private announce(sentence: string): void {
    // The same sentence twice would not be announced.
    this.status.textContent = this.status.textContent === sentence ? `${sentence}\u00a0` : sentence;
  }

  private show(): void {
    const { session } = this;
    this.rowKeyframes.show();
    if (this.element.hidden) return;
    const had = this.lanes.element.contains(document.activeElement);
    this.begin.hidden = !session.isEmpty;
    this.lanes.show();
    this.inspector.show();
    for (const update of this.updates) update();
    // An element that had the focus can be gone, or belong to another keyframe.
    const { focused } = session;
    if (had && focused && (document.activeElement as HTMLElement).dataset.mark !== focused) this.refocus(focused);
  }

  private refocus(mark: string): void {
    const active = document.activeElement;
    const isOnMark = active === document.body || active?.classList.contains('timeline-mark');
    if (isOnMark && this.session.marks.size > 0) this.lanes.focus(mark as never);
  }

  private record(isOn: boolean): void {
    const { recorder } = this.session;
    if (recorder.isOn === isOn) return;
    this.parts.editor.settle();
    recorder.isOn = isOn;
    document.body.classList.toggle('is-recording', isOn);
    this.announce(isOn ? words.recording : words.recorded);
    this.show();
  }

  /** Keys that act on the selection from anywhere in the panel but text fields. */
  private press(event: KeyboardEvent): void {
    const { target } = event;
    if (target instanceof HTMLSelectElement) return;
    if (target instanceof HTMLInputElement && !['range', 'checkbox', 'color'].includes(target.type)) return;
    const { session } = this;
    const edits: Record<string, () => void> = {
      c: () => session.copy(),
      x: () => session.cut(),
      v: () => session.paste(),
      d: () => session.duplicate(),
      a: () => session.selectAll(),
    };
    const key = keyOf(event);
    if ((event.ctrlKey || event.metaKey) && !event.altKey && !event.shiftKey && edits[key]) edits[key]();
    else if ((key === 'Delete' || key === 'Backspace') && session.marks.size > 0) session.remove();
    else return;
    consume(event);
  }

  private createBar(): HTMLElement {
    const bar = create('div', { class: 'timeline-bar', role: 'group', 'aria-label': words.toolbar });
    const heading = create('h2', {}, words.title);
    bar.append(heading, this.createTransport(), this.createSnap(), this.createLength(), this.createZoom());
    return bar;
  }

  private createTransport(): HTMLElement {
    const { session } = this;
    const record = create('button', { type: 'button', class: 'quiet timeline-record', title: words.recordTitle });
    record.append(icon('record'), create('span', {}, words.record));
    record.addEventListener('click', () => this.record(!session.recorder.isOn));
    this.updates.push(() => record.setAttribute('aria-pressed', String(session.recorder.isOn)));
    const previous = iconButton('icon-button', words.previous, icon('previous'), () => session.goToMark(-1));
    const next = iconButton('icon-button', words.next, icon('next'), () => session.goToMark(1));
    const burst = iconButton('icon-button', words.addBurst, icon('burst'), () => session.addBurst());
    const paste = iconButton('icon-button', words.paste, icon('paste'), () => session.paste());
    this.updates.push(() => {
      previous.disabled = next.disabled = session.isEmpty;
      paste.disabled = !session.canPaste;
    });
    return create('div', { class: 'timeline-tools' }, record, previous, next, burst, paste, this.createSelect());
  }

  /** Makes touch draw boxes and add to the selection, which otherwise scrolls. */
  private createSelect(): HTMLElement {
    const { gestures, element } = this.lanes;
    const button = iconButton('icon-button timeline-select', words.select, icon('box'), () => {
      gestures.selectsByTouch = !gestures.selectsByTouch;
      button.setAttribute('aria-pressed', String(gestures.selectsByTouch));
      element.classList.toggle('selects-by-touch', gestures.selectsByTouch);
    });
    button.setAttribute('aria-pressed', 'false');
    return button;
  }

  private createSnap(): HTMLElement {
    const { session } = this;
    const id = uniqueId();
    const options = Object.entries(words.grids).map(([value, label]) => create('option', { value }, label));
    const select = create('select', { id }, ...options.toReversed());
    select.value = String(STEPS_PER_SECOND);
    const bpm = create('input', { type: 'number', min: MIN_BPM, max: MAX_BPM, step: 'any', value: FIRST_BPM });
    setAttributes(bpm, { 'aria-label': words.beats, title: words.beats });
    const change = () => {
      session.grid = gridOf(select.value, bpm.valueAsNumber);
      bpm.hidden = session.grid.name !== 'beats';
      this.show();
    };
    select.addEventListener('change', change);
    bpm.addEventListener('input', change);
    bpm.hidden = true;
    return create('div', { class: 'timeline-tools' }, create('label', { for: id }, words.snap), select, bpm);
  }

  private createLength(): HTMLElement {
    const { session } = this;
    const [id, max] = [uniqueId(), MAX_STEP / STEPS_PER_SECOND];
    const field = create('input', { id, type: 'number', min: 0, max, step: 'any', inputmode: 'decimal' });
    field.addEventListener('change', () => {
      const steps = Math.round(field.valueAsNumber * STEPS_PER_SECOND);
      if (!Number.isNaN(steps)) session.setLength(Math.min(Math.max(1, steps), MAX_STEP));
      session.settle();
      this.show();
    });
    const loop = create('button', { type: 'button', class: 'quiet timeline-loop' }, icon('loop'));
    loop.append(create('span', {}, words.loop));
    loop.addEventListener('click', () => session.setLoops(!session.timeline.loops));
    this.updates.push(() => {
      const { length, loops } = session.timeline;
      if (document.activeElement !== field) field.value = String(Number((length / STEPS_PER_SECOND).toFixed(2)));
      loop.setAttribute('aria-pressed', String(loops));
    });
    const unit = create('span', { class: 'unit', 'aria-hidden': 'true' }, words.seconds);
    return create('div', { class: 'timeline-tools' }, create('label', { for: id }, words.length), field, unit, loop);
  }

  private createZoom(): HTMLElement {
    const { axis } = this.lanes;
    const out = iconButton('icon-button', words.zoomOut, icon('zoomOut'), () => axis.zoomOut());
    const into = iconButton('icon-button', words.zoomIn, icon('zoomIn'), () => axis.zoomIn());
    const fit = iconButton('icon-button', words.fit, icon('fit'), () => axis.fit());
    const close = iconButton('icon-button', words.close, icon('close'), () => this.parts.close());
    return create('div', { class: 'timeline-tools timeline-end-tools' }, out, into, fit, close);
  }

  /** What an empty timeline shows. */
  private createBeginning(): HTMLElement {
    const { title, steps, parameters, record, burst } = words.empty;
    const list = create('ol', {}, ...steps.map((step) => create('li', {}, step)));
    const show = textButton('quiet', parameters, () => this.parts.showParameters());
    const start = textButton('quiet', record, () => this.record(true));
    const add = textButton('quiet', burst, () => this.session.addBurst());
    const buttons = create('div', { class: 'timeline-begin-buttons' }, show, start, add);
    return create('div', { class: 'timeline-begin' }, create('h3', {}, title), list, buttons);
  }
}

/** Update interval in milliseconds of what the panel of the parameters shows of the timeline. */
const READOUT_MS = 100;

function gridOf(name: string, bpm: number): Grid {
  if (name !== 'beats') return { name: 'frames', rate: Number(name) };
  return { name: 'beats', bpm: bpm >= MIN_BPM && bpm <= MAX_BPM ? bpm : FIRST_BPM };
}
