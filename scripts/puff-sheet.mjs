/**
 * `npm run puffs:sheet`: draws the baked puffs as a contact sheet, .cache/puff-sheet.png, to look at after changing
 * a shape. The layers are made on the CPU, so the sheet is the same on every machine.
 */

import { mkdirSync } from 'node:fs';
import { pathToFileURL } from 'node:url';
import { build } from 'esbuild';
import { inRoot } from './lib/paths.mjs';
import { conclude } from './lib/refusal.mjs';

await conclude(async () => {
  const sheet = inRoot('.cache/puff-sheet.png');
  const bundle = inRoot('.cache/puff-sheet.mjs');
  mkdirSync(inRoot('.cache'), { recursive: true });
  await build({
    entryPoints: [inRoot('tests/bench/puff-sheet.ts')],
    outfile: bundle,
    bundle: true,
    platform: 'node',
    format: 'esm',
    packages: 'external',
  });
  const { writeSheet } = await import(pathToFileURL(bundle).href);
  writeSheet(sheet);
  console.log(`Wrote ${sheet}.`);
});
