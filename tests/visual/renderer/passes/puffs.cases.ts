/** Single puffs and small heaps, compared with expected pixels. */
import { OrthographicCamera, PerspectiveCamera, Vector3, type Camera } from 'three';
import { bakedPuffs } from '../../../../src/renderer/bakedPuffs.ts';
import type { PuffForm } from '../../../../src/renderer/gpu/puffTextures.ts';
import { samplePuff, type PuffSample } from '../../../../src/renderer/puffs/billboards/layers.ts';
import { sampleLobes } from '../../../../src/renderer/puffs/billboards/channelSheet.ts';
import { LOBE_SHAPES } from '../../../../src/renderer/puffs/lobeShapes.ts';
import type { PuffShape } from '../../../../src/renderer/puffs/shapes.ts';
import { orientationOf, rotatedLobes } from '../../../../src/renderer/puffs/orientation.ts';
import { parseStops, rampOf } from '../../../../src/renderer/palette.ts';
import type { Style } from '../../../../src/renderer/style.ts';
import { frontCamera, Lab, PLAIN_STYLE, takePicture, type LabPicture, type LabPuff } from '../../lab.ts';
import { random } from '../../random.ts';
import { ground } from '../../solids.ts';

const [WIDTH, HEIGHT] = [240, 180];

type Triple = [number, number, number];

export function differing(a: LabPicture, b: LabPicture): number {
  const [wordsOfA, wordsOfB] = [a, b].map(wordsOf);
  return wordsOfA.reduce((count, word, at) => count + Number(word !== wordsOfB[at]), 0);
}

/** Pixels by colour `r,g,b,a`. */
export function colors(picture: LabPicture): Record<string, number> {
  const counts = new Map<number, number>();
  for (const word of wordsOf(picture)) counts.set(word, (counts.get(word) ?? 0) + 1);
  const keyOf = (word: number) => new Uint8Array(Uint32Array.of(word).buffer).join();
  return Object.fromEntries([...counts].map(([word, count]) => [keyOf(word), count]));
}

/** One number per pixel: tests compare hundreds of pictures. */
function wordsOf({ pixels }: LabPicture): Uint32Array {
  return new Uint32Array(pixels.buffer, pixels.byteOffset, pixels.length / 4);
}

function heap(count: number, seed: number): LabPuff[] {
  const next = random(seed);
  return Array.from({ length: count }, () => ({
    place: [next() * 2 - 1, next() * 1.6 - 0.8, next() * 1.6 - 0.8] as Triple,
    radius: 0.15 + 0.3 * next(),
    roll: next() * 2 * Math.PI,
    variation: Math.floor(next() * 4),
    seed: Math.floor(next() * 256),
  }));
}

/** A puff without roll, seen by a camera along -z, by (x, y) in radii; computed on the CPU. */
export function seenOf(form: PuffForm, variation: number, seed = 0, roll = 0): (x: number, y: number) => PuffSample {
  if (form === 'billboards') {
    const { layers } = bakedPuffs().billboards;
    return (x, y) => samplePuff(layers, variation, x, y);
  }
  const lobes = rotatedLobes(orientationOf(seed, roll), LOBE_SHAPES[variation].lobes);
  return (x, y) => sampleLobes(lobes, x, y);
}

/** The colours of a heap of puffs with two tones and shadows, and the colours that its ramp, ink and page allow. */
export function toneColors(form: PuffForm): { found: Record<string, number>; allowed: string[] } {
  const ramp = rampOf(PLAIN_STYLE.smokeColor, { tones: 2, shading: true });
  const opaque = [...ramp.lit.map(({ color }) => color), PLAIN_STYLE.inkColor].map((color) => `${color.join()},255`);
  return {
    found: colors(takePicture({ width: WIDTH, height: HEIGHT, puffs: heap(60, 5), style: { form } })),
    allowed: [...opaque, '0,0,0,0'],
  };
}

/**
 * The colours of a heap of puffs with custom stops, fill light, rim and temperature colours, and the allowed colours:
 * the rim, and the stops and fill tone of each temperature band.
 */
export function chosenColors(form: PuffForm): { found: Record<string, number>; allowed: string[] } {
  const style: Style = {
    ...PLAIN_STYLE,
    form,
    stops: parseStops('0:6a5aff,.2:b89aa8,.6:ffffff'),
    fill: 0.3,
    rim: 0.5,
    rimColor: [255, 250, 120],
    heatColors: parseStops('0:707078,.5:e06030,.9:ffe8a0'),
  };
  const puffs = heap(60, 5).map((puff, index) => ({ ...puff, temperature: [0.1, 0.6, 1.5][index % 3] }));
  const ramps = style.heatColors.map(({ color }) => rampOf(color, style));
  const tones = ramps.flatMap(({ lit, filled }) => [...lit.map(({ color }) => color), filled!]);
  const opaque = [...tones, style.rimColor, style.inkColor].map((color) => `${color.join()},255`);
  return {
    found: colors(takePicture({ width: WIDTH, height: HEIGHT, puffs, style })),
    allowed: [...opaque, '0,0,0,0'],
  };
}

