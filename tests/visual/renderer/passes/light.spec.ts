/** Smoke against Eq. 2 of McGuire and Fein (2006), K = C (Ka + KL q(max(0, N.L))), with the light of a scene. */
import type { Values } from '../../../../src/parameters/parameter.ts';
import { expect, test } from '../../../support/fixtures.ts';
import type { LampScene, Triple } from './light.cases.ts';

type Cases = typeof import('./light.cases.ts');
const CASES = '/tests/visual/renderer/passes/light.cases.ts';

const LIGHT: Triple = [0.6 / Math.sqrt(0.77), 0.5 / Math.sqrt(0.77), 0.4 / Math.sqrt(0.77)];
/** Ten places of the ball, from full light to the side away from it. */
const PLACES = [
  [0.5, 0.4],
  [0.2, 0.6],
  [0.75, 0.05],
  [0.05, 0.1],
  [-0.35, 0.2],
  [-0.2, -0.4],
  [-0.7, 0.3],
  [-0.55, -0.55],
  [0.1, -0.75],
  [0.45, -0.45],
] as const;

/** What the test knows of a case, as numbers that nothing of the product computes. */
interface Expected {
  /** Tones from shadow to full light: least N.L, and display-encoded colour. */
  tones: readonly (readonly [from: number, color: Triple])[];
  /** KL and Ka relative to the light of the style, linear. */
  k: Triple;
  a: Triple;
  isBlended?: boolean;
  /** Tone of the fill light. */
  filled?: Triple;
  /** Factor on display-encoded colours at a height, radii. */
  gradient?: (height: number) => Triple;
}

const [VIOLET, ROSE, SAND]: readonly Triple[] = [
  [52, 56, 104],
  [140, 96, 150],
  [250, 214, 170],
];
const RAMP = '0:343868,.3:8c6096,.6:fad6aa';
const TONES = [
  [0, VIOLET],
  [0.3, ROSE],
  [0.6, SAND],
] as const;
const WHITE: Triple = [1, 1, 1];

const CASES_OF_LIGHT: readonly (readonly [what: string, values: Values, expected: Expected])[] = [
  ['the light of the style', { 'style.ramp': RAMP }, { tones: TONES, k: WHITE, a: WHITE }],
  [
    'half the key light',
    { 'style.ramp': RAMP, 'light.intensity': 0.5 },
    { tones: TONES, k: [0.5, 0.5, 0.5], a: WHITE },
  ],
  ['a red key light', { 'style.ramp': RAMP, 'light.color': '#ff0000' }, { tones: TONES, k: [1, 0, 0], a: WHITE }],
  ['no ambient light', { 'style.ramp': RAMP, 'light.ambient': 0 }, { tones: TONES, k: WHITE, a: [0, 0, 0] }],
  [
    // Display-encoded 99 and 188 are 0.1248 and 0.5029 in linear light.
    'a strong key light and an ambient light of another colour',
    { 'style.ramp': RAMP, 'light.intensity': 1.5, 'light.ambientColor': '#63bcff', 'light.ambient': 2 },
    { tones: TONES, k: [1.5, 1.5, 1.5], a: [0.2496, 1.0058, 2] },
  ],
  [
    'a blended ramp',
    { 'style.ramp': RAMP, 'style.rampBlend': 1, 'light.intensity': 0.25, 'light.ambient': 0.5 },
    { tones: TONES, isBlended: true, k: [0.25, 0.25, 0.25], a: [0.5, 0.5, 0.5] },
  ],
  [
    'a ramp that gets darker in blue as the light increases',
    { 'style.ramp': '0:5a3cc8,.4:fac850', 'light.intensity': 1.6 },
    {
      tones: [
        [0, [90, 60, 200]],
        [0.4, [250, 200, 80]],
      ],
      k: [1.6, 1.6, 1.6],
      a: WHITE,
    },
  ],
  [
    'a fill light, which stays as it is',
    { 'style.ramp': RAMP, 'style.fill': 0.5, 'light.intensity': 0.3, 'light.ambient': 0.4 },
    { tones: TONES, filled: [151, 135, 137], k: [0.3, 0.3, 0.3], a: [0.4, 0.4, 0.4] },
  ],
  [
    'a fill light on a blended ramp',
    { 'style.ramp': RAMP, 'style.rampBlend': 1, 'style.fill': 0.5, 'light.intensity': 0.3, 'light.ambient': 0.4 },
    { tones: TONES, isBlended: true, filled: [151, 135, 137], k: [0.3, 0.3, 0.3], a: [0.4, 0.4, 0.4] },
  ],
  [
    'a gradient, which multiplies what is displayed',
    {
      'style.ramp': RAMP,
      'style.gradient': 'height',
      'style.gradientColor': '#7d6b55',
      'style.gradientBottom': -0.7,
      'style.gradientTop': 0.7,
      'light.intensity': 0.5,
      'light.ambient': 0.25,
    },
    {
      tones: TONES,
      k: [0.5, 0.5, 0.5],
      a: [0.25, 0.25, 0.25],
      // Half of the brightest tone at the bottom, all of it at the top.
      gradient: (height) => [0.75 + 0.25 * height, 0.75 + 0.25 * height, 0.75 + 0.25 * height],
    },
  ],
];

