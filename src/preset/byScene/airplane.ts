import type { Values } from '../parameter.ts';
import type { Preset } from './preset.ts';

/** Values shared by all presets of this scene. */
const smoke: Values = {
  scene: 'airplane',
  'emission.rate': 120,
  'emission.lifetime': 5.6,
  'emission.growthTime': 0.8,
  'emission.density': '0:1,.8:1,1:0',
  'forces.turbulence': 0.8,
  'simulation.maxParticles': 1500,
  'puff.turn': 0.6,
  'puff.stretch': 1.4,
  'puff.billow': 0.5,
  'style.simplify': 5.5,
};

export const airplanePresets: readonly Preset[] = [
  {
    name: 'airplane',
    label: 'Airplane',
    text: 'A little biplane that parts the morning clouds. Steer it.',
    values: {
      ...smoke,
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
  {
    name: 'airplane-ukiyo-e',
    label: 'Ukiyo-e',
    text: 'Indigo on rice paper, like a woodcut.',
    values: {
      ...smoke,
      'style.ramp': '0:5f88a4,.42:f3e8cf',
      'style.gradient': 'height',
      'style.gradientColor': '#a8c0c4',
      'style.gradientBottom': -2,
      'style.gradientTop': 0.6,
      'style.inkColor': '#1c2c4e',
      'style.outlineWidth': 1.8,
      'style.inkSwell': 0.8,
      'style.innerLine': 0.3,
      'style.strokes': 0.4,
      'style.backdrop': '0:f4d8b4,1:23508a',
      'style.wash': 0.3,
      'style.washColor': '#f0dcb8',
      'light.azimuth': 62,
      'light.elevation': 52,
    },
  },
];
