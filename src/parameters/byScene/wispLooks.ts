/** In a module of its own, so that a page with the first preset does not load it. */
import type { Values, Preset } from '../parameter.ts';
import { curl, smoke } from './wisp.ts';

/** Smoke that follows flows closely. */
const guided: Values = {
  'emission.rate': 40,
  'emission.lifetime': 5,
  'emission.growthTime': 1,
  'emission.density': '0:1,.8:.8,1:0',
  'emission.dissolve': 'shrink',
  'emitters.0.size': 0.22,
  'forces.buoyancy': 0.1,
  'forces.turbulence': 0.25,
};

export const presets: readonly Preset[] = [
  {
    name: 'wisp-matcha',
    values: {
      ...smoke,
      'style.ramp': '0:7fa878,.34:bcd6a4,.7:f2f7dc',
      'style.inkColor': '#24452f',
      'style.outlineWidth': 1.5,
      'style.backdrop': '0:e4efc8,1:8fb98a',
      'style.wash': 0.9,
      'style.washColor': '#dcecb4',
    },
  },
  {
    name: 'wisp-hearts',
    values: {
      ...smoke,
      'emission.rate': 3.2,
      'emission.dissolve': 'shrink',
      'emission.density': '0:1,.8:.9,1:0',
      'puff.drawing':
        'ffffff*IBKgdjYlVqUuWxbzhxnvtqwjzd0WyRyPxNwPvSuWtbqdmgigedabWWTSSPRNQPPROWOdMjNqQvTxZzfxluqqslrjo;ffd0da*IBKgdjYlVqUuWxbzhxnvtqwjzd0WyRyPxNwPvSuWtbqdmgigedabWWTSSPRNQPPROWOdMjNqQvTxZzfxluqqslrjo,ffffff*F05ceagZjakamdmemikkimgmenblakahb;ff9db4*IBKgdjYlVqUuWxbzhxnvtqwjzd0WyRyPxNwPvSuWtbqdmgigedabWWTSSPRNQPPROWOdMjNqQvTxZzfxluqqslrjo',
      'puff.upright': 0.85,
      'puff.size': 1.05,
      'emitters.0.spread': 0.4,
      'emitters.0.speed': 0.6,
      'style.simplify': 0,
      'style.form': 0,
      'style.ramp': '0:e6849f,.3:ffb3c4,.62:ffe3e8',
      'style.inkColor': '#7c2440',
      'style.outlineWidth': 2,
      'style.backdrop': '0:fff3ee,1:ffc4d2',
      'style.wash': 0.6,
      'style.washColor': '#fff0f2',
    },
  },
  {
    name: 'wisp-flourish',
    values: {
      ...smoke,
      ...guided,
      'flows.0.points': '0:.72:0,.62:.98:.1,.8:1.42:.1,.1:1.72:0,-.68:2.02:-.1,-.62:2.56:-.1,.1:2.86:0,.85:2.72:.1',
      'flows.0.speed': 1.1,
      'flows.0.radius': 0.5,
      'flows.0.inflow': 1.2,
      'style.smokeColor': '#fffaf0',
      'style.backdrop': '0:f7d9a8,1:e08a5f',
    },
  },
  {
    name: 'wisp-valentine',
    values: {
      ...smoke,
      ...guided,
      'flows.0.points': '.02:.7:0,.5:1.2:0,1:1.75:0,1.12:2.3:0,.82:2.72:0,.36:2.7:0,.03:2.42:0',
      'flows.0.speed': 1,
      'flows.0.radius': 0.45,
      'flows.0.inflow': 1.2,
      'flows.1.points': '-.02:.7:0,-.5:1.2:0,-1:1.75:0,-1.12:2.3:0,-.82:2.72:0,-.36:2.7:0,-.03:2.42:0',
      'flows.1.speed': 1,
      'flows.1.radius': 0.45,
      'flows.1.inflow': 1.2,
      'emission.rate': 85,
      'emission.lifetime': 3.6,
      'style.ramp': '0:d8577c,.34:ff9db4,.7:ffe0e6',
      'style.inkColor': '#6a1834',
      'style.outlineWidth': 2.2,
      'style.backdrop': '0:fff1ea,1:ffc9c4',
    },
  },
  {
    name: 'wisp-charcoal',
    values: {
      ...smoke,
      ...curl,
      'style.ramp': '0:c9c3ba,.3:e2dcd2,.6:f4efe7',
      'style.pattern': 'grain',
      'style.patternOn': 'both',
      'style.patternCoverage': 0.55,
      'style.patternSize': 2,
      'style.patternSoftness': 1,
      'style.patternColor': '#2c2a2a',
      'style.inkColor': '#3a3635',
      'style.outlineWidth': 2.4,
      'style.inkSwell': 1,
      'style.boil': 0.4,
      'style.strokes': 0.6,
      'style.backdrop': '0:d9d2c6,1:bfb8ac',
      'style.wash': 1,
      'style.washColor': '#e9e2d6',
    },
  },
];
