/** The page of the measurement, which the documentation shows in a frame. It measures when `measureCosts` is called. */
import { Color, GLSL3, RawShaderMaterial, type BufferGeometry, type Material } from 'three';
import { BASE, CASES, type CostCase } from './cases.ts';
import { CostScene, type CostSmoke } from './costScene.ts';
import { rendererName, timeQueries, type Query } from './gpuClock.ts';
import type { CaseCost, CostOptions, CostReport, MeasureCosts, PassCost } from './report.ts';

declare global {
  interface Window {
    measureCosts?: MeasureCosts;
  }
}

/** CSS pixels of the picture; the small one is what a processor draws in a fraction of a second. */
const SIZE = { width: 960, height: 540 };
const SMALL = { width: 320, height: 180 };
const ON_PROCESSOR = /SwiftShader|llvmpipe|Basic Render/;
/** Frames of a round, and milliseconds after which it has enough of them. */
const FRAMES = 30;
const ROUND_MS = 120;
/** The same of the frames that the display shows. */
const SHOWN_FRAMES = 60;
const SHOWN_MS = 700;
const TIMED_STEPS = 20;
/** Name of the materials of the scene without smoke. */
const SCENE = 'scene';

window.measureCosts = async ({ rounds, signal, onProgress }: CostOptions): Promise<CostReport> => {
  const canvas = document.createElement('canvas');
  document.body.replaceChildren(canvas);
  const gl = canvas.getContext('webgl2', { stencil: true, antialias: false });
  if (!gl) throw new Error('This browser has no WebGL 2, or it is turned off, so there is nothing to measure.');
  const gpu = rendererName(gl);
  const { width, height } = ON_PROCESSOR.test(gpu) ? SMALL : SIZE;
  const scene = new CostScene(canvas, width, height, paint);
  try {
    const measurement = new Measurement(scene, rounds, signal);
    const all = [BASE, ...CASES];
    onProgress(0, BASE.name);
    const base = await scene.create(BASE, signal);
    const cases: CaseCost[] = [];
    for (const [index, each] of all.entries()) {
      onProgress(index / all.length, each.name);
      cases.push(await measurement.measure(base, each));
    }
    return { gpu, width, height, rounds, cases, passes: await measurement.timePasses(base) };
  } finally {
    scene.dispose();
  }
};

class Measurement {
  private readonly scene: CostScene;
  private readonly rounds: number;
  private readonly signal: AbortSignal;

  constructor(scene: CostScene, rounds: number, signal: AbortSignal) {
    this.scene = scene;
    this.rounds = rounds;
    this.signal = signal;
  }

  /** A case in turns with the base. */
  async measure(base: CostSmoke, given: CostCase): Promise<CaseCost> {
    const { scene, rounds, signal } = this;
    const own = given === base.case ? base : await scene.create(given, signal);
    const times: { frame: number; ratio: number; step: number }[] = [];
    for (let round = 0; round < rounds; round++) {
      await this.whileVisible(async () => {
        // Lets the page react.
        await nextFrame();
        const ofBase = this.timeFrames(base);
        const ofOwn = own === base ? ofBase : this.timeFrames(own);
        times[round] = { frame: ofOwn, ratio: ofOwn / ofBase, step: timeSteps(own) };
      });
    }
    const framesPerSecond = await this.whileVisible(() => this.countShown(own));
    const onGpu: number[] = [];
    for (let round = 0; round < rounds; round++)
      onGpu.push(...(await this.timeOnGpu((query) => query(() => scene.frame()))));
    for (const each of [base, own]) scene.check(each);
    if (own !== base) scene.remove(own.smoke);
    return {
      name: given.name,
      puffs: given.puffs,
      framesPerSecond,
      milliseconds: median(times.map(({ frame }) => frame)),
      ratio: median(times.map(({ ratio }) => ratio)),
      stepMilliseconds: median(times.map(({ step }) => step)),
      ...(onGpu.length > 0 && { gpuMilliseconds: median(onGpu) }),
    };
  }

  /** The draw calls of a frame in groups, medians of the rounds; none where the GPU cannot be timed. */
  async timePasses(smoke: CostSmoke): Promise<PassCost[]> {
    const { scene, rounds } = this;
    const { renderer } = scene;
    const drawAsBefore = renderer.renderBufferDirect.bind(renderer);
    const groups = new Map<string, number[]>();
    scene.show(smoke);
    for (let round = 0; round < rounds; round++) {
      let names: string[] = [];
      const times = await this.timeOnGpu((query) => {
        names = [];
        renderer.renderBufferDirect = (...call) => {
          names.push(groupOf(call[3], call[2]));
          query(() => drawAsBefore(...call));
        };
        scene.frame();
        renderer.renderBufferDirect = drawAsBefore;
      });
      for (const name of new Set(names)) {
        const sum = times.reduce((all, time, index) => all + (names[index] === name ? time : 0), 0);
        if (times.length > 0) groups.set(name, [...(groups.get(name) ?? []), sum]);
      }
    }
    return [...groups].map(([name, sums]) => ({ name, milliseconds: median(sums) }));
  }

