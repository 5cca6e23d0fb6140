/**
 * `npm run poster -- LINK FILE`: renders the first picture of an element with this share link as a PNG, for its
 * `poster` slot. The link's `t` sets the time; `--size WIDTHxHEIGHT` sets the size in pixels of the file, 640x360 by
 * default, and `--scale` the pixels per CSS pixel, as for `npm run film`.
 */

import { writeFileSync } from 'node:fs';
import { evaluateInPage } from '../tests/bench/support/page.mjs';
import { readLink, readScale } from './film/options.mjs';
import { readArguments } from './lib/arguments.mjs';
import { conclude, UserError } from './lib/userError.mjs';
import { setUp, TESTS } from './setup/setup.mjs';

const USAGE = 'npm run poster -- LINK FILE [--size WIDTHxHEIGHT] [--scale N] [--transparent]';

await conclude(async () => {
  const { values, positionals } = readArguments(
    {
      size: { type: 'string', default: '640x360' },
      scale: { type: 'string' },
      transparent: { type: 'boolean', default: false },
    },
    USAGE,
  );
  const [address, file] = positionals;
  const size = /^(\d{1,4})x(\d{1,4})$/.exec(values.size);
  if (positionals.length !== 2 || !size) throw new UserError(`Name a link and a file. Usage: ${USAGE}`);
  const link = readLink(address);
  const scale = readScale(values.scale, Number(size[2]));
  await setUp(TESTS);
  const [width, height] = [Number(size[1]) / scale, Number(size[2]) / scale];
  const order = { link, width, height, isTransparent: values.transparent };
  const draw = `import('/tests/visual/page/element/poster.cases.ts').then(({ poster }) => poster(${JSON.stringify(order)}))`;
  const { png, notices } = /** @type {{ png: string, notices: string[] }} */ (
    await evaluateInPage(draw, console.log, [], undefined, scale)
  );
  for (const notice of notices) console.log(notice);
  writeFileSync(file, Buffer.from(png, 'base64'));
  console.log(`Wrote ${file}.`);
});
