/** Writes the type declarations of the package's exports. */

import { existsSync, mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { runScript } from '../lib/command.mjs';
import { inRoot } from '../lib/paths.mjs';
import { UserError } from '../lib/userError.mjs';
import { writeElementTypes } from './elementTypes.mjs';

const ENTRIES = ['index', 'clip', 'element', 'fiber', 'preset', 'puff', 'script'].map((name) => `src/${name}.ts`);
/** Existing declarations, which the compiler reads but does not write. */
const GIVEN = ['core', 'meshes', 'physics'].map((variant) => `simulator/wasm/${variant}/bindings.d.ts`);

/** Names of the modules that a declaration refers to. */
const REFERENCE = /(?:from|import) ?\(?['"](\.{1,2}\/[^'"]+)\.js['"]/g;

/** Declarations of a file that a bundler's file loader imports as its URL. */
const ASSET = 'declare const url: string;\nexport default url;\n';

/**
 * @param {string} folder
 * @param {(line: string) => void} say
 */
export async function writeTypes(folder, say) {
  const config = inRoot('scripts/package/tsconfig.json');
  const parameters = ['-p', config, '--outDir', folder];
  const { status, output } = await runScript('node_modules/typescript/bin/tsc', parameters, { onLine: say });
  if (status !== 0) throw new UserError(`The type declarations of ${ENTRIES.join(', ')} could not be built.`, output);
  for (const file of GIVEN) {
    mkdirSync(dirname(join(folder, file)), { recursive: true });
    // Disposal by `using` is newer than most projects' compile target, and only this project calls the bindings.
    const text = readFileSync(inRoot(`src/${file}`), 'utf8').replace(/^\s*\[Symbol\.dispose\].*\n/gm, '');
    writeFileSync(join(folder, file), text);
  }
  for (const file of readdirSync(folder, { recursive: true, encoding: 'utf8' })) {
    if (file.endsWith('.d.ts')) nameBuiltFiles(join(folder, file));
  }
  writeElementTypes(folder);
  writeFileSync(join(folder, 'asset.d.ts'), ASSET);
}

/**
 * Removes declarations that no entry refers to, which are more than half of all files.
 * @param {string} folder
 * @param {readonly string[]} kept paths of the declarations of the entries
 */
export function removeUnused(folder, kept) {
  const used = new Set(kept);
  for (const path of used) {
    for (const [, name] of readFileSync(path, 'utf8').matchAll(REFERENCE)) {
      const other = join(dirname(path), `${name}.d.ts`);
      // A set also visits what is added meanwhile.
      if (existsSync(other)) used.add(other);
    }
  }
  for (const file of readdirSync(folder, { recursive: true, encoding: 'utf8' })) {
    const path = join(folder, file);
    if (file.endsWith('.d.ts') && !used.has(path)) rmSync(path);
  }
}

/** Sources import `.ts` files; the package contains `.js` files. */
function nameBuiltFiles(/** @type {string} */ path) {
  const text = readFileSync(path, 'utf8');
  writeFileSync(path, text.replace(/((?:from|import) ?\(?(['"])\.{1,2}\/[^'"]+)\.ts\2/g, '$1.js$2'));
}
