import type { Values, Preset } from '../parameter.ts';

/** Values shared by all presets of this scene. */
const smoke: Values = {
  scene: 'genie',
  'emission.rate': 190,
  'emission.lifetime': 2,
  'emission.growthTime': 0.5,
  'emission.density': '0:1,.7:1,1:0',
  'forces.turbulence': 0.6,
  'simulation.maxParticles': 1000,
  'puff.turn': 0.6,
  'puff.stretch': 1.4,
  'puff.billow': 0.5,
  'style.simplify': 4,
  'style.form': 0.3,
};

export const geniePresets: readonly Preset[] = [
  {
    name: 'genie',
    values: {
      ...smoke,
      'style.smokeColor': '#8ccbf0',
      'style.inkColor': '#221a3e',
      'style.innerLine': 0.42,
      'style.strokes': 0.4,
      'light.azimuth': 38,
      'light.elevation': 46,
    },
  },
  {
    name: 'genie-sumi-e',
    values: {
      ...smoke,
      'style.ramp': '0:c9c6c0,.36:fbf9f2',
      'style.inkColor': '#17161a',
      'style.outlineWidth': 3.4,
      'style.inkSwell': 1,
      'style.boil': 0.5,
      'style.innerLine': 0.5,
      'style.backdrop': '0:f2efe6,1:faf8f1',
      'style.wash': 1,
      'style.washColor': '#f6f3ea',
      'light.azimuth': 38,
      'light.elevation': 52,
      'style.strokes': 0.5,
    },
  },
];
