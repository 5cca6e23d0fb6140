import { LIST_LIMIT, MAX_STEP, type Easing } from '../../internal.ts';
import { findParameter } from '../../preset.ts';
import { createControl } from '../panel/control.ts';
import type { Control } from '../panel/controlTypes.ts';
import { create, iconButton, uniqueId } from '../ui/dom.ts';
import { icon } from '../ui/icons.ts';
import { EasingEditor } from './easingEditor.ts';
import { burstOf, keyframeOf, placeOf, STEPS_PER_SECOND } from './model.ts';
import type { Session } from './session.ts';
import { laneLabel, words } from './words.ts';

const MAX_COUNT = 20_000;

/** Time, value and easing of what is selected. */
export class Inspector {
  readonly element = create('div', { class: 'timeline-inspector', role: 'group', 'aria-label': words.selection });
  private readonly session: Session;
  private readonly easing: EasingEditor;
  private readonly actions: HTMLElement;
  /** What the elements are made for. */
  private shown: string | undefined;
  private update: () => void = () => undefined;

  constructor(session: Session) {
    this.session = session;
    const copy = iconButton('icon-button', words.copy, icon('copy'), () => session.copy());
    const duplicate = iconButton('icon-button', words.duplicate, icon('duplicate'), () => session.duplicate());
    const remove = iconButton('icon-button', words.remove, icon('remove'), () => session.remove());
    this.actions = create('div', { class: 'timeline-tools' }, copy, duplicate, remove);
    this.easing = new EasingEditor({
      change: (easing) => session.setEasing(easing),
      settle: () => session.settle(),
    });
    this.element.addEventListener('keydown', (event) => {
      // Typing would act on the page as well.
      if (event.target instanceof HTMLInputElement && event.key === 'Enter') event.target.blur();
    });
  }

  show(): void {
    const kind = this.kindOf();
    if (kind !== this.shown) this.build(kind);
    this.shown = kind;
    this.update();
  }

  /** Moves the focus to the value of the keyframe, or to the count of the burst. @returns whether there is one */
  focusValue(): boolean {
    const field = this.element.querySelector<HTMLElement>(
      '.inspector-value :is(input, select, button, [tabindex="0"])',
    );
    field?.focus();
    if (field instanceof HTMLInputElement && field.type === 'number') field.select();
    return field !== null;
  }

  /** The lane of the only mark that is selected, `several` or `nothing`. */
  private kindOf(): string {
    const { marks } = this.session;
    const [mark] = marks;
    if (marks.size === 0) return 'nothing';
    if (marks.size > 1) return [...marks].every((each) => burstOf(this.session.timeline, each)) ? 'bursts' : 'several';
    return burstOf(this.session.timeline, mark) ? 'burst' : placeOf(mark).lane;
  }

  private build(kind: string): void {
    const { element } = this;
    element.classList.toggle('is-empty', kind === 'nothing');
    if (kind === 'nothing') {
      element.replaceChildren(create('p', { class: 'inspector-hint' }, words.noSelection));
      this.update = () => undefined;
    } else if (kind === 'several' || kind === 'bursts') this.buildSeveral(kind === 'several');
    else if (kind === 'burst') this.buildBurst();
    else this.buildKeyframe(kind);
  }

  private buildSeveral(hasEasing: boolean): void {
    const title = create('h3', {});
    this.element.replaceChildren(this.createHead(title), ...(hasEasing ? [this.easing.element] : []));
    this.update = () => {
      const { timeline, marks } = this.session;
      const keyframes = [...marks].filter((mark) => keyframeOf(timeline, mark));
      title.textContent = words.several(keyframes.length, marks.size - keyframes.length);
      const easings = new Set(keyframes.map((mark) => JSON.stringify(keyframeOf(timeline, mark)!.easing)));
      const [only] = easings;
      if (hasEasing) this.easing.show(easings.size === 1 ? (JSON.parse(only) as Easing) : undefined);
    };
  }

