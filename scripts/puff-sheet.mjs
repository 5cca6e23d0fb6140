/**
 * `npm run puffs:sheet`: draws the puffs as contact sheets, to look at after changing a shape: of lobes from many sides
 * in .cache/lobe-sheet.png, the baked layers in .cache/puff-sheet.png. All on the CPU, the same on every machine.
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
