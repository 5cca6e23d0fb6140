/**
 * `npm run bench -- host`: smoke in a three.js scene of somebody else: what handles leave behind, bursts, smoke without
 * particles, and the bytes that `import { CartoonSmoke }` adds to a page with three.js.
 */

import { cpSync, mkdirSync, mkdtempSync, rmSync, symlinkSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { gzipSync } from 'node:zlib';
import { pathToFileURL } from 'node:url';
import { rolldown } from 'rolldown';
import { run as runCommand } from '../../scripts/lib/command.mjs';
import { inRoot, root } from '../../scripts/lib/paths.mjs';
import { measureInPage } from './support/page.mjs';

/** The commit that the size is compared with: before handles, transforms and targets. */
const BEFORE = '0e84760';

/** @param {import('./support/page.mjs').Choice} choice @returns {Promise<import('../../scripts/bench/table.mjs').Figure[]>} */
export async function run(choice) {
  const measured = await measureInPage('/tests/bench/host/suite.ts', choice);
  const folder = mkdtempSync(join(tmpdir(), 'cartoon-smoke-host-'));
  try {
    choice.say('size');
    const now = await addedBytes(root, join(folder, 'now'));
    const before = await bytesBefore(folder, choice.say);
    const figures = [
      { name: 'host.importKb', value: now / 1000, unit: 'kB', note: 'gzip, JavaScript beside three.js' },
    ];
    if (before === undefined) return [...measured, ...figures];
    const note = `of ${BEFORE}, ${(before / 1000).toFixed(1)} kB; at most 90`;
    return [...measured, ...figures, { name: 'host.importRatio', value: (100 * now) / before, unit: '%', note }];
  } finally {
    rmSync(folder, { recursive: true });
  }
}

/** The same of the earlier commit; undefined where git does not have it or it cannot be built. */
async function bytesBefore(folder, say) {
  const old = join(folder, 'old');
  mkdirSync(old);
  const archive = join(folder, 'old.tar');
  const steps = [
    ['git', ['archive', '-o', archive, BEFORE]],
    ['tar', ['-xf', archive, '-C', old]],
  ];
  for (const [program, parameters] of steps) {
    const { status } = await runCommand(program, parameters);
    if (status !== 0) return undefined;
  }
  say(`size of ${BEFORE}`);
  symlinkSync(inRoot('node_modules'), join(old, 'node_modules'));
  // The bindings of the simulator, of which only the file names count.
  cpSync(inRoot('src/simulator/wasm'), join(old, 'src/simulator/wasm'), { recursive: true });
  try {
    return await addedBytes(old, join(folder, 'before'));
  } catch {
    return undefined;
  }
}

/** Bytes of the modules that `import { CartoonSmoke }` loads at once, as a bundler with three.js elsewhere writes them. */
async function addedBytes(sources, folder) {
  const { bundleAll } = await import(pathToFileURL(join(sources, 'scripts/package/bundle.mjs')).href);
  await bundleAll(folder);
  const entry = 'host-entry';
  const build = await rolldown({
    input: entry,
    external: /^three(\/|$)/,
    treeshake: { moduleSideEffects: false },
    plugins: [
      {
        name: 'host-entry',
        resolveId: (id) => (id === entry ? id : undefined),
        load: (id) =>
          id === entry ? `export { CartoonSmoke } from ${JSON.stringify(join(folder, 'index.js'))};` : undefined,
      },
    ],
    checks: { bundlerTimings: false },
  });
  const { output } = await build.generate({ format: 'esm', minify: true });
  await build.close();
  const chunks = new Map(output.flatMap((each) => (each.type === 'chunk' ? [[each.fileName, each]] : [])));
  const loaded = new Set([output[0].fileName]);
  for (const name of loaded) for (const next of chunks.get(name)?.imports ?? []) if (chunks.has(next)) loaded.add(next);
  return [...loaded].reduce((sum, name) => sum + gzipSync(chunks.get(name).code, { level: 9 }).length, 0);
}
