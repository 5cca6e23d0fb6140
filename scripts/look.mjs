/**
 * `npm run look [-- NAME...]`: contact sheets and measures of the named presets, or of all, as a page in .cache/look.
 * A preset's sheet shows four times from three cameras, its strip twelve neighbouring frames. The page shows the previous
 * run beside each picture and figure.
 */

import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { evaluateInPage } from '../tests/bench/support/page.mjs';
import { inRoot } from './lib/paths.mjs';
import { conclude, UserError } from './lib/userError.mjs';
import { PAGE, PICTURES, setUp } from './setup/setup.mjs';

const FOLDER = '.cache/look';

/**
 * @typedef {Record<string, number>} Measures
 * @typedef {{ sheet: string, strip: string, measures: Measures }} Look pictures as data addresses
 * @typedef {{ styles: string, looks: Record<string, Look> }} Run
 */

await conclude(async () => {
  await setUp([...new Set([...PAGE, ...PICTURES])]);
  const names = process.argv.slice(2);
  const now = await draw(names);
  mkdirSync(inRoot(FOLDER), { recursive: true });
  const path = inRoot(`${FOLDER}/run.json`);
  const before = existsSync(path) ? /** @type {Run} */ (JSON.parse(readFileSync(path, 'utf8'))) : undefined;
  writeFileSync(inRoot(`${FOLDER}/index.html`), pageOf(now, before));
  // Presets that this run leaves out keep their last pictures.
  writeFileSync(path, JSON.stringify({ ...now, looks: { ...before?.looks, ...now.looks } }));
  for (const [name, { measures }] of Object.entries(now.looks)) console.log(`${name}: ${sentence(measures)}`);
  console.log(`Wrote ${inRoot(FOLDER)}/index.html.`);
});

/** @param {string[]} names @returns {Promise<Run>} */
async function draw(names) {
  const expression = `Promise.all([
    import('/tests/visual/renderer/look.cases.ts'),
    import('/tests/visual/renderer/styles.cases.ts'),
    import('/src/parameters/presets.ts'),
  ]).then(async ([{ sheets, measureTones }, { sheet }, { findPreset, presets }]) => {
    const given = ${JSON.stringify(names)};
    const unknown = given.find((name) => !findPreset(name));
    if (unknown) return { unknown };
    const looks = {};
    const png = (picture) => 'data:image/png;base64,' + picture;
    for (const name of given.length > 0 ? given : presets.map((preset) => preset.name)) {
      await sayProgress(name);
      const { sheet, strip } = await sheets(name);
      looks[name] = { sheet: png(sheet), strip: png(strip), measures: await measureTones(name) };
    }
    return { styles: png(await sheet()), looks };
  })`;
  const run = await evaluateInPage(expression, (name) => console.log(`Drawing ${name}`));
  const { unknown } = /** @type {{ unknown?: string }} */ (run);
  if (unknown) throw new UserError(`There is no preset ${unknown}.`);
  return /** @type {Run} */ (run);
}

/** @param {Run} now @param {Run | undefined} before */
function pageOf(now, before) {
  const rows = Object.entries(now.looks).map(([name, look]) => row(name, look, before?.looks[name]));
  return `<!doctype html>
<meta charset="utf-8" />
<title>Looks</title>
<style>
  body { font: 14px/1.4 sans-serif; margin: 2em; }
  img { width: 100%; }
  section > div { display: grid; grid-template-columns: 1fr 1fr; gap: 1em; }
  td, th { padding: 0 1em; text-align: right; }
</style>
<h1>Looks</h1>
<p>Left: this run. Right: the previous run.</p>
${rows.join('\n')}
<section><h2>Sixteen combinations</h2><div>${image(now.styles)}${image(before?.styles)}</div></section>
`;
}

/** @param {string} name @param {Look} now @param {Look | undefined} before */
function row(name, now, before) {
  const figures = Object.entries(now.measures).map(
    ([key, value]) => `<tr><th>${key}</th><td>${rounded(value)}</td><td>${rounded(before?.measures[key])}</td></tr>`,
  );
  return `<section><h2>${name}</h2>
<table>${figures.join('')}</table>
<div>${image(now.sheet)}${image(before?.sheet)}${image(now.strip)}${image(before?.strip)}</div></section>`;
}

function image(/** @type {string | undefined} */ source) {
  return source ? `<img alt="" src="${source}" />` : '<p>No previous run.</p>';
}

function rounded(/** @type {number | undefined} */ value) {
  return value === undefined ? '' : Number(value.toPrecision(3));
}

function sentence(/** @type {Measures} */ measures) {
  return Object.entries(measures)
    .map(([key, value]) => `${key} ${rounded(value)}`)
    .join(', ');
}
