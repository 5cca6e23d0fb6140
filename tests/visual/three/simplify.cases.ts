/** Simplified light of smoke in a host's scene. */
import { Mesh, MeshBasicMaterial, SphereGeometry } from 'three';
import type { Values } from '../../../src/parameters/parameter.ts';
import { byComposer, byMirror, type Composed, type Seen } from './targets.cases.ts';
import { together } from './transforms.cases.ts';
import { dispose, draw, furnishedHost, HANGING, HEIGHT, smokeIn, smokePixels, WIDTH, type Pixels } from './scene.ts';

/** Two tones of light without lines, on enough puffs for small patches. */
export const TWO_TONES: Values = {
  ...HANGING,
  'simulation.maxParticles': 60,
  'emission.rate': 600,
  'emitters.0.size': 0.35,
  'emitters.0.radius': 0.6,
  'style.outlines': 0,
};
/** Pixels about the edge of smoke, where pictures are blended. */
const EDGE = 2;

export interface Change {
  /** Pixels beside the smoke that change. */
  beside: number;
  /** Pixels inside it, those that change, and pairs of neighbours that differ before and after. */
  inside: number;
  changed: number;
  border: [before: number, after: number];
}

/**
 * How values of the style change the picture of smoke, a part of which is in the shadow of a ball.
 * @param steps of shadow
 */
export async function changedBy(values: Values, steps: 1 | 2): Promise<Change> {
  const host = furnishedHost();
  const smoke = await smokeIn(host, { ...TWO_TONES, 'style.shadowSteps': steps });
  const ball = new Mesh(new SphereGeometry(0.4, 32, 24), new MeshBasicMaterial());
  ball.position.set(0.6, 2.6, 0.9);
  host.scene.add(ball);
  smoke.cast(ball);
  // First, so that nothing is left of other pictures.
  smoke.set(values);
  await smoke.complete();
  const changed = draw(host);
  smoke.set({ 'style.simplify': 0, 'style.form': 0 });
  const plain = draw(host);
  const isSmoke = smokePixels(host, smoke);
  dispose(smoke, host.renderer);
  const inside = pixels().filter((pixel) => around(pixel).every((near) => isSmoke[near]));
  const outside = pixels().filter((pixel) => !around(pixel).some((near) => isSmoke[near]));
  const differ = (pixel: number) => colorOf(plain, pixel) !== colorOf(changed, pixel);
  return {
    beside: outside.filter(differ).length,
    inside: inside.length,
    changed: inside.filter(differ).length,
    border: [borderOf(plain, inside), borderOf(changed, inside)],
  };
}

const SIMPLIFIED: Values = { ...TWO_TONES, 'style.simplify': 3, 'style.form': 0.5 };

/** Simplified smoke in a target without stencil, in a mirror, and in a scene that is elsewhere. */
export async function elsewhere(): Promise<{ composed: Composed; mirrored: Seen; moved: Record<string, number> }> {
  return {
    composed: await byComposer(0, SIMPLIFIED),
    // From the side, so that the mirror shows light and shade.
    mirrored: await byMirror(SIMPLIFIED, [4, 2, -2]),
    moved: await together('perspective', SIMPLIFIED),
  };
}

function borderOf(picture: Pixels, inside: readonly number[]): number {
  return inside.filter((pixel) => colorOf(picture, pixel) !== colorOf(picture, pixel + 1)).length;
}

function colorOf(picture: Pixels, pixel: number): string {
  return picture.subarray(4 * pixel, 4 * pixel + 3).join();
}

function pixels(): number[] {
  return Array.from({ length: WIDTH * HEIGHT }, (_, pixel) => pixel);
}

function around(pixel: number): number[] {
  const [column, row] = [pixel % WIDTH, Math.floor(pixel / WIDTH)];
  const near: number[] = [];
  for (let y = Math.max(0, row - EDGE); y <= Math.min(HEIGHT - 1, row + EDGE); y++)
    for (let x = Math.max(0, column - EDGE); x <= Math.min(WIDTH - 1, column + EDGE); x++) near.push(y * WIDTH + x);
  return near;
}
