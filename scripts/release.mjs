/** `npm run release:check -- TAG`: checks that the tag, the package version and the changelog match. */

import { readFileSync } from 'node:fs';
import { readArguments } from './lib/arguments.mjs';
import { inRoot } from './lib/paths.mjs';
import { conclude, UserError } from './lib/userError.mjs';

const USAGE = 'npm run release:check -- TAG';

await conclude(async () => {
  const { positionals } = readArguments({}, USAGE);
  if (positionals.length !== 1) throw new UserError(`Name one tag. Usage: ${USAGE}`);
  const { version } = JSON.parse(readFileSync(inRoot('package.json'), 'utf8'));
  requireTag(positionals[0], version);
  requireNotes(version);
  console.log(`Version ${version} can be released.`);
});

function requireTag(/** @type {string} */ tag, /** @type {string} */ version) {
  if (tag === `v${version}`) return;
  throw new UserError(
    `The tag is ${tag}, but package.json has version ${version}: tag v${version}, or change the version.`,
  );
}

/** A release must have changelog entries. */
function requireNotes(/** @type {string} */ version) {
  const sections = readFileSync(inRoot('CHANGELOG.md'), 'utf8').split(/^## /m).slice(1);
  const notes = sections.find((section) => section.split(/\s/, 1)[0] === version);
  if (notes && /^- /m.test(notes)) return;
  throw new UserError(`CHANGELOG.md has no entries for ${version}: rename the heading Unreleased to ${version}.`);
}
