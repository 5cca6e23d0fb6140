/** The large part of an element, fetched when it comes near the viewport. It connects the attributes with the stage. */
import type { Fault } from '../../renderer/gpu/faults.ts';
import { LoadError, ParameterError, type SmokeError } from '../../base/errors.ts';
import { notice, type Notice } from '../../parameters/notice.ts';
import type { Values } from '../../parameters/parameter.ts';
import type { RemoteStage } from '../../stage/remote/contract.ts';
import { openStage } from '../../stage/remote/openStage.ts';
import { asSmokeError } from '../asSmokeError.ts';
import { change } from './change.ts';
import { CssColors } from './cssColors.ts';
import type { SmokeEvents } from './events.ts';
import { sizeOf, watchSize } from '../size.ts';
import type { OnPage } from './layout/onPage.ts';
import { part } from './parts.ts';
import { calm, Playback } from './playback.ts';
import { FLAGS, LABELS, OF_PAGE } from './attributes/properties.ts';
import type { PointerControls } from './pointers.ts';
import { ignoreRejection } from './deferred.ts';
import type { Shell } from './shell/shell.ts';
import { parseAttributes, type ParsedAttributes } from './attributes/parsedAttributes.ts';

/** With reduced motion a still frame is shown. After this time the smoke has filled its column. */
const STILL_SECONDS = 4;

/** Interface of the element to its session. */
export interface SessionOwner {
  readonly element: HTMLElement;
  readonly shell: Shell;
  /** Whether the user has paused. */
  readonly isHeld: boolean;
  notify<Name extends keyof SmokeEvents>(name: Name, detail: SmokeEvents[Name]): void;
  /** Called when the smoke fails. */
  fail(error: SmokeError): void;
  readonly fault: Fault | undefined;
}

/**
 * Opens the smoke that the attributes describe, up to its first frame.
 * @param signal cancels it at any time
 * @throws SmokeError with the reason of a failure; the caller must then abort `signal`. Throws the reason of `signal`
 * when that aborts
 */
export async function openSession(owner: SessionOwner, signal: AbortSignal): Promise<Session> {
  const { element, shell } = owner;
  const colors = new CssColors(shell.container.getRootNode());
  signal.addEventListener('abort', () => colors.dispose());
  const attributes = await parseAttributes(element, colors.values());
  signal.throwIfAborted();
  const stage = await openStage(() => shell.makeCanvas(element.getAttribute('alt')), {
    values: attributes.values,
    ...sizeOf(shell.container),
    quality: 'auto',
    background: !element.hasAttribute('transparent'),
    thread: threadOf(element),
    fault: owner.fault,
    signal,
  });
  const session = new Session(owner, stage, attributes, colors);
  const end = () => session.dispose();
  signal.addEventListener('abort', end);
  if (signal.aborted) end();
  await session.begin();
  signal.throwIfAborted();
  return session;
}

/** The running smoke of an element. */
export class Session {
  readonly stage: RemoteStage;
  private readonly owner: SessionOwner;
  private readonly playback: Playback;
  private readonly colors: CssColors;
  private readonly endings: (() => void)[];
  private attributes: ParsedAttributes;
  /** Set once the element was interactive. */
  private pointers: PointerControls | undefined;
  /** Set while elements of the page are in the smoke. */
  private onPage: OnPage | undefined;
  private isBehind = false;
  private isFollowing = false;
  private isDisposed = false;

  constructor(owner: SessionOwner, stage: RemoteStage, attributes: ParsedAttributes, colors: CssColors) {
    const { element, shell } = owner;
    this.owner = owner;
    this.stage = stage;
    this.attributes = attributes;
    this.colors = colors;
    colors.watch(() => this.requestValues());
    const isPaused = element.hasAttribute('paused');
    this.playback = new Playback(stage, isPaused, owner.isHeld, attributes.isPaused, (state) =>
      this.showPlaying(state),
    );
    this.endings = [
      watchSize(shell.container, ({ width, height, pixelRatio }) => {
        ignoreRejection(stage.resize(width, height, pixelRatio));
        // Colours that change while the element has no box have no transition.
        this.requestValues();
      }),
      stage.on('error', (error) => {
        if (error instanceof LoadError) this.notifyMissing(error);
        else owner.fail(asSmokeError(error));
      }),
    ];
  }

  /** Seeks to the start, adds the page's elements, and starts playback if requested. */
  async begin(): Promise<void> {
    await this.stage.ready;
    await this.lookAtPage();
    const notices = await lead(this.stage, this.attributes);
    await this.interact();
    if (this.isDisposed) return;
    this.playback.begin();
    this.notify([...this.attributes.notices, ...notices]);
  }

  get isPlaying(): boolean {
    return this.playback.isPlaying;
  }

  /** Applies a changed attribute that is not a parameter. */
  applyAttribute(name: string): void {
    const { element, shell } = this.owner;
    const isOn = element.hasAttribute(name);
    if (name === 'alt') shell.describe(element.getAttribute(name));
    else if (LABELS.includes(name)) shell.nameButton();
    else if (name === 'paused') this.playback.set(isOn);
    else if (name === 'transparent') ignoreRejection(this.stage.setBackground(!isOn));
    else if (name === 'interactive') ignoreRejection(this.interact());
    else if (OF_PAGE.includes(name)) this.lookAtPage().catch((error) => this.notifyMissing(error));
  }

