/**
 * Builds `embed.html` with its script: one classic script that contains everything, including the simulator's core, and
 * one for each larger simulator, loaded on demand. In a sandbox with an opaque origin, a page can load only classic
 * scripts.
 */

import { createHash } from 'node:crypto';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { deflateRawSync } from 'node:zlib';
import { rolldown } from 'rolldown';
import { inRoot } from '../lib/paths.mjs';
import { modelBy, shrinking, SMALL } from '../package/bundle.mjs';

/** @type {readonly ('meshes' | 'physics')[]} */
const LARGER = ['meshes', 'physics'];
const ENTRY = '<script type="module" src="./src/page/iframe/main.ts"></script>';

/** A frame has no models: their code is rarely needed, and a sandbox could not load it by its URL. */
const NO_MODELS = "Promise.reject(new Error('an iframe of embed.html has none. Use the element or a stage instead.'))";

/**
 * Writes the page and its scripts.
 * @param {string} folder of a built site
 */
export async function buildFrame(folder) {
  const larger = LARGER.map((name) => {
    const code = `bring_${name}(${JSON.stringify(packed(name))});\n`;
    return [name, `./${writeScript(folder, `embed-${name}`, code)}`];
  });
  const script = writeScript(folder, 'embed', await scriptOf(Object.fromEntries(larger)));
  const page = readFileSync(inRoot('embed.html'), 'utf8');
  if (!page.includes(ENTRY)) throw new Error(`embed.html lacks ${ENTRY}.`);
  writeFileSync(join(folder, 'embed.html'), page.replace(ENTRY, `<script defer src="./${script}"></script>`));
}

/** @param {Record<string, string>} larger URLs of the scripts with the larger simulators */
async function scriptOf(larger) {
  const values = { CORE_WASM: packed('core'), WASM_SCRIPTS: larger };
  const define = Object.fromEntries(Object.entries(values).map(([name, value]) => [name, JSON.stringify(value)]));
  const build = await rolldown({
    ...SMALL,
    input: inRoot('src/page/iframe/main.ts'),
    plugins: [...shrinking(), modelBy(NO_MODELS)],
    transform: { ...SMALL.transform, define: { ...SMALL.transform?.define, ...define } },
    // This script contains everything it needs, so it does not use URLs relative to import.meta.
    checks: { ...SMALL.checks, emptyImportMeta: false },
  });
  const { output } = await build.generate({ format: 'iife', codeSplitting: false, minify: true });
  await build.close();
  return output[0].code;
}

/**
 * The WASM of a variant, compressed with raw deflate, in base64url.
 * @param {'core' | 'meshes' | 'physics'} variant
 */
function packed(variant) {
  const bytes = readFileSync(inRoot(`src/simulator/wasm/${variant}/bindings_bg.wasm`));
  return deflateRawSync(bytes, { level: 9 }).toString('base64url');
}

/**
 * Writes a script with a content hash in its name.
 * @param {string} folder
 * @param {string} name
 * @param {string} code
 */
function writeScript(folder, name, code) {
  const hash = createHash('sha256').update(code).digest('base64url').slice(0, 8);
  const path = `assets/${name}-${hash}.js`;
  mkdirSync(join(folder, 'assets'), { recursive: true });
  writeFileSync(join(folder, path), code);
  return path;
}
