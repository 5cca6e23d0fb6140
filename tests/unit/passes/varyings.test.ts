/** WebGL 2 guarantees 15 varying vectors, and some GPUs have no more. */
import { readdirSync, readFileSync } from 'node:fs';
import { expect, it } from 'vitest';
import { MAX_LOBES } from '../../../src/constants.ts';

const SHADERS = new URL('../../../shaders/', import.meta.url);
const GUARANTEED = 15;

const files = readdirSync(SHADERS, { recursive: true, encoding: 'utf8' }).filter((file) => file.endsWith('.vert'));

it.each(files)('%s has as many varyings as every GPU takes', (file) => {
  const source = readFileSync(new URL(file, SHADERS), 'utf8').replaceAll(/\bLOBES\b/g, String(MAX_LOBES));
  const varyings = [...source.matchAll(/^(?:flat )?out \w+ \w+(?:\[(\d+)\])?;/gm)];
  const vectors = varyings.reduce((sum, [, length = '1']) => sum + Number(length), 0);
  expect(vectors).toBeLessThanOrEqual(GUARANTEED);
});

it('reads the arrays of lobes', () => {
  expect(files).toContain('volumes/volumes.vert');
  expect(readFileSync(new URL('volumes/volumes.vert', SHADERS), 'utf8')).toContain('flat out vec3 discs[LOBES];');
});
