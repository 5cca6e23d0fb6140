/** Shadows on a ground: those of balls, which are known exactly, and their colours in two steps. */
import { Vector3 } from 'three';
import type { Color } from '../../../src/device/ramps.ts';
import type { PuffShape } from '../../../src/puffs/shapes.ts';
import { multiply, rampOf, surfaceToning } from '../../../src/smoke/palette.ts';
import { PLAIN_STYLE, takePicture, type LabPuff, type LabScene } from '../lab.ts';
import { towardsLightOf, type View } from '../shadowVolume.ts';
import { ground } from '../solids.ts';
import { cluster, GROUND_HALF, GROUND_Y, groundPoint, HEIGHT, lightOf, viewRay, VIEWS, WIDTH } from './stencil.ts';

const BALL: readonly PuffShape[] = [{ name: 'ball', lobes: [{ center: [0, 0, 0], radius: 1 }] }];

/** Pixels of the ground under puffs of one lobe, and those whose count is not that of the balls before the light. */
export function balls(viewName: string): { receiver: number; differing: number; deepest: number } {
  const view = VIEWS[viewName]();
  const casters = cluster(12);
  const { counts } = takePicture({
    width: WIDTH,
    height: HEIGHT,
    puffs: [],
    casters,
    shapes: BALL,
    surfaces: [ground(GROUND_Y, GROUND_HALF)],
    camera: view.camera,
    ...lightOf(view),
    readCounts: true,
  });
  const result = { receiver: 0, differing: 0, deepest: 0 };
  counts.forEach((count, pixel) => {
    const point = groundPoint(viewRay(pixel, view.camera), false);
    if (!point) return;
    const expected = casters.filter((ball) => hides(ball, point, view)).length;
    result.receiver += 1;
    result.deepest = Math.max(result.deepest, expected);
    if (count !== expected) result.differing += 1;
  });
  return result;
}

/** Whether a ball stands between a point and the light. */
function hides({ place, radius }: LabPuff, point: Vector3, view: View): boolean {
  const towards = towardsLightOf(view, point);
  const offset = new Vector3(...place).sub(point);
  const along = offset.dot(towards);
  return along > 0 && offset.addScaledVector(towards, -along).length() <= radius;
}

/** Pixels of a ground under puffs by the colour that their count asks for, and those that have another. */
export function steps(shadowDepth: number): {
  lit: number;
  shadow: number;
  deep: number;
  wrong: number;
  foreign: string[];
} {
  const view = VIEWS.ordinary();
  const deepShadow: Color = [120, 96, 200];
  const style = { shadowSteps: 2, shadowDepth, deepShadow } as const;
  const scene = { width: WIDTH, height: HEIGHT, camera: view.camera, ...lightOf(view), style };
  const surfaces = [ground(GROUND_Y, GROUND_HALF)];
  const { counts, pixels } = takePicture({ ...scene, puffs: [], casters: cluster(45), surfaces, readCounts: true });
  const ramp = rampOf(surfaces[0].color, surfaceToning(PLAIN_STYLE));
  const shadow = ramp.unlit[0].color;
  const tones = { lit: ramp.lit[1].color, shadow, deep: multiply(shadow, deepShadow) };
  const result = { lit: 0, shadow: 0, deep: 0, wrong: 0, foreign: foreignColors(scene, shadowDepth) };
  counts.forEach((count, pixel) => {
    if (pixels[4 * pixel + 3] === 0) return;
    const step = count === 0 ? 'lit' : count < shadowDepth ? 'shadow' : 'deep';
    result[step] += 1;
    if (tones[step].join() !== pixels.slice(4 * pixel, 4 * pixel + 3).join()) result.wrong += 1;
  });
  return result;
}

/** Colours of puffs that shade each other which are neither a tone, nor a step of shadow, nor the ink, nor the page. */
function foreignColors(scene: Omit<LabScene, 'puffs'>, shadowDepth: number): string[] {
  const { lit, unlit } = rampOf(PLAIN_STYLE.smokeColor, PLAIN_STYLE);
  const deep = multiply(unlit[0].color, scene.style!.deepShadow!);
  const known = [...lit.map(({ color }) => color), deep, PLAIN_STYLE.inkColor].map((color) => `${color.join()},255`);
  const { pixels } = takePicture({ ...scene, puffs: cluster(45), style: { ...scene.style, shadowDepth } });
  const found = new Set<string>(['0,0,0,0']);
  for (let at = 0; at < pixels.length; at += 4) found.add(pixels.slice(at, at + 4).join());
  return [...found].filter((color) => color !== '0,0,0,0' && !known.includes(color));
}
