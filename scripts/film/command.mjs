#!/usr/bin/env node
/** The command `cartoon-smoke` of the package. */

import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { conclude, UserError } from '../lib/userError.mjs';
import { film } from './film.mjs';
import { flipbook } from './flipbook.mjs';
import { FLIPBOOK_USAGE, USAGE } from './options.mjs';

const USAGES = { film: USAGE, flipbook: FLIPBOOK_USAGE };

// Paths in the package, where this file is bundled to the folder film/.
const inPackage = (/** @type {string} */ path) => fileURLToPath(new URL(path, import.meta.url));

await conclude(async () => {
  const [name, ...words] = process.argv.slice(2);
  const files = { page: inPackage('./page'), wasm: inPackage('../dist/wasm') };
  if (name === undefined || name === '--help') return console.log(list(inPackage('../docs')));
  if (name !== 'film' && name !== 'flipbook') {
    throw new UserError(`There is no command ${name}: cartoon-smoke without a command lists them.`);
  }
  if (words.includes('--help')) return console.log(`Usage: ${USAGES[name]}`);
  if (name === 'flipbook') return flipbook(words, files);
  const { version } = JSON.parse(readFileSync(inPackage('../package.json'), 'utf8'));
  return film(words, files, version);
});

/** @param {string} guides folder of the documents */
function list(guides) {
  return `Usage: cartoon-smoke COMMAND LINK [options]

  film         writes the frames of a share link as PNG or OpenEXR files, and a video of them; or a wipe as a
               stinger for OBS Studio and editors
  flipbook     writes a share link as an atlas of a seamless loop for games

cartoon-smoke COMMAND --help lists the options of a command. Guides of this version: ${guides}`;
}
