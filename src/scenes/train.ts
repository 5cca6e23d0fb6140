import { cos, sin } from '../simulator/exact/sine.ts';
import { every, strideWithin } from './models/revolve.ts';
import { island, trees } from './models/island.ts';
import { AXLES, CHIMNEY, CRANK, CYLINDER, locomotive, locomotiveHull, WHEEL_RADIUS } from './models/locomotive.ts';
import { merged, placed, placement } from './models/place.ts';
import { roundedBox } from './models/roundedBox.ts';
import { wagon } from './models/wagons.ts';
import type { MovingPart, Placement, Scene } from './scene.ts';
import type { TriangleMesh } from '../renderer/passes/extrusion.ts';

const LOCOMOTIVE = 0;
/** Radius of the circular track, and height of the rails; metres. */
const TRACK = 2.35;
const RAIL = 0.13;
/** m/s. */
export const SPEED = 1.3;
/** The cylinder exhausts steam at both ends of the piston stroke. */
const CHUFFS_A_REVOLUTION = 2;
/** Seconds between puffs. */
export const CHUFF = (2 * Math.PI * WHEEL_RADIUS) / SPEED / CHUFFS_A_REVOLUTION;

/** Indices of the parts. */
const [FIRST_AXLE, RIGHT_ROD, LEFT_ROD, TENDER, YELLOW, BLUE] = [0, 3, 4, 5, 6, 7];

/** A toy train on a circular track. Its puffs are synchronized with its wheels. */
export function train(): Scene {
  return {
    name: 'train',
    rig: RIG,
    rigids: [{ kind: 'kinematic', shape: locomotiveHull(), ...onTrack(0, 0), friction: 0.2 }],
    rigidNames: ['Locomotive'],
    guide: ({ seconds }) => [{ rigid: LOCOMOTIVE, ...onTrack(seconds, 0) }],
    surfaces: [
      ...island(3.1, [150, 196, 104], [176, 120, 92]),
      ...track(),
      ...trees(TREES, [92, 160, 96], [150, 104, 80]),
      ...locomotive(LOCOMOTIVE, { axles: [0, 1, 2].map((index) => FIRST_AXLE + index), rods: [RIGHT_ROD, LEFT_ROD] }),
      ...wagon(TENDER, [58, 150, 124], { color: [72, 62, 78], heaps: COAL }),
      ...wagon(YELLOW, [246, 192, 84], { color: [232, 108, 76], heaps: FRUIT }),
      ...wagon(BLUE, [92, 152, 204], { color: [236, 140, 160], heaps: SWEETS }),
    ],
    parts: PARTS,
    ground: [
      { shape: { type: 'cylinder', halfHeight: 0.3, radius: 3.05 }, position: [0, -0.3, 0] },
      ...TREES.map(([x, z, height]) => ({
        shape: { type: 'ball', radius: 0.33 * height } as const,
        position: [x, 0.6 * height, z] as const,
      })),
    ],
    camera: { target: [0, 0.95, 0], azimuth: 0.12, elevation: 0.36, distance: 10, fieldOfView: 0.58 },
    portrait: { target: [0, 0.95, 0], elevation: 0.5, distance: 12.5, minWidth: 0.5 },
    cameraMove: (seconds) => ({ azimuth: 0.4 * sin(seconds / 9), elevation: 0.05 * sin(seconds / 5) }),
    backdrop: { top: [104, 184, 206], bottom: [252, 226, 188] },
  };
}

/** Pose on the track at a time, this many metres behind the locomotive. */
function onTrack(seconds: number, behind: number): Placement {
  const angle = Math.PI * 0.98 - (SPEED * seconds - behind) / TRACK;
  return placement([TRACK * cos(angle), RAIL, TRACK * sin(angle)], [0, Math.PI / 2 - angle, 0]);
}

/** Rotation of the driving wheels, radians. Forwards is negative, because the axle axis points to the right. */
function wheelAngle(seconds: number): number {
  return (-SPEED * seconds) / WHEEL_RADIUS;
}

function axle(index: number, name: string): MovingPart {
  const radius = index < 2 ? WHEEL_RADIUS : WHEEL_RADIUS * 0.62;
  return {
    name,
    rigid: LOCOMOTIVE,
    pose: (seconds) => placement([AXLES[index], radius, 0], [0, 0, (wheelAngle(seconds) * WHEEL_RADIUS) / radius]),
  };
}

/** A rod stays horizontal while the cranks turn. The left side leads by a quarter turn, to avoid a dead point. */
function rod(lead: number, name: string): MovingPart {
  const place = (angle: number) => placement([CRANK * cos(angle), CRANK * sin(angle), 0]);
  return { name, rigid: LOCOMOTIVE, pose: (seconds) => place(wheelAngle(seconds) + lead) };
}

const PARTS: readonly MovingPart[] = [
  axle(0, 'Rear wheels'),
  axle(1, 'Middle wheels'),
  axle(2, 'Front wheels'),
  rod(0, 'Right rod'),
  rod(-Math.PI / 2, 'Left rod'),
  { name: 'Tender', pose: (seconds) => onTrack(seconds, 1.26) },
  { name: 'Yellow wagon', pose: (seconds) => onTrack(seconds, 2.18) },
  { name: 'Blue wagon', pose: (seconds) => onTrack(seconds, 3.1) },
];

