/** Marks of a print on puffs: where they are, how much they cover, and how they move. Coverage is 0 to 1. */
import { Matrix4, OrthographicCamera, Vector3, type Camera, type Texture, type WebGLRenderer } from 'three';
import type { Values } from '../../../../src/parameters/parameter.ts';
import { fetchExtras } from '../../../../src/renderer/extraPasses.ts';
import { FullScreen } from '../../../../src/renderer/gpu/fullScreen.ts';
import { pictureTarget } from '../../../../src/renderer/passes/targets.ts';
import type { Style } from '../../../../src/renderer/style.ts';
import { Lab, PLAIN_STYLE, type LabPicture, type LabPuff } from '../../lab.ts';
import { SceneLab } from '../../sceneLab.ts';

const [WIDTH, HEIGHT] = [240, 180];
/** Pixels for each metre. */
const SCALE = 100;
/** Distance from the silhouette at which marks are whole, pixels. */
const INSIDE = 10;

/** White smoke without ink, whose black marks are its only other colour. */
const PAPER: Style = {
  ...PLAIN_STYLE,
  outlines: false,
  stops: [
    { from: 0, color: [255, 255, 255] },
    { from: 0.5, color: [255, 255, 254] },
  ],
  patternColor: [0, 0, 0],
};

const front = new OrthographicCamera(-WIDTH, WIDTH, HEIGHT, -HEIGHT, 0.1, 10);
front.zoom = 2 * SCALE;
front.updateProjectionMatrix();
front.position.z = 4;
front.updateMatrixWorld();

const lab = new Lab({ width: WIDTH, height: HEIGHT, puffs: [], capacity: 8 });

/** The coverage of each pixel, from the bottom; -1 where smoke does not cover all of it. */
function coverage({ pixels }: LabPicture): Float32Array {
  return Float32Array.from({ length: pixels.length / 4 }, (_, at) =>
    pixels[4 * at + 3] < 255 ? -1 : 1 - linear(pixels[4 * at]),
  );
}

function linear(code: number): number {
  const value = code / 255;
  return value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4;
}

/** Puffs with the light behind them: all that is seen of them is in shadow. */
function draw(
  puffs: readonly LabPuff[],
  style: Partial<Style>,
  options: { pixelRatio?: number; smoothEdges?: boolean } = {},
) {
  const scene = { width: WIDTH, height: HEIGHT, puffs, camera: front, towardsLight: [0, 0, -1] as const };
  return lab.draw({ ...scene, ...options, style: { ...PAPER, ...style } });
}

/** Number of pixels whose coverage differs by more than a tenth after a puff has moved by whole pixels, and of all compared. */
export function moved(style: Partial<Style>): { changed: number; compared: number } {
  const [right, up] = [40, 20];
  const [before, after] = [0, 1].map((share) => {
    const place = [-0.3 + (share * right) / SCALE, -0.1 + (share * up) / SCALE, 0] as const;
    return coverage(draw([{ place, radius: 0.4, roll: 1 }], style));
  });
  let [changed, compared] = [0, 0];
  for (let y = 0; y < HEIGHT - up; y++) {
    for (let x = 0; x < WIDTH - right; x++) {
      const [one, other] = [before[y * WIDTH + x], after[(y + up) * WIDTH + x + right]];
      if (one < 0 || other < 0) continue;
      compared++;
      if (Math.abs(one - other) > 0.1) changed++;
    }
  }
  return { changed, compared };
}

/** Mean coverage well inside of puffs of several radii, pixels, by radius. */
export function shares(style: Partial<Style>, radii: readonly number[]): number[] {
  return radii.map((radius) => {
    const covered = coverage(draw([{ place: [0, 0, 0], radius: radius / SCALE }], style));
    const inside = insideOf(covered);
    return inside.reduce((sum, at) => sum + covered[at], 0) / inside.length;
  });
}

/** Pixels from which the silhouette is far away. */
function insideOf(covered: Float32Array): number[] {
  const isSmoke = (at: number) => covered[at] >= 0;
  return [...covered.keys()].filter((at) =>
    [-INSIDE, 0, INSIDE].every((y) => [-INSIDE, 0, INSIDE].every((x) => isSmoke(at + y * WIDTH + x))),
  );
}

