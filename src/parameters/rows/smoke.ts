import type { Keyed, NumberParameter, Parameter } from '../parameter.ts';
import { choice, fixed, ofScene, quantity, simulated, simulatedChoice } from './row.ts';

const SCENES = [
  'lamp',
  'airplane',
  'train',
  'campfire',
  'rocket',
  'genie',
  'dust',
  'cloudscape',
  'wisp',
  'firework',
  'title',
  'dragon',
  'teapot',
  'air',
] as const;

/** Scene and seed. */
export const sceneRows = [
  choice('scene', 'stage', 'lamp', SCENES),
  quantity('seed', 'stage', { kind: 'integer', min: 0, max: 4294967295, default: 1 }),
] as const satisfies readonly Parameter[];

/** Emission rate, lifetime and size of puffs. */
export const smokeRows = [
  simulated('emission.rate'),
  simulated('emission.lifetime'),
  simulated('emission.growthTime'),
  { kind: 'curve', key: 'emission.density', reader: 'simulator', default: '0:1,1:0' },
  { kind: 'curve', key: 'emission.glow', reader: 'style', default: '0:0,1:0' },
  fixed('shaders', simulatedChoice('emission.dissolve')),
  ofScene(simulated('emission.entrainment')),
  simulated('emission.company'),
  simulated('puff.size'),
  simulated('emission.sizeSpread'),
] as const satisfies readonly Parameter[];

/** Shape of the puffs. */
export const puffRows = [
  fixed('puffs', simulated('puff.variations')),
  fixed('puffs', simulated('puff.turn')),
  fixed('puffs', simulated('puff.stretch')),
  fixed('puffs', simulated('puff.billow')),
  fixed('puffs', choice('puff.form', 'style', 'lobes', ['lobes', 'billboards'])),
  { kind: 'drawing', key: 'puff.drawing', reader: 'style', fixed: 'puffs', default: '' },
  quantity('puff.upright', 'style', { min: 0, max: 1, default: 0 }),
  fixed('puffs', choice('puff.views', 'style', 1, [1, 2, 4, 8])),
  fixed('puffs', choice('puff.precision', 'style', 16, [16, 8])),
  fixed('puffs', lobeShape('lumpiness', 0.8)),
  fixed('puffs', lobeShape('flatness', 0.2)),
  fixed('puffs', lobeShape('roughness', 0.6)),
  fixed('puffs', quantity('puff.lobes', 'style', { kind: 'integer', min: 5, max: 12, default: 10 })),
  fixed('puffs', quantity('puff.seed', 'style', { kind: 'integer', min: 0, max: 9999, default: 0 })),
] as const satisfies readonly Parameter[];

/** Forces on smoke: multipliers, wind, turbulence, gravity, buoyancy and drag. */
export const airRows = [
  simulated('forces.gravity'),
  simulated('forces.buoyancy'),
  simulated('forces.turbulence'),
  simulated('forces.vortex'),
  simulated('forces.drag'),
  simulated('forces.wind.x'),
  simulated('forces.wind.y'),
  simulated('forces.wind.z'),
  simulated('turbulence.speed'),
  simulated('turbulence.scale'),
  simulated('turbulence.octaves'),
  simulated('turbulence.evolution'),
  ofScene(simulated('gravity.acceleration')),
  ofScene(simulated('buoyancy.acceleration')),
  ofScene(simulated('buoyancy.coolingTime')),
  ofScene(simulated('drag.rate')),
  ofScene(simulated('drag.quadratic')),
  ofScene(simulated('wind.gusts')),
  ofScene(simulated('wind.gustTime')),
  ofScene(simulated('wind.shear')),
  ofScene(simulated('wind.height')),
] as const satisfies readonly Parameter[];

/** Integrator, capacity and timeline. */
export const simulationRows = [
  fixed('simulation', ofScene(simulatedChoice('simulation.integrator'))),
  quantity('simulation.maxParticles', 'stage', {
    kind: 'integer',
    min: 1,
    max: 1000000,
    linkMax: 50000,
    default: 4000,
  }),
  { kind: 'timeline', key: 'timeline', reader: 'stage', default: '' },
] as const satisfies readonly Parameter[];

function lobeShape<const Name extends string>(
  name: Name,
  initial: number,
): Keyed<NumberParameter, `puff.${Name}`, 'style'> {
  return quantity(`puff.${name}`, 'style', { min: 0, max: 1, default: initial });
}
