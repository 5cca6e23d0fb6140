import type { Beginning, DrawnFrame, FilmOrder, FlipbookOrder } from './order.ts';

/** The command that opened the page, over HTTP; scripts/film/server.mjs answers. */
export class Receiver {
  async order(): Promise<FilmOrder | FlipbookOrder> {
    return (await (await request('GET', 'order')).json()) as FilmOrder | FlipbookOrder;
  }

  /** @returns the numbers of the frames to render */
  async begin(beginning: Beginning): Promise<number[]> {
    return (await (await request('POST', 'begin', JSON.stringify(beginning))).json()) as number[];
  }

  /** Reports how much of a flipbook is drawn, 0 to 1. */
  async progress(share: number): Promise<void> {
    await request('POST', 'progress', String(share));
  }

  /** Sends a file. */
  async put(name: string, content: Blob): Promise<void> {
    await request('PUT', `file/${name}`, content);
  }

  /** Reports a frame of which all files were sent. */
  async finish(frame: DrawnFrame): Promise<void> {
    await request('POST', 'finish', JSON.stringify(frame));
  }

  /** The latest saved state at or before a step, and its hash; undefined if there is none. */
  async state(step: number): Promise<{ bytes: Uint8Array; hash: string } | undefined> {
    const response = await request('GET', `state/${step}`);
    if (response.status === 204) return undefined;
    return { bytes: new Uint8Array(await response.arrayBuffer()), hash: response.headers.get('x-hash') ?? '' };
  }

  async save(step: number, hash: string, bytes: Uint8Array): Promise<void> {
    await request('PUT', `state/${step}`, new Blob([bytes as Uint8Array<ArrayBuffer>]), { 'x-hash': hash });
  }

  /** The picture of a frame. */
  async picture(frame: number): Promise<Blob> {
    return (await request('GET', `picture/${frame}`)).blob();
  }

  /** @param what the film itself, or the track matte in a file of its own */
  async putVideo(video: Blob, what: 'film' | 'matte' = 'film'): Promise<void> {
    await request('PUT', `video/${what}`, video);
  }

  /** Sends what a player has to know of a stinger. */
  async putStinger(report: object): Promise<void> {
    await request('PUT', 'stinger', `${JSON.stringify(report, null, 1)}\n`);
  }

  async end(): Promise<void> {
    await request('POST', 'end');
  }

  async fail(error: unknown): Promise<void> {
    await request('POST', 'fail', error instanceof Error ? error.message : String(error));
  }
}

async function request(method: string, path: string, body?: BodyInit, headers?: HeadersInit): Promise<Response> {
  const response = await fetch(`./${path}`, { method, body, headers });
  if (!response.ok) throw new Error(messages.failed(`${method} ${path}`, response.status));
  return response;
}

/** Errors of the film page. They are not in strings.ts, which every visitor of the demo downloads. */
export const messages = {
  badLink: (problems: readonly string[]) => `The link has mistakes: ${problems.join(' ')}`,
  otherState: (saved: string, found: string) =>
    `A saved state has the hash ${saved}, but ${found} after it was read: delete the folder of the states.`,
  uncovered: (pixels: number) =>
    `The smoke leaves ${pixels} pixels uncovered at the cut: choose a longer --stinger, or a link with an opaque look.`,
  leftOver: (frame: number) => `Frame ${frame} of the stinger is not empty: choose a longer --stinger.`,
  failed: (what: string, status: number) => `${what}: the command answered ${status}.`,
};
