/** The package.json of the npm package. */

import { readFileSync } from 'node:fs';
import { inRoot } from '../lib/paths.mjs';

/** @type {{ name: string, version: string, description: string, license: string, repository: string }} */
const project = JSON.parse(readFileSync(inRoot('package.json'), 'utf8'));

/** Web URL of the GitHub repository in package.json. */
export const address = githubAddress(project.repository);

/**
 * A module and, for development builds, one with warnings.
 * @param {string} name
 */
const warning = (name) => ({ development: `./dist/development/${name}.js`, default: `./dist/${name}.js` });
const ELEMENT = warning('element');

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
  keywords: [
    'cartoon',
    'smoke',
    'clouds',
    'particles',
    'three',
    'webgl2',
    'wasm',
    'web-component',
    'custom-element',
    'confetti',
  ],
  exports: {
    '.': { types: './types/index.d.ts', ...warning('index') },
    './element': { types: './types/element.d.ts', ...ELEMENT },
    './react': { types: './types/jsx/react.d.ts', ...ELEMENT },
    './preact': { types: './types/jsx/preact.d.ts', ...ELEMENT },
    './solid': { types: './types/jsx/solid.d.ts', ...ELEMENT },
    './svelte': { types: './types/jsx/svelte.d.ts', ...ELEMENT },
    './vue': { types: './types/jsx/vue.d.ts', ...ELEMENT },
    './fiber': { types: './types/fiber.d.ts', ...warning('fiber') },
    './clip': { types: './types/clip.d.ts', ...warning('clip') },
    './puff': { types: './types/puff.d.ts', ...warning('puff') },
    './preset': { types: './types/preset.d.ts', default: './dist/preset.js' },
    './cartoon-smoke.min.js': { types: './types/script.d.ts', default: './dist/cartoon-smoke.min.js' },
    './cartoon-smoke.development.js': {
      types: './types/script.d.ts',
      default: './dist/cartoon-smoke.development.js',
    },
    './core.wasm': { types: './types/asset.d.ts', default: './dist/wasm/core/bindings_bg.wasm' },
    './meshes.wasm': { types: './types/asset.d.ts', default: './dist/wasm/meshes/bindings_bg.wasm' },
    './physics.wasm': { types: './types/asset.d.ts', default: './dist/wasm/physics/bindings_bg.wasm' },
    './stageModel.js': { types: './types/asset.d.ts', default: './dist/stageModel.js' },
    './worker.js': { types: './types/asset.d.ts', default: './dist/worker.js' },
    './custom-elements.json': './custom-elements.json',
    './html-custom-data.json': './html-custom-data.json',
    './web-types.json': './web-types.json',
    './package.json': './package.json',
  },
  unpkg: './dist/cartoon-smoke.min.js',
  jsdelivr: './dist/cartoon-smoke.min.js',
  customElements: './custom-elements.json',
  'web-types': './web-types.json',
  bin: { 'cartoon-smoke': 'film/command.js' },
  files: ['dist', 'docs', 'film', 'types', 'custom-elements.json', 'html-custom-data.json', 'web-types.json'],
  sideEffects: [
    './dist/element.js',
    './dist/development/*.js',
    './dist/cartoon-smoke.min.js',
    './dist/cartoon-smoke.development.js',
  ],
  // From the oldest release that uploads ranges of textures. tests/e2e/package/versions.long.spec.ts installs both ends.
  peerDependencies: { '@react-three/fiber': '^9.0.0', react: '>=19', three: '>=0.177.0 <1' },
  peerDependenciesMeta: { '@react-three/fiber': { optional: true }, react: { optional: true } },
};

/** @param {string} repository npm's shorthand, `github:owner/name` */
function githubAddress(repository) {
  const path = /^github:([\w-]+\/[\w.-]+)$/.exec(repository)?.[1];
  if (!path) throw new Error(`repository in package.json is ${repository}: write it as github:owner/name.`);
  return `https://github.com/${path}`;
}
