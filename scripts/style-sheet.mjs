/**
 * `npm run style:sheet`: renders the sixteen combinations of shading, shadows, outlines and gradient as a contact sheet
 * in .cache/style-sheet.png, for review after rendering changes. The result is reproducible.
 */

import { mkdirSync, writeFileSync } from 'node:fs';
import { evaluateInPage } from '../tests/bench/support/page.mjs';
import { inRoot } from './lib/paths.mjs';
import { conclude } from './lib/userError.mjs';
import { PICTURES, setUp } from './setup/setup.mjs';

await conclude(async () => {
  await setUp(PICTURES);
  const draw = `import('/tests/visual/renderer/styles.cases.ts').then((cases) => cases.sheet())`;
  const picture = await evaluateInPage(draw, (line) => console.log(line));
  mkdirSync(inRoot('.cache'), { recursive: true });
  const sheet = inRoot('.cache/style-sheet.png');
  writeFileSync(sheet, Buffer.from(String(picture), 'base64'));
  console.log(`Wrote ${sheet}.`);
});
