/** The start caps of shadow volumes as a texture: see `src/renderer/puffs/bake/startCaps.ts`. */
import { DataArrayTexture, FloatType, NearestFilter, RedFormat } from 'three';
import type { StartCaps } from '../puffs/bake/startCaps.ts';

/** The least and the greatest start cap, with 0 included. */
export function capRange({ values }: StartCaps): [number, number] {
  return values.reduce<[number, number]>(([min, max], cap) => [Math.min(min, cap), Math.max(max, cap)], [0, 0]);
}

/** An array texture with a layer for each variation. */
export function capTexture({ values, width, height, count }: StartCaps): DataArrayTexture {
  const texture = new DataArrayTexture(values, width, height, count);
  texture.format = RedFormat;
  texture.type = FloatType;
  texture.minFilter = NearestFilter;
  texture.magFilter = NearestFilter;
  texture.needsUpdate = true;
  return texture;
}
