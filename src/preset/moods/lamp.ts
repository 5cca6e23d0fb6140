import type { Values } from '../parameter.ts';
import type { Preset } from './preset.ts';

/** The vortex that curls the column above the lamp's spout; the moods keep it and change its strength. */
const curl: Values = {
  'vortices.0.circulation': 3.2,
  'vortices.0.coreRadius': 0.45,
  'vortices.0.reach': 2.4,
  'vortices.0.position.x': 0.1,
  'vortices.0.position.y': 1.7,
  'forces.wind.x': -0.06,
};

export const lampPresets: readonly Preset[] = [
  {
    name: 'lamp',
    label: 'Lamp',
    text: 'White smoke in two tones that rises from the spout and curls.',
    values: curl,
  },
  {
    name: 'lamp-noir',
    label: 'Noir',
    text: 'One flat tone and heavy ink, as printed in black and white.',
    values: {
      ...curl,
      'style.tones': 1,
      'style.smokeColor': '#fbf7ec',
      'style.inkColor': '#0b090c',
      'style.outlineWidth': 4,
      'style.innerLine': 0.34,
      'light.azimuth': -70,
      'light.elevation': 30,
    },
  },
  {
    name: 'lamp-sunset',
    label: 'Sunset',
    text: 'Three warm tones under a low sun.',
    values: {
      ...curl,
      'emission.lifetime': 7.5,
      'style.tones': 3,
      'style.smokeColor': '#ffb36b',
      'style.inkColor': '#4a1527',
      'style.gradient': 'height',
      'style.gradientColor': '#f0708a',
      'style.rim': 0.25,
      'style.rimColor': '#ffe6a8',
      'light.azimuth': 62,
      'light.elevation': 20,
    },
  },
  {
    name: 'lamp-ghost',
    label: 'Ghost',
    text: 'Pale smoke without ink that hangs in the air and thins out.',
    values: {
      ...curl,
      'emission.lifetime': 9,
      'emission.rate': 22,
      'forces.buoyancy': 0.7,
      'style.outlines': 0,
      'style.smokeColor': '#dcefe9',
      'style.gradient': 'age',
      'style.gradientColor': '#a8c4dd',
    },
  },
  {
    name: 'lamp-ember',
    label: 'Ember',
    text: 'Fire that leaves the spout and cools to dark smoke.',
    values: {
      ...curl,
      'emission.rate': 34,
      'style.ramp': '0:c06a62,.3:e6ae94,.62:ffffff',
      'style.heatRamp': '0:57525f,.2:8c4a45,.32:e0552b,.5:f9a53a,.68:fff0a8',
      'style.inkColor': '#1c0f14',
      'buoyancy.coolingTime': 2.2,
      'buoyancy.acceleration': 1.7,
    },
  },
  {
    name: 'lamp-storm',
    label: 'Storm',
    text: 'Dark smoke torn by gusts from the right.',
    values: {
      ...curl,
      'emission.rate': 48,
      'emission.lifetime': 4.5,
      'style.smokeColor': '#8f96a8',
      'style.inkColor': '#14151c',
      'style.outlineWidth': 2.8,
      'forces.turbulence': 2.2,
      'forces.wind.x': -0.5,
      'turbulence.octaves': 3,
      'turbulence.evolution': 0.8,
      'vortices.0.circulation': 1.5,
    },
  },
];
