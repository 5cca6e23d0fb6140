import { finished, inPieces, type Work } from '../base/work.ts';
import type { SurfaceDescription } from '../renderer/passes/surface.ts';
import { atan2 } from '../simulator/exact/arc.ts';
import { cos, sin } from '../simulator/exact/sine.ts';
import { emitterRig } from './emitterRig.ts';
import { AXLE, hills, sheep, sun, windmill } from './models/meadow.ts';
import { placement, merged, placed } from './models/place.ts';
import type { LightMove, Scene, Vector } from './scene.ts';
import type { TriangleMesh } from '../renderer/passes/extrusion.ts';
import { ballMesh } from './models/ball.ts';

/** Wind speed, m/s; negative blows to the left. */
export const WIND = -0.42;
/** Distance between each cloud and its copy, metres. The initial clouds fill one such interval. */
const WIDTH = 12.6;
const CLOUDS: readonly Cumulus[] = [
  [-4.4, 2.5, -1.6, 1.35],
  [-0.5, 1.5, 0.2, 1.1],
  [2.6, 3, -1.2, 1.05],
  [5.4, 1.3, -2.2, 1.6],
];
/** The light at noon, degrees; the presets start with it. */
export const NOON = { azimuth: 0, elevation: 62 } as const;
/** Duration of a day, seconds, and the azimuth range of the sun on each side of noon, degrees. */
const DAY = 90;
const SWING = 64;
/** How much lower the sun is at both ends, degrees. */
const SINK = 24;
const CENTRE: Vector = [0, 1.2, 0];
/** Position range of the drawn sun: to the sides, above the centre, and behind the clouds; metres. */
const SKY: Vector = [5.6, 2.75, -3];
const [SAILS, RAYS, FACE] = [0, 1, 2];

/** Clouds drift over a meadow while the sun moves from one side to the other and back. */
export const cloudscape = (): Scene => finished(building());

/** Like {@link cloudscape}, but keeps the page responsive: most visits to it begin here. */
export const buildCloudscape = (): Promise<Scene> => inPieces(building());

function* building(): Work<Scene> {
  const emissionSurfaces = [cumuli(CLOUDS)];
  yield;
  emissionSurfaces.push(cumuli(CLOUDS.map(([x, ...rest]) => [x + WIDTH, ...rest] as const)));
  const surfaces: SurfaceDescription[] = [];
  for (const build of [hills, () => windmill(SAILS), () => sheep(FLOCK), () => sun(RAYS, FACE)]) {
    yield;
    surfaces.push(...build());
  }
  return {
    name: 'cloudscape',
    rig: RIG,
    rigids: [],
    rigidNames: [],
    emissionSurfaces,
    surfaces,
    parts: [
      { name: 'Windmill sails', pose: (seconds) => placement(AXLE, [0, 0, 0.9 * WIND * seconds]) },
      { name: 'Sun rays', pose: (seconds) => placement(sunPlace(seconds), [0, 0, sunAngle(seconds)]) },
      { name: 'Sun face', pose: (seconds) => placement(sunPlace(seconds), [0, 0, 0.1 * sin(seconds)]) },
    ],
    camera: { target: [0, 1.15, 0], azimuth: 0, elevation: 0.06, distance: 9.6, fieldOfView: 0.58 },
    portrait: { target: [-0.7, 0.75, 0], distance: 11, minWidth: 0.44 },
    cameraMove: (seconds) => ({ azimuth: 0.06 * sin(seconds / 8), elevation: 0.02 * sin(seconds / 5) }),
    lightMove,
    lightCentre: CENTRE,
    backdrop: { top: [86, 158, 216], bottom: [250, 226, 206] },
  };
}

/** The sun moves from the left in the morning to the right and back, lowest at both ends. */
export const lightMove: LightMove = (seconds) => {
  const way = -cos((2 * Math.PI * (seconds + 6)) / DAY);
  return { azimuth: SWING * way, elevation: -SINK * way * way };
};

/** Position of the drawn sun: on the side of the light, at its elevation. */
export function sunPlace(seconds: number): Vector {
  const { azimuth, elevation } = lightMove(seconds);
  const [aside, height] = [NOON.azimuth + azimuth, NOON.elevation + elevation].map((angle) => (Math.PI * angle) / 180);
  return [CENTRE[0] + SKY[0] * sin(aside) * cos(height), CENTRE[1] + SKY[1] * sin(height), CENTRE[2] + SKY[2]];
}

/** Rotation of the rays: their bright side faces the light. */
function sunAngle(seconds: number): number {
  const [x, y] = sunPlace(seconds);
  return atan2(y - CENTRE[1], x - CENTRE[0]);
}

const FLOCK = [
  [[-0.5, -0.95, 1.3], 1],
  [[0.35, -0.98, 0.7], -1],
  [[1.5, -1.05, 1.5], -1],
] as const;

/** Large and small puffs on the cloud surfaces: a burst at the start, then the clouds that follow. */
const RIG: Readonly<Record<string, number>> = {
  'winds.0.velocity.x': WIND,
  'buoyancy.acceleration': 0,
  'gravity.acceleration': 0,
  'drag.rate': 3,
  ...clouds(0, 0, { size: 0.66, count: 84 }),
  ...clouds(1, 0, { size: 0.42, count: 76 }),
  ...clouds(2, 1, { size: 0.66, count: 84 }),
  ...clouds(3, 1, { size: 0.42, count: 76 }),
};

function clouds(
  emitter: number,
  surface: number,
  { size, count }: { size: number; count: number },
): Record<string, number> {
  const values = {
    shape: 8,
    surface,
    speed: 0,
    size,
    sizeVariation: 0.35,
    temperature: 0,
    share: 0,
    lifetimeVariation: 0.08,
    'burst.count': count,
    ...(surface > 0 && { 'envelope.period': WIDTH / -WIND }),
  };
  return emitterRig(emitter, values);
}

/** Centre of a cloud's flat base, and half its width; metres. */
type Cumulus = readonly [x: number, y: number, z: number, half: number];

/** Spheres of a cloud with half width 1: centre offsets from the base, and radius. */
const HEAPS = [
  [0, 0.3, 0, 0.52],
  [-0.42, 0.14, 0.06, 0.36],
  [0.46, 0.16, -0.04, 0.38],
  [-0.76, 0.04, -0.05, 0.22],
  [0.8, 0.05, 0.05, 0.22],
  [0.16, 0.56, 0.04, 0.32],
] as const;
/** Fraction of its height that a sphere keeps below its centre. */
const FLATNESS = 0.22;

/** Surfaces that emit the clouds: rounded above, flat below. Every second cloud is mirrored. */
function cumuli(all: readonly Cumulus[]): Pick<TriangleMesh, 'positions' | 'indices'> {
  const { positions, indices } = merged(
    ...all.flatMap(([x, y, z, half], index) =>
      HEAPS.map(([aside, up, ahead, radius]) => {
        const mirrored = index % 2 === 0 ? aside : -aside;
        return placed(flattened(radius * half), { at: [x + mirrored * half, y + up * half, z + ahead * half] });
      }),
    ),
  );
  return { positions, indices };
}

function flattened(radius: number): TriangleMesh {
  const ball = ballMesh(radius, 8);
  return { ...ball, positions: ball.positions.map((at, i) => (i % 3 === 1 && at < 0 ? FLATNESS * at : at)) };
}
