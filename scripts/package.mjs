/**
 * `npm run package`: writes the npm package to package/ and as a tarball beside it, and prints the size and integrity
 * hash of each file that CDNs serve.
 */

import { readArguments } from './lib/arguments.mjs';
import { inRoot } from './lib/paths.mjs';
import { withProgress } from './lib/progress.mjs';
import { conclude } from './lib/userError.mjs';
import { hashes } from './package/measure.mjs';
import * as packaged from './setup/package.mjs';
import { PAGE, setUp } from './setup/setup.mjs';

await conclude(async () => {
  readArguments({}, 'npm run package');
  await setUp(PAGE);
  await withProgress(packaged.title, packaged.bring);
  for (const { file, integrity, kB } of hashes(inRoot(`${packaged.FOLDER}/dist`))) {
    console.log(`dist/${file}: ${kB.toFixed(1)} kB gzip, integrity="${integrity}"`);
  }
  console.log(
    `The package is in ${packaged.FOLDER}/. Install it elsewhere with npm install ${inRoot(packaged.ARCHIVE)}`,
  );
});
