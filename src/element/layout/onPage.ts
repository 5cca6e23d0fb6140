/** Things of the page in the smoke: boxes that it flows around (`collide`), and elements that it rises from (`emit-from`). */
import { notice, type Notice } from '../../preset/notice.ts';
import type { Values } from '../../preset/parameter.ts';
import type { RemoteStage } from '../../remote/contract.ts';
import type { ScenePlane } from '../../stage/sight.ts';
import { change } from '../change.ts';
import { Deferred } from '../deferred.ts';
import { EmitterSwitch } from './emitterSwitch.ts';
import { nearest, type Box } from './nearest.ts';
import { colliderValues, curlValues, emitterValues, MAX_FOLLOWED, maxCurled, placeOnPlane } from './pageValues.ts';
import { ignoreRejection } from '../ignoreRejection.ts';

interface PageOwner {
  readonly element: HTMLElement;
  /** The box of the smoke. */
  readonly container: HTMLElement;
  /** What the smoke is without things of the page. */
  readonly values: () => Values;
  readonly notify: (notices: readonly Notice[]) => void;
}

export class OnPage {
  private readonly stage: RemoteStage;
  private readonly owner: PageOwner;
  private readonly stopWatching: () => void;
  private readonly emitters: EmitterSwitch;
  private obstacles: Element[] = [];
  private given: Values = {};
  private notified = '';
  private isMeasuring = false;
  private isBehind = false;
  private hasEnded = false;
  private hasBegun = new Deferred<void>();

  constructor(stage: RemoteStage, owner: PageOwner) {
    this.stage = stage;
    this.owner = owner;
    this.emitters = new EmitterSwitch(() => this.measure());
    this.stopWatching = watchLayout(owner.container, () => this.measure());
  }

  /** Settled when things of the page are in the smoke for the first time. */
  async begin(): Promise<void> {
    await this.holdView();
    this.measure();
    await this.hasBegun.promise;
  }

  /** The smoke has lost what it was given, as by another scene. Settled when things of the page are in it again. */
  async beginAnew(): Promise<void> {
    this.given = {};
    this.hasBegun.resolve();
    this.hasBegun = new Deferred();
    await this.begin();
  }

  /** Those of some values that things of the page leave alone. */
  without(values: Values): Values {
    return Object.fromEntries(Object.entries(values).filter(([key]) => !(key in this.given)));
  }

  /** Looks where everything is, soon: not more than once at a time. */
  measure(): void {
    this.isBehind = true;
    if (!this.isMeasuring) ignoreRejection(this.measureAll());
  }

  /** Takes the things of the page out of the smoke again. */
  dispose(): void {
    this.hasEnded = true;
    this.stopWatching();
    this.emitters.dispose();
    ignoreRejection(change(this.stage, this.given, this.restored()));
  }

  /** A view that turned by itself would leave the things behind: it stays as it is until somebody turns it. */
  private async holdView(): Promise<void> {
    await this.stage.orbit(0, 0);
    await this.stage.zoom(1);
    await this.stage.pan(0, 0);
  }

  private async measureAll(): Promise<void> {
    this.isMeasuring = true;
    try {
      while (this.isBehind && !this.hasEnded) {
        this.isBehind = false;
        await this.measureOnce();
        this.hasBegun.resolve();
        await new Promise(requestAnimationFrame);
      }
    } finally {
      this.hasBegun.resolve();
      this.isMeasuring = false;
    }
  }

  private async measureOnce(): Promise<void> {
    this.find();
    const values = this.valuesOn(await this.stage.plane());
    if (this.hasEnded) return;
    const before = this.given;
    this.given = values;
    await change(this.stage, before, { ...this.restored(values, before), ...values });
  }

  private find(): void {
    const notices: Notice[] = [];
    this.obstacles = this.matches('collide', 'nearest', notices);
    const emitters = this.matches('emit-from', 'first', notices).slice(0, MAX_FOLLOWED);
    this.emitters.attach(emitters, this.owner.element.getAttribute('emit-on') ?? 'always');
    const messages = notices.map(({ message }) => message).join();
    if (messages !== this.notified && notices.length > 0) this.owner.notify(notices);
    this.notified = messages;
  }

