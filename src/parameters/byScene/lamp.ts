import type { Values, Preset } from '../parameter.ts';

/**
 * The vortex that curls the smoke above the lamp's spout, and puffs that turn in it. All presets of the scene use them and
 * may change their strength.
 */
const curl: Values = {
  'vortices.0.circulation': 3.2,
  'vortices.0.coreRadius': 0.45,
  'vortices.0.reach': 2.4,
  'vortices.0.position.x': 0.1,
  'vortices.0.position.y': 1.7,
  'forces.wind.x': -0.06,
  'puff.turn': 0.6,
  'puff.stretch': 1.5,
  'puff.billow': 0.6,
  // Puffs stay large almost until they end, and end together, so that the plume does not end in single small balls.
  'emission.density': '0:1,.85:.4,1:0',
  'emitters.0.lifetimeVariation': 0.05,
  'style.simplify': 3,
  'style.form': 0.5,
};

/** Smoke of which stragglers end first. */
const together: Values = {
  ...curl,
  'emission.rate': 26,
  'emission.entrainment': 0.05,
  'emission.sizeSpread': 0.3,
  'emission.company': 0.85,
};

/** Puffs without ink that holes open in. They keep their size longer than those that shrink. */
const eroding: Values = {
  'emission.dissolve': 'erode',
  'emission.density': '0:1,.55:.75,.9:.25,1:0',
  'puff.size': 0.8,
};

export const lampPresets: readonly Preset[] = [
  {
    name: 'lamp',
    values: {
      ...together,
      'style.strokes': 0.5,
    },
  },
  {
    name: 'lamp-noir',
    values: {
      ...curl,
      'style.ramp': '0:8b867f,.3:fbf7ec',
      'style.inkColor': '#0b090c',
      'style.outlineWidth': 4,
      'style.innerLine': 0.34,
      'style.backdrop': '0:9c988f,1:24222a',
      'style.wash': 1,
      'style.washColor': '#d8d3c8',
      'light.azimuth': -70,
      'light.elevation': 30,
      'style.strokes': 0.5,
    },
  },
  {
    name: 'lamp-sunset',
    values: {
      ...curl,
      'emission.lifetime': 7.5,
      'style.tones': 3,
      'style.smokeColor': '#ffb36b',
      'style.inkColor': '#4a1527',
      'style.gradient': 'height',
      'style.gradientColor': '#f0708a',
      'style.rim': 0.4,
      'style.rimColor': '#ffe6a8',
      'style.strokes': 0.4,
      'light.azimuth': 62,
      'light.elevation': 20,
    },
  },
  {
    name: 'lamp-ghost',
    values: {
      ...curl,
      ...eroding,
      'emission.lifetime': 9,
      'emission.rate': 22,
      'forces.buoyancy': 0.7,
      'style.outlines': 0,
      'style.smokeColor': '#dcefe9',
      'style.gradient': 'age',
      'style.gradientColor': '#a8c4dd',
    },
  },
  {
    name: 'lamp-ember',
    values: {
      ...curl,
      'emission.rate': 34,
      'style.ramp': '0:c06a62,.3:e6ae94,.62:ffffff',
      'style.heatRamp':
        '0:57525f,.15:57525f,.2:8c4a45,.28:8c4a45,.32:e0552b,.46:e0552b,.52:f9a53a,.64:f9a53a,.7:fff0a8',
      'style.softColors': 1,
      'style.inkColor': '#1c0f14',
      'buoyancy.coolingTime': 2.2,
      'buoyancy.acceleration': 1.7,
      'style.form': 0.25,
    },
  },
  {
    name: 'lamp-storm',
    values: {
      ...curl,
      'emission.rate': 42,
      'emission.lifetime': 4.5,
      'emission.density': '0:1,.85:.6,1:0',
      'emission.entrainment': 0.15,
      'emission.sizeSpread': 0.2,
      'emission.company': 1,
      'style.smokeColor': '#8f96a8',
      'style.inkColor': '#14151c',
      'style.outlineWidth': 2.8,
      'forces.turbulence': 2.2,
      'forces.wind.x': -0.5,
      'turbulence.octaves': 3,
      'turbulence.evolution': 0.8,
      'vortices.0.circulation': 1.5,
      'style.strokes': 0.5,
    },
  },
  {
    name: 'lamp-blueprint',
    values: {
      ...together,
      'style.shading': 0,
      'style.shadows': 0,
      'style.smokeColor': '#1f5196',
      'style.inkColor': '#e6f2ff',
      'style.outlineWidth': 1.6,
      'style.inkSwell': 0,
      'style.innerLine': 0.12,
      'style.backdrop': '0:1b4a8c,1:163f7a',
      'style.wash': 1,
      'style.washColor': '#2a62ac',
      'style.strokes': 0.8,
    },
  },
  {
    name: 'lamp-newspaper',
    values: {
      ...curl,
      'style.ramp': '0:aaa293,.3:f8f0dc',
      'style.inkColor': '#1d1a18',
      'style.outlineWidth': 2.6,
      'style.inkSwell': 0.7,
      'style.backdrop': '0:e9dfc6,1:f0e7d0',
      'style.wash': 1,
      'style.washColor': '#efe5cd',
      'style.strokes': 0.5,
    },
  },
  {
    name: 'lamp-candy',
    values: {
      ...curl,
      'style.ramp': '0:9a6fd0,.34:ff8fc0,.7:fff0c8',
      'style.inkColor': '#6a2a78',
      'style.outlineWidth': 2.4,
      'style.rim': 0.35,
      'style.rimColor': '#9ff0e0',
      'style.backdrop': '0:ffd9e4,1:a6e4e0',
      'style.wash': 0.35,
      'style.washColor': '#ffc2dc',
      'style.strokes': 0.4,
      'light.elevation': 42,
    },
  },
  {
    name: 'lamp-papercut',
    values: {
      ...curl,
      ...eroding,
      'style.outlines': 0,
      'style.smokeColor': '#fff4e2',
      'style.gradient': 'height',
      'style.gradientColor': '#f4a27c',
      'style.gradientBottom': 0.8,
      'style.gradientTop': 2.8,
      'style.backdrop': '0:2f6f7c,1:174a5c',
      'style.wash': 0.4,
      'style.washColor': '#ffe2b8',
      'light.azimuth': -40,
    },
  },
  {
    name: 'lamp-wind-waker',
    values: {
      ...curl,
      'emission.rate': 30,
      'emission.lifetime': 8,
      'emission.density': '0:1,.85:.8,1:0',
      'puff.size': 1.08,
      'vortices.0.circulation': 5,
      'vortices.0.coreRadius': 0.4,
      'vortices.0.reach': 2.6,
      'style.simplify': 4,
      'style.strokes': 0.6,
      'style.ramp': '0:6fcbe8,.34:ffffff',
      'style.rim': 0.26,
      'style.rimColor': '#e6feff',
      'style.inkColor': '#15406e',
      'style.outlineWidth': 2.4,
      'style.backdrop': '0:8ff0ec,1:1668d8',
      'light.elevation': 48,
    },
  },
];
