import { decode, encode, type Decoded } from '../../preset/codec.ts';
import type { Editor } from '../editor/editor.ts';
import { QUIET_MS } from '../input/gestureEnd.ts';

/** The share link of what the page shows now; the smoke starts anew wherever it is opened. */
export async function linkTo(editor: Editor): Promise<string> {
  const address = new URL(await addressOf(editor));
  for (const name of ['t', 'paused']) address.searchParams.delete(name);
  return address.href;
}

/** What the address bar shall say. */
async function addressOf(editor: Editor): Promise<string> {
  const address = new URL(location.href);
  address.hash = await encode(editor.state);
  return address.href;
}

/**
 * Keeps the address bar on what is edited, and edits what somebody puts into the address bar. A moment that was put there
 * stays until somebody edits.
 * @param arrive called with what was put there, once the editor has it; settled when the page shows it
 */
export function followAddress(
  editor: Editor,
  arrive: (decoded: Decoded, isNewest: () => boolean) => Promise<void>,
): void {
  let timer: ReturnType<typeof setTimeout> | undefined;
  let arriving: Decoded | undefined;
  let newest: Promise<Decoded>;
  editor.listen((_state, changed) => {
    if (arriving?.take || Object.keys(changed).length === 0) return;
    clearTimeout(timer);
    timer = setTimeout(async () => {
      const started = timer;
      const link = await addressOf(editor);
      // A packed link takes a moment; if an edit came meanwhile, its own turn will write.
      if (timer === started) history.replaceState(history.state, '', link);
    }, QUIET_MS);
  });
  addEventListener('hashchange', async ({ newURL }) => {
    clearTimeout(timer);
    timer = undefined;
    // A write that was under way may have replaced the new address before this event came.
    if (location.href !== newURL) history.replaceState(history.state, '', newURL);
    const reading = (newest = decode(new URL(newURL).hash));
    const decoded = await reading;
    // A packed link takes a moment; what was put there since goes before.
    if (reading !== newest) return;
    arriving = decoded;
    editor.load(decoded.state);
    await arrive(decoded, () => arriving === decoded);
    if (arriving === decoded) arriving = undefined;
  });
}