  /** @param which of too many count */
  private matches(attribute: string, which: 'first' | 'nearest', notices: Notice[]): Element[] {
    const selector = this.owner.element.getAttribute(attribute);
    if (selector === null) return [];
    try {
      const root = this.owner.element.getRootNode() as ParentNode;
      const found = [...root.querySelectorAll(selector)].filter((each) => each !== this.owner.element);
      const sentence = () => `${attribute} matches ${found.length} elements; the ${which} ${MAX_FOLLOWED} are used.`;
      if (found.length > MAX_FOLLOWED) notices.push(notice('outOfRange', attribute, selector, sentence));
      return found;
    } catch {
      const sentence = (given: string) => `${attribute} cannot be ${given}: it takes a CSS selector.`;
      notices.push(notice('malformed', attribute, selector, sentence));
      return [];
    }
  }

  private valuesOn(plane: ScenePlane): Values {
    const container = this.owner.container.getBoundingClientRect();
    const scale = this.owner.container.clientWidth / Math.max(container.width, 1);
    const place = (box: Box) => placeOnPlane(box, container, scale, plane);
    const own = this.owner.values();
    const emitters = this.emitters.attached
      .filter(isShown)
      .map((element) => ({ box: element.getBoundingClientRect(), isOn: this.emitters.isOn(element) }))
      .filter(({ box }) => hasArea(box));
    const sources = emitters.map(({ box }) => box);
    const boxes = this.obstacles
      .filter(isShown)
      .map((element) => element.getBoundingClientRect())
      .filter(hasArea);
    const followed = nearest(boxes, MAX_FOLLOWED, container, sources);
    const firstVortex = vorticesOf(own);
    const curled = nearest(followed, maxCurled(firstVortex), container, sources);
    return {
      ...colliderValues(followed.map(place), plane),
      ...curlValues(curled.map(place), plane, firstVortex),
      ...emitterValues(
        emitters.map(({ box, isOn }) => ({ place: place(box), isOn })),
        plane,
        Number(own['emission.rate']),
      ),
    };
  }

  /** What the attributes say of the keys that were given before and are not now. */
  private restored(now: Values = {}, before: Values = this.given): Values {
    const own = this.owner.values();
    const gone = Object.keys(before).filter((key) => !(key in now) && own[key] !== undefined);
    return Object.fromEntries(gone.map((key) => [key, own[key]]));
  }
}

/** How many vortices the attributes have already. */
function vorticesOf(values: Values): number {
  const used = Object.keys(values).flatMap((key) => /^vortices\.(\d)\./.exec(key)?.[1] ?? []);
  return used.length === 0 ? 0 : 1 + Math.max(...used.map(Number));
}

/** What is folded away, as in closed details, may have a box all the same. */
function isShown(element: Partial<Element>): boolean {
  return element.checkVisibility?.() ?? true;
}

function hasArea({ width, height }: Box): boolean {
  return width > 0 && height > 0;
}

/** What moves without an event of its own is found so late. */
const LOOK_MS = 400;

/**
 * Calls back when things on a page may have moved against each other: scrolling, sizes, pictures that have come, and now
 * and then while the container is in view. It may call back although nothing moved.
 * @returns the function that ends it
 */
function watchLayout(container: Element, look: () => void): () => void {
  const end = new AbortController();
  const options = { capture: true, passive: true, signal: end.signal } as const;
  const page = container.ownerDocument;
  for (const type of ['scroll', 'load', 'transitionend', 'animationend']) page.addEventListener(type, look, options);
  page.defaultView?.addEventListener('resize', look, options);
  const sizes = new ResizeObserver(look);
  sizes.observe(container);
  sizes.observe(page.documentElement);
  let timer: ReturnType<typeof setInterval> | undefined;
  const inView = new IntersectionObserver((entries) => {
    clearInterval(timer);
    if (entries[entries.length - 1].isIntersecting) timer = setInterval(look, LOOK_MS);
  });
  inView.observe(container);
  return () => {
    end.abort();
    sizes.disconnect();
    inView.disconnect();
    clearInterval(timer);
  };
}
