import type { Preset } from '../parameter.ts';

/** Steps at which the letters of the scene jump up and fall back. */
const RISES = [120, 156, 192, 228] as const;
const FALLS = [588, 595, 602, 610] as const;

/** Easings of a circle: a sine away from its centre and back to it. */
const [AWAY, BACK] = ['.39,.58,.57,1', '.47,0,.75,.72'];

/** Twelve seconds: a comet flies in, the letters jump up, the comet circles them, a curtain rises, and they fall. */
const TIMELINE = [
  '720*loop',
  // The comet: to the first letter, then around all of them.
  `emitters.4.position.x/0*-5*e/70*1.6*e/118*-1.62*h/300*0*${AWAY}/336*3*${BACK}/372*0*${AWAY}/408*-3*${BACK}/444*0*h`,
  `emitters.4.position.y/0*2.4*e/70*1.6*e/118*.4*h/300*.5*e/444*2.6*h`,
  `emitters.4.position.z/0*1.5*e/70*-1.2*e/118*.3*h/300*2*${BACK}/336*.2*${AWAY}/372*-1.6*${BACK}/408*.2*${AWAY}/444*2*h`,
  'emitters.4.perMetre/0*0*h/1*8*h/118*0*h/301*8*h/444*0*h',
  // The camera: close to the first letter, along with the others, and back.
  'camera.azimuth/0*-26*e/108*-16*e/150*-10/228*12*e/300*14*e/444*-14*e/590*6*e/719*-26',
  'camera.elevation/0*20*e/108*7*e/228*6*e/300*11*e/444*15*e/575*8*e/719*20',
  'camera.distance/0*9*e/108*6.6*e/150*6.4/228*6.6*e/290*9.2*e/444*9*e/560*8.6*e/719*9',
  'camera.target.x/0*0*e/108*-1.3*e/228*1*e/290*0',
  'camera.target.y/0*.6*e/108*.7*e/228*.7*e/290*.75*e/719*.6',
  // Light and colours: blue, gold with the letters, and rose.
  'light.azimuth/0*-50*e/228*20*e/444*50*e/719*-50',
  'light.color/0*8ea4ff*e/110*a8b4ff*e/240*ffe6b8*e/460*ffc8b0*e/575*ffd8e8*e/719*8ea4ff',
  'light.intensity/0*.5*e/110*.55*e/240*.95*e/575*.9*e/719*.5',
  'light.ambientColor/0*7484e0*e/240*d8b0e0*e/575*e0a8d0*e/719*7484e0',
  'light.ambient/0*.45*e/240*.8*e/575*.75*e/719*.45',
  'style.smokeColor/0*b8c8ff*e/240*ffe8d0*e/460*ffd0d8*e/719*b8c8ff',
  // Bursts: the letters, the curtain, and the end.
  [
    'burst',
    ...RISES.map((step, letter) => `${step}*${letter}*24`),
    '446*5*70',
    ...FALLS.map((step, letter) => `${step - 4}*${letter}*30`),
  ].join('/'),
].join(';');

const cloud = (index: number, colors: string) =>
  ({
    [`emitters.${index}.look.lifetime`]: 1.4,
    [`emitters.${index}.look.growthTime`]: 0.12,
    [`emitters.${index}.look.sizeCurve`]: '0:.4,.15:1,1:.8',
    [`emitters.${index}.look.densityCurve`]: '0:1,.45:.95,1:0',
    [`emitters.${index}.lifetimeVariation`]: 0.2,

    [`emitters.${index}.look.drag`]: 2.4,
    [`emitters.${index}.look.gravity`]: 0,
    [`emitters.${index}.look.colors`]: colors,
  }) as const;

export const titlePresets: readonly Preset[] = [
  {
    name: 'title',
    values: {
      scene: 'title',
      'emission.rate': 44,
      'emission.lifetime': 4,
      'emission.growthTime': 0.8,
      'emission.company': 0.6,
      'forces.turbulence': 0.5,
      'simulation.maxParticles': 900,
      'puff.turn': 0.6,
      'puff.stretch': 1.5,
      'puff.billow': 0.4,
      'style.simplify': 3,
      'style.form': 0.4,
      'style.inkColor': '#160e2c',
      'style.outlineWidth': 2.8,
      'style.backdrop': '0:6a4a94,.5:3a2c70,1:181442',
      ...cloud(0, '0:c84a54,.35:ff7a66,.75:ffa890'),
      ...cloud(1, '0:d88a2c,.35:ffb848,.75:ffd88a'),
      ...cloud(2, '0:2c94a0,.35:48c4c0,.75:96e8d8'),
      ...cloud(3, '0:7a50b8,.35:a878e8,.75:d0acff'),
      'emitters.4.look.lifetime': 1.1,
      'emitters.4.look.sizeCurve': '0:1,1:.3',
      'emitters.4.look.gravity': 0.3,
      'emitters.4.look.colors': '0:5a8ad8,.35:9cd0ff,.75:e8faff',
      'emitters.5.look.lifetime': 2.4,
      'emitters.5.look.growthTime': 0.3,
      'emitters.5.look.gravity': 0,
      'emitters.5.look.colors': '0:d85c8c,.35:ff9cb4,.75:ffe0d8',
      'emitters.6.look.gravity': 0,
      timeline: TIMELINE,
    },
  },
];
