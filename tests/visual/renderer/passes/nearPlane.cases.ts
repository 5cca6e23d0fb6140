/** Puffs around the camera and at its near plane. */
import { OrthographicCamera, PerspectiveCamera, type Camera } from 'three';
import type { PuffForm } from '../../../../src/renderer/gpu/puffTextures.ts';
import { Lab, takePicture, type LabPuff } from '../../lab.ts';
import { random } from '../../random.ts';
import { box } from '../../solids.ts';

const [WIDTH, HEIGHT] = [160, 120];
const NEAR = 0.1;
const WALL = {
  name: 'wall',
  mesh: box([0, 0, -4], [3, 3, 0.1]),
  color: [222, 170, 110],
  casts: false,
  inked: false,
} as const;

/**
 * A puff in front of a wall, seen from the direction of the light, so that its shadow is exactly behind it.
 * @param depth of its centre beyond the near plane, radii
 * @returns pixels of the puff, and pixels of the wall in its shadow
 */
export function shadowBehind(form: PuffForm, depth: number): { puff: number; shadow: number } {
  const camera = new OrthographicCamera(-1, 1, 0.75, -0.75, NEAR, 10);
  const radius = 0.5;
  const puffs = [{ place: [0, 0, -NEAR - depth * radius] as const, radius }];
  const light = { towardsLight: [0, 0, 1], readCounts: true } as const;
  const scene = { ...placed(camera), ...light, surfaces: [WALL], style: { form } };
  const whole = takePicture({ ...scene, puffs });
  const bare = pixelsOf(takePicture({ ...scene, puffs: [], casters: puffs }).pixels);
  const isPuff = pixelsOf(whole.pixels).map((color, pixel) => Number(color !== bare[pixel]));
  return {
    puff: isPuff.reduce((sum, is) => sum + is, 0),
    shadow: whole.counts.reduce((sum, count, pixel) => sum + Number(count > 0 && !isPuff[pixel]), 0),
  };
}

/** Shares of the picture that puffs cover in pictures of a camera that moves through them. */
export function flight(form: PuffForm, pictures: number): number[] {
  const next = random(11);
  const puffs = Array.from({ length: 12 }, (_, index): LabPuff => ({
    place: [next() - 0.5, next() - 0.5, -0.9 - 0.1 * index],
    radius: 0.15 + 0.3 * next(),
    roll: 6 * next(),
    variation: index % 4,
    seed: Math.floor(256 * next()),
  }));
  const camera = new PerspectiveCamera(45, WIDTH / HEIGHT, NEAR, 100);
  const lab = new Lab({ ...placed(camera), puffs });
  const shares = Array.from({ length: pictures }, (_, index) => {
    camera.position.z = (-2.6 * index) / (pictures - 1);
    const { pixels } = lab.draw({ ...placed(camera), puffs, style: { form, shadows: false } });
    return pixels.filter((value, byte) => byte % 4 === 3 && value > 0).length / (WIDTH * HEIGHT);
  });
  lab.dispose();
  return shares;
}

function placed(camera: Camera) {
  camera.updateMatrixWorld();
  return { width: WIDTH, height: HEIGHT, camera };
}

function pixelsOf(pixels: Uint8Array): Uint32Array {
  return new Uint32Array(pixels.buffer);
}
