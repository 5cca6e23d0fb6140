import type { Preset } from '../parameter.ts';

export const rocketPresets: readonly Preset[] = [
  {
    name: 'rocket',
    values: {
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
    },
  },
];
