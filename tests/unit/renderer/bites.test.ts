import { RawShaderMaterial, type WebGLRenderer } from 'three';
import { expect, it } from 'vitest';
import lobesFragment from '../../../shaders/bodies/lobes.frag';
import lobesVertex from '../../../shaders/bodies/lobes.vert';
import {
  ATTRIBUTE_WORDS,
  ONE_QUAD,
  PLACE_FLOATS,
  RowGeometry,
  RowTextures,
  type DrawnRows,
} from '../../../src/renderer/gpu/drawnRows.ts';
import type { PuffTextures } from '../../../src/renderer/gpu/puffTextures.ts';
import { ATTRIBUTE_BITS } from '../../../src/simulator/layout.ts';
import { bitesOf } from '../../../src/renderer/bites.ts';

const EROSIONS = [0, 0, 0, 0, 9, 255, 1, 40];

/** Rows whose place is their number. */
function rowsOf(erosions: readonly number[]): RowGeometry {
  const rows = new RowTextures(erosions.length);
  const { word, shift } = ATTRIBUTE_BITS.erosion;
  erosions.forEach((erosion, row) => {
    rows.placeArray.fill(row, PLACE_FLOATS * row, PLACE_FLOATS * (row + 1));
    rows.attributeWords.fill(row, ATTRIBUTE_WORDS * row, ATTRIBUTE_WORDS * (row + 1));
    rows.attributeWords[ATTRIBUTE_WORDS * row + word] = (erosion << shift) >>> 0;
  });
  rows.update(erosions.length, erosions.filter((erosion) => erosion === 0).length);
  return new RowGeometry(rows, ONE_QUAD);
}

/** The draw calls: their rows and materials. @param maxVaryings 15 is what WebGL 2 guarantees */
function drawn(geometry: RowGeometry, lobeCount = 10, maxVaryings = 15) {
  const whole = new RawShaderMaterial({ vertexShader: lobesVertex, fragmentShader: lobesFragment });
  whole.stencilRef = 3;
  const calls: { numbers: number[]; words: number[]; material: RawShaderMaterial }[] = [];
  const mesh = {
    material: whole,
    drawPlain(_renderer: WebGLRenderer, { rows: { first, count, placeArray, attributeWords } }: RowGeometry) {
      const shown = Array.from({ length: count - first }, (_, index) => first + index);
      calls.push({
        numbers: shown.map((row) => placeArray[PLACE_FLOATS * row + 3]),
        words: shown.map((row) => attributeWords[ATTRIBUTE_WORDS * row]),
        material: mesh.material,
      });
    },
  };
  const puffs = { lobes: { puffs: { lobeCount } } } as unknown as PuffTextures;
  const renderer = { capabilities: { maxVaryings } } as unknown as WebGLRenderer;
  bitesOf(puffs).bodies.draw(renderer, mesh as unknown as DrawnRows, geometry);
  expect(mesh.material).toBe(whole);
  return { calls, whole };
}

it('draws whole rows with the plain material and the others with bites, each once', () => {
  const geometry = rowsOf(EROSIONS);
  const { calls, whole } = drawn(geometry);
  expect(calls.map(({ numbers }) => numbers)).toEqual([
    [0, 1, 2, 3],
    [4, 5, 6, 7],
  ]);
  for (const { numbers, words } of calls) expect(words).toEqual(numbers);
  expect(calls[0].material).toBe(whole);
  expect(calls[1].material.uniforms).toBe(whole.uniforms);
  expect(calls[1].material.stencilRef).toBe(3);
  expect([calls[0], calls[1]].map(({ material }) => 'CUT' in material.defines)).toEqual([false, true]);
  expect([geometry.rows.first, geometry.rows.count]).toEqual([0, EROSIONS.length]);
});

it('draws no row twice if all are whole or all have bites', () => {
  expect(drawn(rowsOf([0, 0])).calls.map(({ numbers }) => numbers)).toEqual([[0, 1], []]);
  expect(drawn(rowsOf([7, 8])).calls.map(({ numbers }) => numbers)).toEqual([[0, 1]]);
});

it('draws other geometries in one call', () => {
  class Listed extends RowGeometry {}
  const { rows } = rowsOf(EROSIONS);
  const { calls } = drawn(new Listed(rows, ONE_QUAD));
  expect(calls.map(({ numbers }) => numbers)).toEqual([[0, 1, 2, 3, 4, 5, 6, 7]]);
});

it.each([
  [10, 15, true],
  [11, 15, false],
  [12, 15, false],
  [12, 17, true],
])('draws puffs of %i lobes on a GPU with %i varyings: with bites %s', (lobes, maxVaryings, isBitten) => {
  const { calls, whole } = drawn(rowsOf(EROSIONS), lobes, maxVaryings);
  expect(calls).toHaveLength(isBitten ? 2 : 1);
  expect(calls[0].numbers).toHaveLength(isBitten ? 4 : EROSIONS.length);
  expect(calls[0].material).toBe(whole);
});
