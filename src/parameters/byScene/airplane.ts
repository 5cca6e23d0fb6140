import type { Values, Preset } from '../parameter.ts';

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
  'style.simplify': 4,
  'style.form': 0.5,
  'style.strokes': 0.4,
};

/** White clouds that darken downwards. */
const morning: Values = {
  ...smoke,
  'style.smokeColor': '#fff7ec',
  'style.gradient': 'height',
  'style.gradientColor': '#cfd3ee',
  'style.gradientBottom': -2,
  'style.gradientTop': 0.3,
  'style.innerLine': 0.26,
  'light.azimuth': 62,
  'light.elevation': 48,
};

export const airplanePresets: readonly Preset[] = [
  {
    name: 'airplane',
    values: morning,
  },
  {
    name: 'airplane-ukiyo-e',
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
      'style.backdrop': '0:f4d8b4,1:23508a',
      'style.wash': 0.3,
      'style.washColor': '#f0dcb8',
      'light.azimuth': 62,
      'light.elevation': 52,
    },
  },
  {
    name: 'airplane-air-show',
    values: {
      ...morning,
      'emission.rate': 200,
      'emission.growthTime': 0.35,
      'forces.turbulence': 0.6,
      // Smoke from the wing tips.
      'emitters.4.rigid': 0,
      'emitters.4.position.x': -0.25,
      'emitters.4.position.z': 1.3,
      'emitters.4.speed': 0,
      'emitters.4.temperature': 0,
      'emitters.4.share': 1.8,
      'emitters.4.lifetime': 0.8,
      'emitters.4.tint': 1,
      'emitters.5.rigid': 0,
      'emitters.5.position.x': -0.25,
      'emitters.5.position.z': -1.3,
      'emitters.5.speed': 0,
      'emitters.5.temperature': 0,
      'emitters.5.share': 1.8,
      'emitters.5.lifetime': 0.8,
      'emitters.5.tint': 2,
      'style.tint1': '#ff9ab0',
      'style.tint2': '#ffe6a8',
      // Strong, smooth vortices of the wing tips, and little swirl behind the propeller.
      'shedders.0.perSpeed': 0.15,
      'shedders.1.perSpeed': 1.2,
      'shedders.1.coreRadius': 0.4,
      'shedders.1.lifetime': 4,
    },
  },
];
