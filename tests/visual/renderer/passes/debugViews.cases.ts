/** Debug views, compared with data that the lab reads from the same scene. */
import { OrthographicCamera, PerspectiveCamera, Plane, Raycaster, Vector2, Vector3, type Camera } from 'three';
import type { PuffForm } from '../../../../src/renderer/gpu/puffTextures.ts';
import type { DebugView } from '../../../../src/parameters/quality.ts';
import { RenderBench } from '../../../bench/render/bench.ts';
import { drawFrame } from '../../../../src/renderer/frame.ts';
import { eyeView, viewSources } from '../../../../src/renderer/views.ts';
import type { View } from '../../../../src/simulator/view.ts';
import { Lab, PLAIN_STYLE, type LabPuff, type LabScene } from '../../lab.ts';
import { box, ground } from '../../solids.ts';

const [WIDTH, HEIGHT] = [240, 180];
const TOWARDS_LIGHT = [-0.5, 0.8, 0.4] as const;

const PUFFS: readonly LabPuff[] = [
  { place: [-0.5, 0.35, 0.2], radius: 0.6, seed: 3 },
  { place: [0.5, 0.15, -0.3], radius: 0.7, seed: 9, variation: 1 },
];

const BOX = { name: 'part', color: [219, 64, 92], casts: true, inked: false } as const;

function tilted(camera: Camera): Camera {
  camera.position.set(0, 1.1, 4);
  camera.lookAt(0, -0.1, 0);
  camera.updateMatrixWorld();
  return camera;
}

function sceneOf(form: PuffForm): LabScene {
  return {
    width: WIDTH,
    height: HEIGHT,
    puffs: PUFFS,
    surfaces: [ground(-0.9, 1.6)],
    camera: tilted(new PerspectiveCamera(40, WIDTH / HEIGHT, 0.1, 50)),
    towardsLight: TOWARDS_LIGHT,
    style: { form },
  };
}

type Rgba = readonly [number, number, number, number];

/** A picture by pixel. */
function reader(pixels: Uint8Array): (pixel: number) => Rgba {
  return (pixel) => [pixels[4 * pixel], pixels[4 * pixel + 1], pixels[4 * pixel + 2], pixels[4 * pixel + 3]];
}

function same(a: Rgba, b: Rgba, tolerance = 0): boolean {
  return a.every((value, channel) => Math.abs(value - b[channel]) <= tolerance);
}

/** Colour of a count in the heat map views. */
function heatOf(number: number, rate: number): Rgba {
  const heat = 3 * (1 - 2 ** (-rate * (number > 0 ? number + 1 : 0)));
  const channel = (from: number) => Math.round(255 * Math.min(1, Math.max(0, heat - from)));
  return [channel(0), channel(1), channel(2), 255];
}

export interface ViewsReport {
  /** Wrong pixels by view. */
  wrong: Record<DebugView, number>;
  /** Pixels with a known expected value, by view. */
  judged: Record<DebugView, number>;
  error: number;
}

export function compareViews(form: PuffForm): ViewsReport {
  const plain = sceneOf(form);
  const parts = [0, 0.2].map((beside) => ({ ...BOX, mesh: box([-1.1 + beside, -0.5, 0.6], [0.3, 0.2, 0.2]) }));
  const surfaces = [...plain.surfaces!, ...parts];
  // With two shadow steps all parts count as one caster. There are too few volumes for the second step.
  const scene: LabScene = { ...plain, surfaces, style: { form, shadowSteps: 2, shadowDepth: 100 } };
  const lab = new Lab(scene);
  const show = (extra: Partial<LabScene>) => lab.draw({ ...scene, ...extra });
  const { pixels, counts } = show({ readCounts: true });
  const picture = reader(pixels);
  const free = reader(show({ style: { ...scene.style, shadows: false } }).pixels);
  // Bodies write other colours for simplified light, which the views do not show.
  const style = { ...scene.style, simplify: 2 };
  show({ style });
  const views = Object.fromEntries(VIEWS.map((view) => [view, reader(show({ view, style }).pixels)]));
  const report: ViewsReport = { wrong: zeros(), judged: zeros(), error: lab.error };
  const judge = (view: DebugView, isRight: boolean) => {
    report.judged[view] += 1;
    report.wrong[view] += isRight ? 0 : 1;
  };
  for (let pixel = 0; pixel < WIDTH * HEIGHT; ++pixel) {
    const [seen, isInk] = [picture(pixel), isInkColor(picture(pixel))];
    judge('lit', same(views.lit(pixel), free(pixel)));
    if (counts[pixel] > 0) judge('unlit', same(views.unlit(pixel), seen));
    if (seen[3] > 0) judge('ink', isInk === views.ink(pixel)[0] < 128);
    judge('counts', same(views.counts(pixel), heatOf(counts[pixel], 0.25), 1));
  }
  lab.dispose();
  return report;
}

