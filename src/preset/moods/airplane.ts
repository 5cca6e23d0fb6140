import type { Preset } from './preset.ts';

export const airplanePresets: readonly Preset[] = [
  {
    name: 'airplane',
    label: 'Airplane',
    text: 'A little biplane that parts the clouds of the morning; steer it.',
    values: {
      scene: 'airplane',
      'emission.rate': 120,
      'emission.lifetime': 5.6,
      'emission.growthTime': 0.8,
      'emission.density': '0:1,.8:1,1:0',
      'forces.turbulence': 0.8,
      'simulation.maxParticles': 1500,
      'style.smokeColor': '#fff7ec',
      'style.gradient': 'height',
      'style.gradientColor': '#cfd3ee',
      'style.gradientBottom': -2,
      'style.gradientTop': 0.3,
      'style.innerLine': 0.26,
      'light.azimuth': 62,
      'light.elevation': 48,
    },
  },
];
