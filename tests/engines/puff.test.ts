/** `puff()` draws smoke, resolves when it is gone, and hides and shows elements. */
import { expect } from 'vitest';
import { test } from './fixtures.ts';

type Page = typeof import('./page/puff.ts');

test('puff draws smoke and resolves when it is gone', async ({ load }) => {
  const page = await load<Page>('/tests/engines/page/puff.ts');
  const { most, after, canvases, visibility } = await page.playPuff('poof');
  expect(most).toBeGreaterThan(20);
  expect(after).toBe(0);
  expect(canvases).toBe(1);
  expect(visibility).toBe('');
  const vanished = await page.playPuff('vanish');
  expect(vanished.most).toBeGreaterThan(20);
  expect(vanished.visibility).toBe('hidden');
});
