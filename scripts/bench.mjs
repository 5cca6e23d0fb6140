/**
 * `npm run bench -- SUITE [--quick] [--json FILE]`: runs tests/bench/SUITE.mjs, prints its figures as a table and
 * writes them as `{ suite, commit, figures }`.
 *
 * A suite exports `run({ quick })`, which resolves to its figures, and optionally `summary(figures)`, which returns
 * text to print below the table, and `failures(figures)`, whose sentences end the command with status 1.
 */

import { existsSync, mkdirSync, readdirSync, writeFileSync } from 'node:fs';
import { dirname, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { figuresTable } from './bench/table.mjs';
import { readArguments } from './lib/arguments.mjs';
import { run } from './lib/command.mjs';
import { inRoot } from './lib/paths.mjs';
import { withProgress } from './lib/progress.mjs';
import { conclude, UserError } from './lib/userError.mjs';
import { setUp, TESTS } from './setup/setup.mjs';

/** @typedef {import('./bench/table.mjs').Figure} Figure */

const USAGE = 'npm run bench -- SUITE [--quick] [--json FILE]';
const FOLDER = 'tests/bench';

await conclude(async () => {
  const { values, positionals } = readArguments(
    { quick: { type: 'boolean', default: false }, json: { type: 'string' } },
    USAGE,
  );
  const suite = chooseSuite(positionals);
  // Resolved before the run, so that an error appears at once and not after minutes. npm runs this in the package
  // folder.
  const file = values.json === undefined ? undefined : resolve(values.json);
  await setUp(TESTS);
  const { figures, summary, failures } = await measure(suite, values.quick);
  console.log(figuresTable(figures));
  if (summary) console.log(`\n${summary}`);
  if (file) {
    mkdirSync(dirname(file), { recursive: true });
    writeFileSync(file, `${JSON.stringify({ suite, commit: await commit(), figures }, null, 2)}\n`);
  }
  if (failures.length > 0) throw new UserError(failures.join('\n'));
});

/** @param {string[]} names */
function chooseSuite(names) {
  const known = existsSync(inRoot(FOLDER))
    ? readdirSync(inRoot(FOLDER))
        .filter((name) => name.endsWith('.mjs'))
        .map((name) => name.slice(0, -'.mjs'.length))
    : [];
  const list = known.length > 0 ? `The suites are ${known.join(', ')}.` : 'There are no suites yet.';
  if (names.length !== 1) throw new UserError(`Name one suite: ${USAGE}. ${list}`);
  if (!known.includes(names[0])) throw new UserError(`There is no suite named ${names[0]}. ${list}`);
  return names[0];
}

/** @param {string} suite @param {boolean} quick @returns {Promise<{ figures: Figure[], summary?: string, failures: string[] }>} */
async function measure(suite, quick) {
  const module = await import(pathToFileURL(inRoot(`${FOLDER}/${suite}.mjs`)).href);
  if (typeof module.run !== 'function')
    throw new UserError(`${FOLDER}/${suite}.mjs is not a suite: it must export run().`);
  const figures = await withProgress(`Bench ${suite}`, (say) => module.run({ quick, say }));
  if (!Array.isArray(figures) || figures.length === 0) throw new UserError(`The suite ${suite} measured nothing.`);
  return { figures, summary: module.summary?.(figures), failures: module.failures?.(figures) ?? [] };
}

/** The measured commit, marked if the working tree differs from it. */
async function commit() {
  const head = await run('git', ['rev-parse', 'HEAD']);
  const changes = await run('git', ['status', '--porcelain']);
  if (head.status !== 0) return 'unknown';
  return changes.output === '' ? head.output : `${head.output}-modified`;
}
