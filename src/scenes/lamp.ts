import type { Color } from '../renderer/gpu/ramps.ts';
import type { SurfaceDescription } from '../renderer/passes/surface.ts';
import { cos } from '../simulator/exact/sine.ts';
import type { RigidDescription } from '../simulator/rigid.ts';
import { ballMesh } from './models/ball.ts';
import { lampModel, type LampModel, type LampRole } from './models/lamp.ts';
import { tableMesh } from './models/table.ts';
import type { CameraShift, Scene } from './scene.ts';

const BALL = 0;
const BALL_RADIUS = 0.26;
const BALL_START = [1.5, 1.75, 0.1] as const;
const TABLE_RADIUS = 1.75;
const TABLE_THICKNESS = 0.12;

const LAMP_COLORS: Record<LampRole, Color> = {
  metal: [246, 196, 74],
  fitting: [214, 136, 52],
  gem: [219, 64, 92],
};

/** Parts that merge into another part without an ink line between them. */
const GROWS_FROM: Record<string, string> = { curl: 'handle', spout: 'belly' };

/** The paper's Fig. 1: a magic oil lamp whose smoke rises, curls and drifts away, and a ball to stir it with. */
export function lamp(): Scene {
  const model = lampModel();
  return {
    name: 'lamp',
    rig: rig(model),
    rigids: rigids(model),
    rigidNames: ['Ball', 'Table', ...model.collision.map((_, part) => `Lamp, part ${part + 1}`)],
    surfaces: surfaces(model),
    handle: {
      rigid: BALL,
      radius: BALL_RADIUS,
      start: BALL_START,
      min: [-2.2, BALL_RADIUS, -1.6],
      max: [2.2, 3.4, 1.6],
    },
    camera: { target: [0.15, 1.5, 0], azimuth: 0.15, elevation: 0.16, distance: 6.3, fieldOfView: 0.58 },
    cameraMove: swing,
    backdrop: { top: [43, 45, 92], bottom: [214, 110, 122] },
  };
}

/** Seconds until the column has formed. The camera does not move before that. */
const STANDS = 7;

function swing(seconds: number): CameraShift {
  const since = Math.max(0, seconds - STANDS);
  return { azimuth: 0.12 * (cos(since / 7) - 1), elevation: 0.025 * (1 - cos(since / 4.5)) };
}

function rigids({ collision }: LampModel): RigidDescription[] {
  const half = TABLE_THICKNESS / 2;
  return [
    { kind: 'kinematic', shape: { type: 'ball', radius: BALL_RADIUS }, position: BALL_START, friction: 0.2 },
    {
      kind: 'fixed',
      shape: { type: 'cylinder', halfHeight: half, radius: TABLE_RADIUS },
      position: [0, -half, 0],
      friction: 0.3,
    },
    ...collision.map((shape): RigidDescription => ({ kind: 'fixed', shape, position: [0, 0, 0], friction: 0.3 })),
  ];
}

function surfaces({ parts }: LampModel): SurfaceDescription[] {
  return [
    { name: 'ball', mesh: ballMesh(BALL_RADIUS), color: [64, 190, 178], casts: true, inked: true, rigid: BALL },
    { name: 'table', mesh: tableMesh(TABLE_RADIUS, TABLE_THICKNESS), color: [178, 92, 96], casts: false, inked: true },
    ...parts.map(({ name, role, mesh }) => ({
      name,
      mesh,
      color: LAMP_COLORS[role],
      casts: true,
      inked: true,
      group: GROWS_FROM[name] ?? name,
    })),
  ];
}

/** The forces of the scene, which the parameters scale. */
function rig({ spout }: LampModel): Record<string, number> {
  return {
    'emitters.0.shape': 1,
    ...vector('emitters.0.position', spout.position),
    ...vector('emitters.0.direction', spout.direction),
    'emitters.0.radius': spout.radius * 0.6,
    'emitters.0.speed': 0.6,
    'emitters.0.speedVariation': 0.25,
    'emitters.0.spread': 0.22,
    'emitters.0.size': 0.5,
    'emitters.0.sizeVariation': 0.35,
    'emitters.0.lifetimeVariation': 0.25,
    'emitters.0.temperature': 1,
    'emitters.0.share': 1,
    'gravity.acceleration': 0.1,
    'buoyancy.acceleration': 0.75,
    'buoyancy.coolingTime': 3,
    'drag.rate': 1.6,
  };
}

function vector(key: string, [x, y, z]: readonly [number, number, number]): Record<string, number> {
  return { [`${key}.x`]: x, [`${key}.y`]: y, [`${key}.z`]: z };
}
