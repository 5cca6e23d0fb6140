/**
 * `npm run bench -- package`: the sizes of the scripts of the package that have a limit, and what each step of the build
 * saves in them: the size without the step minus the size with it.
 */

import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import glsl from 'vite-plugin-glsl';
import { bundleAll, shrinking } from '../../scripts/package/bundle.mjs';
import { kilobytes } from '../../scripts/package/measure.mjs';

/**
 * The files of each size that tests/e2e/page/element/size.spec.ts limits. The core is a wisp on the page's main thread.
 * @type {Record<string, string[]>}
 */
const FILES = {
  core: 'element cartoonSmokeElement session zoom stage shaders errors core wisp wispPresets models rolldown-runtime'.split(
    ' ',
  ),
  worker: ['worker'],
  cdn: ['cartoon-smoke.min'],
};

/** @param {import('./support/page.mjs').Choice} choice @returns {Promise<import('../../scripts/bench/table.mjs').Figure[]>} */
export async function run({ say }) {
  say('with all steps');
  const sizes = await sizesWith(shrinking());
  const figures = Object.entries(sizes).map(([name, value]) => figure(name, value, 'gzip'));
  for (const [step, plugins] of variants(shrinking())) {
    say(`without ${step}`);
    for (const [name, value] of Object.entries(await sizesWith(plugins)))
      figures.push(figure(`${name}.${step}`, value - sizes[name], 'saved'));
  }
  return figures;
}

/** A pair of a step and the plugins without it. Shaders are always loaded. */
function variants([shaders, ...others]) {
  const without = (step) => [shaders, ...others.filter((plugin) => plugin !== step)];
  return [['shader-minifier', [glsl(), ...others]], ...others.map((step) => [step.name, without(step)])];
}

function figure(name, value, note) {
  return { name: `package.${name}`, value, unit: 'kB', note };
}

async function sizesWith(plugins) {
  const folder = mkdtempSync(join(tmpdir(), 'cartoon-smoke-package-'));
  try {
    await bundleAll(folder, plugins);
    const sizeOf = (files) => files.reduce((sum, file) => sum + kilobytes(join(folder, `${file}.js`)), 0);
    return Object.fromEntries(Object.entries(FILES).map(([name, files]) => [name, sizeOf(files)]));
  } finally {
    rmSync(folder, { recursive: true });
  }
}
