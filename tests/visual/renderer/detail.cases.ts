/** Models with coarser triangles in small pictures. */
import { coarserSurfaces, deviationFor } from '../../../src/renderer/sceneSurfaces.ts';
import type { LabPicture } from '../lab.ts';
import { SceneLab } from '../sceneLab.ts';
import { SMALL } from '../stage/stage.cases.ts';
import { createStage } from '../../../src/stage/stage.ts';

const SIZE = { width: 160, height: 96, smoothEdges: true, ownLook: true } as const;
const STEPS = 120;

interface Detail {
  /** Triangles of the finest models, and of the coarser ones. */
  triangles: readonly [finest: number, coarser: number];
  /** Pixels that differ by more than 2 of 255, and their number in total. */
  changed: number;
  pixels: number;
  /** Pixels in which the finest picture differs after coarser ones. */
  after: number;
  /** Pixels in which the coarser picture differs from one of a scene that has those triangles only. */
  other: number;
}

/** Pictures of a scene with its finest and with coarser triangles, in a small picture. */
export async function pictures(preset: string): Promise<Detail> {
  const lab = await SceneLab.create(preset, SIZE);
  const deviation = deviationFor(1 / lab.pixelsPerMetre(lab.scene.camera.distance));
  const surfaces = (own: SceneLab['scene']['surfaces']) => coarserSurfaces(own, deviation);
  const only = await SceneLab.create(preset, { ...SIZE, surfaces });
  for (const each of [lab, only]) each.step(STEPS);
  const finest = lab.draw();
  const { triangles: most } = lab.drawn();
  const coarser = lab.draw({ deviation });
  const { triangles: least } = lab.drawn();
  const report = {
    triangles: [most, least],
    changed: differing(finest, coarser, 2),
    pixels: finest.width * finest.height,
    after: differing(finest, lab.draw(), 0),
    other: differing(coarser, only.draw(), 0),
  } as const;
  for (const each of [lab, only]) each.dispose();
  return report;
}

/** Deviation of the models in square pictures of a stage, metres, by their height. */
export async function deviations(heights: readonly number[]): Promise<number[]> {
  const stage = await createStage(new OffscreenCanvas(16, 16), { values: SMALL });
  let latest = NaN;
  stage.running.picture.smoke.overrideFrame((input) => {
    latest = input.deviation!;
    return input;
  });
  const found = heights.map((height) => {
    stage.resize(height, height, 1);
    return latest;
  });
  stage.dispose();
  return found;
}

function differing(one: LabPicture, other: LabPicture, tolerance: number): number {
  let count = 0;
  for (let at = 0; at < one.pixels.length; at += 4) {
    const channels = [0, 1, 2].map((channel) => Math.abs(one.pixels[at + channel] - other.pixels[at + channel]));
    if (Math.max(...channels) > tolerance) count++;
  }
  return count;
}
