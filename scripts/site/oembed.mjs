/**
 * Writes an oEmbed response for each gallery preset as a static file, `oembed/lamp.json`, and a page that links to it,
 * `gallery/lamp.html`. A page per preset is required, because URL fragments are not sent to servers.
 */

import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { sourceModule } from '../package/sourceModule.mjs';

const PICTURE = { width: 192, height: 128 };

/** @typedef {import('../../src/parameters/words/presets.ts').Preset} Preset */
/** @typedef {typeof import('../../src/demo/share/embed.ts')} Embed */

/**
 * @param {string} folder of the built site
 * @param {string} base URL at which the site is published, with a trailing slash. Default: relative to the folder of
 * the files
 */
export async function writeOembed(folder, base = '../') {
  /** @type {{ presets: Preset[] }} */
  const { presets } = await sourceModule('src/parameters/words/presets.ts');
  /** @type {Embed} */
  const embed = await sourceModule('src/demo/share/embed.ts');
  for (const name of ['oembed', 'gallery']) mkdirSync(join(folder, name), { recursive: true });
  for (const preset of presets) {
    const answer = oembedOf(preset, base, embed);
    writeFileSync(join(folder, 'oembed', `${preset.name}.json`), `${JSON.stringify(answer, null, 2)}\n`);
    writeFileSync(join(folder, 'gallery', `${preset.name}.html`), pageOf(preset, base, answer));
  }
}

/**
 * @param {Preset} preset
 * @param {string} base
 * @param {ReturnType<typeof oembedOf>} answer
 */
function pageOf({ name, label, text }, base, { title, thumbnail_url: picture }) {
  const { width, height } = PICTURE;
  return `<!doctype html>
<html lang="en">
  <head>
    <meta charset="utf-8" />
    <meta name="viewport" content="width=device-width, initial-scale=1" />
    <title>${title}</title>
    <meta name="description" content="${text} Play with it in the browser and share the result." />
    <link rel="alternate" type="application/json+oembed" href="${base}oembed/${name}.json" title="${title}" />
    <meta property="og:title" content="${title}" />
    <meta property="og:image" content="${picture}" />
    <link rel="icon" href="../favicon.svg" type="image/svg+xml" />
  </head>
  <body>
    <a href="../#v=1&amp;preset=${name}"><img src="../thumbnails/${name}.webp" width="${width}" height="${height}" alt="" /> Play with ${label}</a>
  </body>
</html>
`;
}

/**
 * Version 1.0, type rich.
 * @param {Preset} preset
 * @param {string} base
 * @param {Embed} embed
 */
function oembedOf({ name, label }, base, { frameOf, FRAME }) {
  const title = `${label}: cartoon smoke`;
  return {
    version: '1.0',
    type: 'rich',
    title,
    provider_name: 'Cartoon Smoke',
    provider_url: base,
    ...FRAME,
    html: frameOf(`${base}embed.html#v=1&preset=${name}`, title),
    thumbnail_url: `${base}thumbnails/${name}.webp`,
    thumbnail_width: PICTURE.width,
    thumbnail_height: PICTURE.height,
  };
}
