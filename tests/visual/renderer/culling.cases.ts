/** Pictures with and without the culling of `arrange`: pixels that differ, and pixels whose shadow differs. */
import { OrthographicCamera, PerspectiveCamera, Vector3, type Camera } from 'three';
import { defaultPreset, findPreset, presetValues, type Preset } from '../../../src/parameters/presets.ts';
import type { Value, Values } from '../../../src/parameters/parameter.ts';
import { finished } from '../../../src/base/work.ts';
import { bakingPuffs } from '../../../src/renderer/bakedPuffs.ts';
import type { PuffShape } from '../../../src/renderer/puffs/shapes.ts';
import { SmokeRenderer } from '../../../src/renderer/smoke.ts';
import { ALL_PARTICLES } from '../../../src/simulator/view.ts';
import { drawFrame } from '../../../src/renderer/frame.ts';
import type { FrameInput, FrameReport } from '../../../src/renderer/frameInput.ts';
import type { Style } from '../../../src/renderer/style.ts';
import { createStage } from '../../../src/stage/stage.ts';
import { RenderBench } from '../../bench/render/bench.ts';
import { PLAIN_LOOK } from '../../support/plainLook.ts';

/** Differences between two pictures of the same moment, and the number of rows that each one draws. */
export interface Comparison {
  /** Pixels with another colour, and pixels that are in shadow in only one of the two. */
  changed: number;
  masked: number;
  /** Pixels in shadow, and colours. A picture without them compares nothing. */
  shadowed: number;
  colors: number;
  bodies: [culled: number, whole: number];
  casters: [culled: number, whole: number];
}

/** Camera of the scene, from the side and above, inside a plume, behind the smoke, orthographic. */
export type Viewpoint = 'scene' | 'above' | 'inside' | 'behind' | 'orthographic';

const [WIDTH, HEIGHT] = [200, 150];

/** A moment of a preset's scene as its stage draws it, from several viewpoints. The default preset where absent. */
export async function compareScene(
  { preset, ...values }: Values & { readonly preset?: string },
  seconds: number,
  places: readonly Viewpoint[],
): Promise<Comparison[]> {
  const comparisons: Comparison[] = [];
  const { prepare } = SmokeRenderer.prototype;
  const stage = await createStage(new OffscreenCanvas(WIDTH, HEIGHT), {
    values: { ...presetValues(presetNamed(preset)), ...PLAIN_LOOK, ...values },
    width: WIDTH,
    height: HEIGHT,
    pixelRatio: 1,
  });
  await stage.seek(seconds);
  // Every frame begins with this call. The frames that are compared precede it.
  SmokeRenderer.prototype.prepare = function (input: FrameInput) {
    SmokeRenderer.prototype.prepare = prepare;
    for (const place of places) {
      const camera = place === 'behind' ? cameraBehind(input) : cameraAt(place, input.camera);
      comparisons.push(compare(this, (cull) => drawFrame(this, { ...input, camera, cull })));
    }
    return this.prepare(input);
  };
  try {
    await stage.picture();
  } finally {
    SmokeRenderer.prototype.prepare = prepare;
    stage.dispose();
  }
  return comparisons;
}

function presetNamed(name: Value | undefined): Preset {
  if (name === undefined) return defaultPreset;
  const preset = findPreset(String(name));
  if (!preset) throw new Error(`There is no preset ${name}; nothing would be compared.`);
  return preset;
}

/** A seeded plume of the benchmark. @param shapes, sides of its puffs, if not the default ones */
export async function comparePlume(
  particles: number,
  style: Partial<Style>,
  places: readonly Exclude<Viewpoint, 'behind'>[],
  shapes?: readonly PuffShape[],
  sides = 1,
): Promise<Comparison[]> {
  const bench = await RenderBench.create(0.5, particles);
  if (shapes) bench.smoke.setPuffs(finished(bakingPuffs(shapes, { sides })));
  bench.style = { ...bench.style, ...style };
  const comparisons = places.map((place) => {
    const camera = cameraAt(place, bench.camera);
    return compare(bench.smoke, (cull) => bench.draw(cull, camera));
  });
  bench.dispose();
  return comparisons;
}

/** On the opposite side of the smoke, at the distance of the scene's camera. */
function cameraBehind({ camera, simulator, blend }: FrameInput): Camera {
  const { min, max } = simulator.arrange({ ...ALL_PARTICLES, blend }).bounds;
  const middle = new Vector3(...min).lerp(new Vector3(...max), 0.5);
  const behind = camera.clone();
  const { x, y, z } = new Vector3().subVectors(camera.position, middle);
  behind.position.set(middle.x - x, middle.y + y, middle.z - z);
  behind.lookAt(middle);
  behind.updateMatrixWorld();
  return behind;
}

/** Both lamp and plume start at the origin. */
function cameraAt(place: Exclude<Viewpoint, 'behind'>, scene: Camera): Camera {
  if (place === 'scene') return scene;
  const aspect = WIDTH / HEIGHT;
  const camera =
    place === 'orthographic'
      ? new OrthographicCamera(-1.6 * aspect, 1.6 * aspect, 1.6, -1.6, 0.1, 30)
      : new PerspectiveCamera(place === 'inside' ? 70 : 35, aspect, 0.05, 60);
  const [x, y, z] = { above: [4.5, 5.2, 2.5], inside: [0.35, 1.1, 0.1], orthographic: [-4, 3, 5] }[place];
  camera.position.set(x, y, z);
  camera.lookAt(0.3, 1.6, 0);
  camera.updateMatrixWorld();
  return camera;
}

function compare(smoke: SmokeRenderer, draw: (cull: boolean) => FrameReport): Comparison {
  const [culled, whole] = [true, false].map((cull) => ({ report: draw(cull), ...read(smoke) }));
  return {
    changed: differing(culled.colors, whole.colors),
    masked: differing(culled.mask, whole.mask),
    shadowed: whole.mask.reduce((sum, value) => sum + (value > 0 ? 1 : 0), 0),
    colors: new Set(whole.colors).size,
    bodies: [culled.report.bodiesDrawn, whole.report.bodiesDrawn],
    casters: [culled.report.castersDrawn, whole.report.castersDrawn],
  };
}

/** The picture, and where the stencil is not zero (the mask, which the alpha channel of the lit colour stores). */
function read({ passes }: SmokeRenderer): { colors: Uint32Array; mask: Uint8Array } {
  const { renderer, targets } = passes;
  const gl = renderer.getContext();
  const { width, height } = targets.renderTarget;
  const colors = new Uint32Array(width * height);
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(colors.buffer));
  const lit = new Uint8Array(4 * width * height);
  renderer.readRenderTargetPixels(targets.renderTarget, 0, 0, width, height, lit, 0, 1);
  return { colors, mask: lit.filter((_, index) => index % 4 === 3) };
}

function differing(a: Uint32Array | Uint8Array, b: Uint32Array | Uint8Array): number {
  let count = 0;
  for (let index = 0; index < a.length; index++) count += a[index] === b[index] ? 0 : 1;
  return count;
}
