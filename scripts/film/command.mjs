#!/usr/bin/env node
/** The command `cartoon-smoke` of the package. */

import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { conclude, UserError } from '../lib/userError.mjs';
import { film } from './film.mjs';
import { flipbook } from './flipbook.mjs';
import { FLIPBOOK_USAGE, USAGE } from './options.mjs';

// Paths in the package, where this file is bundled to the folder film/.
const inPackage = (/** @type {string} */ path) => fileURLToPath(new URL(path, import.meta.url));

await conclude(async () => {
  const [name, ...words] = process.argv.slice(2);
  const files = { page: inPackage('./page'), wasm: inPackage('../dist/wasm') };
  if (name === undefined || name === '--help' || words.includes('--help')) {
    return console.log(`Usage: ${USAGE}\n\n${FLIPBOOK_USAGE}`);
  }
  if (name === 'flipbook') return flipbook(words, files);
  if (name !== 'film') throw new UserError(`There is no command ${name}: cartoon-smoke --help shows the usage.`);
  const { version } = JSON.parse(readFileSync(inPackage('../package.json'), 'utf8'));
  return film(words, files, version);
});
