/** Runs in a page: the element, and a sandboxed frame. */
// oxlint-disable-next-line import/no-unassigned-import -- it defines the element
import '../../../src/element/define.ts';
import type { CartoonSmokeElement } from '../../../src/element/cartoonSmokeElement.ts';
import { connectFrame } from '../../../src/remote/connectFrame.ts';
import type { RemoteStage } from '../../../src/remote/contract.ts';
import { packedFile } from './bytes.ts';

const SIZE = 'width: 160px; height: 120px';
const ATTRIBUTES = { 'simulation-max-particles': '300', 'puff-variations': '1', loading: 'eager', style: SIZE };

interface Played {
  thread: string;
  /** Steps during playback. */
  steps: number;
  /** A PNG, base64. */
  picture: string;
}

function put(attributes: Record<string, string>): CartoonSmokeElement {
  const element = document.createElement('cartoon-smoke');
  for (const [name, value] of Object.entries({ ...ATTRIBUTES, ...attributes })) element.setAttribute(name, value);
  document.body.append(element);
  return element;
}

async function play(stage: RemoteStage): Promise<Played> {
  const first = (await stage.stats()).steps;
  let steps = 0;
  while (steps < 30) {
    await new Promise((resolve) => setTimeout(resolve, 50));
    steps = (await stage.stats()).steps - first;
  }
  return { thread: stage.thread, steps, picture: await packedFile(await stage.picture()) };
}

/** Resolves after half a second of playback. */
export async function playElement(thread: 'auto' | 'main'): Promise<Played> {
  const element = put({ preset: 'wisp', thread, start: '2' });
  try {
    await element.ready;
    return await play(await element.stage);
  } finally {
    element.remove();
  }
}

/** The hash at the moment of a share link. */
export async function hashAtLink(link: string): Promise<{ hash: string; notices: readonly string[] }> {
  const notices: string[] = [];
  const element = document.createElement('cartoon-smoke');
  element.addEventListener('statechange', ({ detail }) =>
    notices.push(...detail.notices.map(({ message }) => message)),
  );
  element.setAttribute('style', SIZE);
  element.setAttribute('loading', 'eager');
  element.setAttribute('src', `${location.origin}/?paused=1${link}`);
  document.body.append(element);
  try {
    await element.ready;
    return { hash: await element.hash(), notices };
  } finally {
    element.remove();
  }
}

/** Resolves after half a second of playback in a frame with an opaque origin. */
export async function playFrame(address: string): Promise<Played> {
  const frame = document.createElement('iframe');
  frame.setAttribute('sandbox', 'allow-scripts');
  frame.setAttribute('style', `border: 0; ${SIZE}`);
  frame.src = address;
  document.body.append(frame);
  try {
    return await play(await connectFrame(frame));
  } finally {
    frame.remove();
  }
}
