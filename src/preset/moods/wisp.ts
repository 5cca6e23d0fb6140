import type { Preset } from './preset.ts';

export const wispPresets: readonly Preset[] = [
  {
    name: 'wisp',
    label: 'Cup of tea',
    text: 'A little steam from a cup that is glad to see you.',
    values: {
      scene: 'wisp',
      'emission.rate': 18,
      'emission.lifetime': 4.5,
      'emission.growthTime': 2.2,
      'forces.turbulence': 1.2,
      'turbulence.scale': 0.7,
      'vortices.0.circulation': -1.6,
      'vortices.0.coreRadius': 0.4,
      'vortices.0.reach': 1.6,
      'vortices.0.position.x': -0.25,
      'vortices.0.position.y': 2.1,
      'simulation.maxParticles': 400,
      'style.smokeColor': '#fffaf0',
      'light.azimuth': 30,
      'light.elevation': 40,
    },
  },
];
