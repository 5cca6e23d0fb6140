import type { Values } from '../preset/parameter.ts';
import { LivePuffs } from '../smoke/livePuffs.ts';

/** Spent at a time: a page goes on answering in between. */
const PIECE_MS = 16;

/**
 * Bakes the puffs that values describe while a scene and its simulator are still on their way; whoever asks for them next
 * has them at once.
 */
export async function bakeAhead(values: Values): Promise<void> {
  const puffs = new LivePuffs(values);
  while (!puffs.workFor(PIECE_MS)) await nextTask();
}

function nextTask(): Promise<void> {
  return new Promise((resolve) => setTimeout(resolve));
}
