import { decode, encode, type Decoded } from '../../preset.ts';
import { QUIET_MS, type Editor } from '../editor/editor.ts';
import { linkOf } from '../poster.ts';

/** The share link of the current state. The smoke starts from the beginning where it is opened. */
export async function linkTo(editor: Editor): Promise<string> {
  const address = new URL(await addressOf(editor));
  for (const name of ['t', 'paused']) address.searchParams.delete(name);
  return address.href;
}

/** The URL for the address bar. */
async function addressOf(editor: Editor): Promise<string> {
  const address = new URL(location.href);
  address.hash = await encode(editor.state);
  return address.href;
}

/**
 * Synchronizes the address bar and the editor. A moment in the address stays until the first edit.
 * @param arrive called with a new address after the editor has loaded it; resolves when the page shows it
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
      // Encoding is asynchronous. A later edit starts its own write.
      if (timer === started) history.replaceState(history.state, '', link);
    }, QUIET_MS);
  });
  addEventListener('hashchange', async ({ newURL }) => {
    clearTimeout(timer);
    timer = undefined;
    // A pending write may have replaced the new address before this event.
    if (location.href !== newURL) history.replaceState(history.state, '', newURL);
    const reading = (newest = decode(linkOf(new URL(newURL).hash)));
    const decoded = await reading;
    // Decoding is asynchronous. The newest address wins.
    if (reading !== newest) return;
    arriving = decoded;
    editor.load(decoded.state);
    await arrive(decoded, () => arriving === decoded);
    if (arriving === decoded) arriving = undefined;
  });
}