for (const [what, values, expected] of CASES_OF_LIGHT) {
  test(`ten pixels have the colours of Eq. 2 under ${what}`, async ({ load }) => {
    const cases = await load<Cases>(CASES);
    const samples = await cases.evaluate((module, given) => module.sampled(...given), [PLACES, LIGHT, values] as const);
    expect(samples).toHaveLength(10);
    for (const { normal, color } of samples) {
      const all = colorOf(normal, expected);
      const worst = Math.max(...color.map((channel, at) => Math.abs(channel - all[at])));
      expect.soft(worst, `${what} at ${normal.join()}: ${color.join()} for ${all.join()}`).toBeLessThanOrEqual(1);
    }
    expect.soft(new Set(samples.map(({ color }) => color.join())).size).toBeGreaterThan(1);
  });
}

test('the rim follows the key light, and the backdrop follows none', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const values: Values = { 'style.ramp': RAMP, 'style.rim': 0.6, 'style.rimColor': '#ffc800', 'light.intensity': 0.2 };
  const found = await cases.evaluate((module, given) => module.colorsOf(...given), [LIGHT, values] as const);
  // 0.2 of 1 and of 0.5776: 0.2 and 0.1155, display-encoded 124 and 95.
  expect(Object.keys(found)).toEqual(expect.arrayContaining(['124,95,0,255', '60,90,200,255']));
  expect(found['124,95,0,255']).toBeGreaterThan(500);
  expect(found['60,90,200,255']).toBeGreaterThan(10_000);
});

test('ink follows the light as far as it is told', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const ink: Values = { 'style.outlines': 1, 'style.outlineWidth': 5, 'style.inkColor': '#ffffff' };
  const light: Values = { 'light.color': '#ff0000', 'light.ambient': 0 };
  for (const [inkLight, color] of [
    [0, '255,255,255,255'],
    // Half of red, and nothing of the others.
    [1, '188,0,0,255'],
    // 0.75 of red, and 0.5 of the others.
    [0.5, '225,188,188,255'],
  ] as const) {
    const values = { ...ink, ...light, 'style.inkLight': inkLight };
    const found = await cases.evaluate((module, given) => module.colorsOf(...given), [LIGHT, values] as const);
    expect(found[color], `${inkLight}`).toBeGreaterThan(500);
  }
});

/** A ball 1.3 m from the lamp, two others at more than 2 m, and a wall. The lamp is to be 1.5 m from the centre. */
const BY_LAMP: LampScene = {
  balls: [
    [-0.6, 0.35, 0],
    [0.1, -0.4, 0],
    [0.65, 0.4, -0.2],
  ],
  radius: 0.33,
  wall: -0.6,
  lamp: [-1.2, 0.9, 1],
};
const OF_LAMP: Values = { 'light.distance': 1.5, 'light.decay': 2, 'style.tones': 2 };
/** Places of the wall that no ball covers, metres. */
const ON_WALL = [
  [-0.95, -0.7],
  [-0.9, -0.2],
  [-0.1, 0.7],
  [0.15, 0.1],
  [0.9, -0.1],
  [0.95, -0.75],
] as const;

const CASES_OF_LAMPS: readonly (readonly [what: string, values: Values, expected: Expected])[] = [
  ['by itself', { 'style.ramp': RAMP }, { tones: TONES, k: WHITE, a: WHITE }],
  [
    'that is so strong that near tones are white, but not far ones',
    { 'style.ramp': RAMP, 'light.intensity': 4, 'light.color': '#ffbc63', 'light.ambient': 0.5 },
    { tones: TONES, k: [4, 2.0116, 0.4992], a: [0.5, 0.5, 0.5] },
  ],
  [
    'with a fill light on a blended ramp',
    { 'style.ramp': RAMP, 'style.rampBlend': 1, 'style.fill': 0.5, 'light.intensity': 0.8, 'light.ambient': 0.4 },
    { tones: TONES, isBlended: true, filled: [151, 135, 137], k: [0.8, 0.8, 0.8], a: [0.4, 0.4, 0.4] },
  ],
  [
    'that colours billboards',
    { 'style.ramp': RAMP, 'puff.form': 'billboards', 'light.intensity': 0.8 },
    { tones: TONES, k: [0.8, 0.8, 0.8], a: WHITE },
  ],
];

