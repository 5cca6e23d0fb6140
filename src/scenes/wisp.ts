import { sin } from '../simulator/exact/sine.ts';
import { TEA_LEVEL, TEA_RADIUS, teacup } from './models/teacup.ts';
import type { Scene } from './scene.ts';

/** Steam from a smiling cup of tea. The smallest scene: without rigids, for widgets. */
export function wisp(): Scene {
  return {
    name: 'wisp',
    rig: RIG,
    rigids: [],
    rigidNames: [],
    surfaces: teacup(),
    camera: { target: [0.06, 1.5, 0], azimuth: 0.12, elevation: 0.26, distance: 6.4, fieldOfView: 0.58 },
    portrait: { distance: 7.2, target: [0.05, 1.2, 0], minWidth: 0.42 },
    cameraMove: (seconds) => ({ azimuth: 0.22 * sin(seconds / 6), elevation: 0.04 * sin(seconds / 4.1) }),
    backdrop: { top: [92, 148, 162], bottom: [246, 214, 176] },
  };
}

/** Warm steam leaves the whole surface of the tea slowly and swirls as it rises. */
const RIG: Readonly<Record<string, number>> = {
  'emitters.0.shape': 1,
  'emitters.0.position.y': TEA_LEVEL + 0.05,
  'emitters.0.direction.y': 1,
  'emitters.0.radius': TEA_RADIUS * 0.5,
  'emitters.0.speed': 0.2,
  'emitters.0.speedVariation': 0.3,
  'emitters.0.spread': 0.3,
  'emitters.0.size': 0.34,
  'emitters.0.sizeVariation': 0.3,
  'emitters.0.lifetimeVariation': 0.25,
  'emitters.0.temperature': 1,
  'emitters.0.share': 1,
  'buoyancy.acceleration': 0.9,
  'buoyancy.coolingTime': 4,
  'drag.rate': 1.5,
};
