import type { Values } from '../parameter.ts';
import type { Preset } from './preset.ts';

/** Values shared by all presets of this scene. */
const smoke: Values = {
  scene: 'cloudscape',
  'emission.rate': 0,
  'emission.lifetime': 46,
  'emission.growthTime': 1,
  'emission.density': '0:1,.9:1,1:0',
  'forces.turbulence': 0.35,
  'turbulence.evolution': 0.1,
  'simulation.maxParticles': 2000,
};

export const cloudscapePresets: readonly Preset[] = [
  {
    name: 'cloudscape',
    label: 'Cloudscape',
    text: 'Clouds drift over a meadow, and the sun moves on.',
    values: {
      ...smoke,
      'style.ramp': '0:bcb8e2,.28:fffaf0',
      'style.innerLine': 0.3,
      'style.gradient': 'height',
      'style.gradientColor': '#e6e2f4',
      'style.gradientBottom': 0.6,
      'style.gradientTop': 2.6,
      'style.inkColor': '#2b2740',
      'light.azimuth': 0,
      'light.elevation': 62,
    },
  },
  {
    name: 'cloudscape-gouache',
    label: 'Gouache',
    text: 'Evening clouds in three broad tones, painted without a line.',
    values: {
      ...smoke,
      'style.outlines': 0,
      'style.ramp': '0:ac90c8,.3:f4a49c,.6:ffe6b8',
      'style.gradient': 'height',
      'style.gradientColor': '#d8c8ea',
      'style.gradientBottom': 0.4,
      'style.gradientTop': 2.4,
      'style.backdrop': '0:ffcfa4,1:5c5cac',
      'style.wash': 0.35,
      'style.washColor': '#f4b49c',
      'light.azimuth': 0,
      'light.elevation': 62,
    },
  },
];
