import { ContextError, type SmokeError } from '../../base/errors.ts';
import type { Fault } from '../../renderer/gpu/faults.ts';
import { runOnSelf } from '../../base/onSelf.ts';
import { asSmokeError } from '../asSmokeError.ts';
import { Deferred, ignoreRejection } from './deferred.ts';
import type { RemoteStage } from '../../stage/remote/contract.ts';
import type { SmokeEvents } from './events.ts';
import { HANDED_ON, type StageMethods } from './methods.ts';
import { keyOfAttribute } from './attributes/names.ts';
import { whenNear } from '../visibility.ts';
import { fetchAhead } from './parts.ts';
import { fetched } from '../../base/timeout.ts';
import { defineProperties, FLAGS, upgradeProperties, TEXTS, type ElementProperties } from './attributes/properties.ts';
import type { Session } from './session.ts';
import { isInert, Shell } from './shell/shell.ts';

/** Importing this module must not fail on a server, where HTMLElement is undefined. */
const Base = globalThis.HTMLElement ?? (Object as unknown as typeof HTMLElement);

/** Has the properties of the attributes. Their accessors work on a Proxy, so `runOnSelf` need not wrap them. */
const Reflecting: typeof Base = class extends Base {
  static {
    defineProperties(this.prototype);
  }
};

/** Attributes besides the parameters that select the smoke. */
const PARSED_TOGETHER: readonly string[] = ['preset', 'src'];

// eslint-disable-next-line typescript/no-unsafe-declaration-merging -- the methods and properties are made from tables below
export interface CartoonSmokeElement extends StageMethods, ElementProperties {
  addEventListener<Name extends keyof SmokeEvents>(
    type: Name,
    listener: (this: CartoonSmokeElement, event: CustomEvent<SmokeEvents[Name]>) => unknown,
    options?: boolean | AddEventListenerOptions,
  ): void;
  addEventListener(
    type: string,
    listener: EventListenerOrEventListenerObject,
    options?: boolean | AddEventListenerOptions,
  ): void;
}

/** @internal */
export interface ElementOptions {
  /** Simulates a failure, to test how a page handles it. Builds ignore it. */
  fault?: Fault;
}

/**
 * `<cartoon-smoke preset="lamp" emission-rate="60" paused>`: smoke on any page. Every parameter is an attribute and a
 * property. The element has the methods of RemoteStage, which wait for the smoke to be ready. Large resources are
 * fetched when the element comes near the viewport, when a method is called, or at once with `loading="eager"`.
 */
export class CartoonSmokeElement extends Reflecting {
  /**
   * Version of the package. With several versions on one page, `customElements.get('cartoon-smoke').version` is the one
   * in use.
   */
  static readonly version: string = '0.1.0';

  static get observedAttributes(): string[] {
    return [...FLAGS, ...TEXTS, ...keyOfAttribute.keys()];
  }

  readonly #fault: Fault | undefined;
  readonly #shell = new Shell(this.attachShadow({ mode: 'open' }));
  #stopWaiting: (() => void) | undefined;
  /** Cancels the current start or session. Aborted after a failure. */
  #start: AbortController | undefined;
  /** Attributes that changed between the start and the first frame. */
  readonly #changed = new Set<string>();
  /** Whether the user has paused with the button. Kept apart from the attribute, which belongs to the page. */
  #isHeld = false;
  /** Whether the button set the attribute `paused`. */
  #setsPaused = false;
  /** Whether the context is lost. The session stays, because the browser may restore it. */
  #isLost = false;
  /** Whether a user started playback on this element despite reduced motion. */
  #isConsented = false;
  /** Set once the first frame is rendered. */
  #session: Session | undefined;
  #awaited = new Deferred<Session>();

