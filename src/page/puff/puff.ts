/** `puff()`: smoke by one call. This file is all that a page downloads before the first call. */
import { LoadError, ParameterError } from '../../base/errors.ts';
import type { Engine } from './engine.ts';
import {
  requirePuffOptions,
  requireWipeOptions,
  EFFECTS,
  type Effect,
  type PuffOptions,
  type WipeOptions,
} from './options.ts';
import { sourceOf, type PuffTarget } from './target.ts';

export interface Puff {
  /**
   * Shows smoke.
   *
   * @param target an element, which smoke leaves and flows around; an event with coordinates; or a point in client
   * pixels. Default: the middle of the window
   * @returns resolves when the last particle is gone. It resolves at once if there is nothing to show: for an element
   * without a box, or with reduced motion. Rejects with a ParameterError for invalid arguments, an UnsupportedError
   * without WebGL2 or WASM, a LoadError when code cannot be fetched, a ContextError when the context is lost for good
   */
  (target?: PuffTarget, options?: PuffOptions): Promise<void>;
  /** The names of the effects. */
  readonly effects: readonly Effect[];
  /**
   * Loads everything and compiles the shaders, so that later calls start at once, and keeps it.
   * @throws as a call does
   */
  preload(): Promise<void>;
  /**
   * Covers the window or an element with smoke, changes it while nothing of it is visible, and clears.
   *
   * @param target as for a call; an event or a point stands for its element. Default: the window
   * @returns resolves when the smoke is gone and `to` is done. `to` is called exactly once in any case: without smoke with
   * reduced motion, in a hidden tab, without WebGL2, or when the smoke fails. Rejects as a call does, or with the error of `to`
   */
  wipe(target: PuffTarget | undefined, options: WipeOptions): Promise<void>;
  /** Removes all smoke. The promises of its calls resolve; elements that vanish or appear have done so. */
  clear(): void;
  /**
   * A `puff` that draws on this canvas instead of one over the page. The canvas must not have a context. After `dispose`
   * or a lost context, the next call replaces it by a copy.
   */
  create(canvas: HTMLCanvasElement): OwnPuff;
}

/** A `puff` on a canvas of the page. */
export interface OwnPuff extends Puff {
  /** Releases everything. The canvas stays in the page. */
  dispose(): void;
}

/** Whether nothing can be drawn here, as on servers and in the simulated DOMs of unit tests: calls then do nothing. */
const isInert = (): boolean => !('WebGL2RenderingContext' in globalThis);

/** Whether a call shows nothing. */
function isCalm({ reducedMotion = 'skip' }: Pick<PuffOptions, 'reducedMotion'>): boolean {
  return isInert() || (reducedMotion === 'skip' && matchMedia('(prefers-reduced-motion: reduce)').matches);
}

/** Within a view transition where there are some, so that the browser shows no half-changed page. */
async function changePage(to: () => unknown): Promise<void> {
  if (!globalThis.document?.startViewTransition || document.hidden) return void (await to());
  const transition = document.startViewTransition(async () => void (await to()));
  // The smoke is the transition.
  transition.ready.then(() => transition.skipTransition()).catch(() => undefined);
  transition.finished.catch(() => undefined);
  await transition.updateCallbackDone;
}

function makePuff(canvas?: HTMLCanvasElement): OwnPuff {
  let opening: Promise<Engine> | undefined;
  let isKept = canvas !== undefined;
  /** The calls before the latest `clear`. */
  let calls = new AbortController();

  const open = async (): Promise<Engine> => {
    opening ??= fetchEngine().then(({ openEngine }) => openEngine({ canvas, onEnd: () => (opening = undefined) }));
    try {
      const engine = await opening;
      if (isKept) engine.keep();
      return engine;
    } catch (error) {
      opening = undefined;
      throw error;
    }
  };

  const end = (act: (engine: Engine) => void) => {
    calls.abort();
    calls = new AbortController();
    opening?.then(act).catch(() => undefined);
  };

  const play = async (target?: PuffTarget, options: PuffOptions = {}): Promise<void> => {
    requirePuffOptions(options);
    if (!globalThis.document) return;
    const source = sourceOf(target);
    const { effect = 'poof' } = options;
    const change = visibilityChange(effect, source.element);
    const { signal } = calls;
    signal.addEventListener('abort', change.end);
    try {
      if (isCalm(options) || !source.box()) return change.end();
      const engine = await open();
      if (signal.aborted) return;
      await engine.play({ ...options, effect, source, signal, onBegin: change.begin });
      await change.finished();
    } catch (error) {
      change.end();
      throw error;
    } finally {
      signal.removeEventListener('abort', change.end);
    }
  };

  const wipe = async (target: PuffTarget | undefined, options: WipeOptions): Promise<void> => {
    requireWipeOptions(options);
    let changed: Promise<void> | undefined;
    const change = () => (changed ??= changePage(options.to));
    const stop = new AbortController();
    const { signal } = stop;
    const { signal: cleared } = calls;
    try {
      if (isCalm(options) || document.hidden) return;
      const source = target ? sourceOf(target) : undefined;
      if (source && !source.box()) return;
      cleared.addEventListener('abort', () => stop.abort(), { signal });
      document.addEventListener('visibilitychange', () => document.hidden && stop.abort(), { signal });
      addEventListener('keydown', ({ key }) => key === 'Escape' && stop.abort(), { signal, capture: true });
      const { playWipe } = await fetchWipe();
      await playWipe(source, options, change, signal);
    } finally {
      stop.abort();
      await change();
    }
  };

  const preload = async () => {
    isKept = true;
    if (!isInert()) await (await open()).warmUp();
  };

  const puff = (target?: PuffTarget, options?: PuffOptions) => handled(play(target, options));
  return Object.assign(puff, {
    effects: EFFECTS,
    wipe: (target: PuffTarget | undefined, options: WipeOptions) => handled(wipe(target, options)),
    preload: () => handled(preload()),
    clear: () => end((engine) => engine.clear()),
    create(own: HTMLCanvasElement) {
      if ((own as HTMLCanvasElement | undefined)?.localName !== 'canvas')
        throw new ParameterError('canvas', own, 'a canvas of the page');
      return makePuff(own);
    },
    dispose: () => end((engine) => engine.dispose()),
  });
}

