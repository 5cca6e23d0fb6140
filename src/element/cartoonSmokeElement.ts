import { ContextError, type SmokeError } from '../preset/errors.ts';
import type { Fault } from '../device/faults.ts';
import { asSmokeError } from './asSmokeError.ts';
import { Deferred } from './deferred.ts';
import type { RemoteStage } from '../remote/contract.ts';
import type { SmokeEvents } from './events.ts';
import { HANDED_ON, type HandedOn } from './methods.ts';
import { keyOfAttribute } from './attributes/names.ts';
import { whenNear } from '../page/visibility.ts';
import { fetchAhead, part } from './parts.ts';
import { defineProperties, FLAGS, takeUpEarlier, TEXTS } from './attributes/properties.ts';
import { ignoreRejection } from './ignoreRejection.ts';
import type { Session } from './session.ts';
import { Shell } from './shell/shell.ts';
import { version } from './version.ts';

/** On a server there are no elements; importing this must not fail there. */
const Base = globalThis.HTMLElement ?? (Object as unknown as typeof HTMLElement);

/** Attributes that say what the smoke is, beside the parameters. */
const PARSED_TOGETHER: readonly string[] = ['preset', 'src'];

// eslint-disable-next-line typescript/no-unsafe-declaration-merging -- the methods and properties are made from tables below
export interface CartoonSmokeElement extends HandedOn {
  paused: boolean;
  transparent: boolean;
  interactive: boolean;
  preset: string | undefined;
  src: string | undefined;
  start: string | undefined;
  alt: string | undefined;
  labelPlay: string | undefined;
  labelPause: string | undefined;
  thread: string | undefined;
  loading: string | undefined;
  collide: string | undefined;
  emitFrom: string | undefined;
  emitOn: string | undefined;
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

export interface ElementOptions {
  /** What goes wrong, to try how a page copes. What is built does not heed it. */
  fault?: Fault;
}

/**
 * `<cartoon-smoke preset="lamp" emission-rate="60" paused>`: smoke on any page. Every parameter is an attribute and a
 * property; the methods of RemoteStage are its own, and wait until the smoke stands. Nothing heavy is fetched until it
 * nears the viewport, unless `loading="eager"` says so or a method is called.
 */
export class CartoonSmokeElement extends Base {
  /** Of the package: with several on one page, `customElements.get('cartoon-smoke').version` is the one in use. */
  static readonly version: string = version;

  static get observedAttributes(): string[] {
    return [...FLAGS, ...TEXTS, ...keyOfAttribute.keys()];
  }

  readonly #fault: Fault | undefined;
  readonly #shell = new Shell(this.attachShadow({ mode: 'open' }));
  #stopWaiting: (() => void) | undefined;
  /** Ends what was started, on its way or come to stand; aborted when it has failed. */
  #start: AbortController | undefined;
  /** Attributes that have changed since it was started and before it stood. */
  readonly #changed = new Set<string>();
  /** Whether a person asked for motion here, though the system may ask for less. */
  #isConsented = false;
  /** Once its first picture stands. */
  #session: Session | undefined;
  #awaited = new Deferred<Session>();

