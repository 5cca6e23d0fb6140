/** Render targets without stencil: what post-processing, mirrors and cube cameras draw into. */
import { HalfFloatType, WebGLRenderTarget } from 'three';
import { EffectComposer } from 'three/examples/jsm/postprocessing/EffectComposer.js';
import { OutputPass } from 'three/examples/jsm/postprocessing/OutputPass.js';
import { RenderPass } from 'three/examples/jsm/postprocessing/RenderPass.js';
import type { CartoonSmoke } from '../../../src/three/cartoonSmoke.ts';
import { censusOf, maskOf, type Census } from './shadow.cases.ts';
import {
  differences,
  dispose,
  draw,
  furnishedHost,
  HEIGHT,
  makeRenderer,
  readCanvas,
  smokeIn,
  WIDTH,
  type Host,
  type Pixels,
} from './scene.ts';

/** The furnished scene without the shader that ignores the colour space of its target. */
function plainHost(samples: number): Host {
  const host = furnishedHost(makeRenderer({ antialias: samples > 0 }));
  host.scene.children.pop();
  return host;
}

/** Draws by the default composer, or by one whose target has samples. */
function composed({ renderer, scene, camera }: Host, samples: number): () => Pixels {
  const target = new WebGLRenderTarget(WIDTH, HEIGHT, { type: HalfFloatType, samples });
  const composer = new EffectComposer(renderer, samples > 0 ? target : undefined);
  composer.addPass(new RenderPass(scene, camera));
  composer.addPass(new OutputPass());
  return () => {
    composer.render(0);
    return readCanvas(renderer);
  };
}

/** Mean difference of the channels of two pictures, as a share of white. */
function meanDifference(a: Pixels, b: Pixels): number {
  return a.reduce((sum, value, at) => sum + Math.abs(value - b[at]), 0) / a.length / 255;
}

/** Shadow that a way of drawing shows, with the pictures of the same scene without smoke and without its key light. */
async function censusWith(host: Host, smoke: CartoonSmoke, picture: () => Pixels): Promise<Census> {
  const isSmoke = maskOf(host, smoke);
  const after = picture();
  host.scene.remove(smoke);
  const before = picture();
  const { intensity } = host.keyLight;
  host.keyLight.intensity = 0;
  const unlit = picture();
  host.keyLight.intensity = intensity;
  host.scene.add(smoke);
  return censusOf(before, unlit, after, isSmoke);
}

export interface Composed {
  census: Census;
  /** Mean differences from the canvas, with smoke and without it. */
  difference: number;
  bare: number;
  /** Pixels of the canvas that differ by more than 10 % of white. */
  distinct: number;
  errors: string[];
}

/** The scene by a composer and on the canvas. */
export async function byComposer(samples: number): Promise<Composed> {
  const host = plainHost(samples);
  const picture = composed(host, samples);
  const empty = { canvas: draw(host), composed: picture() };
  const smoke = await smokeIn(host);
  const errors: string[] = [];
  smoke.addEventListener('error', ({ error }) => errors.push(error.message));
  picture();
  await smoke.complete();
  const census = await censusWith(host, smoke, picture);
  const [canvas, shown] = [draw(host), picture()];
  smoke.update(0);
  dispose(smoke, host.renderer);
  return {
    census,
    difference: meanDifference(canvas, shown),
    bare: meanDifference(empty.canvas, empty.composed),
    distinct: differences(canvas, shown).filter((gap) => gap > 25).length,
    errors,
  };
}

/** Smoke that a composer has drawn once. `census` draws again. */
export async function smokeWithoutStencil() {
  const host = plainHost(0);
  const picture = composed(host, 0);
  const smoke = await smokeIn(host);
  const errors: string[] = [];
  smoke.addEventListener('error', ({ error }) => errors.push(`${error.name}: ${error.message}`));
  picture();
  return { smoke, errors, census: () => censusWith(host, smoke, picture) };
}
