import { type DeviceCanvas, createDevice, type Device } from '../../renderer/gpu/device.ts';
import { UnsupportedError, SimulatorError } from '../../base/errors.ts';
import type { StageOptions } from '../contract.ts';
import { createStage, type Stage } from '../stage.ts';
import type { RemoteStage, RemoteStageOptions, Thread } from './contract.ts';
import { Crowd, type CrowdTurns } from './crowd.ts';
import { calls, type MethodName } from './calls.ts';
import { makeMethods } from './makeMethods.ts';

/**
 * Keeps the device for stages that are soon reopened, for example when a page moves its widgets: programs stay compiled
 * and puffs stay uploaded.
 */
const GRACE_MS = 2_000;

/**
 * One device for all stages of a thread, because browsers limit the number of WebGL contexts. After its context is
 * given up, the next stage gets a new device; existing stages keep the old one, which may still be restored.
 */
export class SharedDevice {
  private device: Device | undefined;
  private readonly holders = new Map<Device, number>();
  private shutdownTimer: ReturnType<typeof setTimeout> | undefined;

  /**
   * Returns the device. It must be released once for each call.
   * @returns undefined if the browser cannot draw on an OffscreenCanvas: each stage then needs its own device
   */
  acquire(): Device | undefined {
    clearTimeout(this.shutdownTimer);
    this.dropLostDevice();
    this.device ??= createOffPage();
    if (this.device) this.holders.set(this.device, this.countOf(this.device) + 1);
    return this.device;
  }

  release(device: Device): void {
    const left = this.countOf(device) - 1;
    if (left > 0) return void this.holders.set(device, left);
    this.holders.delete(device);
    if (device === this.device) this.shutdownTimer = setTimeout(() => this.end(), GRACE_MS);
    else device.dispose();
  }

  /** Drops a device that new stages cannot use. */
  private dropLostDevice(): void {
    const { device } = this;
    if (!device) return;
    if (this.countOf(device) === 0 && !device.isUsable) this.end();
    else if (!device.isRecoverable) this.device = undefined;
  }

  private countOf(device: Device): number {
    return this.holders.get(device) ?? 0;
  }

  private end(): void {
    this.device?.dispose();
    this.device = undefined;
  }
}

function createOffPage(): Device | undefined {
  if (typeof OffscreenCanvas === 'undefined' || !new OffscreenCanvas(1, 1).getContext('bitmaprenderer'))
    return undefined;
  try {
    return createDevice(new OffscreenCanvas(1, 1));
  } catch {
    return undefined;
  }
}

/** The shared device of this thread. */
export const threadDevice = new SharedDevice();

const crowds = new WeakMap<Device, Crowd>();

function crowdOn(device: Device): Crowd {
  const crowd = crowds.get(device) ?? new Crowd(device);
  crowds.set(device, crowd);
  return crowd;
}

const FRAME_RATE = 60;
/** After a call of these, the stage is drawn in every frame for a while. */
const INPUTS = 'pointer blow steer emit changeEmission drop nudge orbit zoom pan resetView'.split(' ');

/** @throws UnsupportedError when this thread cannot draw on an OffscreenCanvas */
export function requireDrawing(): void {
  const device = threadDevice.acquire();
  if (!device) throw new UnsupportedError('This browser has no WebGL2 in workers.');
  threadDevice.release(device);
}

/**
 * Opens a stage on this thread. All stages of a thread share one device where possible.
 * @throws the errors of createStage
 */
export async function openHere(
  canvas: DeviceCanvas,
  { signal, thread: _thread, graceMs: _grace, ...options }: RemoteStageOptions & Pick<StageOptions, 'onStep'>,
  thread: Thread = 'main',
): Promise<RemoteStage> {
  signal?.throwIfAborted();
  const device = threadDevice.acquire();
  const release = () => device && threadDevice.release(device);
  const turns = device && crowdOn(device).join();
  const stage = await createStage(canvas, { frameRate: FRAME_RATE, ...options, device, turns }).catch((error) => {
    release();
    throw error;
  });
  const opened = localStage(stage, thread, release, turns);
  if (!signal?.aborted) return opened;
  await opened.dispose();
  throw signal.reason;
}

/**
 * Wraps a stage of this thread as a RemoteStage.
 * @param release called once, after disposal
 * @param turns told of inputs
 */
export function localStage(
  stage: Stage,
  thread: Thread = 'main',
  release?: () => void,
  turns?: CrowdTurns,
): RemoteStage {
  let isDisposed = false;
  const call = async (name: MethodName, args: unknown[]) => {
    if (isDisposed) throw new SimulatorError('This stage was disposed; create a new one.');
    if (INPUTS.includes(name)) turns?.touch();
    const act = calls[name] as (on: Stage, ...given: unknown[]) => unknown;
    // More arguments than a method has could be options that only other calls accept.
    return act(stage, ...args.slice(0, act.length - 1));
  };
  return {
    ...makeMethods(Object.keys(calls) as MethodName[], call),
    ready: stage.ready,
    thread,
    on: (event, listener) => stage.on(event, listener),
    async dispose() {
      if (isDisposed) return;
      isDisposed = true;
      stage.dispose();
      release?.();
    },
  };
}
