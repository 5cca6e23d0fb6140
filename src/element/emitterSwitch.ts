/** How long a click lets smoke rise. */
const PUFF_MS = 900;

/** Knows which of the elements that smoke rises from do so now: always, under a pointer or the keyboard, or after a click. */
export class EmitterSwitch {
  private readonly tell: () => void;
  private readonly until = new Map<Element, number>();
  private readonly listening = new Map<Element, AbortController>();
  private when = '';

  /** @param tell told when one begins or ends */
  constructor(tell: () => void) {
    this.tell = tell;
  }

  get attached(): readonly Element[] {
    return [...this.listening.keys()];
  }

  isOn(element: Element): boolean {
    return this.when === 'always' || (this.until.get(element) ?? 0) > performance.now();
  }

  /** @param when one of `EMIT_ON`; what it is not means always */
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
    const turn = (until: number) => () => {
      this.until.set(element, until);
      this.tell();
    };
    if (this.when === 'hover') {
      for (const type of ['pointerenter', 'focusin']) element.addEventListener(type, turn(Infinity), { signal });
      for (const type of ['pointerleave', 'focusout']) element.addEventListener(type, turn(0), { signal });
      // Who was there before the smoke came enters no more.
      if (element.matches(':hover, :focus-within')) this.until.set(element, Infinity);
    }
    if (this.when === 'click') element.addEventListener('click', () => this.puff(element), { signal });
  }

  private puff(element: Element): void {
    this.until.set(element, performance.now() + PUFF_MS);
    this.tell();
    setTimeout(this.tell, PUFF_MS + 1);
  }

  private detach(element: Element): void {
    this.listening.get(element)?.abort();
    this.listening.delete(element);
    this.until.delete(element);
  }
}
