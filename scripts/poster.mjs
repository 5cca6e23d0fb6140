/**
 * `npm run poster -- LINK FILE`: renders the first picture of an element with this share link as a PNG, for its
 * `poster` slot. The link's `t` sets the time; `--size WIDTHxHEIGHT` sets the size. Default: 640x360.
 */

import { writeFileSync } from 'node:fs';
import { evaluateInPage } from '../tests/bench/support/page.mjs';
import { readArguments } from './lib/arguments.mjs';
import { conclude, UserError } from './lib/userError.mjs';
import { setUp, TESTS } from './setup/setup.mjs';

const USAGE = 'npm run poster -- LINK FILE [--size WIDTHxHEIGHT] [--transparent]';

await conclude(async () => {
  const { values, positionals } = readArguments(
    { size: { type: 'string', default: '640x360' }, transparent: { type: 'boolean', default: false } },
    USAGE,
  );
  const [link, file] = positionals;
  const size = /^(\d{1,4})x(\d{1,4})$/.exec(values.size);
  if (positionals.length !== 2 || !size) throw new UserError(`Name a link and a file. Usage: ${USAGE}`);
  await setUp(TESTS);
  const order = { link, width: Number(size[1]), height: Number(size[2]), isTransparent: values.transparent };
  const draw = `import('/tests/visual/element/poster.cases.ts').then(({ poster }) => poster(${JSON.stringify(order)}))`;
  const { png, notices } = /** @type {{ png: string, notices: string[] }} */ (await evaluateInPage(draw, console.log));
  for (const notice of notices) console.log(notice);
  writeFileSync(file, Buffer.from(png, 'base64'));
  console.log(`Wrote ${file}.`);
});