  /** @param options for those who make an element by hand; @see ElementOptions */
  constructor({ fault }: ElementOptions = {}) {
    super();
    this.#fault = fault;
    this.#shell.button.addEventListener('click', (event) => {
      // It may stand in a link of the page.
      event.preventDefault();
      if (this.playing) return this.pause();
      this.paused = false;
      this.#consent();
    });
  }

  /** Settled when the first picture stands; rejects with the error that is told when there will be none. */
  get ready(): Promise<void> {
    const ready = this.#awaited.promise.then(() => undefined);
    ignoreRejection(ready);
    return ready;
  }

  /** The stage, for its events. Who asks does not wait for the viewport; rejects with the error that is told. */
  get stage(): Promise<RemoteStage> {
    const stage = this.#demand().then((session) => session.stage);
    ignoreRejection(stage);
    return stage;
  }

  /** Whether the smoke moves. Out of sight it rests and counts as moving. */
  get playing(): boolean {
    return this.#session?.isPlaying ?? false;
  }

  play(): void {
    this.paused = false;
    if (navigator.userActivation?.isActive) this.#consent();
  }

  pause(): void {
    this.paused = true;
  }

  connectedCallback(): void {
    takeUpEarlier(this);
    this.#waitOrStart();
  }

  disconnectedCallback(): void {
    // Whoever moves it puts it back in the same task.
    queueMicrotask(() => this.isConnected || this.#end());
  }

  /** Moving by moveBefore leaves everything as it is. */
  connectedMoveCallback(): void {}

  adoptedCallback(): void {
    this.#shell.dress();
  }

  attributeChangedCallback(name: string, before: string | null, after: string | null): void {
    if (before === after) return;
    if (name === 'loading') this.#waitOrStart();
    else if (this.#hasFailed) this.#tryAnew(name);
    else if (!this.#session) this.#changed.add(name);
    else if (PARSED_TOGETHER.includes(name) || keyOfAttribute.has(name)) this.#session.follow();
    else this.#session.takeUp(name);
  }

  /** There is no smoke, or no more; nothing is tried again until the page asks for other smoke or puts the element back. */
  get #hasFailed(): boolean {
    return this.#start?.signal.aborted ?? false;
  }

  /** @param name of the attribute that has changed */
  #tryAnew(name: string): void {
    if (!PARSED_TOGETHER.includes(name)) return;
    this.#end();
    this.#waitOrStart();
  }

  /** Starts, if that has not happened yet, and gives the smoke once it stands. */
  #demand(): Promise<Session> {
    if (this.isConnected) this.#begin();
    return this.#awaited.promise;
  }

  #waitOrStart(): void {
    if (!this.isConnected || this.#start) return;
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
      (session) => this.#stand(session, signal),
      (error) => signal.aborted || this.#fail(asSmokeError(error)),
    );
  }

  async #open(signal: AbortSignal): Promise<Session> {
    fetchAhead(this);
    const { openSession } = await part('session');
    signal.throwIfAborted();
    return openSession(
      {
        element: this,
        shell: this.#shell,
        notify: (name, detail) => this.#notify(name, detail),
        fail: (error) => this.#fail(error),
        fault: this.#fault,
      },
      signal,
    );
  }

  #stand(session: Session, signal: AbortSignal): void {
    if (signal.aborted) return;
    this.#session = session;
    if (this.#changed.size > 0) session.catchUp();
    if (this.#isConsented) session.consent();
    this.#shell.show('smoke');
    this.#awaited.resolve(session);
    this.#notify('ready', { thread: session.stage.thread });
  }

  #fail(error: SmokeError): void {
    // Of what failed on its way the page may want no more by now.
    const isPast = !this.#session && PARSED_TOGETHER.some((name) => this.#changed.has(name));
    this.#start?.abort();
    this.#session = undefined;
    if (isPast) {
      this.#start = undefined;
      return this.#begin();
    }
    this.#shell.show('failure');
    this.#awaited.reject(error);
    this.#notify('error', { error });
  }

  #end(): void {
    this.#stopWaiting?.();
    this.#stopWaiting = undefined;
    this.#start?.abort();
    this.#start = this.#session = undefined;
    this.#isConsented = false;
    this.#shell.show('poster');
    this.#awaited.reject(new ContextError('The element was removed. It restarts when it is inserted again.'));
    this.#awaited = new Deferred();
  }

  #consent(): void {
    this.#isConsented = true;
    this.#session?.consent();
  }

  #notify<Name extends keyof SmokeEvents>(name: Name, detail: SmokeEvents[Name]): void {
    this.dispatchEvent(new CustomEvent(name, { detail }));
  }

  static {
    defineProperties(this.prototype);
    for (const name of HANDED_ON) {
      Object.defineProperty(this.prototype, name, {
        configurable: true,
        writable: true,
        value: async function (this: CartoonSmokeElement, ...given: unknown[]) {
          const { stage } = await this.#demand();
          return (stage[name] as (...given: unknown[]) => Promise<unknown>)(...given);
        },
      });
    }
  }
}