/** Pixels of a puff with a height gradient that change when smoke appears far above, outside the picture. */
export function heightUnrest(form: PuffForm): { differing: number; shades: number } {
  const puff: LabPuff = { place: [0, 0, 0], radius: 0.8 };
  const style = { form, shadows: false, gradient: 'height' } as const;
  const [alone, below] = [[puff], [puff, { place: [0, 40, 0], radius: 0.8 } as LabPuff]].map((puffs) =>
    takePicture({ width: WIDTH, height: HEIGHT, puffs, style }),
  );
  return { differing: differing(alone, below), shades: Object.keys(colors(alone)).length };
}

/** A puff of one ball, with an analytic surface. */
const BALL: PuffShape = { name: 'ball', lobes: [{ center: [0, 0, 0], radius: 1 }] };
const BALL_RADIUS = 0.8;

/**
 * A ball with a height gradient, seen by tilted cameras: largest error of a channel against the tone for the height at
 * the pixel, and the number of compared pixels.
 */
export function heightErrors(form: PuffForm): { tilt: number; projection: string; looked: number; worst: number }[] {
  const puff: LabPuff = { place: [0.3, 0.2, -0.1], radius: BALL_RADIUS };
  const style = { ...PLAIN_STYLE, form, shadows: false, shading: false, outlines: false, gradient: 'height' } as const;
  const size = { width: WIDTH, height: HEIGHT };
  const lab = new Lab({ ...size, puffs: [puff], shapes: [BALL] });
  const reports = ['orthographic', 'perspective'].flatMap((projection) =>
    [-60, 0, 35, 70].map((tilt) => {
      const camera = tiltedCamera(projection, tilt, puff);
      const { pixels } = lab.draw({ ...size, puffs: [puff], camera, style });
      let [looked, worst] = [0, 0];
      for (let at = 0; at < WIDTH * HEIGHT; at++) {
        const height = heightShown(at, camera, puff);
        if (height === undefined) continue;
        const share = (height - style.gradientHeights[0]) / (style.gradientHeights[1] - style.gradientHeights[0]);
        looked++;
        style.smokeColor.forEach((bright, channel) => {
          const low = style.gradientColor[channel];
          const expected = low + (bright - low) * Math.min(1, Math.max(0, share));
          worst = Math.max(worst, Math.abs(pixels[4 * at + channel] - expected));
        });
      }
      return { tilt, projection, looked, worst };
    }),
  );
  lab.dispose();
  return reports;
}

/** Camera in front of a puff, off-centre and tilted around it in degrees: 90 looks down. */
function tiltedCamera(projection: string, tilt: number, { place }: LabPuff): Camera {
  const camera =
    projection === 'perspective'
      ? new PerspectiveCamera(50, WIDTH / HEIGHT, 0.1, 50)
      : new OrthographicCamera(-1.6, 1.6, 1.2, -1.2, 0.1, 50);
  const angle = (tilt * Math.PI) / 180;
  camera.position.set(0, 3 * Math.sin(angle), 3 * Math.cos(angle)).add(new Vector3(...place));
  camera.lookAt(...place);
  camera.translateX(0.3);
  camera.translateY(0.2);
  camera.updateMatrixWorld();
  return camera;
}

/**
 * World height of a ball's surface at a pixel, raised along the view ray as on a nailboard; undefined outside and at
 * the rim.
 */
function heightShown(at: number, camera: Camera, { place, radius }: LabPuff): number | undefined {
  const pixel = [((at % WIDTH) + 0.5) / WIDTH, (Math.floor(at / WIDTH) + 0.5) / HEIGHT].map((share) => 2 * share - 1);
  const [near, far] = [-1, 1].map((z) =>
    new Vector3(pixel[0], pixel[1], z).unproject(camera).applyMatrix4(camera.matrixWorldInverse),
  );
  const pointAt = (z: number) => near.clone().lerp(far, (z - near.z) / (far.z - near.z));
  const centre = new Vector3(...place).applyMatrix4(camera.matrixWorldInverse);
  const beside = pointAt(centre.z).sub(centre).length() / radius;
  if (beside > 0.9) return undefined;
  return pointAt(centre.z + radius * Math.sqrt(1 - beside * beside)).applyMatrix4(camera.matrixWorld).y;
}

/**
 * The colours of a lone puff by tint, most frequent first, without ink and page, and the colours of the tint's ramp.
 */
