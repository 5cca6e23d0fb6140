/** Puffs of lobes against a picture that the CPU makes of them: silhouette, ink, depth and normals, pixel by pixel. */
import { OrthographicCamera, Quaternion, Vector3 } from 'three';
import { colorAt, type Color } from '../../../src/device/ramps.ts';
import { meetLobes, sampleLobes } from '../../../src/puffs/lobes.ts';
import { LOBE_SHAPES } from '../../../src/puffs/lobeShapes.ts';
import { orientationOf, turnedLobes, type Rotation } from '../../../src/puffs/orientation.ts';
import type { Lobe } from '../../../src/puffs/shapes.ts';
import { dot, type Vector } from '../../../src/puffs/vector.ts';
import { rampOf } from '../../../src/smoke/palette.ts';
import { Lab, PLAIN_STYLE, type LabPuff, type LabScene } from '../lab.ts';
import { random } from '../random.ts';

const SIZE = 200;
/** Half the width of the picture, metres. */
const HALF = 1.2;
const INK_PIXELS = 3;
const INNER_LINE = 0.3;
const TONING = { tones: 3, shading: true } as const;

/** A puff as the reference sees it: all in view space, lobes in radii. */
interface SeenPuff {
  centre: Vector;
  radius: number;
  lobes: readonly Lobe[];
  color: Color;
}

/** Pixels that differ from the reference, of those that either covers, over random pairs of puffs, cameras and lights. */
export function differing(trials: number): { differing: number; covered: number; inked: number } {
  const next = random(12);
  const lab = new Lab({
    width: SIZE,
    height: SIZE,
    puffs: [
      { place: [0, 0, 0], radius: 1 },
      { place: [0, 0, 0], radius: 1 },
    ],
  });
  const result = { differing: 0, covered: 0, inked: 0 };
  for (let trial = 0; trial < trials; trial++) {
    const scene = randomScene(next, trial);
    const { pixels } = lab.draw(scene);
    const seen = scene.puffs.map((puff) => seenPuff(puff, scene));
    const light = new Vector3(...scene.towardsLight)
      .normalize()
      .applyQuaternion(scene.camera.quaternion.clone().invert());
    for (let pixel = 0; pixel < SIZE * SIZE; pixel++) {
      const expected = colorOf(seen, light.toArray(), pixel);
      const found = [...pixels.subarray(4 * pixel, 4 * pixel + 4)].join();
      if (expected !== found) result.differing++;
      if (expected !== '0,0,0,0') result.covered++;
      if (expected === `${PLAIN_STYLE.inkColor.join()},255`) result.inked++;
    }
  }
  lab.dispose();
  return result;
}

/** Pixels that change when one smoke goes from lobes to billboards, and those that are not as before when it goes back. */
export function switchForms(): { there: number; back: number } {
  const scene = randomScene(random(3), 0);
  const lab = new Lab(scene);
  const [first, second, third] = (['lobes', 'billboards', 'lobes'] as const).map(
    (form) => new Uint32Array(lab.draw({ ...scene, style: { form } }).pixels.buffer),
  );
  lab.dispose();
  const unlike = (a: Uint32Array, b: Uint32Array): number => a.filter((pixel, index) => pixel !== b[index]).length;
  return { there: unlike(first, second), back: unlike(first, third) };
}

type Scene = LabScene & { camera: OrthographicCamera; towardsLight: Vector };

function randomScene(next: () => number, trial: number): Scene {
  const centred = (): number => next() - 0.5;
  const camera = new OrthographicCamera(-HALF, HALF, HALF, -HALF, 0.1, 10);
  camera.quaternion.copy(new Quaternion(centred(), centred(), centred(), centred()).normalize());
  camera.position.set(0, 0, 4).applyQuaternion(camera.quaternion);
  camera.updateMatrixWorld();
  const puffs = [0, 1].map((tint): LabPuff => ({
    place: [0.7 * centred(), 0.7 * centred(), 0.7 * centred()],
    radius: 0.4 + 0.3 * next(),
    variation: (trial + 2 * tint) % 4,
    seed: Math.floor(256 * next()),
    roll: (Math.floor(65536 * next()) / 65536) * 2 * Math.PI,
    tint,
  }));
  const style = { tones: 3, shadows: false, outlineWidth: INK_PIXELS, innerLine: INNER_LINE } as const;
  return { width: SIZE, height: SIZE, puffs, camera, towardsLight: [centred(), centred(), centred()], style };
}

function seenPuff(
  { place, radius, variation = 0, seed = 0, roll = 0, tint = 0 }: LabPuff,
  { camera }: Scene,
): SeenPuff {
  const back = camera.quaternion.clone().invert();
  const columns = [new Vector3(1, 0, 0), new Vector3(0, 1, 0), new Vector3(0, 0, 1)].map((axis) =>
    axis.applyQuaternion(back).toArray(),
  );
  const standing = turnedLobes(orientationOf(seed, roll), LOBE_SHAPES[variation].lobes);
  return {
    centre: new Vector3(...place).applyMatrix4(camera.matrixWorldInverse).toArray(),
    radius,
    lobes: turnedLobes(columns as unknown as Rotation, standing),
    color: tint === 0 ? PLAIN_STYLE.smokeColor : PLAIN_STYLE.tints[tint - 1],
  };
}

/** The colour of a pixel, `r,g,b,a`: of the puff that comes first along its ray, where a ring of ink lies deeper. */
function colorOf(seen: readonly SeenPuff[], light: Vector, pixel: number): string {
  const metre = SIZE / (2 * HALF);
  const x = ((pixel % SIZE) + 0.5) / metre - HALF;
  const y = (Math.floor(pixel / SIZE) + 0.5) / metre - HALF;
  let [nearest, color] = [-Infinity, '0,0,0,0'];
  for (const { centre, radius, lobes, color: own } of seen) {
    const [px, py] = [(x - centre[0]) / radius, (y - centre[1]) / radius];
    const { distance, height } = meetLobes(lobes, px, py);
    if (distance * radius * metre > INK_PIXELS) continue;
    const isInk = distance > 0;
    const z = centre[2] + radius * (isInk ? height - INNER_LINE : height);
    if (z <= nearest) continue;
    nearest = z;
    const facing = isInk ? 0 : toTexel(dot(sampleLobes(lobes, px, py).normal, light));
    color = `${(isInk ? PLAIN_STYLE.inkColor : colorAt(rampOf(own, TONING).lit, facing)).join()},255`;
  }
  return color;
}

/** A ramp is read at its nearest of 256 texels. */
function toTexel(facing: number): number {
  return Math.floor(Math.max(0, facing) * 256) / 256;
}
