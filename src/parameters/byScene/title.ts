import type { Preset } from '../parameter.ts';

/** Steps at which the letters of the scene jump up, hop for the second time, and fall back. */
const [RISES, HOPS, FALLS] = [[96, 126, 156, 186], [486, 495, 504, 513], [588, 595, 602, 610]] as const; // prettier-ignore

/** Easings of a circle: a sine away from its centre and back to it. */
const [AWAY, BACK] = ['0.39,0.58,0.57,1', '0.47,0,0.75,0.72'];

/** Twelve seconds: a comet flies in, the letters jump up, the comet circles them, a curtain rises, and they fall. */
const TIMELINE = [
  '720*loop',
  // The comet: to the first letter, then around all of them.
  `emitters.4.position.x/0*-5.5*o/56*1.5*i/95*-1.62*h/264*0*${AWAY}/300*2.9*${BACK}/336*0*${AWAY}/372*-2.9*${BACK}/408*0*h`,
  `emitters.4.position.y/0*2.2/56*1.7*i/95*0.4*h/264*0.4*e/408*1.9*h`,
  `emitters.4.position.z/0*-1.6/95*0.3*h/264*2*${BACK}/300*0.2*${AWAY}/336*-1.6*${BACK}/372*0.2*${AWAY}/408*2*h`,
  'emitters.4.perMetre/0*0*h/1*8*h/95*0*h/265*8*h/408*0*h',
  // The camera: close to the first letter, along with the others, and back.
  'camera.azimuth/0*-24*e/88*-15*e/120*-10/188*10*e/260*13*e/440*-13*e/590*5*e/719*-24',
  'camera.elevation/0*15*e/88*6*e/188*6*e/260*9*e/440*13*e/590*7*e/719*15',
  'camera.distance/0*7.9*e/88*5.6*e/188*5.6*e/250*7.6*e/440*7.5*e/560*7.2*e/719*7.9',
  'camera.target.x/0*0*e/88*-1.2*e/188*0.9*e/250*0',
  'camera.target.y/0*0.4*e/88*0.6*e/188*0.6*e/250*0.5*e/330*0.75*e/440*0.6*e/719*0.4',
  // Light and colours: blue, gold with the letters, and rose.
  'light.azimuth/0*-50*e/188*20*e/440*50*e/719*-50',
  'light.color/0*8ea4ff*e/88*b4bcff*e/200*ffe6b8*e/440*ffc8b0*e/580*ffd8e8*e/719*8ea4ff',
  'light.intensity/0*0.5*e/88*0.6*e/200*1*e/580*0.95*e/719*0.5',
  'light.ambientColor/0*7484e0*e/200*d8b0e0*e/580*e0a8d0*e/719*7484e0',
  'light.ambient/0*0.45*e/200*0.85*e/580*0.8*e/719*0.45',
  'style.smokeColor/0*b8c8ff*e/200*ffe8d0*e/440*ffd0d8*e/719*b8c8ff',
  // Bursts: the letters, the curtain, the hops, and the end.
  [
    'burst',
    ...RISES.map((step, letter) => `${step}*${letter}*24`),
    '328*5*64',
    ...HOPS.map((step, letter) => `${step}*${letter}*13`),
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

export const presets: readonly Preset[] = [
  {
    name: 'title',
    values: {
      scene: 'title',
      'emission.rate': 44,
      'emission.lifetime': 4,
      'emission.growthTime': 0.8,
      'emission.company': 0.6,
      // Clouds and the comet are warm and keep their colours in every light; mist is cold.
      'emission.glow': '0:0,.1:.3,.6:.65',
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