const COAL = [[0.16, 0.64, 0.1, 0.12], [-0.1, 0.66, -0.08, 0.15], [0.1, 0.62, -0.13, 0.11], [-0.18, 0.62, 0.12, 0.12], [0, 0.68, 0.06, 0.12]] as const; // prettier-ignore
const FRUIT = [[0.2, 0.68, 0.1, 0.13], [0.18, 0.68, -0.13, 0.12], [-0.04, 0.7, 0, 0.15], [-0.22, 0.67, 0.13, 0.12], [-0.22, 0.68, -0.11, 0.13], [0.06, 0.84, 0.02, 0.11]] as const; // prettier-ignore
const SWEETS = [[0.2, 0.66, 0.08, 0.13], [0.16, 0.66, -0.14, 0.12], [-0.06, 0.67, 0.1, 0.14], [-0.1, 0.66, -0.12, 0.13], [-0.26, 0.64, 0.02, 0.11], [0.05, 0.8, -0.02, 0.13]] as const; // prettier-ignore
const TREES = [[-0.55, -0.5, 1.15], [0.35, -0.85, 0.95], [0.95, -0.2, 0.75], [-1.15, 0.25, 0.8], [-0.3, -1.25, 0.8]] as const; // prettier-ignore

/** A bed of gravel, sleepers, and two rails. */
function track(): Scene['surfaces'] {
  const sleepers = Array.from({ length: 44 }, (_, index) => {
    const angle = (2 * Math.PI * index) / 44;
    return placed(roundedBox([0.055, 0.03, 0.3], 0.02, 3), {
      at: [TRACK * cos(angle), 0.07, TRACK * sin(angle)],
      angles: [0, Math.PI / 2 - angle, 0],
    });
  });
  const rail = (radius: number) => ringMesh(radius - 0.022, radius + 0.022, 0.06, RAIL);
  return [
    {
      name: 'gravel',
      mesh: ringMesh(TRACK - 0.4, TRACK + 0.4, -0.05, 0.045),
      color: [226, 204, 164],
      casts: false,
      inked: true,
    },
    { name: 'sleepers', mesh: merged(...sleepers), color: [160, 108, 84], casts: false, inked: true },
    {
      name: 'rails',
      mesh: merged(rail(TRACK - 0.2), rail(TRACK + 0.2)),
      color: [150, 150, 172],
      casts: false,
      inked: true,
    },
  ];
}

const RIG: Readonly<Record<string, number>> = {
  'emitters.0.shape': 1,
  'emitters.0.rigid': LOCOMOTIVE,
  'emitters.0.position.x': CHIMNEY[0],
  'emitters.0.position.y': CHIMNEY[1],
  'emitters.0.direction.y': 1,
  'emitters.0.radius': 0.05,
  'emitters.0.speed': 1.4,
  'emitters.0.speedVariation': 0.25,
  'emitters.0.spread': 0.2,
  'emitters.0.inherit': 0.3,
  'emitters.0.size': 0.36,
  'emitters.0.sizeVariation': 0.3,
  'emitters.0.lifetimeVariation': 0.2,
  'emitters.0.share': 4,
  'emitters.0.envelope.duration': 0.34 * CHUFF,
  'emitters.0.envelope.period': CHUFF,
  // Some steam near the ground, to both sides.
  'emitters.1.shape': 7,
  'emitters.1.rigid': LOCOMOTIVE,
  'emitters.1.position.x': CYLINDER[0],
  'emitters.1.position.y': CYLINDER[1],
  'emitters.1.extent.x': 0,
  'emitters.1.extent.y': 0,
  'emitters.1.extent.z': 0.42,
  'emitters.1.direction.x': 1,
  'emitters.1.direction.y': 0,
  'emitters.1.speed': 0.5,
  'emitters.1.spread': 0.7,
  'emitters.1.size': 0.14,
  'emitters.1.lifetime': 0.18,
  'emitters.1.temperature': 0.3,
  'emitters.1.share': 1,
  'emitters.1.envelope.duration': 0.25 * CHUFF,
  'emitters.1.envelope.period': CHUFF,
  'buoyancy.acceleration': 0.55,
  'buoyancy.coolingTime': 3,
  'drag.rate': 1.7,
};

/**
 * A closed ring with a square section about the vertical axis, with sharp edges.
 * @param inner, outer radii in metres; `bottom` and `top` are heights in metres
 */
function ringMesh(inner: number, outer: number, bottom: number, top: number, segments = 96): TriangleMesh {
  const positions: number[] = [];
  const normals: number[] = [];
  const firsts: number[] = [];
  const band = (from: readonly [number, number], to: readonly [number, number], out: number, up: number) => {
    firsts.push(positions.length / 3);
    for (let segment = 0; segment < segments; segment++) {
      const angle = (2 * Math.PI * segment) / segments;
      const [x, z] = [cos(angle), sin(angle)];
      for (const [radius, height] of [from, to]) positions.push(radius * x, height, radius * z);
      for (let end = 0; end < 2; end++) normals.push(out * x, up, out * z);
    }
  };
  band([outer, bottom], [outer, top], 1, 0);
  band([outer, top], [inner, top], 0, 1);
  band([inner, top], [inner, bottom], -1, 0);
  band([inner, bottom], [outer, bottom], 0, -1);
  const triangles = (stride: number): Uint32Array => {
    const columns = every(stride, segments);
    const indices = firsts.flatMap((first) =>
      columns.slice(1).flatMap((end, index) => {
        const [here, next] = [first + 2 * columns[index], first + 2 * (end % segments)];
        return [here, here + 1, next + 1, here, next + 1, next];
      }),
    );
    return Uint32Array.from(indices);
  };
  return {
    positions: Float32Array.from(positions),
    normals: Float32Array.from(normals),
    indices: triangles(1),
    coarser: (deviation) => triangles(strideWithin(deviation, outer, segments)),
  };
}
