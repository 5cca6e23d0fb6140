import { emitterRig } from './emitterRig.ts';
import { MOUTH, teapotSurfaces } from './models/teapot.ts';
import type { Scene } from './scene.ts';

/** A teapot whose steam writes a word, which the presets have as a shape. */
export function teapot(): Scene {
  return {
    name: 'teapot',
    rig: RIG,
    rigids: [],
    rigidNames: [],
    surfaces: teapotSurfaces(),
    camera: { target: [0.1, 1.36, 0], azimuth: 0.12, elevation: 0.12, distance: 6.9, fieldOfView: 0.52 },
    portrait: { minWidth: 0.56 },
    backdrop: { top: [58, 50, 92], bottom: [222, 140, 110] },
  };
}

/** Steam leaves the spout. */
const RIG: Readonly<Record<string, number>> = {
  ...emitterRig(0, {
    shape: 1,
    'position.x': MOUTH.x,
    'position.y': MOUTH.y,
    'direction.x': 0.5,
    'direction.y': 0.8,
    radius: MOUTH.radius,
    speed: 1.1,
    speedVariation: 0.3,
    spread: 0.2,
    size: 0.13,
    sizeVariation: 0.3,
    lifetimeVariation: 0.06,
    temperature: 1,
  }),
  'buoyancy.acceleration': 0.9,
  'buoyancy.coolingTime': 2,
  'drag.rate': 1.8,
};
