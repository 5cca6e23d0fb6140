/** The style, whose fields and uniforms follow from the table. */
import { Color } from 'three';
import { expect, it } from 'vitest';
import type { Values } from '../../../src/parameters/parameter.ts';
import { styleRows } from '../../../src/parameters/rows/style.ts';
import { defaults } from '../../../src/parameters/values.ts';
import { inkPixelsOf, setStyle, styleOf, styleUniforms, widestLineOf } from '../../../src/renderer/style.ts';

const STYLE = styleOf(defaults());

it('has a uniform for each number, toggle and colour that is a field', () => {
  const types: Readonly<Record<string, unknown>> = {
    toggle: expect.any(Boolean),
    number: expect.any(Number),
    integer: expect.any(Number),
    color: expect.any(Color),
  };
  const fields: Readonly<Record<string, unknown>> = { ...STYLE };
  const uniforms = styleUniforms();
  for (const row of styleRows) {
    const name = row.key.slice('style.'.length);
    const isField = ['number', 'boolean'].includes(typeof fields[name]) || Array.isArray(fields[name]);
    if (isField && row.kind in types) expect(uniforms[name], name).toEqual({ value: types[row.kind] });
  }
  expect(uniforms).toHaveProperty('innerTaper');
});

it('sets the uniforms to the values of a style', () => {
  const uniforms = styleUniforms();
  const values: Values = { ...defaults(), 'style.innerTaper': 2.5, 'style.inkColor': '#ff0033', 'style.creases': 0 };
  setStyle(uniforms, styleOf({ ...values, 'style.rim': 0.5, 'style.outlineWidth': 3 }), 2);
  expect(uniforms.innerTaper.value).toBe(2.5);
  expect((uniforms.inkColor.value as Color).toArray()).toEqual([1, 0, 0.2]);
  expect(uniforms.creases.value).toBe(false);
  expect(uniforms.rim.value).toBe(0.5);
  expect(uniforms.inkPixels.value).toBe(6);
});

it('draws no rim on smoke without shading, and no lines without outlines', () => {
  const uniforms = styleUniforms();
  setStyle(uniforms, { ...STYLE, rim: 0.5, shading: false, outlines: false }, 2);
  expect([uniforms.rim.value, uniforms.inkPixels.value]).toEqual([0, 0]);
  expect(inkPixelsOf({ ...STYLE, outlines: false }, 2)).toBe(0);
});

it('doubles the widest line at a swell of 1', () => {
  expect(widestLineOf({ ...STYLE, outlineWidth: 3, inkSwell: 1 }, 2)).toBe(12);
});
