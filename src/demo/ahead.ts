/** Fetches the scene and the simulator of the page's address, in parallel with the rest of the page. */
import { openScene } from '../internal.ts';
import { decode } from '../preset.ts';
import { linkOf } from './poster.ts';

async function fetchAhead(): Promise<void> {
  const { state } = await decode(linkOf(location.hash));
  await openScene(state.values.scene as string);
}

// The same failure occurs again in main.ts, which reports it.
fetchAhead().catch(() => undefined);
