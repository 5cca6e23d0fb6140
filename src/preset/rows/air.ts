import type { NumberParameter, Parameter } from '../parameter.ts';
import { ofScene, quantity } from './row.ts';

/** Forces on smoke: multipliers, wind, turbulence, gravity, buoyancy and drag. */
export const airRows: readonly Parameter[] = [
  multiplier('gravity', 'Gravity', 'Downward pull on all smoke.'),
  multiplier('buoyancy', 'Buoyancy', 'Lift of warm smoke. It decreases as the smoke cools.'),
  multiplier('turbulence', 'Turbulence', 'Small irregular swirls in the air.'),
  multiplier('vortex', 'Vortices', 'Strength of all vortices together.'),
  multiplier('drag', 'Drag', 'How strongly the air carries smoke.'),
  wind('x', 'Wind to the right', 'Steady wind along x; negative blows to the left.'),
  wind('y', 'Wind upwards', 'Steady wind along y; negative blows down.'),
  wind('z', 'Wind to the front', 'Steady wind along z; negative blows away from the viewer.'),
  quantity('turbulence.speed', 'turbulence', 'simulator', {
    min: 0,
    max: 20,
    step: 0.02,
    default: 0.13,
    unit: 'm/s',
    slider: 'fine',
    label: 'Speed',
    text: 'Typical (root mean square) speed of the swirls.',
  }),
  quantity('turbulence.scale', 'turbulence', 'simulator', {
    min: 0.05,
    max: 20,
    step: 0.05,
    default: 0.9,
    unit: 'm',
    slider: 'fine',
    label: 'Scale',
    text: 'Size of the largest swirls.',
  }),
  quantity('turbulence.octaves', 'turbulence', 'simulator', {
    kind: 'integer',
    min: 0,
    max: 4,
    step: 1,
    default: 2,
    label: 'Octaves',
    text: 'Number of layers of swirls, each finer than the one before; 0 is still air.',
  }),
  quantity('turbulence.evolution', 'turbulence', 'simulator', {
    min: 0,
    max: 10,
    step: 0.02,
    default: 0.25,
    unit: '1/s',
    slider: 'fine',
    label: 'Evolution',
    text: 'Rate at which the pattern of swirls changes.',
  }),
  ofScene('gravity.acceleration', 'air', {
    max: 100,
    default: 0,
    unit: 'm/s\u00b2',
    label: 'Gravity strength',
    text: 'Downward acceleration of all smoke.',
  }),
  ofScene('buoyancy.acceleration', 'air', {
    max: 100,
    default: 1.5,
    unit: 'm/s\u00b2',
    label: 'Buoyancy strength',
    text: 'Upward acceleration of smoke at temperature 1.',
  }),
  ofScene('buoyancy.coolingTime', 'air', {
    min: 0.01,
    max: 1000,
    default: 4,
    unit: 's',
    label: 'Cooling time',
    text: 'Time in which warm smoke loses two thirds of its warmth.',
  }),
  ofScene('drag.rate', 'air', {
    max: 1000,
    default: 1.5,
    unit: '1/s',
    label: 'Drag rate',
    text: 'How strongly the air of this scene carries smoke.',
  }),
  ofScene('drag.quadratic', 'air', {
    max: 1000,
    default: 0,
    unit: '1/m',
    label: 'Quadratic drag',
    text: 'Drag that grows with speed, so it slows fast smoke most.',
  }),
  ofScene('wind.gusts', 'air', {
    max: 20,
    default: 0,
    unit: 'm/s',
    label: 'Gusts',
    text: 'Typical (root mean square) speed of gusts along the wind.',
  }),
  ofScene('wind.gustTime', 'air', {
    min: 0.1,
    max: 60,
    default: 2,
    unit: 's',
    label: 'Gust time',
    text: 'How long a strong gust lasts.',
  }),
  ofScene('wind.shear', 'air', {
    min: -10,
    max: 10,
    default: 0,
    unit: '1/m',
    label: 'Wind shear',
    text: 'Increase of the wind speed per metre of height, as a fraction.',
  }),
  ofScene('wind.height', 'air', {
    min: -1000,
    max: 1000,
    default: 0,
    unit: 'm',
    label: 'Shear height',
    text: 'Height at which shear has no effect.',
  }),
];

function multiplier(name: string, label: string, text: string): NumberParameter {
  const range = { min: 0, max: 10, step: 0.05, default: 1, unit: '\u00d7' } as const;
  return quantity(`forces.${name}`, 'forces', 'simulator', { label, text, ...range, slider: 'fine' });
}

function wind(axis: 'x' | 'y' | 'z', label: string, text: string): NumberParameter {
  const range = { min: -50, max: 50, step: 0.05, default: 0, unit: 'm/s' } as const;
  return quantity(`forces.wind.${axis}`, 'forces', 'simulator', { label, text, ...range, slider: 'fine' });
}
