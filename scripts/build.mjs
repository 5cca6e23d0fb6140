/** `npm run build`: writes the demo page to dist/ as a static site that works from any folder of any host. */

import { readArguments } from './lib/arguments.mjs';
import { conclude } from './lib/refusal.mjs';
import { PAGE, setUp } from './setup/setup.mjs';
import * as site from './setup/site.mjs';
import { withProgress } from './lib/progress.mjs';

await conclude(async () => {
  readArguments({}, 'npm run build');
  await setUp(PAGE);
  await withProgress(site.title, site.bring);
  console.log('The site is in dist/.');
});
