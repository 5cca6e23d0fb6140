/** Colours in screenshots. */
import type { Page } from '@playwright/test';
import { PNG } from 'pngjs';

/** Number of pixels of a screenshot that have exactly this colour. @param color `#rrggbb` */
export async function pixelsOf(page: Page, color: string): Promise<number> {
  const wanted = Number.parseInt(color.slice(1), 16);
  const { data } = PNG.sync.read(await page.screenshot());
  let count = 0;
  for (let at = 0; at < data.length; at += 4) {
    if (((data[at] << 16) | (data[at + 1] << 8) | data[at + 2]) === wanted) count++;
  }
  return count;
}
