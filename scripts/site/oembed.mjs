/** An oEmbed answer for each preset of the gallery, as a static file: `oembed/lamp.json`. */

import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { sourceModule } from '../package/sourceModule.mjs';

const PICTURE = { width: 192, height: 128 };

/** @typedef {import('../../src/preset/presets.ts').Preset} Preset */
/** @typedef {typeof import('../../src/app/embed.ts')} Embed */

/**
 * @param {string} folder of the built site
 * @param {string} base where the site is published, ending with a slash; without one, addresses count from the folder that
 * the files lie in
 */
export async function writeOembed(folder, base = '../') {
  /** @type {{ presets: Preset[] }} */
  const { presets } = await sourceModule('src/preset/presets.ts');
  /** @type {Embed} */
  const embed = await sourceModule('src/app/embed.ts');
  mkdirSync(join(folder, 'oembed'), { recursive: true });
  for (const preset of presets) {
    const text = JSON.stringify(oembedOf(preset, base, embed), null, 2);
    writeFileSync(join(folder, 'oembed', `${preset.name}.json`), `${text}\n`);
  }
}

/** Version 1.0, type rich. @param {Preset} preset @param {string} base @param {Embed} embed */
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
