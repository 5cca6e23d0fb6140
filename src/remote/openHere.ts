import type { DeviceCanvas } from '../device/device.ts';
import { createStage } from '../stage/stage.ts';
import type { RemoteStage, RemoteStageOptions, Thread } from './contract.ts';
import { localStage } from './localStage.ts';
import { SharedDevice } from './sharedDevice.ts';

const FRAME_RATE = 60;
const shared = new SharedDevice();

/**
 * Opens a stage on this thread; all of a thread share one device where that is possible.
 * @throws what createStage throws
 */
export async function openHere(
  canvas: DeviceCanvas,
  { signal, ...options }: RemoteStageOptions,
  thread: Thread = 'main',
): Promise<RemoteStage> {
  signal?.throwIfAborted();
  const device = shared.hold();
  const release = () => device && shared.release();
  const stage = await createStage(canvas, { frameRate: FRAME_RATE, ...options, device }).catch((error) => {
    release();
    throw error;
  });
  const opened = localStage(stage, thread, release);
  if (!signal?.aborted) return opened;
  await opened.dispose();
  throw signal.reason;
}
