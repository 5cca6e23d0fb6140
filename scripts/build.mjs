/**
 * `npm run build [-- --out FOLDER]`: writes the demo page to dist/ as a static site that works in any folder of any
 * host. CARTOON_SMOKE_BASE is the URL at which it will be published, for files that need absolute URLs.
 */

import { resolve } from 'node:path';
import { readArguments } from './lib/arguments.mjs';
import { conclude } from './lib/userError.mjs';
import { PAGE, setUp } from './setup/setup.mjs';
import * as site from './setup/site.mjs';
import { withProgress } from './lib/progress.mjs';
import { publishedAt } from './site/published.mjs';

await conclude(async () => {
  const { values } = readArguments({ out: { type: 'string' } }, 'npm run build -- [--out FOLDER]');
  publishedAt();
  await setUp(PAGE);
  const { out } = values;
  await withProgress(site.title, out ? (say) => site.build(resolve(out), say) : site.bringWhole);
  console.log(`The site is in ${out ?? 'dist/'}.`);
});
