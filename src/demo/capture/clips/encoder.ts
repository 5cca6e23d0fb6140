import type { ClipShape, LoopFormat } from './clipFile.ts';
import type { Answer, Request } from './worker.ts';

/** Encodes looped clips in a worker, so that a frame is encoded while the next one is drawn. */
export class ClipEncoder {
  private readonly worker = new Worker(new URL('./worker.ts', import.meta.url), { type: 'module', name: 'clips' });
  private previous: Promise<Answer>;

  /** @param formats files that get the same frames */
  constructor(formats: readonly LoopFormat[], shape: ClipShape) {
    this.previous = this.ask({ formats, shape });
  }

  /**
   * Adds a frame, and waits for the one before it.
   * @param pixels straight alpha, as many as the size says; the worker takes their memory
   * @throws RangeError for a size or a rate that is not accepted
   */
  async add(pixels: Uint8ClampedArray<ArrayBuffer>): Promise<void> {
    await this.previous;
    this.previous = this.ask({ pixels }, [pixels.buffer]);
  }

  /** The files in the order of the formats. */
  async finish(): Promise<readonly Blob[]> {
    await this.previous;
    return (await this.ask('finish')).files!;
  }

  /** Ends the worker, also while it encodes. */
  close(): void {
    this.worker.terminate();
  }

  private ask(request: Request, memory: Transferable[] = []): Promise<Answer> {
    const answer = new Promise<Answer>((resolve, reject) => {
      this.worker.onmessage = ({ data }: MessageEvent<Answer>) => {
        if (data.error === undefined) resolve(data);
        else reject(data.error);
      };
      this.worker.onerror = (event) => {
        event.preventDefault();
        reject(new Error(`The worker that encodes could not be started. ${event.message ?? ''}`.trim()));
      };
      this.worker.postMessage(request, memory);
    });
    // Awaited by the next call, where its error is thrown.
    answer.catch(() => undefined);
    return answer;
  }
}
