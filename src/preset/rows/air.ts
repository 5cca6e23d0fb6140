import type { NumberParameter, Parameter } from '../parameter.ts';
import { ofScene, simulated, type SingleKey } from './row.ts';

/** Forces on smoke: multipliers, wind, turbulence, gravity, buoyancy and drag. */
export const airRows: readonly Parameter[] = [
  multiplier('forces.gravity', 'Gravity', 'Downward pull on all smoke.'),
  multiplier('forces.buoyancy', 'Buoyancy', 'Lift of warm smoke. It decreases as the smoke cools.'),
  multiplier('forces.turbulence', 'Turbulence', 'Small irregular swirls in the air.'),
  multiplier('forces.vortex', 'Vortices', 'Strength of all vortices together.'),
  multiplier('forces.drag', 'Drag', 'How strongly the air carries smoke.'),
  wind('x', 'Wind to the right', 'Steady wind along x; negative blows to the left.'),
  wind('y', 'Wind upwards', 'Steady wind along y; negative blows down.'),
  wind('z', 'Wind to the front', 'Steady wind along z; negative blows away from the viewer.'),
  simulated('turbulence.speed', 'turbulence', {
    step: 0.02,
    slider: 'fine',
    label: 'Speed',
    text: 'Typical (root mean square) speed of the swirls.',
  }),
  simulated('turbulence.scale', 'turbulence', {
    step: 0.05,
    slider: 'fine',
    label: 'Scale',
    text: 'Size of the largest swirls.',
  }),
  simulated('turbulence.octaves', 'turbulence', {
    step: 1,
    label: 'Octaves',
    text: 'Number of layers of swirls, each finer than the one before; 0 is still air.',
  }),
  simulated('turbulence.evolution', 'turbulence', {
    step: 0.02,
    slider: 'fine',
    label: 'Evolution',
    text: 'Rate at which the pattern of swirls changes.',
  }),
  ofScene('gravity.acceleration', 'air', {
    label: 'Gravity strength',
    text: 'Downward acceleration of all smoke.',
  }),
  ofScene('buoyancy.acceleration', 'air', {
    label: 'Buoyancy strength',
    text: 'Upward acceleration of smoke at temperature 1.',
  }),
  ofScene('buoyancy.coolingTime', 'air', {
    label: 'Cooling time',
    text: 'Time in which warm smoke loses two thirds of its warmth.',
  }),
  ofScene('drag.rate', 'air', {
    label: 'Drag rate',
    text: 'How strongly the air of this scene carries smoke.',
  }),
  ofScene('drag.quadratic', 'air', {
    label: 'Quadratic drag',
    text: 'Drag that grows with speed, so it slows fast smoke most.',
  }),
  ofScene('wind.gusts', 'air', {
    label: 'Gusts',
    text: 'Typical (root mean square) speed of gusts along the wind.',
  }),
  ofScene('wind.gustTime', 'air', {
    label: 'Gust time',
    text: 'How long a strong gust lasts.',
  }),
  ofScene('wind.shear', 'air', {
    label: 'Wind shear',
    text: 'Increase of the wind speed per metre of height, as a fraction.',
  }),
  ofScene('wind.height', 'air', {
    label: 'Shear height',
    text: 'Height at which shear has no effect.',
  }),
];

function multiplier(key: SingleKey, label: string, text: string): NumberParameter {
  return simulated(key, 'forces', { label, text, step: 0.05, unit: '\u00d7', slider: 'fine' });
}

function wind(axis: 'x' | 'y' | 'z', label: string, text: string): NumberParameter {
  return simulated(`forces.wind.${axis}`, 'forces', { label, text, step: 0.05, slider: 'fine' });
}