for (const [what, values, expected] of CASES_OF_LAMPS) {
  test(`smoke and a wall have the colours of Eq. 2 at their distance from a lamp ${what}`, async ({ load }) => {
    const cases = await load<Cases>(CASES);
    const { balls, radius, wall, lamp } = BY_LAMP;
    const onBalls = balls.flatMap((ball) =>
      PLACES.map(([x, y]) => [ball[0] + radius * x, ball[1] + radius * y] as const),
    );
    const input = [BY_LAMP, [...onBalls, ...ON_WALL], { ...OF_LAMP, ...values }] as const;
    const samples = await cases.evaluate((module, given) => module.sampledByLamp(...given), input);
    const isBillboard = values['puff.form'] === 'billboards';
    let compared = 0;
    for (const [index, { middle, color }] of samples.entries()) {
      const ball = balls[Math.floor(index / PLACES.length)];
      // The whole ball has the light at its centre.
      const place: Triple = ball ?? [...middle, wall];
      const way = [0, 1, 2].map((axis) => lamp[axis] - place[axis]);
      const light = way.map((part) => part / Math.hypot(...way)) as unknown as Triple;
      const [x, y] = ball ? middle.map((part, axis) => (part - ball[axis]) / radius) : [0, 0];
      const normal: Triple = [x, y, Math.sqrt(1 - x ** 2 - y ** 2)];
      const f = (1.5 / Math.hypot(...way)) ** 2;
      const k = expected.k.map((factor) => factor * f) as unknown as Triple;
      const own = ball ? { ...expected, k } : { tones: OF_WALL, k, a: expected.a };
      const slack = isBillboard && ball ? 0.03 : 1 / 256;
      if (isAtBorder(normal, own, light, slack)) continue;
      compared++;
      const all = colorOf(normal, own, light);
      const worst = Math.max(...color.map((channel, at) => Math.abs(channel - all[at])));
      expect.soft(worst, `${what} at ${middle.join()}: ${color.join()} for ${all.join()}`).toBeLessThanOrEqual(1);
    }
    expect(compared).toBeGreaterThan(26);
  });
}

/** Display-encoded: white in shadow, and in the light. */
const OF_WALL = [
  [0, [150, 140, 196]],
  [0.5, [255, 255, 255]],
] as const;

test('simplified light has the same tones by a lamp, and the form of the smoke too', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const lamp: Values = {
    ...OF_LAMP,
    'style.ramp': RAMP,
    'light.intensity': 1.5,
    'light.ambient': 0.5,
    'style.rim': 0.5,
  };
  const outlined: Values = { ...lamp, 'style.outlines': 1, 'style.outlineWidth': 4 };
  for (const values of [lamp, outlined, { ...lamp, 'puff.form': 'billboards' } as const]) {
    const input = [BY_LAMP, 6, { ...values, 'style.simplify': 0 }, { ...values, 'style.simplify': 2 }] as const;
    const found = await cases.evaluate((module, given) => module.compareTones(...given), input);
    expect.soft(found.pixels, JSON.stringify(values)).toBeGreaterThan(5000);
    expect.soft(found.worst, JSON.stringify(values)).toBeLessThanOrEqual(2);
  }
  const leaning = await cases.evaluate((module, given) => module.colorsByLamp(...given), [
    BY_LAMP,
    { ...lamp, 'style.simplify': 0.1, 'style.form': 0.01 },
  ] as const);
  // Half of the violet, at every distance from the lamp.
  const shadow = VIOLET.map((channel) => Math.round(encoded(decoded(channel) / 2)));
  expect(leaning[`${shadow.join()},255`]).toBeGreaterThan(500);
});

test('the rim follows the light of a lamp at each puff', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const values: Values = { ...OF_LAMP, 'style.ramp': RAMP, 'style.rim': 0.8, 'style.rimColor': '#ffc800' };
  const found = await cases.evaluate((module, given) => module.colorsByLamp(...given), [BY_LAMP, values] as const);
  for (const ball of BY_LAMP.balls) {
    const f = (1.5 / Math.hypot(...[0, 1, 2].map((axis) => BY_LAMP.lamp[axis] - ball[axis]))) ** 2;
    const [red, green] = [1, decoded(200)].map((light) => Math.round(encoded(Math.min(1, light * f))));
    expect(found[`${red},${green},0,255`], `${red},${green}`).toBeGreaterThan(30);
  }
});

