import { ballMesh } from './models/ball.ts';
import { tableMesh } from './models/table.ts';
import type { Scene } from './scene.ts';

const BALL_RADIUS = 0.26;
const BALL_START = [1.55, 0.9, 0.55] as const;
const TABLE_RADIUS = 2.6;
const SPOUT = { position: [0.95, 0.62, 0], direction: [0.35, 0.94, 0], radius: 0.05 } as const;

/** The paper's Fig. 1: a magic oil lamp whose smoke rises, curls and drifts away, and a ball to stir it with. */
export function lamp(): Scene {
  return {
    name: 'lamp',
    rig: rig(),
    rigids: [
      { kind: 'kinematic', shape: { type: 'ball', radius: BALL_RADIUS }, position: BALL_START, friction: 0.2 },
      { kind: 'fixed', shape: { type: 'cylinder', halfHeight: 0.05, radius: TABLE_RADIUS }, position: [0, -0.05, 0], friction: 0.3 },
    ],
    surfaces: [
      { name: 'ball', mesh: ballMesh(BALL_RADIUS), color: [226, 72, 61], casts: true, inked: true, rigid: 0 },
      { name: 'table', mesh: tableMesh(TABLE_RADIUS, 0.1), color: [233, 178, 108], casts: false, inked: true },
    ],
    handle: { rigid: 0, radius: BALL_RADIUS, start: BALL_START, min: [-2, BALL_RADIUS, -2], max: [2.4, 3.2, 2] },
    camera: { target: [0.35, 1.25, 0], azimuth: 0.18, elevation: 0.2, distance: 6.2, fieldOfView: 0.62 },
    backdrop: { top: [38, 70, 110], bottom: [246, 190, 140] },
  };
}

function rig(): Record<string, number> {
  return {
    'emitters.0.shape': 1,
    ...vector('emitters.0.position', SPOUT.position),
    ...vector('emitters.0.direction', SPOUT.direction),
    'emitters.0.radius': SPOUT.radius,
    'emitters.0.speed': 0.9,
    'emitters.0.speedVariation': 0.25,
    'emitters.0.spread': 0.22,
    'emitters.0.size': 0.3,
    'emitters.0.sizeVariation': 0.35,
    'emitters.0.lifetimeVariation': 0.25,
    'emitters.0.temperature': 1,
    'emitters.0.share': 1,
    'gravity.acceleration': 0.35,
    'buoyancy.acceleration': 1.9,
    'buoyancy.coolingTime': 3.5,
    'drag.rate': 1.6,
  };
}

function vector(key: string, [x, y, z]: readonly [number, number, number]): Record<string, number> {
  return { [`${key}.x`]: x, [`${key}.y`]: y, [`${key}.z`]: z };
}
