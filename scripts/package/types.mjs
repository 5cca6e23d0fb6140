/** Writes the declarations of what the package exports. */

import { mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { run } from '../lib/command.mjs';
import { inRoot } from '../lib/paths.mjs';
import { UserError } from '../lib/userError.mjs';
import { writeElementTypes } from './elementTypes.mjs';

const ENTRIES = ['src/index.ts', 'src/element/define.ts', 'src/preset.ts'];
/** Declarations that are there already; the compiler only follows them. */
const GIVEN = ['sim/wasm/core/bindings.d.ts', 'sim/wasm/physics/bindings.d.ts'];

/** @param {string} folder @param {(line: string) => void} say */
export async function writeTypes(folder, say) {
  const compiler = inRoot('node_modules/typescript/bin/tsc');
  const config = inRoot('scripts/package/tsconfig.json');
  const parameters = ['-p', config, '--outDir', folder];
  const { status, output } = await run(process.execPath, [compiler, ...parameters], { onLine: say });
  if (status !== 0) throw new UserError(`The type declarations of ${ENTRIES.join(', ')} could not be built.`, output);
  for (const file of GIVEN) {
    mkdirSync(dirname(join(folder, file)), { recursive: true });
    // Disposal by `using` is newer than what most projects compile for, and nobody outside calls these.
    const text = readFileSync(inRoot(`src/${file}`), 'utf8').replace(/^\s*\[Symbol\.dispose\].*\n/gm, '');
    writeFileSync(join(folder, file), text);
  }
  for (const file of readdirSync(folder, { recursive: true, encoding: 'utf8' })) {
    if (file.endsWith('.d.ts')) nameBuiltFiles(join(folder, file));
  }
  writeElementTypes(folder);
}

/** Sources name each other by `.ts`; what is shipped is named by `.js`. */
function nameBuiltFiles(/** @type {string} */ path) {
  const text = readFileSync(path, 'utf8');
  writeFileSync(path, text.replace(/((?:from|import) ?\(?(['"])\.{1,2}\/[^'"]+)\.ts\2/g, '$1.js$2'));
}
