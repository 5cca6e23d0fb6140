/** The parts of a page that drivers use, with a clock that the test moves. */
import { vi } from 'vitest';

type Frame = (now: number) => void;

/** A target whose events have properties. */
export class Target extends EventTarget {
  emit(type: string, properties: object = {}): void {
    this.dispatchEvent(Object.assign(new Event(type), properties));
  }
}

export class FakeElement extends Target {
  scrollTop = 0;
  scrollHeight = 3000;
  clientHeight = 1000;
  box = { top: 0, height: 0 };

  getBoundingClientRect(): { top: number; height: number } {
    return this.box;
  }
}

export class FakeNode extends Target {
  readonly outputs = new Set<unknown>();
  readonly context: FakeContext;

  constructor(context: FakeContext) {
    super();
    this.context = context;
  }

  connect(node: unknown): void {
    this.outputs.add(node);
  }

  disconnect(node: unknown): void {
    this.outputs.delete(node);
  }
}

/** Bins in dB, which the test fills. */
export const spectrum = new Map<number, number>();

export class FakeAnalyser extends FakeNode {
  readonly frequencyBinCount = 1024;

  getFloatFrequencyData(bins: Float32Array): void {
    bins.fill(-Infinity);
    for (const [bin, level] of spectrum) bins[bin] = level;
  }
}

export class FakeContext extends Target {
  static last: FakeContext | undefined;
  /** Whether it resumes, as after a gesture. */
  static isAllowed = false;
  readonly sampleRate = 2048 * 20;
  readonly destination = {};
  state = 'suspended';

  constructor() {
    super();
    FakeContext.last = this;
  }

  async resume(): Promise<void> {
    if (!FakeContext.isAllowed) throw new Error('NotAllowedError');
    this.become('running');
  }

  become(state: string): void {
    this.state = state;
    this.emit('statechange');
  }

  createMediaElementSource(element: FakeMedia): FakeNode {
    if (element.isTaken) throw new Error('InvalidStateError');
    element.isTaken = true;
    return new FakeNode(this);
  }
}

export class FakeMedia extends FakeElement {
  paused = true;
  isTaken = false;
}

export class FakePage {
  readonly window = new Target();
  readonly root = new FakeElement();
  readonly stillness = Object.assign(new Target(), { matches: false });
  now = 0;
  private frames = new Map<number, Frame>();
  private count = 0;

  constructor() {
    const { window, root, stillness } = this;
    const globals = {
      addEventListener: window.addEventListener.bind(window),
      removeEventListener: window.removeEventListener.bind(window),
      matchMedia: () => stillness,
      requestAnimationFrame: (frame: Frame) => (this.frames.set(++this.count, frame), this.count),
      cancelAnimationFrame: (frame: number) => this.frames.delete(frame),
      document: { scrollingElement: root, documentElement: root },
      innerHeight: 1000,
      Element: FakeElement,
      HTMLMediaElement: FakeMedia,
      AudioNode: FakeNode,
      AudioContext: FakeContext,
      AnalyserNode: FakeAnalyser,
      isSecureContext: true,
      navigator: {},
    };
    for (const [name, value] of Object.entries(globals)) vi.stubGlobal(name, value);
    spectrum.clear();
  }

  /** Whether a frame is asked for. */
  get isAwake(): boolean {
    return this.frames.size > 0;
  }

  /** Draws a frame after some seconds. */
  frame(seconds = 1 / 60): void {
    this.now += 1000 * seconds;
    const due = [...this.frames.values()];
    this.frames.clear();
    for (const frame of due) frame(this.now);
  }

  scrollTo(top: number): void {
    this.root.scrollTop = top;
    this.window.emit('scroll');
  }

  move(clientX: number, clientY = 0, more: object = {}): void {
    this.window.emit('pointermove', { pointerId: 1, pointerType: 'mouse', clientX, clientY, ...more });
  }
}
