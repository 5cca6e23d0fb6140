/** The smoke of all calls on one canvas: one stage, whose emissions and obstacles the calls share. */
import { ContextError, LoadError } from '../../base/errors.ts';
import type { Value, Values } from '../../parameters/parameter.ts';
import { defaults, differing } from '../../parameters/values.ts';
import { asSmokeError } from '../asSmokeError.ts';
import type { PlaneRectangle } from '../plane.ts';
import { sizeOf } from '../size.ts';
import type { RemoteStage } from '../../stage/remote/contract.ts';
import { openStage } from '../../stage/remote/openStage.ts';
import { Alarm } from './alarm.ts';
import { emissionsOf, flowsAround } from './effects.ts';
import { AIR, alongLine, emissionOptions, type Emission } from './emission.ts';
import { follow } from './follow.ts';
import { hexOf, lookOf, Tints } from './look.ts';
import { Obstacles } from './obstacles.ts';
import type { Effect, PuffOptions } from './options.ts';
import { Overlay, OwnCanvas, type Sheet, topLayerOf } from './overlay.ts';
import { Placement } from './placement.ts';
import { Scrolling } from './scrolling.ts';
import { sourceOf, type Source } from './target.ts';
import { wordOf, Words, type Word } from './words.ts';

/** Time until a waiting call tries again, milliseconds. */
const RETRY_MS = 80;
/** Emissions of all calls: the limit of the stage. */
const MAX_EMISSIONS = 384;
/** The engine ends this long after the last particle, milliseconds. */
const IDLE_MS = 10_000;
/** The worker then presents the empty picture before it ends, milliseconds. */
const GRACE_MS = 1000;
/** Simulated seconds after which the smoke of `warmUp` is large enough to run all shaders. */
const WARM_UP = 0.2;
/** Time without frames of the page after which it counts as hidden, milliseconds. */
const HIDDEN_MS = 200;

/** A call with valid options. */
export interface PuffCall extends PuffOptions {
  readonly effect: Effect;
  readonly source: Source;
  /** Aborted by `clear`. */
  readonly signal: AbortSignal;
  /** Called when the smoke begins. */
  readonly onBegin: () => void;
}

interface Waiting {
  readonly call: PuffCall;
  readonly look: Values | undefined;
  readonly color: string | undefined;
  /** Of the effect `form`. */
  readonly word?: Word;
  readonly resolve: () => void;
  readonly reject: (error: Error) => void;
}

/** A call whose emissions are on the way to the stage. */
interface Starting extends Waiting {
  readonly place: PlaneRectangle;
  readonly tint: number;
  readonly emissions: readonly Emission[];
}

interface Running extends Starting {
  /** Simulated time at which the last particle is gone. */
  readonly end: number;
  readonly stopFollowing: readonly (() => void)[];
}

type Changes = Record<string, Value>;

export interface EngineOptions {
  /** A canvas of the page. Default: one over the page. */
  canvas?: HTMLCanvasElement;
  /** Called when the engine has ended: after a failure, or because it was not used. */
  onEnd: () => void;
}

/** @throws LoadError, UnsupportedError or ContextError when smoke cannot be drawn */
export async function openEngine({ canvas, onEnd }: EngineOptions): Promise<Engine> {
  const look = await lookOf();
  const sheet = canvas ? new OwnCanvas(canvas) : new Overlay();
  try {
    const values = { ...defaults(), ...AIR, ...look };
    const size = sizeOf(sheet.canvas);
    const options = {
      values,
      ...size,
      quality: 'auto',
      background: false,
      historyBytes: 0,
      graceMs: GRACE_MS,
    } as const;
    const stage = await openStage(() => sheet.makeCanvas(), options);
    return new Engine(stage, sheet, new Placement(sheet, size), values, look, onEnd);
  } catch (error) {
    sheet.remove();
    throw asSmokeError(error);
  }
}

export class Engine {
  private readonly stage: RemoteStage;
  private readonly sheet: Sheet;
  private readonly placement: Placement;
  private readonly usualLook: Values;
  private readonly onEnd: () => void;
  private readonly scrolling: Scrolling;
  private readonly obstacles = new Obstacles();
  private readonly words = new Words();
  private readonly tints = new Tints();
  private waiting: Waiting[] = [];
  private starting: Starting[] = [];
  private running: Running[] = [];
  private look: Values;
  /** The values of the stage. */
  private sent: Values;
  private isStarting = false;
  private isKept = false;
  private hasEnded = false;
  /** Ends the listeners of visible smoke; set while there is some. */
  private playing: AbortController | undefined;
  private idle: ReturnType<typeof setTimeout> | undefined;
  /** Waits for the next end of a call. */
  private alarm: Alarm | undefined;