  /** Pauses by a user action, or starts playback despite reduced motion and the attribute `paused`. */
  setUserPaused(isHeld: boolean): void {
    this.playback.setUserPaused(isHeld);
  }

  /** Plays although the share link pauses. */
  overrideLink(): void {
    this.playback.setLinkPaused(false);
  }

  /** Applies changed parameters. Changes of the same task are merged. */
  requestValues(): void {
    this.isBehind = true;
    if (!this.isFollowing) ignoreRejection(this.applyRequestedValues());
  }

  /** Applies attributes that changed before the session was ready. */
  catchUp(): void {
    for (const name of [...FLAGS, ...LABELS, 'alt', 'collide']) this.applyAttribute(name);
    this.requestValues();
  }

  dispose(): void {
    if (this.isDisposed) return;
    this.isDisposed = true;
    this.playback.dispose();
    this.onPage?.dispose();
    this.pointers?.toggle(false);
    for (const end of this.endings) end();
    ignoreRejection(this.stage.dispose());
  }

  private async applyRequestedValues(): Promise<void> {
    this.isFollowing = true;
    while (this.isBehind && !this.isDisposed) {
      await Promise.resolve();
      this.isBehind = false;
      const attributes = await parseAttributes(this.owner.element, this.colors.values()).catch((error: Error) =>
        this.notifyMissing(error),
      );
      if (attributes) await this.applyAttributes(attributes);
    }
    this.isFollowing = false;
  }

  private async applyAttributes(after: ParsedAttributes): Promise<void> {
    const before = this.attributes;
    this.attributes = after;
    if (after.isPaused !== before.isPaused) this.playback.setLinkPaused(after.isPaused);
    this.notify(
      after.notices.filter(({ message }) => !before.notices.some((notified) => notified.message === message)),
    );
    try {
      // A link without a moment changes the running smoke.
      const isOtherMoment = after.link !== before.link && (after.take ?? startOf(after)) !== undefined;
      if (isOtherMoment || after.values.scene !== before.values.scene) {
        await this.stage.enter(after.values);
        await this.onPage?.beginAnew();
        this.notify(await lead(this.stage, after));
      } else await this.changeValues(before.values, after.values);
    } catch (error) {
      if (error instanceof ParameterError) this.notify([noticeOf(error)]);
      else if (!this.isDisposed) this.owner.fail(asSmokeError(error));
    }
  }

  /** Values that the page's elements control stay as they are; the elements are measured again afterwards. */
  private async changeValues(before: Values, after: Values): Promise<void> {
    const { onPage } = this;
    const own = (values: Values) => onPage?.without(values) ?? values;
    await change(this.stage, own(before), own(after));
    onPage?.measure();
  }

  /** Enables or disables dragging and orbiting. */
  private async interact(): Promise<void> {
    const isWanted = () => this.owner.element.hasAttribute('interactive');
    if (!this.isDisposed && isWanted() && !this.pointers) {
      const code = await part('pointers').catch((error: Error) => this.notifyMissing(error));
      if (code) this.pointers ??= new code.PointerControls(this.stage, this.owner.shell);
    }
    if (!this.isDisposed) this.pointers?.toggle(isWanted());
  }

  /** Adds, updates or removes the page's elements in the smoke. */
  private async lookAtPage(): Promise<void> {
    const { element, shell } = this.owner;
    const hasThings = () => ['collide', 'emit-from'].some((name) => element.hasAttribute(name));
    if (!hasThings()) return this.leavePage();
    if (this.onPage) return this.onPage.measure();
    const { OnPage } = await part('onPage');
    if (this.isDisposed || this.onPage || !hasThings()) return;
    const values = () => this.attributes.values;
    this.onPage = new OnPage(this.stage, {
      element,
      container: shell.container,
      values,
      notify: (notices) => this.notify(notices),
    });
    await this.onPage.begin();
  }

  private leavePage(): void {
    this.onPage?.dispose();
    this.onPage = undefined;
  }

  private showPlaying({ isPlaying, isStill }: { isPlaying: boolean; isStill: boolean }): void {
    this.owner.shell.showPlaying(isPlaying, isStill);
    this.owner.notify('statechange', { playing: isPlaying, notices: [] });
  }

  /** Reports an optional resource that could not be fetched. The stage reports all other errors. */
  private notifyMissing(error: Error): void {
    if (error instanceof LoadError) this.notify([notice('malformed', '', '', () => error.message)]);
  }

  private notify(notices: readonly Notice[]): void {
    if (notices.length > 0 && !this.isDisposed) this.owner.notify('statechange', { playing: this.isPlaying, notices });
  }
}

/** Seeks to the shared moment, to the requested start, or to the still frame for reduced motion. */
async function lead(stage: RemoteStage, attributes: ParsedAttributes): Promise<readonly Notice[]> {
  const { take, start, values } = attributes;
  if (take) return (await part('moment')).goToMoment(stage, take, start, values);
  const seconds = startOf(attributes);
  if (seconds) await stage.seek(seconds);
  return [];
}

function startOf({ start }: ParsedAttributes): number | undefined {
  return start ?? (calm().matches ? STILL_SECONDS : undefined);
}

/**
 * Converts an error of the simulator for values that the table accepts, for example a value that requires another one.
 */
function noticeOf({ key, value, message }: ParameterError): Notice {
  return notice('malformed', key, String(value), () => message);
}

function threadOf(element: Element): 'auto' | 'main' | 'worker' {
  const thread = element.getAttribute('thread');
  return thread === 'main' || thread === 'worker' ? thread : 'auto';
}
