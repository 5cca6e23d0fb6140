/** The fog of the host's scene on smoke. */
import { Color, Fog, FogExp2 } from 'three';
import { dispose, draw, emptyHost, HANGING, HEIGHT, smokeIn, WIDTH } from './scene.ts';
import { composed } from './targets.cases.ts';
import type { Values } from '../../../src/parameters/parameter.ts';

const FOG = '#406080';
const SMOKE = '#ffe0a0';
/** Distances from the camera of the middle of the smoke, of its front and of its silhouette, metres. */
const [AWAY, FRONT, SIDE] = [5, 4.2, 5.3];

/**
 * Smoke of one colour in fog, on the canvas or by a composer: its pixels, those whose colour is not that of fog of a
 * distance within the smoke, and those that differ from smoke without fog.
 */
export async function inFog(kind: 'linear' | 'exponential', isComposed: boolean) {
  const host = emptyHost();
  host.camera.position.set(0, 1.2, AWAY);
  host.camera.lookAt(0, 1.2, 0);
  const smoke = await smokeIn(host, { ...HANGING, ...FLAT, 'style.smokeColor': SMOKE });
  const picture = isComposed ? composed(host, 0) : () => draw(host);
  picture();
  await smoke.complete();
  const clear = picture();
  const [near, far, density] = [3.5, 14, 0.15];
  host.scene.fog = kind === 'linear' ? new Fog(FOG, near, far) : new FogExp2(FOG, density);
  const shareAt = (depth: number) =>
    kind === 'linear' ? smoothstep((depth - near) / (far - near)) : 1 - Math.exp(-((density * depth) ** 2));
  const [least, most] = [FRONT, SIDE].map((depth) => colorIn(shareAt(depth), isComposed));
  const foggy = picture();
  const isBetween = (pixel: number) =>
    [0, 1, 2].every((channel) => {
      const value = foggy[4 * pixel + channel];
      const [low, high] = [least[channel], most[channel]].toSorted((a, b) => a - b);
      return value >= low - 1 && value <= high + 1;
    });
  const counts = { smoke: 0, wrong: 0, changed: 0 };
  const plain = colorIn(0, false);
  for (let pixel = 0; pixel < WIDTH * HEIGHT; ++pixel) {
    // Without the smoothed edges.
    if (plain.some((value, channel) => Math.abs(clear[4 * pixel + channel] - value) > 1)) continue;
    ++counts.smoke;
    if (!isBetween(pixel)) ++counts.wrong;
    if (foggy[4 * pixel] !== clear[4 * pixel]) ++counts.changed;
  }
  dispose(smoke, host.renderer);
  return counts;
}

const FLAT: Values = { 'style.shading': 0, 'style.outlines': 0, 'style.shadows': 0 };

function smoothstep(share: number): number {
  const x = Math.min(1, Math.max(0, share));
  return x * x * (3 - 2 * x);
}

/** Smoke of one colour in fog as bytes. Fog is mixed in linear light in targets, and in display-encoded colour on the canvas. */
function colorIn(share: number, isLinear: boolean): number[] {
  const [smoke, fog] = [SMOKE, FOG].map((color) => new Color(color));
  if (!isLinear) for (const color of [smoke, fog]) color.convertLinearToSRGB();
  smoke.lerp(fog, share);
  if (isLinear) smoke.convertLinearToSRGB();
  return smoke.toArray().map((value) => Math.round(255 * value));
}
