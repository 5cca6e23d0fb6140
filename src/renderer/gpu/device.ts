import { WebGLRenderer } from 'three';
import { ContextError, ParameterError, requireOptions, UnsupportedError } from '../../base/errors.ts';
import { executed } from './framesInFlight.ts';
import { ProgramsAhead } from './programsAhead.ts';
import { PuffLibrary } from './puffTextures.ts';
import { drawDepthTest } from './selfTest.ts';

export type DeviceCanvas = HTMLCanvasElement | OffscreenCanvas;

/** The context was lost, was restored, or the device gave up on its restoration. */
export type ContextEvent = 'lost' | 'restored' | 'missing';

/** Timeout of the restoration, milliseconds. Browsers restore a context within about two seconds or not at all. */
const TIMEOUT_MS = 10_000;
/** Losses within two minutes after which the device gives up: the drawn content probably causes them. */
const MAX_LOSSES = 3;
const LOSSES_WITHIN_MS = 120_000;

export interface DeviceOptions {
  /** Behaves as if the self test had failed, for tests and to preview the fallback. */
  failsSelfTest?: boolean;
}

/**
 * A WebGL2 context and what all smokes on it share: the renderer with its programs, and the puff textures. It handles
 * context loss and restoration for all of them; three.js uploads all resources again after the restoration.
 */
export class Device {
  readonly renderer: WebGLRenderer;
  /** @internal */
  readonly puffs: PuffLibrary;
  /** @internal */
  readonly programs = new ProgramsAhead();
  private readonly ownsRenderer: boolean;
  private readonly listeners = new Set<(event: ContextEvent) => void>();
  private waiting: ReturnType<typeof setTimeout> | undefined;
  private hasPassed: boolean | undefined;
  private isDisposed = false;
  private isLost = false;
  private isMissing = false;
  /** Times of the most recent losses, milliseconds of `performance.now()`. */
  private losses: number[] = [];

  /**
   * @param ownsRenderer whether `dispose` also disposes of the renderer and its context; false for a host's renderer
   */
  constructor(renderer: WebGLRenderer, ownsRenderer: boolean, { failsSelfTest = false }: DeviceOptions = {}) {
    this.renderer = renderer;
    this.ownsRenderer = ownsRenderer;
    if (failsSelfTest) this.hasPassed = false;
    this.puffs = new PuffLibrary(renderer.getContext() as WebGL2RenderingContext);
    this.canvas.addEventListener('webglcontextlost', this.handleLoss);
    this.canvas.addEventListener('webglcontextrestored', this.handleRestoration);
  }

  get canvas(): DeviceCanvas {
    return this.renderer.domElement;
  }

  /**
   * Whether the GPU keeps the depth that fragments write. If not, puffs are flat. The first access runs a self test,
   * which waits for the GPU.
   */
  get writesDepth(): boolean {
    // Nothing can be read from a lost context.
    if (!this.isUsable) return this.hasPassed ?? true;
    return (this.hasPassed ??= drawDepthTest(this.renderer)());
  }

  /** @internal Runs the self test for `writesDepth` without blocking. */
  async testDepth(): Promise<void> {
    if (this.hasPassed !== undefined) return;
    const read = drawDepthTest(this.renderer);
    if (await executed(this.renderer.getContext() as WebGL2RenderingContext)) this.hasPassed = read();
  }

  /** False while the context is lost and after disposal: nothing can be drawn then. */
  get isUsable(): boolean {
    // The context can be lost before its event is dispatched.
    return !this.isDisposed && !this.isLost && !this.renderer.getContext().isContextLost();
  }

  /** Adds a listener for context events. Returns the function that removes it. */
  onContext(listener: (event: ContextEvent) => void): () => void {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  }

  /** @throws ContextError if the device is disposed or the context is lost */
  requireUsable(): void {
    if (this.isDisposed) throw new ContextError('This device was disposed; create a new one.');
    if (!this.isUsable) throw new ContextError('The graphics context is lost. Drawing resumes when it is restored.');
  }

  /**
   * False after the device gave up on a lost context: a timeout or repeated losses. A later restoration makes it true
   * again.
   */
  get isRecoverable(): boolean {
    return !this.isMissing;
  }

  /** Releases all resources, and the context if the device owns it. Can be called more than once. */
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
    const context = this.renderer.getContext();
    if (!context.isContextLost()) return this.renderer.forceContextLoss();
    // A lost context cannot be released until the browser restores it.
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
    if (this.losses.length > MAX_LOSSES) return this.abandonRestore();
    // The browser restores the context only if the default action is prevented.
    event.preventDefault();
    this.waiting = setTimeout(() => this.abandonRestore(), TIMEOUT_MS);
  };

  private readonly handleRestoration = (): void => {
    this.isLost = this.isMissing = false;
    clearTimeout(this.waiting);
    this.notify('restored');
  };

  private abandonRestore(): void {
    this.isMissing = true;
    this.notify('missing');
  }

  private notify(event: ContextEvent): void {
    for (const listener of this.listeners) listener(event);
  }
}

/** The error of a context that was not restored. */
export function missingContext(): ContextError {
  return new ContextError('The graphics context is lost. Reload the page, or use another canvas.');
}

/** @throws ParameterError unless it is a canvas, of any window */
export function requireCanvas(canvas: unknown): void {
  if (typeof (canvas as DeviceCanvas | undefined)?.getContext !== 'function')
    throw new ParameterError('canvas', canvas, 'a canvas');
}

/**
 * Creates the WebGL2 context of a canvas that has no context yet, and a device on it.
 * @throws UnsupportedError if WebGL2 is not available
 * @throws ContextError if the canvas has had a device before: its context was released and cannot be created again
 */
export function createDevice(canvas: DeviceCanvas, options: DeviceOptions = {}): Device {
  requireCanvas(canvas);
  requireOptions('createDevice', options, ['failsSelfTest']);
  const context = contextOf(canvas);
  if (!context) {
    throw new UnsupportedError(
      'This browser has no WebGL2. Turn on hardware acceleration, or use a current Firefox, Chrome, Edge or Safari.',
    );
  }
  if (context.isContextLost()) throw missingContext();
  const renderer = new WebGLRenderer({ canvas, context });
  renderer.autoClear = false;
  renderer.sortObjects = false;
  renderer.info.autoReset = false;
  // Each question about a program waits for the GPU.
  renderer.debug.checkShaderErrors = import.meta.env.DEV;
  return new Device(renderer, true, options);
}

/** Creates the context of `createDevice`, and resolves when the GPU has it: until then, any question to it blocks. */
export async function contextAhead(canvas: DeviceCanvas): Promise<void> {
  const context = contextOf(canvas);
  if (context) await executed(context);
}

function contextOf(canvas: DeviceCanvas): WebGL2RenderingContext | null {
  return canvas.getContext('webgl2', { antialias: false, depth: false });
}
