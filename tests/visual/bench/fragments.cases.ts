/** The counters of the render benchmark, compared with known values. */
import { OrthographicCamera } from 'three';
import type { PuffForm } from '../../../src/renderer/gpu/puffTextures.ts';
import { bakedPuffs } from '../../../src/renderer/bakedPuffs.ts';
import { createDevice } from '../../../src/renderer/gpu/device.ts';
import { LOBE_SHAPES } from '../../../src/renderer/puffs/lobeShapes.ts';
import { countFragments, type Fragments } from '../../bench/render/fragments.ts';
import { watchUploads } from '../../bench/render/uploads.ts';
import { Lab, type LabScene } from '../lab.ts';

const SIZE = 100;

/** Fragments of coincident equal puffs with a radius of 25 pixels, and the number of pixels that they cover. */
export function bodies(form: PuffForm, count: number): Fragments & { pixels: number } {
  const puffs = Array.from({ length: count }, () => ({ place: [0, 0, 0] as const, radius: 0.5 }));
  const camera = new OrthographicCamera(-1, 1, 1, -1, 0.1, 10);
  camera.position.set(0, 0, 4);
  const scene: LabScene = {
    width: SIZE,
    height: SIZE,
    puffs,
    camera,
    style: { form, outlines: false, shadows: false },
  };
  const lab = new Lab(scene);
  const { pixels } = lab.draw(scene);
  const { bodies: rows, body, renderer } = lab['smoke'].passes;
  const fragments = countFragments(
    renderer,
    body.material,
    (material) => body.drawAs(renderer, material, rows.geometry),
    SIZE,
    SIZE,
  );
  lab.dispose();
  return { ...fragments, pixels: pixels.filter((value, index) => index % 4 === 3 && value > 0).length };
}

/** Pixel centres inside the quad of one such puff: around the silhouette of its lobes, or a texel around that of its layer. */
export function quadPixels(form: PuffForm): number {
  const { lobes } = LOBE_SHAPES[0];
  const layers = form === 'billboards' ? bakedPuffs().billboards.layers : undefined;
  const across = (axis: 0 | 1): number => {
    const ends = [-1, 1].map((side) => {
      if (!layers) return Math.max(...lobes.map(({ center, radius }) => side * center[axis] + radius));
      const { supports } = layers.figures[0];
      return supports[(supports.length / 4) * (1 + axis - side)] + (2 * layers.pad) / layers.size;
    });
    const [low, high] = [SIZE / 2 - (SIZE / 4) * ends[0], SIZE / 2 + (SIZE / 4) * ends[1]];
    return Math.ceil(high - 0.5) - Math.ceil(low - 0.5);
  };
  return across(0) * across(1);
}

/** Bytes counted for uploads of 100, 40, 32 and 12 bytes to a buffer, and of 96 bytes to a texture. */
export function uploads(): number[] {
  const device = createDevice(new OffscreenCanvas(1, 1));
  const gl = device.renderer.getContext() as WebGL2RenderingContext;
  gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
  gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
  gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA32F, 4, 4);
  const watch = watchUploads(gl);
  const floats = new Float32Array(10);
  const seen = [
    () => gl.bufferData(gl.ARRAY_BUFFER, 100, gl.STATIC_DRAW),
    () => gl.bufferSubData(gl.ARRAY_BUFFER, 0, floats),
    () => gl.bufferSubData(gl.ARRAY_BUFFER, 8, floats, 2),
    () => gl.bufferSubData(gl.ARRAY_BUFFER, 8, floats, 2, 3),
    () => gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, 3, 2, gl.RGBA, gl.FLOAT, new Float32Array(24)),
  ].map((upload) => {
    watch.bytes = 0;
    upload();
    return watch.bytes;
  });
  device.dispose();
  return seen;
}