export function tintColors(form: PuffForm): { tint: number; found: string[]; expected: string[] }[] {
  const { smokeColor, tints, inkColor } = PLAIN_STYLE;
  const other = [`${inkColor.join()},255`, '0,0,0,0'];
  return [smokeColor, ...tints, tints[0], tints[1]].map((color, tint) => {
    const puffs = [{ place: [0, 0, 0] as Triple, radius: 1, tint }];
    const scene = { width: WIDTH, height: HEIGHT, puffs, towardsLight: [0.6, 0.6, 0.53] as Triple, style: { form } };
    const found = colors(takePicture(scene));
    const ramp = rampOf(color, { tones: 2, shading: true });
    return {
      tint,
      found: Object.keys(found)
        .filter((key) => !other.includes(key))
        .sort(),
      expected: ramp.lit.map((tone) => `${tone.color.join()},255`).sort(),
    };
  });
}

/** The ink of a lit puff, of one seen from its dark side, and of one in another puff's shadow. */
export function inkColors(form: PuffForm): Record<string, { ink: number; nearInk: number }> {
  const puff: LabPuff = { place: [0, 0, 0], radius: 0.8 };
  const blocker: LabPuff = { place: [0, 0, 6], radius: 3 };
  const of = (towardsLight: Triple, casters: LabPuff[]) => {
    const picture = takePicture({
      width: WIDTH,
      height: HEIGHT,
      puffs: [puff],
      casters,
      towardsLight,
      style: { form },
    });
    const ink = `${PLAIN_STYLE.inkColor.join()},255`;
    const found = colors(picture);
    const near = Object.keys(found).filter((key) => key !== ink && isDark(key));
    return { ink: found[ink] ?? 0, nearInk: near.reduce((sum, key) => sum + found[key], 0) };
  };
  return { light: of([0, 0, 1], []), shade: of([0, 0, -1], []), shadow: of([0, 0, 1], [blocker]) };
}

function isDark(color: string): boolean {
  const [red, green, blue, alpha] = color.split(',').map(Number);
  return alpha > 0 && Math.max(red, green, blue) < 100;
}

interface Heights {
  lowest: number;
  highest: number;
}

function spanOf(heights: readonly number[]): Heights {
  return { lowest: Math.min(...heights), highest: Math.max(...heights) };
}

/** Heights along a puff's silhouette, in radii. The ink around the puff has these heights. */
function edgeHeights(seen: (x: number, y: number) => PuffSample): Heights {
  const heights: number[] = [];
  for (let x = -1; x <= 1; x += 1 / 128) {
    for (let y = -1; y <= 1; y += 1 / 128) {
      const { distance, height } = seen(x, y);
      if (Math.abs(distance) < 0.06) heights.push(height);
    }
  }
  return spanOf(heights);
}

/** Heights of a puff's surface near its centre, in radii. */
function faceHeights(seen: (x: number, y: number) => PuffSample, reach: number): Heights {
  const heights: number[] = [];
  for (let x = -1.3; x <= 1.3; x += 0.1) {
    for (let y = -1.3; y <= 1.3; y += 0.1) heights.push(seen(x * reach, y * reach).height);
  }
  return spanOf(heights);
}

/**
 * Ink pixels around a small puff in front of the face of a very large one.
 * @param side the silhouette of the small puff is nearer to the face than the threshold (`under`), or farther (`over`)
 */
export function innerInk(form: PuffForm, side: 'under' | 'over', innerTaper = 0, multiple = 1): number {
  const [near, far, innerLine, variation] = [0.35, 14, 0.9, 2];
  const threshold = multiple * innerLine * near;
  const seen = seenOf(form, variation);
  const face = faceHeights(seen, near / far);
  const edge = edgeHeights(seen);
  const slack = 0.04 * threshold;
  const centre =
    side === 'under'
      ? face.lowest * far + threshold - edge.highest * near - slack
      : face.highest * far + threshold - edge.lowest * near + slack;
  const picture = takePicture({
    width: WIDTH,
    height: HEIGHT,
    puffs: [
      { place: [0, 0, centre], radius: near, variation },
      { place: [0, 0, 0], radius: far, variation },
    ],
    camera: frontCamera(WIDTH, HEIGHT, far + 25, 4),
    style: { form, innerLine, innerTaper, outlineWidth: 6, shadows: false },
  });
  return colors(picture)[`${PLAIN_STYLE.inkColor.join()},255`] ?? 0;
}

