/** Draws a flipbook: opens the film page in a browser and keeps the files that it sends. */

import { join } from 'node:path';
import { prepareFolder, writeWhole } from './files.mjs';
import { readFlipbookOptions } from './options.mjs';
import { bytesOf, PageRun, untilStopped } from './pageRun.mjs';

/**
 * `cartoon-smoke flipbook`.
 *
 * @param {string[]} words after `flipbook`
 * @param {import('./server.mjs').PageFiles} files of the page
 * @returns {Promise<number>} the exit status
 */
export async function flipbook(words, files) {
  const { order, out, usesGpu } = readFlipbookOptions(words);
  prepareFolder(out);
  const page = new PageRun();
  return untilStopped('Flipbook', page, async (say) => {
    await page.run(files, usesGpu, async ({ method, path, body }) => {
      const [, name] = /^file\/((?:color|channels|normals|motion|lightA|lightB)\.png|flipbook\.json)$/.exec(path) ?? [];
      if (path === 'order') return { body: JSON.stringify(order) };
      if (path === 'progress') say(`${Math.round(100 * Number(await bytesOf(body)))} % are drawn`);
      else if (method === 'PUT' && name) await writeWhole(join(out, name), body);
      else return undefined;
      return {};
    });
    return `${order.columns * order.rows} frames in ${out}`;
  });
}
