/** Post-processing besides the default passes: pmndrs/postprocessing, passes of ambient occlusion and focus, output buffers. */
import { ACESFilmicToneMapping, HalfFloatType, MathUtils, WebGLRenderTarget, type ToneMapping } from 'three';
import { parseColor } from '../../../src/renderer/palette.ts';
import { EffectComposer } from 'three/examples/jsm/postprocessing/EffectComposer.js';
import { BokehPass } from 'three/examples/jsm/postprocessing/BokehPass.js';
import { OutputPass } from 'three/examples/jsm/postprocessing/OutputPass.js';
import { RenderPass } from 'three/examples/jsm/postprocessing/RenderPass.js';
import { SSAOPass } from 'three/examples/jsm/postprocessing/SSAOPass.js';
import {
  BrightnessContrastEffect,
  EffectComposer as PmndrsComposer,
  EffectPass,
  RenderPass as PmndrsRenderPass,
} from 'postprocessing';
import { composed, meanDifference, plainHost } from './targets.cases.ts';
import {
  changedPixels,
  differences,
  dispose,
  draw,
  emptyHost,
  furnishedHost,
  HANGING,
  HEIGHT,
  makeRenderer,
  readCanvas,
  smokeIn,
  smokePixels,
  WIDTH,
  type Pixels,
} from './scene.ts';

/** What post-processing shows, compared with the canvas. */
export interface Compared {
  /** Mean differences from the canvas, with smoke and without it. */
  difference: number;
  bare: number;
  /** Pixels that smoke and its shadow change. */
  smoke: number;
  errors: string[];
}

/** The composer of pmndrs/postprocessing with an effect that changes nothing, and the canvas. */
export async function byPmndrs(multisampling: number): Promise<Compared> {
  const host = plainHost(multisampling);
  const { renderer, scene, camera } = host;
  const canvas = () => {
    renderer.setRenderTarget(null);
    renderer.autoClear = true;
    return draw(host);
  };
  const empty = canvas();
  const composer = new PmndrsComposer(renderer, { frameBufferType: HalfFloatType, multisampling });
  composer.setSize(WIDTH, HEIGHT, false);
  composer.addPass(new PmndrsRenderPass(scene, camera));
  composer.addPass(new EffectPass(camera, new BrightnessContrastEffect({ brightness: 0, contrast: 0 })));
  const picture = () => {
    renderer.autoClear = false;
    composer.render(0);
    return readCanvas(renderer);
  };
  const bare = meanDifference(empty, picture());
  const smoke = await smokeIn(host);
  const errors: string[] = [];
  smoke.addEventListener('error', ({ error }) => errors.push(error.message));
  picture();
  await smoke.complete();
  const shown = picture();
  const direct = canvas();
  smoke.update(0);
  composer.dispose();
  dispose(smoke, renderer);
  return { difference: meanDifference(direct, shown), bare, smoke: changedPixels(direct, empty, 25), errors };
}

/** Smoke that `SSAOPass` darkens, in pixels. */
export async function bySsao(): Promise<{ darkened: number; smoke: number }> {
  const host = plainHost(0);
  const { renderer, scene, camera } = host;
  const smoke = await smokeIn(host, { ...HANGING, 'style.shading': 0, 'style.outlines': 0, 'style.shadows': 0 });
  const isSmoke = smokePixels(host, smoke);
  // The pass takes its samples from Math.random.
  const { random } = Math;
  Math.random = () => MathUtils.seededRandom();
  MathUtils.seededRandom(1);
  const picture = composed(host, 0, new SSAOPass(scene, camera, WIDTH, HEIGHT));
  Math.random = random;
  picture();
  await smoke.complete();
  const gaps = differences(draw(host), picture());
  dispose(smoke, renderer);
  return {
    darkened: gaps.filter((gap, pixel) => isSmoke[pixel] && gap > 25).length,
    smoke: isSmoke.filter(Boolean).length,
  };
}

/** Pixels that `BokehPass` changes: with everything in focus, and with a wide aperture. */
export async function byBokeh(): Promise<{ sharp: number; blurred: number; smoke: number }> {
  const host = plainHost(0);
  const { scene, camera } = host;
  const before = draw(host);
  const smoke = await smokeIn(host);
  const after = draw(host);
  const pictures = [0, 0.02].map((aperture) =>
    composed(host, 0, new BokehPass(scene, camera, { focus: 0.5, aperture, maxblur: 0.02 })),
  );
  const plain = composed(host, 0);
  plain();
  await smoke.complete();
  const [reference, sharp, blurred] = [plain, ...pictures].map((picture) => picture());
  dispose(smoke, host.renderer);
  return {
    sharp: changedPixels(reference, sharp, 2),
    blurred: changedPixels(reference, blurred, 2),
    smoke: changedPixels(before, after, 25),
  };
}

/** A renderer with an output buffer that maps its tones, and a composer that does the same with a target. */
export async function byOutputBuffer(): Promise<Compared> {
  const pictures: Pixels[][] = [];
  const errors: string[] = [];
  for (const outputBufferType of [HalfFloatType, undefined]) {
    const renderer = makeRenderer({ outputBufferType }, undefined, ACESFilmicToneMapping);
    const host = furnishedHost(renderer);
    host.scene.children.pop();
    const target = new WebGLRenderTarget(WIDTH, HEIGHT, { type: HalfFloatType, stencilBuffer: true });
    const composer = new EffectComposer(renderer, target);
    for (const pass of [new RenderPass(host.scene, host.camera), new OutputPass()]) composer.addPass(pass);
    const picture = () => {
      if (outputBufferType) renderer.render(host.scene, host.camera);
      else composer.render(0);
      return readCanvas(renderer);
    };
    const empty = picture();
    const smoke = await smokeIn(host);
    smoke.addEventListener('error', ({ error }) => errors.push(error.message));
    pictures.push([empty, picture()]);
    smoke.update(0);
    dispose(smoke, renderer);
  }
  const [[empty, shown], [bare, direct]] = pictures;
  return {
    difference: meanDifference(direct, shown),
    bare: meanDifference(bare, empty),
    smoke: changedPixels(shown, empty, 25),
    errors,
  };
}

/** Colours of smoke, of which one is nearly white and one saturated. */
const SHOWN = ['#f6efe2', '#d05030', '#203050', '#000000'];

/**
 * The greatest difference of a pixel of flat smoke from its colour under `OutputPass`, and the number of pixels with that
 * colour on the canvas, which are compared.
 */
export async function underToneMapping(
  operator: ToneMapping,
  exposure: number,
): Promise<{ gap: number; smoke: number }> {
  const host = emptyHost();
  host.renderer.toneMapping = operator;
  host.renderer.toneMappingExposure = exposure;
  const smoke = await smokeIn(host, { ...HANGING, 'style.shading': 0, 'style.outlines': 0, 'style.shadows': 0 });
  const picture = composed(host, 0);
  picture();
  await smoke.complete();
  const found = { gap: 0, smoke: 0 };
  for (const shown of SHOWN) {
    const color = parseColor(shown);
    smoke.set({ 'style.smokeColor': shown });
    const [canvas, mapped] = [draw(host), picture()];
    const gapAt = (pixels: Pixels, at: number) =>
      Math.max(...color.map((channel, index) => Math.abs(pixels[at + index] - channel)));
    for (let at = 0; at < canvas.length; at += 4) {
      if (gapAt(canvas, at) > 0) continue;
      found.smoke += 1;
      found.gap = Math.max(found.gap, gapAt(mapped, at));
    }
  }
  dispose(smoke, host.renderer);
  return found;
}