  constructor(stage: RemoteStage, sheet: Sheet, placement: Placement, values: Values, look: Values, onEnd: () => void) {
    this.stage = stage;
    this.sheet = sheet;
    this.placement = placement;
    this.scrolling = new Scrolling(sheet);
    this.sent = values;
    this.usualLook = this.look = look;
    this.onEnd = onEnd;
    stage.on('error', (error) => {
      // The stage goes on without what could not be fetched.
      if (!(error instanceof LoadError)) this.fail(error);
    });
    this.scheduleDisposal();
  }

  /** Keeps everything while there is no smoke. */
  keep(): void {
    this.isKept = true;
    clearTimeout(this.idle);
  }

  /** Draws some smoke on the hidden canvas, so that the first call does not wait for shaders. */
  async warmUp(): Promise<void> {
    if (this.playing || this.isStarting) return;
    this.isStarting = true;
    const { style } = this.sheet.canvas;
    const before: [string, string] = [style.getPropertyValue('visibility'), style.getPropertyPriority('visibility')];
    style.setProperty('visibility', 'hidden', 'important');
    try {
      await this.drawOnce({
        effect: 'poof',
        source: sourceOf(),
        signal: AbortSignal.abort(),
        onBegin: () => undefined,
      });
    } finally {
      await pictureShown();
      style.setProperty('visibility', ...before);
      this.isStarting = false;
    }
    if (this.waiting.length > 0) await this.startAll();
  }

  /** Resolves when the last particle of the call is gone, or after `clear`. */
  async play(call: PuffCall): Promise<void> {
    clearTimeout(this.idle);
    const look = call.preset === undefined ? undefined : await this.orEnd(lookOf(call.preset));
    const color = call.color === undefined ? undefined : hexOf(call.color, call.source.inside);
    const word = call.effect === 'form' ? await this.orEnd(wordOf(call.text, call.source)) : undefined;
    if (call.signal.aborted) return this.playing ? undefined : this.scheduleDisposal();
    if (this.hasEnded) throw new ContextError('The smoke has just ended. Call puff() again.');
    await new Promise<void>((resolve, reject) => {
      this.waiting.push({ call, look, color, word, resolve, reject });
      if (!this.isStarting) this.startAll().catch((error) => this.fail(error));
    });
  }

  /** Removes all smoke. */
  clear(): void {
    for (const each of this.removeAll()) each.resolve();
    if (this.playing) this.empty();
  }

  dispose(): void {
    if (this.hasEnded) return;
    this.hasEnded = true;
    clearTimeout(this.idle);
    this.playing?.abort();
    for (const each of this.removeAll()) each.resolve();
    this.stage.dispose().catch(() => undefined);
    this.sheet.remove();
    this.onEnd();
  }

  private fail(error: unknown): void {
    if (this.hasEnded) return;
    const failure = asSmokeError(error);
    for (const each of this.removeAll()) each.reject(failure);
    this.dispose();
  }

  private removeAll(): Waiting[] {
    for (const { stopFollowing } of this.running) for (const stop of stopFollowing) stop();
    return [...this.waiting.splice(0), ...this.starting.splice(0), ...this.running.splice(0)];
  }

  private async drawOnce(call: PuffCall): Promise<void> {
    const each = { call, look: undefined, color: undefined, resolve: () => undefined, reject: () => undefined };
    const changes: Changes = {};
    this.place(true, [each], changes);
    const placed = this.placed(each, changes, 0);
    await Promise.all([this.set(changes), this.emit(placed), this.stage.seek(WARM_UP)]);
    await this.reset();
  }

  /** What a call needs; without it, the call ends. */
  private async orEnd<Result>(needed: Promise<Result>): Promise<Result> {
    try {
      return await needed;
    } catch (error) {
      if (!this.playing) this.scheduleDisposal();
      throw error;
    }
  }

  private async startAll(): Promise<void> {
    this.isStarting = true;
    try {
      // The calls of one task start together.
      await Promise.resolve();
      while (this.waiting.length > 0 && !this.hasEnded) await this.startSome();
    } finally {
      this.isStarting = false;
      this.alarm?.wake();
    }
  }

