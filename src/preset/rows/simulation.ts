import type { Parameter } from '../parameter.ts';
import { choice, quantity } from './row.ts';

/** Scene and seed. */
export const sceneRows: readonly Parameter[] = [
  choice('scene', 'simulation', 'stage', { label: 'Scene', text: 'The scene to show.', default: 'lamp' }, [
    ['lamp', 'Magic lamp'],
    ['airplane', 'Airplane'],
    ['train', 'Steam train'],
    ['campfire', 'Campfire'],
    ['rocket', 'Rocket launch'],
    ['genie', 'Genie'],
    ['dust', 'Dust'],
    ['cloudscape', 'Cloudscape'],
    ['wisp', 'Cup of tea'],
    ['air', 'Open air'],
  ]),
  quantity('seed', 'simulation', 'stage', {
    kind: 'integer',
    min: 0,
    max: 4294967295,
    step: 1,
    default: 1,
    label: 'Seed',
    text: 'Seed of the random numbers. The same seed makes the same smoke. A change restarts the smoke.',
  }),
];

/** Integrator and capacity. */
export const simulationRows: readonly Parameter[] = [
  {
    ...choice(
      'simulation.integrator',
      'simulation',
      'simulator',
      {
        label: 'Motion',
        text: "How puffs follow the air. With the paper's method, vortices throw them outwards.",
        default: 'airAndSlip',
      },
      [
        ['airAndSlip', 'With the air'],
        ['paper', 'As in the paper'],
      ],
    ),
    isOptional: true,
  },
  quantity('simulation.maxParticles', 'simulation', 'stage', {
    kind: 'integer',
    min: 1,
    max: 1000000,
    linkMax: 50000,
    step: 100,
    default: 4000,
    slider: 'fine',
    label: 'Maximum particles',
    text: 'Maximum number of puffs alive at once. Further puffs wait.',
  }),
];