/** A page that does not await a call gets no unhandled rejection. */
function handled(call: Promise<void>): Promise<void> {
  call.catch(() => undefined);
  return call;
}

const fetchEngine = () => loaded(import('./engine.ts'));
const fetchWipe = () => loaded(import('./wipe.ts'));

/** Not by `fetched`, which would bring code of the element into the download before the first call. */
async function loaded<Module>(module: Promise<Module>): Promise<Module> {
  try {
    return await module;
  } catch (cause) {
    throw new LoadError(`The smoke could not be loaded: ${(cause as Error).message}`, { cause });
  }
}

export const puff: Puff = makePuff();

/** Hides the element of a `vanish` and shows that of an `appear`, with or without smoke. Layout does not change. */

/** Milliseconds in which an element fades, and how long it waits for the smoke. */
const FADE = { vanish: { duration: 450, delay: 60 }, appear: { duration: 240, delay: 520 } } as const;

/** The change of an element's visibility. */
interface VisibilityChange {
  /** Starts to fade. */
  readonly begin: () => void;
  /** Hides or shows the element, at once if it has not faded. */
  readonly end: () => void;
  /** Ends after the fade, if it has begun. */
  readonly finished: () => Promise<void>;
}

/** @param element that the effect hides or shows, if any */
export function visibilityChange(effect: Effect, element: Element | undefined): VisibilityChange {
  const isChange = effect === 'vanish' || effect === 'appear';
  if (!isChange || !isStyled(element)) {
    return { begin() {}, end() {}, finished: async () => undefined };
  }
  let fade: Animation | undefined;
  const end = () => {
    if (effect === 'vanish') hide(element);
    else show(element);
    fade?.cancel();
    fade = undefined;
  };
  return {
    begin() {
      // The other end is the opacity that the page gives.
      const keyframes = [{ opacity: 0, offset: effect === 'vanish' ? 1 : 0 }];
      fade = element.animate?.(keyframes, { ...FADE[effect], fill: 'both', easing: 'ease-in-out' });
      if (effect === 'appear') show(element);
      fade?.addEventListener('finish', end, { once: true });
    },
    end,
    async finished() {
      // Cancelled by the page.
      await fade?.finished.catch(() => undefined);
      end();
    },
  };
}

type Styled = HTMLElement | SVGElement;

/** By shape, because an element of a frame is no instance of this window's classes. */
function isStyled(element: Element | undefined): element is Styled {
  return element !== undefined && 'style' in element;
}

/** The page's own inline visibility of the elements that are hidden. */
const hidden = new WeakMap<Styled, readonly [value: string, priority: string]>();

function hide(element: Styled): void {
  const { style } = element;
  if (!hidden.has(element)) {
    hidden.set(element, [style.getPropertyValue('visibility'), style.getPropertyPriority('visibility')]);
  }
  style.setProperty('visibility', 'hidden', 'important');
  skipTransitions(element);
}

function show(element: Styled): void {
  const { style } = element;
  const [value, priority] = hidden.get(element) ?? [''];
  hidden.delete(element);
  if (style.visibility !== 'visible') style.removeProperty('visibility');
  // A page that has hidden it inline wants it to appear.
  if (value === 'visible') style.setProperty('visibility', value, priority);
  element.removeAttribute('hidden');
  skipTransitions(element);
  // Hidden by a rule of the page.
  if (!element.isConnected || getComputedStyle(element).visibility === 'visible') return;
  style.visibility = 'visible';
  skipTransitions(element);
}

/** With a transition of the page, an element or its children would stay visible for a while. */
function skipTransitions(element: Styled): void {
  for (const each of element.getAnimations?.({ subtree: true }) ?? []) {
    if ((each as Partial<CSSTransition>).transitionProperty === 'visibility') each.finish();
  }
}