  /** Starts as many of the waiting calls as there are emissions for. */
  private async startSome(): Promise<void> {
    if (this.playing && this.placement.isFar) this.restart();
    const isFirst = !this.playing;
    const taken = this.dequeue();
    if (taken.length === 0) return delay(RETRY_MS);
    const changes: Changes = isFirst ? this.release() : {};
    const hasWords = taken.some(({ word }) => word);
    const begun = isFirst || !hasWords ? 0 : (await this.stage.stats()).time;
    this.place(isFirst, taken, changes);
    this.starting = taken.map((each) => this.placed(each, changes, begun));
    const sent = isFirst ? this.begin(taken[0].call, changes) : this.set(changes);
    const emitted = Promise.all(this.starting.map((each) => this.emit(each)));
    // Last, so that the first emissions are in step 0.
    if (isFirst) this.beginPlay();
    const [{ time }, numbers] = await Promise.all([this.stage.stats(), emitted, sent]);
    this.starting.splice(0).forEach((each, index) => this.run(each, numbers[index], time));
  }

  private dequeue(): Waiting[] {
    let free = MAX_EMISSIONS - this.running.reduce((sum, { emissions }) => sum + emissions.length, 0);
    const taken: Waiting[] = [];
    for (let [next] = this.waiting; next; [next] = this.waiting) {
      free -= emissionsOf(next.call.effect, { halfWidth: 0, halfHeight: 0 }, next.call).length;
      if (free < 0) break;
      taken.push(next);
      this.waiting.shift();
    }
    return taken;
  }

  /** Moves the canvas to what is visible, and gives it the look and the layer of the latest call that asks for one. */
  private place(isFirst: boolean, taken: readonly Waiting[], changes: Changes): void {
    const layer = taken.findLast((each) => isLayered(each))?.call.layer;
    const host = layer === 'below' ? undefined : this.hostOf([...this.running, ...taken]);
    if (isFirst || host !== this.sheet.host || host || this.placement.isOff) this.move(isFirst, host);
    Object.assign(changes, this.placement.values);
    const look = taken.findLast((each) => each.look)?.look ?? (isFirst ? this.usualLook : this.look);
    if (look !== this.look) Object.assign(changes, look);
    this.look = look;
    const { call } = taken.findLast((each) => isLayered(each)) ?? taken.at(-1)!;
    if (isFirst || isLayered({ call })) this.sheet.style(call.layer, call.zIndex);
  }

  /** The element of the top layer that the smoke of these calls leaves; that of the latest one which has one. */
  private hostOf(calls: readonly Waiting[]): Element | undefined {
    return this.sheet.followsWindow ? calls.map(({ call }) => topLayerOf(call.source)).findLast(Boolean) : undefined;
  }

  /** A target has entered the top layer. */
  private moveToTop(): void {
    const host = this.hostOf(this.running);
    if (!host) return;
    this.move(false, host);
    this.set(this.placement.values).catch(() => undefined);
  }

  private move(isEmpty: boolean, host: Element | undefined): void {
    const before = this.placement.canvasSize;
    this.placement.move(isEmpty, host);
    const { width, height, pixelRatio } = this.placement.canvasSize;
    const isSame = width === before.width && height === before.height && pixelRatio === before.pixelRatio;
    if (!isSame) this.stage.resize(width, height, pixelRatio).catch(() => undefined);
  }

  /** Sends the values that differ from those of the stage: long messages take time of both threads. */
  private set(values: Values): Promise<void> {
    const changes = differing(this.sent, values);
    if (Object.keys(changes).length === 0) return Promise.resolve();
    this.sent = { ...this.sent, ...changes };
    return this.stage.set(changes);
  }

  /**
   * @param changes receives the obstacle, the shape and the tint
   * @param time simulated
   */
  private placed(each: Waiting, changes: Changes, time: number): Starting {
    const { call, word } = each;
    const box = this.placement.clipped(call.source.box()!);
    const place = this.placement.rectangleOf(box);
    if (flowsAround(call.effect) && box.width > 0)
      Object.assign(changes, this.obstacles.claim(call, place, this.placement.plane));
    if (word) Object.assign(changes, this.words.claim(call, word, place, this.placement.top, time));
    const tint = this.tints.acquireTint(each.color, changes);
    const emissions = emissionsOf(call.effect, place, { ...call, text: word?.text });
    return { ...each, place, tint, emissions };
  }

  /** @returns the number of its first emission */
  private async emit({ emissions, place, tint }: Starting): Promise<number> {
    const all = emissions.map((each) => this.stage.emit(emissionOptions(each, place.middle, tint)));
    return (await Promise.all(all))[0];
  }

