import { WebGLRenderer } from 'three';
import { ContextError, UnsupportedError } from '../preset/errors.ts';
import { ProgramsAhead } from './programsAhead.ts';
import { PuffLibrary } from './puffTextures.ts';
import { keepsWrittenDepth } from './selfTest.ts';

export type DeviceCanvas = HTMLCanvasElement | OffscreenCanvas;

/** The context went, came back, or nobody should wait for it any longer. */
export type ContextEvent = 'lost' | 'restored' | 'missing';

/** Browsers restore a context within a second or two, if they do. */
const TIMEOUT_MS = 10_000;
/** A context that goes more often than this within two minutes goes by what is drawn, and would go for ever. */
const MAX_LOSSES = 3;
const LOSSES_WITHIN_MS = 120_000;

export interface DeviceOptions {
  /** Draws as where the self test fails, for tests and to see what that looks like. */
  failsSelfTest?: boolean;
}

/**
 * One WebGL2 context and what every smoke on it shares: the renderer with its programs, and the puffs.
 * A lost context is recovered here, once: three uploads everything anew after the browser gives the context back.
 */
export class Device {
  readonly renderer: WebGLRenderer;
  readonly puffs: PuffLibrary;
  readonly programs = new ProgramsAhead();
  /** Whether a depth that fragments write is kept; where it is not, puffs are flat. Found by a small drawing at start. */
  readonly writesDepth: boolean;
  private readonly ownsRenderer: boolean;
  private readonly listeners = new Set<(event: ContextEvent) => void>();
  private waiting: ReturnType<typeof setTimeout> | undefined;
  private isDisposed = false;
  private isLost = false;
  private isMissing = false;
  /** When the context went, the latest losses. */
  private losses: number[] = [];

  /** @param ownsRenderer whether renderer and context end with this device; those of a host stay as they are */
  constructor(renderer: WebGLRenderer, ownsRenderer: boolean, { failsSelfTest = false }: DeviceOptions = {}) {
    this.renderer = renderer;
    this.ownsRenderer = ownsRenderer;
    this.writesDepth = !failsSelfTest && keepsWrittenDepth(renderer);
    this.puffs = new PuffLibrary(renderer.getContext() as WebGL2RenderingContext);
    this.canvas.addEventListener('webglcontextlost', this.handleLoss);
    this.canvas.addEventListener('webglcontextrestored', this.handleRestoration);
  }

  get canvas(): DeviceCanvas {
    return this.renderer.domElement;
  }

  /** False while the context is lost and after disposal: nothing can be drawn then. */
  get isUsable(): boolean {
    // The context may be gone already when its event is still to come.
    return !this.isDisposed && !this.isLost && !this.renderer.getContext().isContextLost();
  }

  /** Tells when the context goes, is back, or is given up. Returns the function that stops telling. */
  onContext(listener: (event: ContextEvent) => void): () => void {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  }

  /** @throws ContextError when nothing can be drawn at present. */
  requireUsable(): void {
    if (this.isDisposed) throw new ContextError('This device was disposed; create a new one.');
    if (!this.isUsable) throw new ContextError('The graphics context is lost. Drawing resumes when it is restored.');
  }

  /** False once the context was lost and nobody should wait for it; it may still come back. */
  get hasHope(): boolean {
    return !this.isMissing;
  }

  /** Gives back what it holds, the context too if that is its own. May be called again. */
  dispose(): void {
    if (this.isDisposed) return;
    this.isDisposed = true;
    this.canvas.removeEventListener('webglcontextlost', this.handleLoss);
    this.canvas.removeEventListener('webglcontextrestored', this.handleRestoration);
    this.listeners.clear();
    clearTimeout(this.waiting);
    this.puffs.dispose();
    this.programs.dispose();
    if (!this.ownsRenderer) return;
    this.renderer.dispose();
    if (!this.isLost) return this.renderer.forceContextLoss();
    // A lost context cannot be given back before the browser restores it.
    const context = this.renderer.getContext();
    const giveBack = () => context.getExtension('WEBGL_lose_context')?.loseContext();
    this.canvas.addEventListener('webglcontextrestored', giveBack, { once: true });
  }

  private readonly handleLoss = (event: Event): void => {
    this.isLost = true;
    this.puffs.dispose();
    this.programs.dispose();
    this.notify('lost');
    clearTimeout(this.waiting);
    const now = performance.now();
    this.losses = [...this.losses.filter((at) => now - at < LOSSES_WITHIN_MS), now];
    if (this.losses.length > MAX_LOSSES) return this.giveUp();
    // Without this the browser never offers the context again.
    event.preventDefault();
    this.waiting = setTimeout(() => this.giveUp(), TIMEOUT_MS);
  };

  private readonly handleRestoration = (): void => {
    this.isLost = this.isMissing = false;
    clearTimeout(this.waiting);
    this.notify('restored');
  };

  private giveUp(): void {
    this.isMissing = true;
    this.notify('missing');
  }

  private notify(event: ContextEvent): void {
    for (const listener of this.listeners) listener(event);
  }
}

/** What is told of a context that nobody should wait for. */
export function missingContext(): ContextError {
  return new ContextError('The graphics context is lost. Reload the page, or use another canvas.');
}

/**
 * Takes the WebGL2 context of a canvas that has none yet.
 * @throws UnsupportedError when the browser refuses WebGL2. ContextError for a canvas that has served a device before: its
 * context was given back for good
 */
export function createDevice(canvas: DeviceCanvas, options: DeviceOptions = {}): Device {
  const context = canvas.getContext('webgl2', {
    alpha: true,
    antialias: false,
    depth: false,
    stencil: false,
    premultipliedAlpha: true,
  });
  if (!context) {
    throw new UnsupportedError(
      'This browser has no WebGL2. Turn on hardware acceleration, or use a current Firefox, Chrome, Edge or Safari.',
    );
  }
  if (context.isContextLost()) throw missingContext();
  const renderer = new WebGLRenderer({ canvas, context, antialias: false, depth: false, stencil: false });
  renderer.autoClear = false;
  renderer.sortObjects = false;
  renderer.info.autoReset = false;
  return new Device(renderer, true, options);
}
