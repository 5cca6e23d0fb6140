/** Warnings about `CartoonSmoke`. Importing this module makes `CartoonSmoke.create` return smoke that warns. */
import type { Object3D } from 'three';
import { CartoonSmoke } from './cartoonSmoke.ts';
import { warnOfError, warnOnce, warnUnawaited } from '../base/warn.ts';

const ABOUT = 'CartoonSmoke';
/** Consecutive frames after which a mistake is reported. Correct programs have some, for example while a page loads. */
const FRAMES = 300;
/** Consecutive calls of `update` with implausible seconds after which they are reported. */
const CALLS = 10;
/** Smokes at a time above which some were probably forgotten. */
const MANY = 16;
/** What programs use of an object of a scene, besides its methods. */
const PROPERTIES = [
  'isObject3D',
  'position',
  'rotation',
  'quaternion',
  'scale',
  'visible',
  'parent',
  'children',
  'stats',
];

let alive = 0;
const create = CartoonSmoke.create.bind(CartoonSmoke);
CartoonSmoke.create = (options) =>
  warnUnawaited('CartoonSmoke.create()', create(options).then(watch), [
    ...PROPERTIES,
    ...methodsOf(CartoonSmoke.prototype),
  ]);

/** Names of the methods of a class and of those that it extends. */
function methodsOf(prototype: object): string[] {
  if (prototype === Object.prototype) return [];
  return [...Object.getOwnPropertyNames(prototype), ...methodsOf(Object.getPrototypeOf(prototype) as object)];
}

/** Replaces methods of one smoke. */
function watch(smoke: CartoonSmoke): CartoonSmoke {
  const frames = new Frames(smoke);
  const update = smoke.update.bind(smoke);
  const step = smoke.step.bind(smoke);
  const updateMatrixWorld = smoke.updateMatrixWorld.bind(smoke);
  smoke.update = (seconds) => {
    frames.update(seconds);
    update(seconds);
  };
  smoke.step = (count) => {
    frames.isUpdated = true;
    step(count);
  };
  // Renderers call it once in each frame for every object of a scene.
  smoke.updateMatrixWorld = (isForced) => {
    frames.render();
    updateMatrixWorld(isForced);
  };
  smoke.addEventListener('error', ({ error }) => warnOfError(ABOUT, error));
  smoke.addEventListener('dispose' as 'added', () => --alive);
  if (++alive > MANY) {
    warnOnce(
      ABOUT,
      `More than ${MANY} smokes exist, each with a simulator of its own. Call dispose() on those that you no longer need.`,
    );
  }
  return smoke;
}

/** The calls of `update` for one smoke and its frames, as far as mistakes show in them. */
class Frames {
  isUpdated = false;
  private readonly smoke: Object3D;
  private rendered = 0;
  private updated = 0;
  /** Consecutive calls with implausible seconds, and those of them with more seconds than the call before. */
  private implausible = 0;
  private rising = 0;
  private last = { seconds: 0, at: -Infinity };
  /** Seconds of each call since the last frame. */
  private calls: number[] = [];
  /** Consecutive frames with two equal calls, their seconds, and when they began. */
  private doubled = { frames: 0, seconds: 0, since: 0 };

  constructor(smoke: Object3D) {
    this.smoke = smoke;
  }

  update(seconds: number): void {
    this.isUpdated = true;
    this.calls.push(seconds);
    this.judgeSeconds(seconds);
    if (this.rendered > 0 || ++this.updated < FRAMES) return;
    const { parent } = this.smoke;
    const missing = parent ? 'The scene that the smoke is in' : 'The smoke is in no scene and';
    warnOnce(
      ABOUT,
      `${missing} is not rendered, although update() is called. ${parent ? 'Render it' : 'Call scene.add(smoke)'}.`,
    );
  }

  render(): void {
    if (++this.rendered === FRAMES && !this.isUpdated) {
      warnOnce(
        ABOUT,
        'The scene is rendered, but update() was never called. Call smoke.update(seconds) before each render.',
      );
    }
    this.judgeCalls();
    this.calls = [];
  }

  private judgeSeconds(seconds: number): void {
    const { last } = this;
    const at = performance.now() / 1000;
    // More than twice the time that has passed; after a hidden tab much time may have passed.
    const isImplausible = seconds > 1 && seconds > 2 * (at - last.at);
    this.implausible = isImplausible ? this.implausible + 1 : 0;
    this.rising = isImplausible && seconds > last.seconds ? this.rising + 1 : 0;
    this.last = { seconds, at };
    if (this.implausible < CALLS) return;
    const what =
      this.rising < CALLS
        ? 'milliseconds. Pass seconds'
        : 'the time since the start. Pass the seconds since the last call';
    warnOnce(ABOUT, `update(${seconds}) looks like ${what}, such as update(clock.getDelta()).`, what);
  }

  private judgeCalls(): void {
    const [one, other, ...more] = this.calls;
    const at = performance.now() / 1000;
    const isDoubled = one > 0 && one === other && more.length === 0;
    const { frames, seconds, since } = this.doubled;
    this.doubled =
      isDoubled && frames > 0
        ? { frames: frames + 1, seconds: seconds + 2 * one, since }
        : { frames: isDoubled ? 1 : 0, seconds: 0, since: at };
    // Two halves of a frame are correct.
    if (this.doubled.frames === FRAMES && this.doubled.seconds > 1.5 * (at - since)) {
      warnOnce(
        ABOUT,
        'update() is called twice in each frame with the same seconds, so smoke is twice as fast. Call it once. <Smoke> of cartoon-smoke/fiber calls it by itself.',
      );
    }
  }
}