  /** Milliseconds of a frame with its step. */
  private timeFrames(smoke: CostSmoke): number {
    const { scene } = this;
    if (scene.show(smoke)) scene.frame();
    scene.finish();
    const start = performance.now();
    let count = 0;
    do {
      scene.frame();
      // Otherwise all frames would wait here, and on the GPU.
      if (count % 4 === 3) scene.finish();
    } while (++count < FRAMES && performance.now() - start < ROUND_MS);
    scene.finish();
    return (performance.now() - start) / count;
  }

  /** Frames a second that the display shows. */
  private async countShown(smoke: CostSmoke): Promise<number> {
    const { scene } = this;
    scene.show(smoke);
    scene.frame();
    const start = await nextFrame();
    let now = start;
    let count = 0;
    for (; count < SHOWN_FRAMES && now - start < SHOWN_MS; count++) {
      this.signal.throwIfAborted();
      scene.frame();
      now = await nextFrame();
    }
    return (1000 * count) / (now - start);
  }

  /** Milliseconds of the queries of the work; none where the GPU cannot be timed. */
  private timeOnGpu(work: (query: Query) => void): Promise<number[]> {
    return this.whileVisible(async () => {
      // Lets the page react.
      await nextFrame();
      this.signal.throwIfAborted();
      try {
        return await timeQueries(contextOf(this.scene), work);
      } catch {
        return [];
      }
    });
  }

  /** Waits until the page is visible, and repeats work during which it was hidden. */
  private async whileVisible<Result>(work: () => Promise<Result>): Promise<Result> {
    for (;;) {
      while (document.hidden) await happens(document, 'visibilitychange', this.signal);
      this.signal.throwIfAborted();
      let wasHidden = false;
      const note = () => (wasHidden = true);
      document.addEventListener('visibilitychange', note);
      try {
        const result = await work();
        if (!wasHidden) return result;
      } finally {
        document.removeEventListener('visibilitychange', note);
      }
    }
  }
}

function happens(target: EventTarget, type: string, signal: AbortSignal): Promise<void> {
  return new Promise((resolve, reject) => {
    target.addEventListener(type, () => resolve(), { once: true, signal });
    signal.addEventListener('abort', () => reject(signal.reason), { once: true });
  });
}

/** Milliseconds of a step. One alone may be shorter than the clock can tell. */
function timeSteps({ smoke }: CostSmoke): number {
  const start = performance.now();
  for (let step = 0; step < TIMED_STEPS; step++) smoke.step();
  return (performance.now() - start) / TIMED_STEPS;
}

/** A material in two tones. The site has three.js without the shaders of its materials. */
function paint(color: string): Material {
  return new RawShaderMaterial({
    name: SCENE,
    glslVersion: GLSL3,
    uniforms: { color: { value: new Color(color).convertLinearToSRGB() } },
    vertexShader: `
      in vec3 position, normal;
      uniform mat4 modelViewMatrix, projectionMatrix;
      uniform mat3 normalMatrix;
      out vec3 facing;
      void main() {
        facing = normalMatrix * normal;
        gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
      }`,
    fragmentShader: `
      precision highp float;
      in vec3 facing;
      uniform vec3 color;
      out vec4 pixel;
      void main() {
        pixel = vec4(color * (dot(normalize(facing), vec3(0.3, 0.8, 0.5)) > 0.3 ? 1.0 : 0.65), 1.0);
      }`,
  });
}

/** What draws: the scene without smoke, or a part of the smoke. */
function groupOf(material: Material, geometry: BufferGeometry): string {
  if (material.name === SCENE) return SCENE;
  if ('corner' in geometry.attributes) return 'passes over the picture';
  return material.colorWrite ? 'puffs' : 'shadow volumes';
}

function contextOf({ renderer }: CostScene): WebGL2RenderingContext {
  return renderer.getContext() as WebGL2RenderingContext;
}

function nextFrame(): Promise<number> {
  return new Promise(requestAnimationFrame);
}

/** @param values at least one */
function median(values: readonly number[]): number {
  const sorted = values.toSorted((a, b) => a - b);
  return (sorted[Math.floor((sorted.length - 1) / 2)] + sorted[Math.ceil((sorted.length - 1) / 2)]) / 2;
}
