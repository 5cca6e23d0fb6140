import type { Preset } from '../parameter.ts';

export const presets: readonly Preset[] = [
  {
    name: 'dust',
    values: {
      scene: 'dust',
      'emission.rate': 5000,
      'emission.lifetime': 1.9,
      'emission.growthTime': 0.5,
      'emission.entrainment': 0.12,
      'emission.sizeSpread': 0.35,
      'emission.company': 0.8,
      'puff.size': 1.1,
      'emission.density': '0:.6,.3:1,.55:.85,.8:.3,1:0',
      'forces.turbulence': 0.9,
      'forces.wind.x': 0.12,
      'simulation.maxParticles': 1500,
      'style.ramp': '0:d79a6c,.34:f3cf98,.66:fff0cf',
      'style.inkColor': '#3a2530',
      'style.innerLine': 0.3,
      'light.azimuth': -48,
      'light.elevation': 37,
      'puff.turn': 0.6,
      'puff.stretch': 1.4,
      'puff.billow': 0.5,
      'style.simplify': 4,
    },
  },
];