const VIEWS: readonly DebugView[] = ['lit', 'unlit', 'ink', 'counts'];

function zeros(): Record<DebugView, number> {
  return { lit: 0, unlit: 0, ink: 0, normals: 0, depth: 0, counts: 0, overdraw: 0, coverage: 0 };
}

function isInkColor([red, green, blue]: Rgba): boolean {
  const { inkColor } = PLAIN_STYLE;
  return red === inkColor[0] && green === inkColor[1] && blue === inkColor[2];
}

/** Ink-free pixels of a lone puff, and those whose normal does not explain their tone. */
export function normalsAndTones(form: PuffForm): { puff: number; unexplained: number } {
  const towardsLight = new Vector3(0.3, 0.5, 0.8).normalize();
  const puffs: LabPuff[] = [{ place: [0, 0, 0], radius: 1, seed: 5 }];
  const scene: LabScene = {
    width: WIDTH,
    height: HEIGHT,
    puffs,
    towardsLight: towardsLight.toArray(),
    style: { form, outlines: false, shadows: false },
  };
  const lab = new Lab(scene);
  const [tones, normals] = [reader(lab.draw(scene).pixels), reader(lab.draw({ ...scene, view: 'normals' }).pixels)];
  lab.dispose();
  const report = { puff: 0, unexplained: 0 };
  for (let pixel = 0; pixel < WIDTH * HEIGHT; ++pixel) {
    if (tones(pixel)[3] === 0) continue;
    const [x, y, z] = normals(pixel).map((value) => value / 127.5 - 1);
    const facing = new Vector3(x, y, z).normalize().dot(towardsLight);
    report.puff += 1;
    // An 8-bit normal has an error of about 0.01 in the cosine.
    if (Math.abs(facing - 0.5) < 0.015) continue;
    if ((tones(pixel)[0] === PLAIN_STYLE.smokeColor[0]) !== facing > 0.5) report.unexplained += 1;
  }
  return report;
}

/** Largest difference between the depth view and the true depth of a ground, in 1/255, for both camera types. */
export function depthError(): { worst: number; pixels: number } {
  const cameras = [
    new PerspectiveCamera(40, WIDTH / HEIGHT, 0.1, 50),
    new OrthographicCamera(-2, 2, 1.5, -1.5, 0.1, 50),
  ];
  const reports = cameras.map((camera) => depthErrorOf(tilted(camera)));
  return {
    worst: Math.max(...reports.map(({ worst }) => worst)),
    pixels: Math.min(...reports.map(({ pixels }) => pixels)),
  };
}

function depthErrorOf(camera: Camera): { worst: number; pixels: number } {
  const scene: LabScene = { ...sceneOf('lobes'), camera, puffs: [], casters: [PUFFS[0]], view: 'depth' };
  const lab = new Lab(scene);
  const view = reader(lab.draw(scene).pixels);
  const { receiversMin, receiversMax } = lab['smoke'].passes.eye.uniforms;
  const [min, max] = [receiversMin.value.clone(), receiversMax.value.clone()];
  lab.dispose();
  const depthOf = (point: Vector3) => -point.clone().applyMatrix4(camera.matrixWorldInverse).z;
  const corners = [min.x, max.x].flatMap((x) =>
    [min.z, max.z].flatMap((z) => [min.y, max.y].map((y) => depthOf(new Vector3(x, y, z)))),
  );
  const [nearest, farthest] = [Math.min(...corners), Math.max(...corners)];
  const report = { worst: 0, pixels: 0 };
  for (let pixel = 0; pixel < WIDTH * HEIGHT; ++pixel) {
    if (view(pixel)[0] === 0) continue;
    const at = new Vector2(
      (((pixel % WIDTH) + 0.5) / WIDTH) * 2 - 1,
      ((Math.floor(pixel / WIDTH) + 0.5) / HEIGHT) * 2 - 1,
    );
    const caster = new Raycaster();
    caster.setFromCamera(at, camera);
    const point = caster.ray.intersectPlane(new Plane(new Vector3(0, 1, 0), 0.9), new Vector3())!;
    const expected = 255 * (1 - (depthOf(point) - nearest) / (farthest - nearest));
    report.pixels += 1;
    report.worst = Math.max(report.worst, Math.abs(view(pixel)[0] - expected));
  }
  return report;
}

