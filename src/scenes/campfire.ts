import { sin } from '../simulator/exact/sine.ts';
import { camp } from './models/camp.ts';
import { island, trees } from './models/island.ts';
import type { Scene } from './scene.ts';

/** A campfire at night: fire that cools to smoke as it rises, and a marshmallow. */
export function campfire(): Scene {
  return {
    name: 'campfire',
    rig: RIG,
    rigids: [],
    rigidNames: [],
    surfaces: [
      ...island(2.5, [104, 150, 108], [134, 96, 98]),
      ...trees(PINES, [70, 128, 112], [124, 84, 84]),
      ...camp(),
    ],
    camera: { target: [0, 1.25, 0], azimuth: 0.25, elevation: 0.26, distance: 8.4, fieldOfView: 0.56 },
    portrait: { target: [0, 1.75, 0], elevation: 0.3, distance: 9.4, minWidth: 0.5 },
    cameraMove: (seconds) => ({ azimuth: 0.3 * sin(seconds / 7), elevation: 0.04 * sin(seconds / 4.6) }),
    backdrop: { top: [32, 34, 82], bottom: [142, 88, 128] },
  };
}

const PINES = [[-0.2, -2, 1.5], [0.75, -1.75, 1.1], [1.65, -1.2, 1.35], [-2.05, 0.1, 0.9]] as const; // prettier-ignore

/** Flames from the logs, and sparks that stay hot longer. */
const RIG: Readonly<Record<string, number>> = {
  'emitters.0.shape': 1,
  'emitters.0.position.y': 0.22,
  'emitters.0.direction.y': 1,
  'emitters.0.radius': 0.3,
  'emitters.0.speed': 0.7,
  'emitters.0.speedVariation': 0.35,
  'emitters.0.spread': 0.12,
  'emitters.0.size': 0.34,
  'emitters.0.sizeVariation': 0.35,
  'emitters.0.lifetimeVariation': 0.2,
  'emitters.0.temperature': 1,
  'emitters.0.share': 1,
  'emitters.1.shape': 1,
  'emitters.1.position.y': 0.4,
  'emitters.1.direction.y': 1,
  'emitters.1.radius': 0.2,
  'emitters.1.speed': 1.6,
  'emitters.1.speedVariation': 0.5,
  'emitters.1.spread': 0.45,
  'emitters.1.size': 0.05,
  'emitters.1.sizeVariation': 0.4,
  'emitters.1.lifetime': 0.32,
  'emitters.1.lifetimeVariation': 0.5,
  'emitters.1.temperature': 3,
  'emitters.1.share': 0.14,
  // The fire draws in air from all sides.
  'attractors.0.acceleration': 2,
  'attractors.0.position.y': 0.8,
  'attractors.0.coreRadius': 0.5,
  'attractors.0.reach': 1.1,
  'vortices.0.circulation': -1.8,
  'vortices.0.coreRadius': 0.5,
  'vortices.0.reach': 1.8,
  'vortices.0.position.x': -0.3,
  'vortices.0.position.y': 2.7,
  'winds.0.velocity.y': 0.4,
  'buoyancy.acceleration': 1.7,
  'buoyancy.coolingTime': 0.85,
  'drag.rate': 1.5,
};
