/** WebGL 2 guarantees 15 varying vectors, and some GPUs have no more. */
import { readdirSync, readFileSync } from 'node:fs';
import { expect, it } from 'vitest';
import { MAX_LOBES } from '../../../../src/base/constants.ts';

const SHADERS = new URL('../../../../shaders/', import.meta.url);
const GUARANTEED = 15;
/** Puffs with more lobes have bites only where there are more varyings; see src/renderer/bites.ts. */
const ERODED_LOBES = 10;

const files = readdirSync(SHADERS, { recursive: true, encoding: 'utf8' }).filter((file) => file.endsWith('.vert'));

/** The shader with the files that it includes. Every included file in the folder of shaders appears once. */
function source(url: URL, included = new Set<string>()): string {
  if (included.has(url.href)) return '';
  included.add(url.href);
  return readFileSync(url, 'utf8').replaceAll(/^#include (\S+)$/gm, (_, path: string) =>
    source(new URL(path, url), included),
  );
}

/** VOLUME is `flat out`: see lib/volumeFrame.glsl. */
const DECLARATION = /^(?:(?:flat )?out|VOLUME) (\w+) \w+(?:\[(\w+)\])?;/gm;

/** Vectors by the packing of GLSL ES 3.00, section 11: a number fits beside a vector of three. */
function vectorsOf(shader: string, lobes: number): number {
  let [vectors, free, numbers] = [0, 0, 0];
  for (const [, type, length = '1'] of shader.matchAll(DECLARATION)) {
    const count = length === 'LOBES' ? lobes : Number(length);
    if (type === 'float') numbers += count;
    else vectors += type === 'mat3' ? 3 * count : count;
    if (type === 'vec3') free += count;
  }
  return vectors + Math.max(0, numbers - free);
}

it.each(files)('%s has as many varyings as every GPU takes', (file) => {
  expect(vectorsOf(source(new URL(file, SHADERS)), MAX_LOBES)).toBeLessThanOrEqual(GUARANTEED);
});

it.each([
  ['bodies/lobes.vert', 'lobesVertex'],
  ['volumes/volumes.vert', 'volumeVertex'],
  ['tiledVolumes/tiledVolumes.vert', 'volumeVertex'],
])('%s has as many varyings as every GPU takes with bites', (file, inserted) => {
  const bites = source(new URL(`bites/${inserted}.glsl`, SHADERS));
  expect(bites).toContain('flat out float packedRadii;');
  const vectors = vectorsOf(`${source(new URL(file, SHADERS))}\n${bites}`, ERODED_LOBES);
  expect(vectors).toBeLessThanOrEqual(GUARANTEED);
});

it.each(['volumes/volumes.vert', 'tiledVolumes/tiledVolumes.vert'])(
  'reads the arrays of lobes that %s includes',
  (file) => {
    expect(files).toContain(file);
    expect(source(new URL(file, SHADERS))).toContain('VOLUME vec3 discs[LOBES];');
  },
);
