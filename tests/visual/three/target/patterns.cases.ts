/** Marks of a print on smoke and on what it shades in a host's scene. */
import { WebGLRenderTarget } from 'three';
import type { Values } from '../../../../src/parameters/parameter.ts';
import { maskOf } from '../shadow.cases.ts';
import {
  changedPixels,
  differences,
  dispose,
  draw,
  drawUnlit,
  furnishedHost,
  HANGING,
  HEIGHT,
  smokeIn,
  WIDTH,
  type Host,
  type Pixels,
} from '../scene.ts';

/** Pixels that marks change, and of which they make a part red. */
export interface Marked {
  /** Of smoke. */
  smoke: number;
  /** Of objects in shadow, all of them and those with marks. */
  shadow: number;
  onShadow: number;
  /** Elsewhere. */
  beside: number;
}

const PLAIN: Values = { ...HANGING, 'style.simplify': 2, 'style.pattern': 'none' };

/**
 * Smoke without and with red marks.
 * @param hasStencil whether the host draws into a target with a stencil buffer
 */
export async function marked(values: Values, hasStencil: boolean): Promise<Marked> {
  const host = furnishedHost();
  const shoot = hasStencil ? draw : drawWithoutStencil;
  const [lit, unlit] = [shoot(host), hasStencil ? drawUnlit(host) : undefined];
  const smoke = await smokeIn(host, PLAIN);
  shoot(host);
  await smoke.complete();
  const plain = shoot(host);
  smoke.set({ 'style.patternColor': '#ff0000', 'style.patternSize': 4, 'style.patternCoverage': 0.4, ...values });
  await smoke.complete();
  const printed = shoot(host);
  const isSmoke = maskOf(host, smoke);
  const [changed, shaded] = [differences(printed, plain), differences(plain, lit)];
  const count = (is: (pixel: number) => boolean) =>
    isSmoke.filter((_, pixel) => changed[pixel] > 8 && is(pixel)).length;
  const found = {
    smoke: count((pixel) => isSmoke[pixel]),
    shadow: isSmoke.filter((inSmoke, pixel) => !inSmoke && shaded[pixel] > 0).length,
    onShadow: count((pixel) => !isSmoke[pixel] && shaded[pixel] > 0 && isRed(printed, plain, pixel)),
    beside: count((pixel) => !isSmoke[pixel] && shaded[pixel] === 0),
  };
  if (unlit && changedPixels(lit, unlit) === 0) throw new Error('The key light changes nothing.');
  dispose(smoke, host.renderer);
  return found;
}

function isRed(printed: Pixels, plain: Pixels, pixel: number): boolean {
  const [red, green] = [0, 1].map((channel) => printed[4 * pixel + channel] - plain[4 * pixel + channel]);
  return red > green;
}

const target = new WebGLRenderTarget(WIDTH, HEIGHT);

function drawWithoutStencil({ renderer, scene, camera }: Host): Pixels {
  renderer.setRenderTarget(target);
  renderer.clear();
  renderer.render(scene, camera);
  const pixels = new Uint8Array(4 * WIDTH * HEIGHT);
  renderer.readRenderTargetPixels(target, 0, 0, WIDTH, HEIGHT, pixels);
  renderer.setRenderTarget(null);
  return pixels;
}
