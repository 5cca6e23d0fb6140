import type { DeviceCanvas } from '../../renderer/gpu/device.ts';
import { UnsupportedError } from '../../base/errors.ts';
import type { StageOptions } from '../contract.ts';
import { createStage } from '../stage.ts';
import type { RemoteStage, RemoteStageOptions, Thread } from './contract.ts';
import { localStage } from './localStage.ts';
import { threadDevice } from './sharedDevice.ts';

const FRAME_RATE = 60;

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
  const stage = await createStage(canvas, { frameRate: FRAME_RATE, ...options, device }).catch((error) => {
    release();
    throw error;
  });
  const opened = localStage(stage, thread, release);
  if (!signal?.aborted) return opened;
  await opened.dispose();
  throw signal.reason;
}