  private buildKeyframe(key: string): void {
    const { session } = this;
    const parameter = findParameter(key)!;
    const time = this.createTime();
    const textId = uniqueId();
    const control: Control = createControl(
      parameter,
      textId,
      { change: (value) => session.setValue(value), settle: () => session.settle() },
      () => session.values,
    );
    const text = create('span', { id: textId, class: 'read-aloud' }, parameter.text);
    const unit = 'unit' in parameter && parameter.unit ? [create('span', { class: 'unit' }, parameter.unit)] : [];
    const label = create('label', { for: control.id }, words.value, ...unit);
    const value = create(
      'div',
      { class: `inspector-value row row-${parameter.kind}` },
      label,
      ...control.elements,
      text,
    );
    const { label: name, group } = laneLabel(key);
    const head = this.createHead(create('h3', {}, name, create('small', {}, group)));
    this.element.replaceChildren(
      head,
      create('div', { class: 'inspector-fields' }, time.element, value),
      this.easing.element,
    );
    this.update = () => {
      const [mark] = session.marks;
      const keyframe = keyframeOf(session.timeline, mark);
      if (!keyframe) return;
      time.show(keyframe.step);
      control.show(keyframe.value);
      this.easing.show(keyframe.easing);
    };
  }

  private buildBurst(): void {
    const { session } = this;
    const time = this.createTime();
    const count = create('input', { id: uniqueId(), type: 'number', min: 1, max: MAX_COUNT, inputmode: 'numeric' });
    const emitters = Array.from({ length: LIST_LIMIT }, (_, at) =>
      create('option', { value: at }, words.emitterOf(at)),
    );
    const emitter = create('select', { id: uniqueId() }, ...emitters);
    count.addEventListener('input', () => {
      const number = Math.round(count.valueAsNumber);
      if (number >= 1 && number <= MAX_COUNT) session.setBurst({ count: number });
    });
    count.addEventListener('change', () => {
      session.settle();
      this.update();
    });
    emitter.addEventListener('change', () => {
      session.setBurst({ emitter: Number(emitter.value) });
      session.settle();
    });
    const head = this.createHead(create('h3', {}, words.burstTitle));
    const counts = create(
      'div',
      { class: 'inspector-value row' },
      create('label', { for: count.id }, words.count),
      count,
    );
    const from = create('div', { class: 'row' }, create('label', { for: emitter.id }, words.emitter), emitter);
    this.element.replaceChildren(head, create('div', { class: 'inspector-fields' }, time.element, counts, from));
    this.update = () => {
      const [mark] = session.marks;
      const burst = mark && burstOf(session.timeline, mark);
      if (!burst) return;
      time.show(burst.step);
      if (document.activeElement !== count) count.value = String(burst.count);
      emitter.value = String(burst.emitter);
    };
  }

  private createHead(title: HTMLElement): HTMLElement {
    return create('div', { class: 'inspector-head' }, title, this.actions);
  }

  /** A field with the time in seconds, which moves the selected mark. */
  private createTime(): { element: HTMLElement; show(step: number): void } {
    const { session } = this;
    const [id, max] = [uniqueId(), MAX_STEP / STEPS_PER_SECOND];
    const field = create('input', { id, type: 'number', min: 0, max, step: 'any', inputmode: 'decimal' });
    field.addEventListener('change', () => {
      const [mark] = session.marks;
      const to = Math.round(field.valueAsNumber * STEPS_PER_SECOND);
      if (mark && !Number.isNaN(to)) session.moveTo(mark, to);
      this.update();
    });
    const label = create('label', { for: id }, words.time, create('span', { class: 'unit' }, words.seconds));
    const show = (step: number) => (field.value = String(Number((step / STEPS_PER_SECOND).toFixed(3))));
    return { element: create('div', { class: 'row' }, label, field), show };
  }
}
