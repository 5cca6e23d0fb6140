import type { Values, Preset } from '../parameter.ts';

/** Steps of a beat. The dragon moves with it, and the timeline is one beat long. */
export const BEAT = 150;
/** Steps of the beat between which fire leaves the mouth. */
export const BREATH = { start: 68, end: 106 } as const;
/** Steps between bursts, and puffs of the first burst and of each later one. */
const [EVERY, FIRST, LATER] = [2, 7, 3];

/** Fire in short bursts, as one breath. */
function timeline(): string {
  const bursts = Array.from({ length: 1 + Math.floor((BREATH.end - BREATH.start) / EVERY) }, (_, index) => {
    return `${BREATH.start + EVERY * index}*0*${index === 0 ? FIRST : LATER}`;
  });
  // The nostrils smoke between breaths.
  const rate = `emission.rate/0*26*h/${BREATH.start - 36}*0*h/${BREATH.end + 8}*26*h`;
  return [`${BEAT}*loop`, rate, ['burst', ...bursts].join('/')].join(';');
}

const day: Values = {
  scene: 'dragon',
  'emission.rate': 26,
  'emission.lifetime': 1.5,
  'emission.growthTime': 0.3,
  'emission.density': '0:.7,.3:1,1:0',
  'emission.company': 0.7,
  'emission.glow': '.12:0,.3:.75,.6:1',
  'forces.turbulence': 1,
  'simulation.maxParticles': 900,
  'style.ramp': '0:a79cc0,.3:d6cfe0,.6:ffffff',
  'style.softColors': 1,
  'style.inkColor': '#1d1830',
  'style.outlineWidth': 2.6,
  'puff.turn': 0.6,
  'puff.stretch': 1.8,
  'puff.billow': 0.4,
  'style.simplify': 3,
  'emitters.0.look.lifetime': 3,
  'emitters.0.look.growthTime': 0.08,
  'emitters.0.look.sizeCurve': '0:.5,.12:.75,.5:1,1:.85',
  'emitters.0.look.densityCurve': '0:1,.6:.9,1:0',
  'emitters.0.look.colors': '0:dc9c8c,.35:f2d2c4,.65:ffffff',
  'emitters.0.look.heatColors': '0:bcb2cc,.06:a890a4,.12:c0645a,.2:e4642c,.36:fb8c2c,.6:ffbe40,.82:ffe67c,1:fff8d8',
  'emitters.0.lifetimeVariation': 0.25,
  timeline: timeline(),
};

export const presets: readonly Preset[] = [
  { name: 'dragon', values: day },
  {
    name: 'dragon-night',
    values: {
      ...day,
      'style.inkLight': 0.5,
      'style.backdrop': '0:4050a0,.5:27346f,1:141b48',
      'light.azimuth': -20,
      'light.elevation': 44,
      'light.color': '#8ca8ff',
      'light.intensity': 0.6,
      'light.ambientColor': '#6c82e0',
      'light.ambient': 0.42,
    },
  },
];
