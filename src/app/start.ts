/**
 * The page's entry, and small: it finds out which scene the address asks for, so that scene and simulator are on their way
 * while the rest of the page still comes.
 */
import { decode } from '../preset/codec.ts';
import { openScene } from '../stage/openScene.ts';

async function fetchAhead(): Promise<void> {
  const { state } = await decode(location.hash);
  await openScene(state.values.scene as string);
}

// Whatever fails here fails again where it is told.
fetchAhead().catch(() => undefined);
void import('./main.ts');
