/** The worker that encodes clips; encoder.ts is the other side. */
import { Apng } from './apng.ts';
import type { ClipFile, ClipShape, LoopFormat } from './clipFile.ts';
import { Gif } from './gif.ts';
import { Webp } from './webp.ts';

/** The first request names the formats, frames follow. The worker answers each request once, in order. */
export type Request =
  | { readonly formats: readonly LoopFormat[]; readonly shape: ClipShape }
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

const FILES = { apng: Apng, gif: Gif, webp: Webp } as const;
const worker = self as unknown as WorkerScope;
let files: ClipFile[] = [];

async function answer(request: Request): Promise<Answer> {
  if (request === 'finish') return { files: files.map((file) => file.finish()) };
  if ('formats' in request) files = request.formats.map((format) => new FILES[format](request.shape));
  else for (const file of files) await file.add(request.pixels);
  return {};
}

worker.addEventListener('message', ({ data }) => {
  answer(data).then(
    (it) => worker.postMessage(it),
    (error: unknown) => worker.postMessage({ error }),
  );
});
