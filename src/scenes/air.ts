import { emitterRig } from './emitterRig.ts';
import type { Scene } from './scene.ts';

/** As many as the simulator supports. Pages with smoke choose which of them emit, and where. */
const EMITTERS = 8;

/** A scene with only smoke, seen from the front, for pages whose elements act as the obstacles. */
export function air(): Scene {
  return {
    name: 'air',
    rig: RIG,
    rigids: [],
    rigidNames: [],
    surfaces: [],
    camera: {
      target: [0, 0, 0],
      azimuth: 0,
      elevation: 0,
      distance: 12,
      fieldOfView: 0.3,
      minWidth: 0.01,
      pixelsPerMetre: 150,
    },
    backdrop: { top: [154, 196, 214], bottom: [246, 226, 198] },
  };
}

/** All emitters are identical. Only the first one emits until another gets a share. */
const RIG: Readonly<Record<string, number>> = {
  ...Object.assign({}, ...Array.from({ length: EMITTERS }, (_, index) => emitter(index))),
  'buoyancy.acceleration': 0.9,
  'buoyancy.coolingTime': 4,
  'drag.rate': 1.5,
};

function emitter(index: number): Record<string, number> {
  const own = {
    shape: 1,
    'position.y': -1.4,
    'direction.y': 1,
    radius: 0.12,
    speed: 0.3,
    speedVariation: 0.3,
    spread: 0.35,
    size: 0.26,
    sizeVariation: 0.35,
    lifetimeVariation: 0.25,
    temperature: 1,
    share: index === 0 ? 1 : 0,
  };
  return emitterRig(index, own);
}