/** Share of the pixels inside of a puff that change by more than half while it grows by 1 %, for each step. */
export function changesByGrowth(style: Partial<Style>, steps: number): number[] {
  const pictures = Array.from({ length: steps + 1 }, (_, step) =>
    coverage(draw([{ place: [0, 0, 0], radius: 0.3 * 1.01 ** step }], style)),
  );
  const inside = insideOf(pictures[0]);
  return pictures.slice(1).map((after, step) => {
    const changed = inside.filter((at) => Math.abs(after[at] - pictures[step][at]) > 0.5);
    return changed.length / inside.length;
  });
}

/** Draw calls without marks, with them, and without them again; and whether the pictures without them are the same. */
export function switched(style: Partial<Style>): { calls: number[]; isSame: boolean } {
  const pictures = (['none', 'dots', 'none'] as const).map((pattern) => {
    const { pixels } = draw([{ place: [0, 0, 0], radius: 0.5 }], { ...style, pattern });
    return { pixels, calls: lab.calls };
  });
  const [before, , after] = pictures;
  const isSame = before.pixels.every((byte, at) => byte === after.pixels[at]);
  return { calls: pictures.map(({ calls }) => calls), isSame };
}

/** Number of pixels that differ between two ways to draw the same puffs. */
export function differing(
  one: { style: Partial<Style>; pixelRatio?: number; smoothEdges?: boolean },
  other: { style: Partial<Style>; pixelRatio?: number; smoothEdges?: boolean },
): { differing: number; marked: number } {
  const puffs = [
    { place: [-0.2, 0, 0], radius: 0.5 },
    { place: [0.5, 0.2, 0.1], radius: 0.4, seed: 7 },
  ] as const;
  const [first, second] = [one, other].map(({ style, ...options }) => coverage(draw(puffs, style, options)));
  const changed = first.filter((share, at) => Math.min(share, second[at]) >= 0 && Math.abs(share - second[at]) > 0.01);
  return { differing: changed.length, marked: first.filter((share) => share > 0.9).length };
}

/** What the pixels of a picture show. */
interface Followed {
  covered: Float32Array;
  isSmoke: readonly boolean[];
  /** Window depths. */
  depths: Float32Array;
  clipFromWorld: Matrix4;
}

/** Shares of the points of smoke whose coverage changes by more than half between two pictures of a scene. */
export interface Changes {
  /** Points that both pictures show. */
  points: number;
  /** With the marks of the pictures. */
  followed: number;
  /** With the marks of the first picture, as if they were fixed on the screen. */
  fixed: number;
}

/** The share of pixels that change by more than half where a full turn of the camera ends, and when it turns by 1 degree. */
export async function changesAtTurn(values: Values): Promise<{ atEnd: number; inDegree: number }> {
  const scene = await SceneLab.create('lamp', { width: 480, height: 270, ownLook: true, values });
  await fetchExtras(scene.style);
  const { azimuth } = scene.scene.camera;
  const { x, z } = scene.camera({ azimuth }).getWorldDirection(new Vector3());
  const [before, after, beyond] = [-1e-5, 1e-5, Math.PI / 180].map((turn) => {
    const camera = scene.camera({ azimuth: azimuth + Math.PI - Math.atan2(-x, -z) + turn });
    return coverage(scene.draw({ camera }));
  });
  scene.dispose();
  const changed = (one: Float32Array, other: Float32Array) =>
    one.filter((share, at) => Math.abs(share - other[at]) > 0.5).length / one.length;
  return { atEnd: changed(before, after), inDegree: changed(after, beyond) };
}

/** @param turn of the camera between the pictures, radians */
export async function orbit(preset: string, values: Values, turn: number): Promise<Changes> {
  const look: Values = {
    'style.outlines': 0,
    'style.strokes': 0,
    'style.creases': 0,
    'style.gradient': 'none',
    'style.ageRamp': '',
    'style.heatRamp': '',
    'style.rim': 0,
    'style.fill': 0,
    'style.ramp': '0:ffffff,.4:fffffe',
    'style.backdrop': '0:ffffff,1:fffffe',
    'style.wash': 1,
    'style.washColor': '#ffffff',
    'style.surfaceShadowColor': '#ffffff',
    'style.patternColor': '#000000',
    ...values,
  };
  const scene = await SceneLab.create(preset, { width: 480, height: 270, ownLook: true, values: look });
  await fetchExtras(scene.style);
  scene.step(420);
  const { azimuth } = scene.scene.camera;
  const [before, after] = [0, turn].map((offset) => shoot(scene, scene.camera({ azimuth: azimuth + offset })));
  scene.dispose();
  return compare(before, after, 480, 270);
}

