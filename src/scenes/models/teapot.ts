/** A teapot, about 2 m from handle to spout, on a round tray. It stands on y = 0 with its spout towards +x. */
import type { SurfaceDescription } from '../../renderer/passes/surface.ts';
import { ballMesh } from './ball.ts';
import { lathe, pipe } from './lathe.ts';
import { placed } from './place.ts';

/** The opening of the spout, metres. */
export const MOUTH = { x: 1.1, y: 0.94, radius: 0.06 };

const GLAZE = [92, 152, 178] as const;
const TRIM = [246, 222, 178] as const;

const BODY = lathe(
  56,
  [[0, 0], [0.36, 0]],
  [[0.36, 0], [0.38, 0.04], [0.58, 0.2], [0.67, 0.42], [0.58, 0.68], [0.37, 0.84]],
  [[0.37, 0.84], [0, 0.84]],
); // prettier-ignore
const BAND = lathe(
  56,
  [[0, 0.395], [0.672, 0.395]],
  [[0.672, 0.395], [0.69, 0.435], [0.672, 0.475]],
  [[0.672, 0.475], [0, 0.475]],
); // prettier-ignore
const LID = lathe(
  48,
  [[0, 0.82], [0.39, 0.82]],
  [[0.39, 0.82], [0.41, 0.86], [0.3, 0.94], [0.08, 1]],
  [[0.08, 1], [0, 1]],
); // prettier-ignore
const SPOUT = pipe(
  24,
  [[0.5, 0.24], [0.76, 0.34], [0.86, 0.62], [MOUTH.x, MOUTH.y]],
  [[0, 0], [0.19, 0]],
  [[0.19, 0], [0.15, 0.25], [0.1, 0.6], [0.085, 1]],
  [[0.085, 1], [MOUTH.radius, 0.97]],
  [[MOUTH.radius, 0.97], [0.05, 0.86]],
  [[0.05, 0.86], [0, 0.86]],
); // prettier-ignore
const HANDLE = pipe(
  16,
  [[-0.5, 0.7], [-0.82, 0.8], [-1.04, 0.62], [-0.94, 0.36], [-0.56, 0.24]],
  [[0, 0], [0.065, 0]],
  [[0.065, 0], [0.055, 0.5], [0.065, 1]],
  [[0.065, 1], [0, 1]],
); // prettier-ignore
const TRAY = lathe(
  72,
  [[0, -0.14], [1.5, -0.14]],
  [[1.5, -0.14], [1.62, -0.06], [1.6, 0.02], [1.54, 0]],
  [[1.54, 0], [0, 0]],
); // prettier-ignore

/** The surfaces of the teapot and its tray. Each mesh is closed. */
export function teapotSurfaces(): SurfaceDescription[] {
  const look = { casts: true, inked: true };
  return [
    { name: 'body', mesh: BODY, color: GLAZE, group: 'pot', ...look },
    { name: 'spout', mesh: SPOUT, color: GLAZE, group: 'pot', ...look },
    { name: 'handle', mesh: HANDLE, color: GLAZE, group: 'pot', ...look },
    { name: 'band', mesh: BAND, color: TRIM, ...look },
    { name: 'lid', mesh: LID, color: GLAZE, ...look },
    { name: 'knob', mesh: placed(ballMesh(0.085, 16), { at: [0, 1.06, 0] }), color: TRIM, ...look },
    { name: 'tray', mesh: TRAY, color: [188, 104, 92], casts: false, inked: true },
  ];
}