  /** @internal @param options for elements created by script; @see ElementOptions */
  constructor({ fault }: ElementOptions = {}) {
    super();
    this.#fault = fault;
    runOnSelf(this, Reflecting.prototype);
    this.#shell.button.addEventListener('click', (event) => {
      // The element may be inside a link.
      event.preventDefault();
      if (this.#isLost) {
        this.#end();
        this.#begin();
      } else this.#hold(this.playing);
    });
  }

  /** Resolves with the first frame. Rejects with the error of the `error` event. */
  get ready(): Promise<void> {
    if (isInert()) return Promise.resolve();
    const ready = this.#awaited.promise.then(() => undefined);
    ignoreRejection(ready);
    return ready;
  }

  /**
   * The stage, for its events. Reading it starts the smoke outside the viewport, too. Rejects with the error of the
   * `error` event.
   */
  get stage(): Promise<RemoteStage> {
    const stage = this.#demand().then((session) => session.stage);
    ignoreRejection(stage);
    return stage;
  }

  /** Whether the smoke plays. Out of view it pauses and still counts as playing. */
  get playing(): boolean {
    return !this.#isLost && (this.#session?.isPlaying ?? false);
  }

  play(): void {
    this.paused = false;
    this.#session?.overrideLink();
    if (navigator.userActivation?.isActive) this.#hold(false);
  }

  pause(): void {
    this.paused = true;
  }

  connectedCallback(): void {
    upgradeProperties(this);
    this.#waitOrStart();
  }

  disconnectedCallback(): void {
    // A script that moves the element inserts it again within the same task.
    queueMicrotask(() => this.isConnected || this.#end());
  }

  /** Moving with moveBefore preserves the state. */
  connectedMoveCallback(): void {}

  adoptedCallback(): void {
    this.#shell.dress();
  }

  attributeChangedCallback(name: string, before: string | null, after: string | null): void {
    if (name === 'paused') this.#setsPaused = false;
    else if (before === after) return;
    if (name === 'loading') this.#waitOrStart();
    else if (this.#hasFailed) this.#tryAnew(name);
    else if (!this.#session) this.#changed.add(name);
    else if (PARSED_TOGETHER.includes(name) || keyOfAttribute.has(name)) this.#session.requestValues();
    else this.#session.applyAttribute(name);
  }

  /**
   * The smoke failed to start or stopped. Retry only when the page selects other smoke or inserts the element again.
   */
  get #hasFailed(): boolean {
    return this.#isLost || (this.#start?.signal.aborted ?? false);
  }

  /** @param name of the changed attribute */
  #tryAnew(name: string): void {
    if (!PARSED_TOGETHER.includes(name)) return;
    this.#end();
    this.#waitOrStart();
  }

  /** Starts the smoke if necessary. Resolves when it is ready. */
  #demand(): Promise<Session> {
    if (this.isConnected && !isInert()) this.#begin();
    return this.#awaited.promise;
  }

  #waitOrStart(): void {
    if (!this.isConnected || this.#start || isInert()) return;
    if (this.loading === 'eager') this.#begin();
    else this.#stopWaiting ??= whenNear(this.#shell.container, () => this.#begin());
  }

  #begin(): void {
    if (this.#start) return;
    this.#stopWaiting?.();
    this.#stopWaiting = undefined;
    this.#changed.clear();
    const { signal } = (this.#start = new AbortController());
    this.#open(signal).then(
      (session) => this.#onReady(session, signal),
      (error) => signal.aborted || this.#fail(asSmokeError(error)),
    );
  }

  async #open(signal: AbortSignal): Promise<Session> {
    fetchAhead(this);
    // Not a part, because sessions fetch parts.
    const { openSession } = await fetched('The smoke', import('./session.ts'));
    signal.throwIfAborted();
    return openSession(
      {
        element: this,
        shell: this.#shell,
        isHeld: this.#isHeld,
        notify: (name, detail) => this.#notify(name, detail),
        fail: (error) => this.#fail(error),
        fault: this.#fault,
      },
      signal,
    );
  }

  #onReady(session: Session, signal: AbortSignal): void {
    if (signal.aborted) return;
    this.#session = session;
    if (this.#changed.size > 0) session.catchUp();
    if (this.#isConsented && !this.paused) session.setUserPaused(false);
    this.#shell.show('smoke');
    this.#awaited.resolve(session);
    this.#notify('ready', { thread: session.stage.thread });
  }

  #fail(error: SmokeError): void {
    // The page may have selected other smoke while this one failed to start.
    const isPast = !this.#session && PARSED_TOGETHER.some((name) => this.#changed.has(name));
    const isContext = error instanceof ContextError;
    if (this.#session && isContext) this.#awaitContext(this.#session);
    else {
      this.#start?.abort();
      this.#session = undefined;
      this.#isLost = isContext;
    }
    if (isPast) {
      this.#start = undefined;
      this.#isLost = false;
      return this.#begin();
    }
    this.#shell.show(isContext ? 'lost' : 'failure');
    this.#awaited.reject(error);
    this.#notify('error', { error });
  }

  /** Shows the smoke again if the browser restores the context. */
  #awaitContext(session: Session): void {
    this.#isLost = true;
    const end = session.stage.on('frame', () => {
      end();
      if (this.#session !== session) return;
      this.#isLost = false;
      session.catchUp();
      this.#shell.show('smoke');
      this.#notify('ready', { thread: session.stage.thread });
    });
  }

  #end(): void {
    this.#stopWaiting?.();
    this.#stopWaiting = undefined;
    this.#start?.abort();
    this.#start = this.#session = undefined;
    this.#isConsented = this.#isLost = false;
    this.#shell.show('poster');
    this.#awaited.reject(new ContextError('The element was removed. It restarts when it is inserted again.'));
    this.#awaited = new Deferred();
  }

  /** Pauses or plays for the user. An attribute of the page stays, so that a morph of the page changes nothing. */
  #hold(isHeld: boolean): void {
    this.#isHeld = isHeld;
    this.#isConsented ||= !isHeld;
    if (isHeld && !this.paused) {
      this.paused = true;
      this.#setsPaused = true;
    } else if (!isHeld && this.#setsPaused) this.paused = false;
    this.#session?.setUserPaused(isHeld);
  }

  #notify<Name extends keyof SmokeEvents>(name: Name, detail: SmokeEvents[Name]): void {
    this.dispatchEvent(new CustomEvent(name, { detail }));
  }

  static {
    for (const name of HANDED_ON) {
      Object.defineProperty(this.prototype, name, {
        configurable: true,
        writable: true,
        value: async function (this: CartoonSmokeElement, ...given: unknown[]) {
          if (isInert()) return undefined;
          const { stage } = await this.#demand();
          return (stage[name] as (...given: unknown[]) => Promise<unknown>)(...given);
        },
      });
    }
  }
}
