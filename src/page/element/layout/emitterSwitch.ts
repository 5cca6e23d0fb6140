/** How long a click or tap emits smoke, in milliseconds. */
const PUFF_MS = 900;

/** Tracks which elements emit smoke now: always, on hover or keyboard focus, or after a click. */
export class EmitterSwitch {
  private readonly notify: () => void;
  private readonly until = new Map<Element, number>();
  private readonly focused = new Set<Element>();
  private readonly listening = new Map<Element, AbortController>();
  private when = '';

  /** @param notify called when an element starts or stops emitting */
  constructor(notify: () => void) {
    this.notify = notify;
  }

  get attached(): readonly Element[] {
    return [...this.listening.keys()];
  }

  isOn(element: Element): boolean {
    if (this.when === 'always' || this.focused.has(element)) return true;
    return (this.until.get(element) ?? 0) > performance.now();
  }

  /** @param when a value of `EMIT_ON`; any other value means `always` */
  attach(elements: readonly Element[], when: string): void {
    if (when !== this.when) this.dispose();
    this.when = when === 'hover' || when === 'click' ? when : 'always';
    for (const element of this.attached) if (!elements.includes(element)) this.detach(element);
    for (const element of elements) if (!this.listening.has(element)) this.listen(element);
  }

  dispose(): void {
    for (const element of this.attached) this.detach(element);
  }

  private listen(element: Element): void {
    const control = new AbortController();
    const { signal } = control;
    this.listening.set(element, control);
    if (this.when === 'hover') this.followHover(element, signal);
    if (this.when === 'click') element.addEventListener('click', () => this.rise(element, PUFF_MS), { signal });
  }

  private followHover(element: Element, signal: AbortSignal): void {
    const on = (type: string, act: (event: Event) => void) => element.addEventListener(type, act, { signal });
    on('pointerenter', () => this.rise(element, Infinity));
    // A touch pointer leaves when the finger lifts. Without a delay the smoke would stop before it is visible.
    on('pointerleave', (event) => this.rise(element, (event as PointerEvent).pointerType === 'touch' ? PUFF_MS : 0));
    on('focusin', () => this.focus(element, isUnderKeyboard(element)));
    on('focusout', () => this.focus(element, false));
    // An element that is already hovered or focused fires no further event.
    if (element.matches(':hover')) this.until.set(element, Infinity);
    if (isUnderKeyboard(element)) this.focused.add(element);
  }

  private rise(element: Element, milliseconds: number): void {
    this.until.set(element, performance.now() + milliseconds);
    this.notify();
    if (milliseconds === PUFF_MS) setTimeout(this.notify, PUFF_MS + 1);
  }

  private focus(element: Element, isOn: boolean): void {
    if (isOn) this.focused.add(element);
    else this.focused.delete(element);
    this.notify();
  }

  private detach(element: Element): void {
    this.listening.get(element)?.abort();
    this.listening.delete(element);
    this.until.delete(element);
    this.focused.delete(element);
  }
}

/** A clicked element keeps the focus, too, but `:focus-visible` matches only keyboard focus. */
function isUnderKeyboard(element: Element): boolean {
  let { activeElement } = element.ownerDocument;
  while (activeElement?.shadowRoot?.activeElement) ({ activeElement } = activeElement.shadowRoot);
  return element.matches(':focus-within') && (activeElement?.matches(':focus-visible') ?? false);
}
