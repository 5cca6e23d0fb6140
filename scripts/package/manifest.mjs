/** The package.json of the npm package. */

import { readFileSync } from 'node:fs';
import { inRoot } from '../lib/paths.mjs';

/** @type {{ name: string, version: string, description: string, license: string, repository: string, dependencies: { three: string } }} */
const project = JSON.parse(readFileSync(inRoot('package.json'), 'utf8'));

/** Web URL of the GitHub repository in package.json. */
const address = githubAddress(project.repository);

/** Omits the fields of the project's package.json that only development needs. */
export const manifest = {
  name: project.name,
  version: project.version,
  description: project.description,
  license: project.license,
  repository: { type: 'git', url: `git+${address}.git` },
  homepage: `${address}#readme`,
  bugs: { url: `${address}/issues` },
  type: 'module',
  keywords: ['cartoon', 'smoke', 'clouds', 'particles', 'three', 'webgl2', 'wasm', 'web-component', 'custom-element'],
  exports: {
    '.': { types: './types/index.d.ts', default: './dist/index.js' },
    './element': { types: './types/element/define.d.ts', default: './dist/element.js' },
    './react': { types: './types/jsx/react.d.ts', default: './dist/element.js' },
    './preact': { types: './types/jsx/preact.d.ts', default: './dist/element.js' },
    './solid': { types: './types/jsx/solid.d.ts', default: './dist/element.js' },
    './preset': { types: './types/preset.d.ts', default: './dist/preset.js' },
    './cartoon-smoke.min.js': { types: './types/element/define.d.ts', default: './dist/cartoon-smoke.min.js' },
    './custom-elements.json': './custom-elements.json',
    './package.json': './package.json',
  },
  customElements: './custom-elements.json',
  bin: { 'cartoon-smoke': 'film/command.js' },
  files: ['dist', 'film', 'types', 'custom-elements.json'],
  sideEffects: ['./dist/element.js', './dist/cartoon-smoke.min.js'],
  peerDependencies: { three: project.dependencies.three },
};

/** @param {string} repository npm's shorthand, `github:owner/name` */
function githubAddress(repository) {
  const path = /^github:([\w-]+\/[\w.-]+)$/.exec(repository)?.[1];
  if (!path) throw new Error(`repository in package.json is ${repository}: write it as github:owner/name.`);
  return `https://github.com/${path}`;
}
