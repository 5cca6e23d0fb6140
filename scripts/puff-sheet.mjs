/**
 * `npm run puffs:sheet`: renders the puffs as contact sheets, for review after a shape changes. .cache/lobe-sheet.png
 * shows the lobes from many sides, .cache/puff-sheet.png the baked layers. Rendered on the CPU, so the result is the
 * same on every machine.
 */

import { mkdirSync } from 'node:fs';
import { pathToFileURL } from 'node:url';
import { build } from 'esbuild';
import { inRoot } from './lib/paths.mjs';
import { conclude } from './lib/userError.mjs';

await conclude(async () => {
  mkdirSync(inRoot('.cache'), { recursive: true });
  for (const name of ['lobe-sheet', 'puff-sheet']) {
    const bundle = inRoot(`.cache/${name}.mjs`);
    await build({
      entryPoints: [inRoot(`tests/bench/${name}.ts`)],
      outfile: bundle,
      bundle: true,
      platform: 'node',
      format: 'esm',
      packages: 'external',
    });
    const { writeSheet } = await import(pathToFileURL(bundle).href);
    const sheet = inRoot(`.cache/${name}.png`);
    writeSheet(sheet);
    console.log(`Wrote ${sheet}.`);
  }
});
