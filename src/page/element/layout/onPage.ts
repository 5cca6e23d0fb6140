/** Elements of the page in the smoke: obstacles (`collide`) and emitters (`emit-from`). */
import { notice, type Notice } from '../../../parameters/notice.ts';
import type { AnyValues, Values } from '../../../parameters/parameter.ts';
import { placeOnPlane, type Box } from '../../plane.ts';
import { clientBox } from '../../zoom.ts';
import type { RemoteStage } from '../../../stage/remote/contract.ts';
import type { ScenePlane } from '../../../stage/sight.ts';
import { change } from '../change.ts';
import { Deferred, ignoreRejection } from '../deferred.ts';
import { EmitterSwitch } from './emitterSwitch.ts';
import { colliderValues, curlValues, emitterValues, MAX_FOLLOWED, maxCurled } from './pageValues.ts';

interface PageOwner {
  readonly element: HTMLElement;
  /** The element's box. */
  readonly container: HTMLElement;
  /** The values without obstacles and emitters of the page. */
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

  /** Resolves when the page's elements are first in the smoke. */
  async begin(): Promise<void> {
    await this.stopAutomaticCamera();
    this.measure();
    await this.hasBegun.promise;
  }

  /**
   * Restores the page's elements after the smoke has lost them, for example through a change of scene. Resolves when
   * they are in the smoke again.
   */
  async beginAnew(): Promise<void> {
    this.given = {};
    this.hasBegun.resolve();
    this.hasBegun = new Deferred();
    await this.begin();
  }

  /** The given values without those that the page's elements control. */
  without(values: Values): Values {
    return Object.fromEntries(Object.entries(values).filter(([key]) => !(key in this.given)));
  }

  /** Measures all boxes soon. Concurrent calls are merged. */
  measure(): void {
    this.isBehind = true;
    if (!this.isMeasuring) ignoreRejection(this.measureAll());
  }

  /** Removes the page's elements from the smoke. */
  dispose(): void {
    this.hasEnded = true;
    this.stopWatching();
    this.emitters.dispose();
    ignoreRejection(change(this.stage, this.given, this.restored()));
  }

  /**
   * Stops an automatic camera, whose motion would separate the smoke from the page's elements. The user can still orbit
   * the view.
   */
  private async stopAutomaticCamera(): Promise<void> {
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

  /** @param which the matches that are used when there are too many */
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
    const container = clientBox(this.owner.container);
    const scale = this.owner.container.clientWidth / Math.max(container.width, 1);
    const place = (box: Box) => placeOnPlane(box, container, scale, plane);
    const own = this.owner.values();
    const emitters = this.emitters.attached
      .filter(isShown)
      .map((element) => ({ box: clientBox(element), isOn: this.emitters.isOn(element) }))
      .filter(({ box }) => hasArea(box));
    const sources = emitters.map(({ box }) => box);
    const boxes = this.obstacles.filter(isShown).map(clientBox).filter(hasArea);
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

  /** The attributes' values for keys that were overridden before and are not any more. */
  private restored(now: Values = {}, before: Values = this.given): Values {
    const own: AnyValues = this.owner.values();
    const gone = Object.keys(before).filter((key) => !(key in now) && own[key] !== undefined);
    return Object.fromEntries(gone.map((key) => [key, own[key]]));
  }
}

/** Number of vortices that the attributes define. */
function vorticesOf(values: Values): number {
  const used = Object.keys(values).flatMap((key) => /^vortices\.(\d)\./.exec(key)?.[1] ?? []);
  return used.length === 0 ? 0 : 1 + Math.max(...used.map(Number));
}

/** Collapsed content, for example in closed details, may still have a box. */
function isShown(element: Partial<Element>): boolean {
  return element.checkVisibility?.() ?? true;
}

function hasArea({ width, height }: Box): boolean {
  return width > 0 && height > 0;
}

/** Polling interval for movements that fire no event, in milliseconds. */
const LOOK_MS = 400;

/**
 * Calls back when elements of the page may have moved: on scroll, resize, image loads, and at intervals while the
 * container is in view. It may call back although nothing has moved.
 * @returns a function that stops watching
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

/**
 * Selects the boxes that smoke is most likely to reach, in their original order. Boxes within the container come first,
 * nearest to a source; boxes outside it follow by their distance to it.
 * @param container of the smoke on the page
 * @param sources boxes that emit smoke; empty when unknown
 */
export function nearest<Given extends Box>(
  boxes: readonly Given[],
  count: number,
  container: Box,
  sources: readonly Box[],
): Given[] {
  if (boxes.length <= count) return [...boxes];
  const ranked = boxes.map((box) => ({ box, outside: gap(box, container), way: gapToAny(box, sources) }));
  ranked.sort((one, other) => one.outside - other.outside || one.way - other.way);
  const chosen = new Set(ranked.slice(0, count).map(({ box }) => box));
  return boxes.filter((box) => chosen.has(box));
}

function gapToAny(box: Box, others: readonly Box[]): number {
  return others.length === 0 ? 0 : Math.min(...others.map((other) => gap(box, other)));
}

/** Distance between two boxes in pixels; 0 where they touch or overlap. */
function gap(one: Box, other: Box): number {
  const across = Math.max(one.left - other.left - other.width, other.left - one.left - one.width, 0);
  const down = Math.max(one.top - other.top - other.height, other.top - one.top - one.height, 0);
  return Math.hypot(across, down);
}
