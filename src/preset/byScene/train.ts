import type { Values } from '../parameter.ts';
import type { Preset } from './preset.ts';

/** Values shared by all presets of this scene. */
const smoke: Values = {
  scene: 'train',
  'emission.rate': 75,
  'emission.lifetime': 6.5,
  'emission.growthTime': 1.4,
  'emission.density': '0:1,.45:.85,1:0',
  'forces.wind.x': -0.1,
  'simulation.maxParticles': 1000,
};

export const trainPresets: readonly Preset[] = [
  {
    name: 'train',
    label: 'Steam train',
    text: 'A toy train in a circle, with a puff for each piston stroke.',
    values: {
      ...smoke,
      'forces.turbulence': 1,
      'style.smokeColor': '#fffaf0',
      'style.inkColor': '#2a1d2e',
      'light.azimuth': 34,
      'light.elevation': 52,
    },
  },
  {
    name: 'train-night-mail',
    label: 'Night mail',
    text: 'Moonlight from behind on the last train of the day.',
    values: {
      ...smoke,
      'style.ramp': '0:4a5288,.45:8e9ccc,.75:e8ecff',
      'style.rim': 0.3,
      'style.rimColor': '#f4f0d8',
      'style.inkColor': '#10122a',
      'style.backdrop': '0:4a5a94,1:12163a',
      'style.wash': 0.6,
      'style.washColor': '#7484c4',
      'light.azimuth': -60,
      'light.elevation': 42,
    },
  },
];