/** Overdraw colours of two coincident bodies, without and with shadow volumes, and the expected colours. */
export function overdraw(): { bodies: string[]; expected: string[]; withVolumes: number } {
  const twice = [PUFFS[0], PUFFS[0]];
  const scene: LabScene = { ...sceneOf('lobes'), puffs: twice, view: 'overdraw' };
  const lab = new Lab(scene);
  const colorsOf = (shadows: boolean) => {
    const view = reader(lab.draw({ ...scene, style: { shadows } }).pixels);
    return new Set(Array.from({ length: WIDTH * HEIGHT }, (_, pixel) => view(pixel).join()));
  };
  const [bodies, all] = [colorsOf(false), colorsOf(true)];
  lab.dispose();
  return {
    bodies: [...bodies].sort(),
    expected: [heatOf(0, 0.06), heatOf(2, 0.06)].map((color) => color.join()).sort(),
    withVolumes: all.size,
  };
}

/**
 * Pixels of a plume: tinted by the grid view, tinted by mistake (`wrong`), not tinted although covered (`missing`), and
 * tinted without smoke (`clear`).
 */
export async function coverageTints(): Promise<{ tinted: number; wrong: number; missing: number; clear: number }> {
  const bench = await RenderBench.create(0.5, 1500);
  const input = bench['input'](true);
  const none = { count: 0, whole: 0, place: new Float32Array(), attributes: new Uint32Array() };
  const withoutRows = {
    arrange: (view: View) => ({ ...bench.simulator.arrange(view), rows: none }),
    moves: () => none.place,
  };
  const shown = (view: DebugView, extra = {}) => {
    drawFrame(bench.smoke, { ...input, ...extra, view });
    return reader(bench.picture());
  };
  const [tints, lit, smoke] = [shown('coverage'), shown('lit'), shown('normals')];
  const empty = shown('normals', { simulator: withoutRows });
  const isCovered = coveredIn(bench);
  const report = { tinted: 0, wrong: 0, missing: 0, clear: 0 };
  for (let pixel = 0; pixel < input.width * input.height; pixel++) {
    const warmth = ([red, , blue]: Rgba) => red - blue;
    const isTinted = warmth(tints(pixel)) > 0.4 * warmth(lit(pixel)) + 15;
    report.tinted += isTinted ? 1 : 0;
    report.wrong += isTinted && !isCovered(pixel) ? 1 : 0;
    report.missing += !isTinted && isCovered(pixel) ? 1 : 0;
    report.clear += isTinted && same(smoke(pixel), empty(pixel)) ? 1 : 0;
  }
  bench.dispose();
  return report;
}

/** Whether the simulator's grid covers a pixel of the benchmark picture. */
function coveredIn(bench: RenderBench): (pixel: number) => boolean {
  const { simulator, smoke, camera } = bench;
  const input = bench['input'](true);
  const { grid } = simulator.arrange(eyeView(viewSources(smoke.passes, input), input));
  const { columns, rows, stride, corner, density, depths } = grid!;
  const known = depths.slice();
  const scale = [camera.projectionMatrix.elements[0], camera.projectionMatrix.elements[5]];
  return (pixel) => {
    const at = [(pixel % input.width) + 0.5, Math.floor(pixel / input.width) + 0.5];
    const [column, row] = at.map((value, axis) => {
      const ndc = (2 * value) / [input.width, input.height][axis] - 1;
      return Math.floor((ndc / scale[axis] - corner[axis]) * density);
    });
    const isInside = column >= 0 && column < columns && row >= 0 && row < rows;
    return isInside && Number.isFinite(known[row * stride + column]);
  };
}
