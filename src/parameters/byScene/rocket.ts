import type { Values, Preset } from '../parameter.ts';

/** The first look of the scene. */
const day: Values = {
  scene: 'rocket',
  'emission.rate': 60,
  'emission.lifetime': 7,
  'emission.growthTime': 0.7,
  // Few large puffs, so that the smoke rolls over the ground in billows. The exhaust of the descent travels far through the
  // air: with more entrainment it fills the picture.
  'emission.entrainment': 0.05,
  'emitters.0.size': 0.62,
  'emitters.0.inherit': 0.3,
  'emission.sizeSpread': 0.6,
  'emission.company': 1,
  'emission.density': '0:.55,.3:1,.75:.75,1:0',
  'simulation.maxParticles': 1500,
  // Flat tones with short transitions, so that no puff changes its colour at once.
  'style.heatRamp': '0:fff8ec,.03:fff8ec,.13:f6d9b4,.32:f6a050,.42:f6a050,.52:f9c24c,.58:f9c24c,.95:fff0b4',
  'style.softColors': 1,
  'style.inkColor': '#2a1a26',
  'style.innerLine': 0.24,
  'light.azimuth': 44,
  'light.elevation': 48,
  'puff.turn': 0.6,
  'puff.stretch': 1.3,
  'puff.billow': 0.5,
  'style.simplify': 3.5,
  'style.form': 0.4,
  'style.strokes': 0.4,
};

export const presets: readonly Preset[] = [
  {
    name: 'rocket',
    values: day,
  },
  {
    name: 'rocket-night',
    values: {
      ...day,
      'emission.rate': 96,
      // Smoke that stays hot for longer glows from inside the cloud. With a greater share its lamps bleach the sand.
      'emission.glow': '.16:0,.38:.55,.9:.85',
      'buoyancy.coolingTime': 1,
      // A flame at the nozzle, which travels with the rocket.
      'emitters.1.shape': 'disc',
      'emitters.1.rigid': 0,
      'emitters.1.position.y': 0.14,
      'emitters.1.direction.y': -1,
      'emitters.1.radius': 0.05,
      'emitters.1.speed': 3,
      'emitters.1.speedVariation': 0.3,
      'emitters.1.spread': 0.04,
      'emitters.1.inherit': 1,
      'emitters.1.size': 0.42,
      'emitters.1.sizeVariation': 0.3,
      'emitters.1.lifetime': 0.05,
      'emitters.1.lifetimeVariation': 0.3,
      'emitters.1.temperature': 1.3,
      'emitters.1.share': 0.6,
      'emitters.1.envelope.start': 1,
      'emitters.1.envelope.duration': 14,
      'emitters.1.envelope.period': 18,
      'emitters.1.envelope.fade': 0.3,
      'style.inkLight': 0.5,
      'style.backdrop': '0:4050a0,.5:27346f,1:141b48',
      'light.azimuth': -30,
      'light.color': '#8ca8ff',
      'light.intensity': 0.45,
      'light.ambientColor': '#6c82e0',
      'light.ambient': 0.32,
    },
  },
  {
    name: 'rocket-newsprint',
    values: {
      ...day,
      'style.heatRamp': '',
      'style.ramp': '0:efe4cb,.35:efe4cc,1:f6eedb',
      'style.pattern': 'dots',
      'style.patternCoverage': 0.42,
      'style.patternSize': 5,
      'style.patternColor': '#23201f',
      'style.surfaceShadowColor': '#d8ccb4',
      'style.inkColor': '#1d1a18',
      'style.outlineWidth': 2.4,
      'style.inkSwell': 0.6,
      'style.backdrop': '0:e8dcc0,1:efe6d0',
      'style.wash': 1,
      'style.washColor': '#efe5cd',
    },
  },
];
