/** The page with all presets: a picture, a link and code of each. */

import { cpSync, mkdirSync } from 'node:fs';
import { inRoot } from '../lib/paths.mjs';
import { sourceModule } from '../package/sourceModule.mjs';
import { PAGES, write } from './documents.mjs';

const THUMBNAIL = { width: 192, height: 128 };

/** @typedef {import('../../src/parameters/words/presets.ts').Preset} Preset */
/** @typedef {import('../../src/parameters/words/words.ts').ChoiceParameter} Choice */

export async function writeGallery() {
  /** @type {{ presets: Preset[] }} */
  const { presets } = await sourceModule('src/parameters/words/presets.ts');
  /** @type {{ table: { key: string }[] }} */
  const { table } = await sourceModule('src/parameters/words/table.ts');
  const { options } = /** @type {Choice} */ (table.find(({ key }) => key === 'scene'));
  mkdirSync(inRoot(`${PAGES}/thumbnails`), { recursive: true });
  cpSync(inRoot('public/thumbnails'), inRoot(`${PAGES}/thumbnails`), { recursive: true });
  const sections = options.map(({ value, label }) => {
    const cards = presets.filter((preset) => sceneOf(preset) === value).map(card);
    return `## ${label} {#scene-${value}}\n\n<div class="presets">\n\n${cards.join('\n\n')}\n\n</div>`;
  });
  write('gallery.md', [INTRODUCTION, ...sections, ''].join('\n\n'));
}

const INTRODUCTION = `---
outline: 2
---

# Presets

Each preset is a scene in a style. A picture opens it in the demo. In a three.js scene of your own, a preset is the smoke without the
models of its scene. [Share links](links.md) change presets; [parameters](parameters.md) lists what they can change.`;

function sceneOf(/** @type {Preset} */ { name }) {
  return name.split('-')[0];
}

function card(/** @type {Preset} */ { name, label, text }) {
  const size = `width="${THUMBNAIL.width}" height="${THUMBNAIL.height}"`;
  return `<article>
<a href="../index.html#v=1&amp;preset=${name}" target="_self" aria-label="${label}, in the demo"><img src="./thumbnails/${name}.webp" ${size} alt="" loading="lazy" /></a>

### ${label} {#${name}}

${text} \`${name}\`

<details>
<summary>Code</summary>

\`\`\`html
<cartoon-smoke preset="${name}" style="height: 360px"></cartoon-smoke>
\`\`\`

\`\`\`js
const smoke = await CartoonSmoke.create({ renderer, keyLight, preset: '${name}' });
\`\`\`

</details>
</article>`;
}
