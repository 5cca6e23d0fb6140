import type { Preset } from './preset.ts';

export const trainPresets: readonly Preset[] = [
  {
    name: 'train',
    label: 'Steam train',
    text: 'A toy train goes round, a puff for each stroke.',
    values: {
      scene: 'train',
      'emission.rate': 75,
      'emission.lifetime': 6.5,
      'emission.growthTime': 1.4,
      'emission.density': '0:1,.45:.85,1:0',
      'forces.turbulence': 1,
      'forces.wind.x': -0.1,
      'simulation.maxParticles': 1000,
      'style.smokeColor': '#fffaf0',
      'style.inkColor': '#2a1d2e',
      'light.azimuth': 34,
      'light.elevation': 52,
    },
  },
];
