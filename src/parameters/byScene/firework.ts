import type { Preset } from '../parameter.ts';

/** Where the three shells burst, by emitter: x, height and depth. */
const [LEFT, RIGHT, TOP] = [[-1.75, 3.4, 0], [1.75, 3.9, -0.2], [0, 4.3, 0.1]] as const; // prettier-ignore

/** Steps at which shells burst. The last three are the finale. */
const SHELLS = [
  { at: 62, emitter: 1, place: LEFT },
  { at: 132, emitter: 2, place: RIGHT },
  { at: 212, emitter: 3, place: TOP },
  { at: 300, emitter: 1, place: LEFT },
  { at: 322, emitter: 2, place: RIGHT },
  { at: 346, emitter: 3, place: TOP },
] as const;
const FINALE = 3;
const LENGTH = 480;
/** Steps for which a shell rises. */
const RISE = 46;
/** Particles of a burst, of its sparks and of its core. */
const COUNTS = { 1: 30, 2: 30, 3: 46 } as const;
const [SPARKS, CORE] = [36, 14];

/** Each shell rises with a trail and bursts in a shell, a core and sparks. In the finale one rises for all three. */
function timeline(): string {
  const rising = SHELLS.slice(0, FINALE + 1);
  const lane = (key: string, frames: readonly string[]): string => [key, ...frames].join('/');
  const along = (axis: 0 | 1 | 2, from: number) =>
    rising.flatMap(({ at, place }) => [`${at - RISE}*${from}*o`, `${at}*${place[axis]}*h`]);
  const held = (axis: 0 | 1 | 2) => SHELLS.map(({ at, place }) => `${at - 1}*${place[axis]}*h`);
  const trail = rising.flatMap(({ at }) => [`${at - RISE + 1}*11*h`, `${at}*0*h`]);
  const bursts = SHELLS.flatMap(({ at, emitter }) => [
    `${at}*${emitter}*${COUNTS[emitter]}`,
    `${at}*4*${SPARKS}`,
    `${at + 1}*5*${CORE}`,
  ]);
  return [
    `${LENGTH}*loop`,
    lane('emitters.0.position.x', along(0, 0)),
    lane('emitters.0.position.y', along(1, 0.6)),
    lane('emitters.0.perMetre', trail),
    ...[4, 5].flatMap((emitter) => [
      lane(`emitters.${emitter}.position.x`, held(0)),
      lane(`emitters.${emitter}.position.y`, held(1)),
    ]),
    lane('burst', bursts),
  ].join(';');
}

const shell = (index: number, colors: string, heatColors: string) =>
  ({
    [`emitters.${index}.look.lifetime`]: 1.5,
    [`emitters.${index}.look.growthTime`]: 0.12,
    [`emitters.${index}.look.sizeCurve`]: '0:.8,.1:1,.45:.9,1:.25',
    [`emitters.${index}.look.densityCurve`]: '0:1,.7:1,1:0',
    [`emitters.${index}.look.drag`]: 2.6,
    [`emitters.${index}.look.gravity`]: 0.6,
    [`emitters.${index}.look.colors`]: colors,
    [`emitters.${index}.look.heatColors`]: heatColors,
    [`emitters.${index}.lifetimeVariation`]: 0.15,
  }) as const;

export const presets: readonly Preset[] = [
  {
    name: 'firework',
    values: {
      scene: 'firework',
      'emission.rate': 0,
      'emission.lifetime': 1.6,
      'emission.growthTime': 0.12,
      'emission.glow': '0:.55,.4:1',
      'simulation.maxParticles': 900,
      'puff.lumpiness': 0.3,
      'puff.roughness': 0.3,
      'puff.stretch': 2.4,
      'style.simplify': 3,
      'style.softColors': 1,
      'style.ramp': '0:b8a0c8,.3:ffffff',
      'style.inkColor': '#120c24',
      'style.outlineWidth': 2.6,
      'style.backdrop': '0:4a3e86,.45:262a68,1:10123a',
      'light.azimuth': -20,
      'light.elevation': 50,
      'light.color': '#9cb0ff',
      'light.intensity': 0.5,
      'light.ambientColor': '#7484e0',
      'light.ambient': 0.34,
      ...shell(1, '0:d83a5c,.3:ffffff', '0:d03a64,.2:e8485c,.5:ff6a5c,.85:ffd0a0,1:fff4d8'),
      ...shell(2, '0:4a8ad8,.3:ffffff', '0:2c8cd8,.2:34b0e4,.5:48d8e8,.85:b0fff0,1:f0fff8'),
      ...shell(3, '0:f0b060,.3:ffffff', '0:d8742c,.2:f09a34,.5:ffc044,.85:ffe890,1:fffbe0'),
      'emitters.3.look.lifetime': 2.1,
      'emitters.3.look.gravity': 1.6,
      'emitters.3.look.sizeCurve': '0:.8,.1:1,.4:.75,1:.1',
      'emitters.3.speed': 6.2,
      'emitters.3.size': 0.27,
      ...shell(5, '0:b060d8,.3:ffffff', '0:9448d8,.2:b458e8,.5:d880f4,.85:f8d0ff,1:fff4ff'),
      'emitters.5.speed': 2.2,
      'emitters.5.look.lifetime': 1.1,
      'emitters.0.speedVariation': 0.5,
      'emitters.0.look.lifetime': 0.8,
      'emitters.0.look.sizeCurve': '0:1,1:.15',
      'emitters.0.look.heatColors': '0:c05a3c,.4:ff9c48,.8:ffe8a0,1:fffbe8',
      'emitters.4.speed': 7.5,
      'emitters.4.speedVariation': 0.5,
      'emitters.4.size': 0.1,
      'emitters.4.sizeVariation': 0.4,
      'emitters.4.look.lifetime': 1.9,
      'emitters.4.look.growthTime': 0.05,
      'emitters.4.look.drag': 2,
      'emitters.4.look.gravity': 2.6,
      'emitters.4.look.heatColors': '0:f0a050,.4:ffe090,1:fffdf0',
      'emitters.4.look.inkWeight': 0.6,
      timeline: timeline(),
    },
  },
];
