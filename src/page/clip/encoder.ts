import { SmokeError } from '../../base/errors.ts';
import { fetched } from '../../base/timeout.ts';
import type { ClipFormat, ClipShape } from './clipFile.ts';
import type { Answer, Request } from './files.ts';

/** Encodes clips frame by frame. */
export interface ClipEncoder {
  /**
   * Adds a frame. In a worker, it waits for the frame before.
   * @param pixels straight alpha, as many as the size says; the encoder takes their memory
   */
  add(pixels: Uint8ClampedArray<ArrayBuffer>): Promise<void>;
  /** The files in the order of the formats. */
  finish(): Promise<readonly Blob[]>;
  /** Ends the worker, also while it encodes. */
  close(): void;
}

/**
 * Opens an encoder in a worker, so that a frame is encoded while the next one is drawn. It encodes on this thread where the page
 * or the bundler lets no worker start, as from another origin.
 * @param formats files that get the same frames
 * @throws RangeError for a size or a rate that is not accepted, LoadError if the code cannot be fetched
 */
export async function openEncoder(formats: readonly ClipFormat[], shape: ClipShape): Promise<ClipEncoder> {
  const worker = startWorker();
  const encoder = worker && new WorkerEncoder(worker);
  try {
    if (await encoder?.begin(formats, shape)) return encoder!;
  } catch (error) {
    encoder!.close();
    throw error;
  }
  const { ClipFiles } = await fetched('The encoder', import('./files.ts'));
  const files = new ClipFiles(formats, shape);
  return { add: (pixels) => files.add(pixels), finish: async () => files.finish(), close: () => undefined };
}

/** Whether the browser encodes WebP. Safari does not. */
export async function encodesWebp(): Promise<boolean> {
  const canvas = new OffscreenCanvas(1, 1);
  // Without a context there are no pixels to encode.
  canvas.getContext('2d');
  return (await canvas.convertToBlob({ type: 'image/webp' })).type === 'image/webp';
}

/** @returns undefined where the page's policy forbids it at once */
function startWorker(): Worker | undefined {
  try {
    return new Worker(new URL('./files.ts', import.meta.url), { type: 'module', name: 'clips' });
  } catch {
    return undefined;
  }
}

class WorkerEncoder implements ClipEncoder {
  private readonly worker: Worker;
  private previous: Promise<Answer> = Promise.resolve({});

  private fail: (error: Error) => void = () => undefined;

  constructor(worker: Worker) {
    this.worker = worker;
    worker.onerror = (event) => {
      event.preventDefault();
      this.fail(new SmokeError(`The worker that encodes has stopped. ${event.message ?? ''}`.trim()));
    };
  }

  /** @returns whether the worker has started */
  begin(formats: readonly ClipFormat[], shape: ClipShape): Promise<boolean> {
    const begun = this.ask({ formats, shape }).then(() => true);
    const failed = new Promise<boolean>((resolve) => {
      this.fail = () => resolve(false);
    });
    return Promise.race([begun, failed]);
  }

  async add(pixels: Uint8ClampedArray<ArrayBuffer>): Promise<void> {
    await this.previous;
    this.previous = this.ask({ pixels }, [pixels.buffer]);
    // Awaited by the next call, where its error is thrown.
    this.previous.catch(() => undefined);
  }

  async finish(): Promise<readonly Blob[]> {
    await this.previous;
    return (await this.ask('finish')).files!;
  }

  close(): void {
    this.worker.terminate();
  }

  private ask(request: Request, memory: Transferable[] = []): Promise<Answer> {
    return new Promise((resolve, reject) => {
      this.fail = reject;
      this.worker.onmessage = ({ data }: MessageEvent<Answer>) => {
        if (data.error === undefined) resolve(data);
        else reject(data.error);
      };
      this.worker.postMessage(request, memory);
    });
  }
}