function shoot(scene: SceneLab, camera: Camera): Followed {
  const covered = coverage(scene.draw({ camera }));
  const { renderer, targets } = scene.passes;
  const places = texels(renderer, targets.places, targets, 'vec4 read(vec4 texel) { return texel; }');
  const packed = texels(
    renderer,
    targets.depth,
    targets,
    'vec4 read(vec4 texel) { float code = floor(texel.r * 16777215.0 + 0.5); return vec4(floor(code / 65536.0), mod(floor(code / 256.0), 256.0), mod(code, 256.0), 255.0) / 255.0; }',
  );
  const isSmoke = Array.from(covered, (_, at) => places[4 * at] + places[4 * at + 1] > 0);
  const depths = covered.map(
    (_, at) => (65536 * packed[4 * at] + 256 * packed[4 * at + 1] + packed[4 * at + 2]) / 16777215,
  );
  const clipFromWorld = new Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse);
  return { covered, isSmoke, depths, clipFromWorld };
}

/** The texels of a texture as bytes, after a function in GLSL. */
function texels(
  renderer: WebGLRenderer,
  texture: Texture,
  { width, height }: { width: number; height: number },
  read: string,
) {
  const target = pictureTarget();
  target.setSize(width, height);
  const pass = new FullScreen(
    `precision highp float; precision highp sampler2D; uniform sampler2D source; out vec4 pixel; ${read}
     void main() { pixel = read(texelFetch(source, ivec2(gl_FragCoord.xy), 0)); }`,
    { source: { value: texture } },
  );
  renderer.setRenderTarget(target);
  pass.draw(renderer);
  const pixels = new Uint8Array(4 * width * height);
  renderer.readRenderTargetPixels(target, 0, 0, width, height, pixels);
  renderer.setRenderTarget(null);
  pass.dispose();
  target.dispose();
  return pixels;
}

/** Depth in the picture by which a point may differ from what is seen there, relative to the range near it. */
const SAME_DEPTH = 2e-4;

function compare(before: Followed, after: Followed, width: number, height: number): Changes {
  const worldFromClip = before.clipFromWorld.clone().invert();
  const changes = { points: 0, followed: 0, fixed: 0 };
  before.isSmoke.forEach((isSmoke, at) => {
    if (!isSmoke) return;
    const [x, y] = [(at % width) + 0.5, Math.floor(at / width) + 0.5];
    const point = new Vector3((2 * x) / width - 1, (2 * y) / height - 1, 2 * before.depths[at] - 1);
    point.applyMatrix4(worldFromClip).applyMatrix4(after.clipFromWorld);
    const [toX, toY] = [(point.x + 1) * 0.5 * width - 0.5, (point.y + 1) * 0.5 * height - 0.5];
    if (toX < 0 || toY < 0 || toX > width - 2 || toY > height - 2) return;
    const nearest = Math.round(toY) * width + Math.round(toX);
    if (!after.isSmoke[nearest] || Math.abs(after.depths[nearest] - (point.z + 1) / 2) > SAME_DEPTH) return;
    changes.points++;
    const own = before.covered[at];
    if (Math.abs(sampled(after.covered, toX, toY, width) - own) > 0.5) changes.followed++;
    if (Math.abs(sampled(before.covered, toX, toY, width) - own) > 0.5) changes.fixed++;
  });
  const { points } = changes;
  return { points, followed: changes.followed / points, fixed: changes.fixed / points };
}

/** Linear interpolation. */
function sampled(of: Float32Array, x: number, y: number, width: number): number {
  const [left, low] = [Math.floor(x), Math.floor(y)];
  const row = (from: number) => of[from] + (x - left) * (of[from + 1] - of[from]);
  const [lower, upper] = [row(low * width + left), row((low + 1) * width + left)];
  return lower + (y - low) * (upper - lower);
}
