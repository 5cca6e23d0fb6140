import type { Preset } from '../parameter.ts';

export const campfirePresets: readonly Preset[] = [
  {
    name: 'campfire',
    values: {
      scene: 'campfire',
      'emission.rate': 70,
      'emission.lifetime': 4.4,
      'emission.growthTime': 0.35,
      'emission.density': '0:1,.1:.8,.22:.5,.32:.5,.55:1,1:0',
      'forces.turbulence': 1.5,
      'forces.wind.x': 0.12,
      'simulation.maxParticles': 800,
      'style.ramp': '0:a88fb8,.3:d9c2cc,.6:ffffff',
      'style.heatRamp': '0:7a7494,.13:9a7078,.24:cf6a4c,.36:ea7a38,.54:f99f3e,.8:ffe38c,1:fff0bb',
      // Without blending, a whole puff changes its colour band at once.
      'style.softColors': 1,
      'style.rim': 0.22,
      'style.rimColor': '#d9c8f2',
      'style.inkColor': '#1b1226',
      'style.innerLine': 0.22,
      'light.azimuth': 26,
      'light.elevation': 38,
      'puff.turn': 0.6,
      'puff.stretch': 1.4,
      'puff.billow': 0.4,
      'style.simplify': 3,
    },
  },
];
