/** The worker of a page: it runs all stages of the page on one device. Its first message says whether it can draw. */
import type { AssetUrls } from '../../base/assetUrls.ts';
import { setAssetUrls } from '../../base/setAssetUrls.ts';
import type { RemoteStageOptions } from './contract.ts';
import { BEAT, beatWhile } from './heartbeat.ts';
import { requireDrawing, openHere } from './openHere.ts';
import { packError } from './packedErrors.ts';
import { OPENING, notificationOf } from './protocol.ts';
import { serveStage } from './serveStage.ts';

/** The page's message for each stage. */
export interface OpenRequest {
  readonly canvas: OffscreenCanvas;
  readonly options: RemoteStageOptions;
  /** URLs that the page has set. */
  readonly assets: AssetUrls;
  readonly port: MessagePort;
}

/** The worker's first message. */
export type Greeting = { readonly greeting: true; readonly error?: unknown };

/** Missing from TypeScript's DOM library. */
interface WorkerScope {
  postMessage(message: Greeting | typeof BEAT): void;
  addEventListener(type: 'message', listener: (event: MessageEvent<OpenRequest | typeof BEAT>) => void): void;
  close(): void;
}

const worker = self as unknown as WorkerScope;
const beat = () => worker.postMessage(BEAT);
/** Long batches of steps block the event loop, so they send the heartbeat themselves. */
const onStep = beatWhile(beat);

async function open({ canvas, options, assets, port }: OpenRequest): Promise<void> {
  if (import.meta.env.DEV && options.fault === 'workerSilent') return worker.close();
  const onProgress = (progress: unknown) => port.postMessage(notificationOf('progress', progress));
  try {
    setAssetUrls(assets);
    serveStage(port, await openHere(canvas, { ...options, onProgress, onStep }, 'worker'));
    port.postMessage({ id: OPENING });
  } catch (error) {
    port.postMessage({ id: OPENING, error: packError(error) });
  }
}

function greet(): void {
  try {
    requireDrawing();
    worker.postMessage({ greeting: true });
  } catch (error) {
    worker.postMessage({ greeting: true, error: packError(error) });
  }
}

worker.addEventListener('message', ({ data }) => (data === BEAT ? beat() : void open(data)));
greet();
