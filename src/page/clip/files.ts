/** The encoders of clips, and the worker that runs them: encoder.ts starts this file as a worker, too. */
import { Apng } from './apng.ts';
import type { ClipFile, ClipFormat, ClipShape } from './clipFile.ts';
import { Gif } from './gif.ts';
import { Webp } from './webp.ts';

const FILES = { apng: Apng, gif: Gif, webp: Webp } as const;

/** Files that get the same frames. */
export class ClipFiles {
  private readonly files: readonly ClipFile[];

  /** @throws RangeError for a size or a rate that is not accepted */
  constructor(formats: readonly ClipFormat[], shape: ClipShape) {
    this.files = formats.map((format) => new FILES[format](shape));
  }

  /** Adds a frame. @param pixels as in `ClipFile` */
  async add(pixels: Uint8ClampedArray<ArrayBuffer>): Promise<void> {
    for (const file of this.files) await file.add(pixels);
  }

  /** In the order of the formats. */
  finish(): readonly Blob[] {
    return this.files.map((file) => file.finish());
  }
}

/** The first request names the formats, frames follow. The worker answers each request once, in order. */
export type Request =
  | { readonly formats: readonly ClipFormat[]; readonly shape: ClipShape }
  | { readonly pixels: Uint8ClampedArray<ArrayBuffer> }
  | 'finish';

export interface Answer {
  /** The files in the order of the formats, after the last request. */
  readonly files?: readonly Blob[];
  readonly error?: unknown;
}

/** Missing from TypeScript's DOM library. */
interface WorkerScope {
  postMessage(answer: Answer): void;
  addEventListener(type: 'message', listener: (event: MessageEvent<Request>) => void): void;
}

function serve(worker: WorkerScope): void {
  let files: ClipFiles;
  const answer = async (request: Request): Promise<Answer> => {
    if (request === 'finish') return { files: files.finish() };
    if ('formats' in request) files = new ClipFiles(request.formats, request.shape);
    else await files.add(request.pixels);
    return {};
  };
  worker.addEventListener('message', ({ data }) => {
    answer(data).then(
      (it) => worker.postMessage(it),
      (error: unknown) => worker.postMessage({ error }),
    );
  });
}

if ('WorkerGlobalScope' in globalThis) serve(self);
