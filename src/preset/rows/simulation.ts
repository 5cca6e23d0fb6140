import type { Parameter } from '../parameter.ts';
import { choice, choiceOfScene, quantity } from './row.ts';

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
    text: 'Starts the random numbers: the same seed makes the same smoke. Changing it starts anew.',
  }),
];

/** Integrator and capacity. */
export const simulationRows: readonly Parameter[] = [
  choiceOfScene(
    'simulation.integrator',
    'simulation',
    { label: 'Motion', text: 'How puffs follow the air; the paper lets vortices fling them out.' },
    ['With the air', 'As in the paper'],
  ),
  quantity('simulation.maxParticles', 'simulation', 'stage', {
    kind: 'integer',
    min: 1,
    max: 1000000,
    linkMax: 50000,
    step: 100,
    default: 4000,
    slider: 'fine',
    label: 'Most particles',
    text: 'Room for living puffs; when it is full, new ones wait.',
  }),
];