/** Pixels that change with the order of puffs and casters. */
export function orderSensitivity(form: PuffForm): { differing: number; pixels: number; painted: number } {
  const puffs = heap(200, 9);
  const next = random(4);
  const shuffled = puffs
    .map((puff) => ({ puff, key: next() }))
    .sort((a, b) => a.key - b.key)
    .map(({ puff }) => puff);
  const surfaces = [ground(-1, 3)];
  const [a, b] = [puffs, shuffled].map((rows) =>
    takePicture({ width: WIDTH, height: HEIGHT, puffs: rows, surfaces, style: { form } }),
  );
  const painted = a.pixels.filter((value, index) => index % 4 === 3 && value > 0).length;
  return { differing: differing(a, b), pixels: WIDTH * HEIGHT, painted };
}

/** Pixels that change when the depth buffer is reversed. */
export function reversalSensitivity(form: PuffForm): { differing: number; painted: number } {
  const scene = { width: WIDTH, height: HEIGHT, puffs: heap(60, 9), surfaces: [ground(-0.6, 3)], style: { form } };
  const [plain, reversed] = [false, true].map((reversedDepth) => takePicture({ ...scene, reversedDepth }));
  const painted = plain.pixels.filter((value, index) => index % 4 === 3 && value > 0).length;
  return { differing: differing(plain, reversed), painted };
}

/**
 * Largest distance, in pixels, between the centre of a wrongly covered or wrongly uncovered pixel and the silhouette
 * plus the width of the ink line. The CPU projects the silhouette.
 */
export function outlineError(
  form: PuffForm,
  radius: number,
  distance: number,
  variation: number,
  inkPixels: number,
): { worst: number; covered: number } {
  const size = 320;
  const camera = frontCamera(size, size, distance);
  const [seed, roll] = form === 'lobes' ? [61 * variation, 1 + variation] : [0, 0];
  const puff: LabPuff = { place: [0, 0, 0], radius, variation, seed, roll };
  const style = { form, outlines: inkPixels > 0, outlineWidth: inkPixels / 2 };
  const { pixels } = takePicture({ width: size, height: size, puffs: [puff], camera, style, pixelRatio: 2 });
  const pixelsPerRadius = (size / 2) * camera.projectionMatrix.elements[5] * (radius / distance);
  const seen = seenOf(form, variation, seed, roundedRoll(roll));
  const result = { worst: 0, covered: 0 };
  for (let pixel = 0; pixel < size * size; ++pixel) {
    const x = ((pixel % size) + 0.5 - size / 2) / pixelsPerRadius;
    const y = (Math.floor(pixel / size) + 0.5 - size / 2) / pixelsPerRadius;
    const expected = Math.max(Math.abs(x), Math.abs(y)) < 1.2 ? seen(x, y).distance : 1;
    const isCovered = pixels[4 * pixel + 3] > 0;
    const outside = expected * pixelsPerRadius - inkPixels;
    if (isCovered) result.covered += 1;
    if (isCovered !== outside < 0) result.worst = Math.max(result.worst, Math.abs(outside));
  }
  return result;
}

/** A roll with the 16-bit precision of a row, radians. */
export function roundedRoll(roll: number): number {
  return (Math.round((roll / (2 * Math.PI)) * 65536) / 65536) * 2 * Math.PI;
}

/**
 * Largest deviation of the seam between a puff and a horizontal plane through its centre from a straight line, pixels.
 */
export function seamBend(form: PuffForm): number {
  const camera = new PerspectiveCamera(40, WIDTH / HEIGHT, 0.1, 50);
  camera.position.set(0, 1.6, 3);
  camera.lookAt(0, 0, 0);
  camera.updateMatrixWorld();
  const picture = takePicture({
    width: WIDTH,
    height: HEIGHT,
    puffs: [{ place: [0, 0, 0], radius: 0.8 }],
    surfaces: [ground(0, 4)],
    camera,
    style: { form, outlines: false, shadows: false, shading: false },
  });
  const smoke = PLAIN_STYLE.smokeColor;
  const rows: number[] = [];
  for (let column = 0; column < WIDTH; ++column) {
    for (let row = 0; row < HEIGHT; ++row) {
      const at = 4 * (row * WIDTH + column);
      if (smoke.every((value, channel) => picture.pixels[at + channel] === value)) {
        rows.push(row);
        break;
      }
    }
  }
  return rows.length > 20 ? Math.max(...rows) - Math.min(...rows) : 0;
}

/** Pixels by colour of a ground in the shadow of a puff that is outside the picture. */
export function groundColors(style: Partial<Style>): Record<string, number> {
  const camera = new PerspectiveCamera(40, WIDTH / HEIGHT, 0.1, 50);
  camera.position.set(0, 1.5, 1.5);
  camera.lookAt(0, 0, 0);
  camera.updateMatrixWorld();
  const puffs: LabPuff[] = [{ place: [0, 4, 0], radius: 0.6 }];
  const surfaces = [ground(0, 4)];
  return colors(takePicture({ width: WIDTH, height: HEIGHT, puffs, surfaces, camera, towardsLight: [0, 1, 0], style }));
}