  /** Starts the simulation again, so that a seed decides all of its smoke. */
  private async begin({ seed = Math.floor(Math.random() * 2 ** 32) }: PuffCall, changes: Changes): Promise<void> {
    // Only another seed starts it by itself.
    const isSame = seed === this.sent.seed;
    await Promise.all([this.set({ ...changes, seed }), isSame && this.stage.restart()]);
  }

  private run(each: Starting, emission: number, start: number): void {
    const { call } = each;
    const stopFollowing = [this.scrolling.enter(call.source.inside)];
    if (call.effect === 'trail') stopFollowing.push(this.moveWithSource(each, emission));
    const life = Math.max(...each.emissions.map(lifeOf));
    this.running.push({ ...each, end: start + life, stopFollowing });
    this.alarm?.wake();
    call.onBegin();
  }

  private moveWithSource({ call, place }: Starting, emission: number): () => void {
    return follow(this.placement, call.source, place.middle, async (from, to) => {
      this.moveVisible();
      await this.stage.changeEmission(emission, alongLine(from, to));
    });
  }

  private beginPlay(): void {
    this.playing = new AbortController();
    const { signal } = this.playing;
    this.stage.play().catch((error) => this.fail(error));
    addEventListener('keydown', ({ key }) => key === 'Escape' && this.clear(), { signal, capture: true });
    addEventListener('resize', () => this.moveVisible(), { signal });
    for (const type of ['toggle', 'fullscreenchange']) {
      document.addEventListener(type, () => this.moveToTop(), { signal, capture: true });
    }
    this.watch(signal).catch((error) => this.fail(error));
  }

  private moveVisible(): void {
    if (!this.placement.isOff) return;
    if (this.placement.isFar) return this.clear();
    this.move(false, this.sheet.host);
    this.set(this.placement.values).catch(() => undefined);
  }

  /** Ends calls whose smoke is gone. */
  private async watch(signal: AbortSignal): Promise<void> {
    const alarm = (this.alarm = new Alarm(() => this.stage.stats()));
    signal.addEventListener('abort', () => alarm.wake());
    while (!signal.aborted) {
      if (this.running.length === 0 && !this.isStarting) return this.endPlay();
      const stats = await alarm.wait(Math.min(...this.running.map(({ end }) => end)));
      // Particles that wait for others to die live longer.
      if (signal.aborted || !stats || stats.waiting > 0) continue;
      const over = this.running.filter(({ end }) => end < stats.time);
      this.running = this.running.filter(({ end }) => end >= stats.time);
      for (const each of over) this.end(each);
    }
  }

  private end(each: Running): void {
    for (const stop of each.stopFollowing) stop();
    this.set(this.release(each.call)).catch(() => undefined);
    each.resolve();
  }

  /** Ends the visible smoke, whose place or time the simulation cannot reach any more. */
  private restart(): void {
    for (const each of this.running.splice(0)) this.end(each);
    this.empty();
  }

  private empty(): void {
    this.endPlay();
    this.reset().catch(() => undefined);
  }

  /** Empties the paused stage. */
  private async reset(): Promise<void> {
    await Promise.all([this.set(this.release()), this.stage.restart()]);
  }

  /** Values without the obstacles and the shapes of a call; of all calls without one. */
  private release(call?: PuffCall): Changes {
    return { ...this.obstacles.release(call), ...this.words.release(call) };
  }

  private endPlay(): void {
    this.playing?.abort();
    this.playing = undefined;
    this.stage.pause().catch(() => undefined);
    this.scheduleDisposal();
  }

  /** Ends the engine if it is not used. */
  private scheduleDisposal(): void {
    clearTimeout(this.idle);
    if (!this.isKept) this.idle = setTimeout(() => this.dispose(), IDLE_MS);
  }
}

function isLayered({ call }: Pick<Waiting, 'call'>): boolean {
  return call.layer !== undefined || call.zIndex !== undefined;
}

/** Seconds from the start of an emission until its last particle is gone. */
function lifeOf({ delay: wait, duration, life, lifeVariation }: Emission): number {
  return wait + duration + life * (1 + lifeVariation);
}

/** Resolves when the page has the picture that the worker drew last: at the second frame, or soon in a hidden tab. */
function pictureShown(): Promise<void> {
  return new Promise((resolve) => {
    setTimeout(resolve, HIDDEN_MS);
    requestAnimationFrame(() => requestAnimationFrame(() => resolve()));
  });
}

function delay(milliseconds: number): Promise<void> {
  return new Promise((resolve) => setTimeout(resolve, milliseconds));
}
