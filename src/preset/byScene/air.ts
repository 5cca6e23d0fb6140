import type { Preset } from './preset.ts';

export const airPresets: readonly Preset[] = [
  {
    name: 'air',
    label: 'Open air',
    text: 'Only smoke, to flow over pages and around their elements.',
    values: {
      scene: 'air',
      'emission.rate': 16,
      'emission.lifetime': 6,
      'emission.growthTime': 1.6,
      'forces.turbulence': 1.4,
      'turbulence.scale': 0.8,
      'simulation.maxParticles': 600,
      'style.smokeColor': '#fffaf0',
      'style.outlineWidth': 2,
      'light.azimuth': 35,
      'light.elevation': 48,
    },
  },
];