test('light changes continuously while a lamp moves away, simplified or not', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const lamps = Array.from({ length: 60 }, (_, step) => [-0.6, 0.35, 0.8 + 0.05 * step] as const);
  for (const simplify of [0, 2]) {
    const values: Values = { ...OF_LAMP, 'style.ramp': RAMP, 'light.ambient': 0.5, 'style.simplify': simplify };
    const input = [BY_LAMP, lamps, [-0.6, 0.35], values] as const;
    const colors = await cases.evaluate((module, given) => module.colorsAlong(...given), input);
    const steps = colors.slice(1).map((color, at) => color.map((channel, index) => colors[at][index] - channel));
    expect(Math.max(...steps.flat()), `${simplify}`).toBeLessThanOrEqual(16);
    expect(Math.min(...steps.flat())).toBeGreaterThanOrEqual(0);
    expect(colors[0][0] - colors.at(-1)![0]).toBeGreaterThan(100);
  }
});

test('a lamp without decay has the light of the style, and with little decay nearly the same', async ({ load }) => {
  const cases = await load<Cases>(CASES);
  const values: Values = {
    ...OF_LAMP,
    'style.ramp': RAMP,
    'style.rampBlend': 1,
    'style.fill': 0.5,
    'style.rim': 0.5,
    'light.intensity': 0.7,
    'light.ambient': 0.6,
  };
  for (const simplify of [0, 2]) {
    const decays = [0, 1e-5].map((decay) => ({ ...values, 'light.decay': decay, 'style.simplify': simplify }));
    const input = [BY_LAMP, 0, decays[0], decays[1]] as const;
    const found = await cases.evaluate((module, given) => module.compareTones(...given), input);
    expect(found.pixels).toBe(200 * 160);
    expect(found.worst).toBeLessThanOrEqual(simplify === 0 ? 1 : 2);
  }
});

/** Whether a normal is at the border of a tone or of the fill light. */
function isAtBorder(normal: Triple, { tones, filled }: Expected, light: Triple, slack: number): boolean {
  const dot = (other: Triple) => normal[0] * other[0] + normal[1] * other[1] + normal[2] * other[2];
  const isAtFill = filled !== undefined && Math.abs(dot(towardsFill(light)) - 0.65) < 0.01;
  return isAtFill || tones.some(([from]) => Math.abs(dot(light) - from) < slack);
}

function towardsFill([x, y, z]: Triple): Triple {
  const length = Math.hypot(x, 0.4 * y, Math.max(0.3, z));
  return [-x / length, (-0.4 * y) / length, Math.max(0.3, z) / length];
}

/** The colour at a normal by Eq. 2: S a + (T - S) k, with the part of the fill light unchanged. */
function colorOf(normal: Triple, { tones, k, a, isBlended, filled, gradient }: Expected, light = LIGHT): number[] {
  const dot = (other: Triple) => normal[0] * other[0] + normal[1] * other[1] + normal[2] * other[2];
  const facing = Math.floor(256 * Math.max(0, dot(light))) / 256;
  const tone = tones.findLastIndex(([from]) => facing >= from);
  const next = Math.min(tone + 1, tones.length - 1);
  const toNext = isBlended && next > tone ? (facing - tones[tone][0]) / (tones[next][0] - tones[tone][0]) : 0;
  const isFilled = filled !== undefined && tone === 0 && dot(towardsFill(light)) > 0.65;
  return [0, 1, 2].map((channel) => {
    const own = isFilled ? filled[channel] : tones[tone][1][channel];
    const shown = Math.round(own + toNext * (tones[next][1][channel] - own));
    const [s, t] = [decoded(tones[0][1][channel]), decoded(shown)];
    const f = isFilled ? (1 - toNext) * (decoded(filled[channel]) - s) : 0;
    const shownLight = s * a[channel] + (t - s - f) * k[channel] + f;
    return encoded(Math.min(1, Math.max(0, shownLight))) * (gradient?.(normal[1])[channel] ?? 1);
  });
}

function decoded(code: number): number {
  return code / 255 <= 0.04045 ? code / 255 / 12.92 : ((code / 255 + 0.055) / 1.055) ** 2.4;
}

function encoded(light: number): number {
  return 255 * (light <= 0.0031308 ? 12.92 * light : 1.055 * light ** (1 / 2.4) - 0.055);
}
