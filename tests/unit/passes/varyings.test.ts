/** WebGL 2 guarantees 15 varying vectors, and some GPUs have no more. */
import { readdirSync, readFileSync } from 'node:fs';
import { expect, it } from 'vitest';
import { MAX_LOBES } from '../../../src/constants.ts';

const SHADERS = new URL('../../../shaders/', import.meta.url);
const GUARANTEED = 15;

const files = readdirSync(SHADERS, { recursive: true, encoding: 'utf8' }).filter((file) => file.endsWith('.vert'));

/** The shader with the files that it includes. Every included file in the folder of shaders appears once. */
function source(url: URL, included = new Set<string>()): string {
  if (included.has(url.href)) return '';
  included.add(url.href);
  return readFileSync(url, 'utf8').replaceAll(/^#include (\S+)$/gm, (_, path: string) =>
    source(new URL(path, url), included),
  );
}

const DECLARATION = /^(?:flat )?out \w+ \w+(?:\[(\w+)\])?;/gm;

it.each(files)('%s has as many varyings as every GPU takes', (file) => {
  const lengths = [...source(new URL(file, SHADERS)).matchAll(DECLARATION)].map(([, length = '1']) => length);
  const vectors = lengths.reduce((sum, length) => sum + (length === 'LOBES' ? MAX_LOBES : Number(length)), 0);
  expect(vectors).toBeLessThanOrEqual(GUARANTEED);
});

it.each(['volumes/volumes.vert', 'tiledVolumes/tiledVolumes.vert'])(
  'reads the arrays of lobes that %s includes',
  (file) => {
    expect(files).toContain(file);
    expect(source(new URL(file, SHADERS))).toContain('flat out vec3 discs[LOBES];');
  },
);
