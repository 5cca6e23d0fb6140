import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { ParameterError } from '../../../src/base/errors.ts';
import type { Value } from '../../../src/parameters/parameter.ts';
import { findParameter, table } from '../../../src/parameters/table.ts';
import {
  eased,
  EMPTY_TIMELINE,
  MAX_BURSTS,
  MAX_KEYFRAMES,
  MAX_LANES,
  MAX_STEP,
  readTimeline,
  requireTimeline,
  TIMELINE,
  timeIn,
  valueAt,
  whyNotAnimated,
  writeTimeline,
  type Easing,
  type Keyframe,
  type Lane,
  type Timeline,
} from '../../../src/parameters/timeline.ts';
import { isAccepted } from '../../../src/parameters/values.ts';
import { findParameter as findWords } from '../../../src/parameters/words/table.ts';
import { valueOf } from '../../support/anyState.ts';

const TEXT =
  '720*loop;emission.rate/0*60/120*240*e/300*20;style.smokeColor/0*ffffff/60*ff8800*h;' +
  'style.outlineWidth/0*2*.25,.1,.25,1/90*4;burst/60*0*24/60*1*10';

const READ: Timeline = {
  length: 720,
  loops: true,
  lanes: [
    {
      key: 'emission.rate',
      keyframes: [
        { step: 0, value: 60, easing: 'linear' },
        { step: 120, value: 240, easing: 'ease' },
        { step: 300, value: 20, easing: 'linear' },
      ],
    },
    {
      key: 'style.smokeColor',
      keyframes: [
        { step: 0, value: '#ffffff', easing: 'linear' },
        { step: 60, value: '#ff8800', easing: 'hold' },
      ],
    },
    {
      key: 'style.outlineWidth',
      keyframes: [
        { step: 0, value: 2, easing: [0.25, 0.1, 0.25, 1] },
        { step: 90, value: 4, easing: 'linear' },
      ],
    },
  ],
  bursts: [
    { step: 60, emitter: 0, count: 24 },
    { step: 60, emitter: 1, count: 10 },
  ],
};

const animated = table.filter(({ key }) => !whyNotAnimated(key));

function laneOf(key: string, ...keyframes: (readonly [step: number, value: Value, easing?: Easing])[]): Lane {
  return { key, keyframes: keyframes.map(([step, value, easing = 'linear']) => ({ step, value, easing })) };
}

// The addition turns -0 into 0, as a text does.
const anyHandle = (min: number, max: number) => fc.double({ min, max, noNaN: true }).map((number) => number + 0);
const anyEasing: fc.Arbitrary<Easing> = fc.oneof(
  fc.constantFrom<Easing>('hold', 'linear', 'ease', 'easeIn', 'easeOut'),
  fc.tuple(anyHandle(0, 1), anyHandle(-2, 3), anyHandle(0, 1), anyHandle(-2, 3)),
);

const anyLane = (key: string): fc.Arbitrary<Lane> =>
  fc
    .uniqueArray(fc.tuple(fc.nat(MAX_STEP), fc.nat(999_999_999), anyEasing), {
      minLength: 1,
      maxLength: 5,
      selector: ([step]) => step,
    })
    .map((frames) => ({
      key,
      keyframes: frames
        .map(([step, share, easing]): Keyframe => ({ step, value: valueOf(findParameter(key)!, share / 1e9), easing }))
        .sort((a, b) => a.step - b.step),
    }));

const anyTimeline: fc.Arbitrary<Timeline> = fc.record({
  length: fc.integer({ min: 1, max: MAX_STEP }),
  loops: fc.boolean(),
  lanes: fc
    .uniqueArray(fc.nat(animated.length - 1), { maxLength: 6 })
    .chain((rows) => fc.tuple(...rows.map((row) => anyLane(animated[row].key)))),
  bursts: fc
    .uniqueArray(
      fc.record({ step: fc.nat(MAX_STEP), emitter: fc.nat(7), count: fc.integer({ min: 1, max: 20_000 }) }),
      { maxLength: 5, selector: ({ step, emitter }) => 8 * step + emitter },
    )
    .map((bursts) => bursts.sort((a, b) => a.step - b.step || a.emitter - b.emitter)),
});

describe('the text of a timeline', () => {
  it('is read part by part', () => {
    expect(readTimeline(TEXT)).toEqual({ timeline: READ, problems: [] });
  });

  it('is empty for the empty timeline only', () => {
    expect(writeTimeline(EMPTY_TIMELINE)).toBe('');
    expect(readTimeline('')).toEqual({ timeline: EMPTY_TIMELINE, problems: [] });
    expect(writeTimeline({ ...EMPTY_TIMELINE, length: 60 })).toBe('60');
  });

  it('returns every timeline, and can stand in a link', () => {
    fc.assert(
      fc.property(anyTimeline, (timeline) => {
        const text = writeTimeline(timeline);
        expect(readTimeline(text)).toEqual({ timeline, problems: [] });
        expect(requireTimeline(timeline)).toEqual(timeline);
        expect(text).toMatch(TIMELINE);
        expect(new URLSearchParams(`timeline=${text}`).get('timeline')).toBe(text);
      }),
    );
  });

  it('sorts keyframes and bursts', () => {
    const { timeline, problems } = readTimeline('60;emission.rate/30*2/0*1;burst/9*1*1/9*0*1/3*0*1');
    expect(problems).toEqual([]);
    expect(timeline.lanes[0].keyframes.map(({ step }) => step)).toEqual([0, 30]);
    expect(timeline.bursts.map(({ step, emitter }) => [step, emitter])).toEqual([
      [3, 0],
      [9, 0],
      [9, 1],
    ]);
  });
});

const many = (count: number, part: (index: number) => string, between: string) =>
  Array.from({ length: count }, (_, index) => part(index)).join(between);
const lists = animated.filter(({ key, kind }) => /^emitters|^vortices/.test(key) && kind === 'number');

/** Text, the number of lanes, keyframes and bursts that remain, and a part of the first problem. */
const HOSTILE: readonly [what: string, text: string, remaining: readonly [number, number, number], problem: string][] =
  [
    ['an unknown key', '60;no.such/0*1;emission.rate/0*1', [1, 1, 0], 'There is no parameter no.such'],
    ['a key of the prototype', '60;__proto__/0*1;constructor/0*1', [0, 0, 0], 'There is no parameter __proto__'],
    ['a fixed parameter', '60;seed/0*1;emission.rate/0*1', [1, 1, 0], 'timeline.seed'],
    ['itself', '60;timeline/0*60', [0, 0, 0], 'timeline.timeline'],
    ['a lane without keyframes', '60;emission.rate', [0, 0, 0], 'at least one keyframe'],
    ['a lane twice', '60;emission.rate/0*1;emission.rate/0*2/1*2', [1, 1, 0], 'one lane'],
    ['a step twice', '60;emission.rate/0*1/0*2', [1, 1, 0], 'one keyframe at a step'],
    ['a negative step', '60;emission.rate/-1*1/2*2', [1, 1, 0], '\u201c-1\u201d'],
    ['a fractional step', '60;emission.rate/1.5*1/2*2', [1, 1, 0], '\u201c1.5\u201d'],
    ['a step after ten minutes', '60;emission.rate/36001*1/2*2', [1, 1, 0], '0 to 36000'],
    ['a word as a number', '60;emission.rate/0*fast/2*2', [1, 1, 0], '\u201cfast\u201d'],
    ['a number out of range', '60;emission.rate/0*1e300', [1, 1, 0], '\u201c1e300\u201d'],
    ['NaN', '60;emission.rate/0*NaN', [0, 0, 0], '\u201cNaN\u201d'],
    ['a colour as script', '60;style.smokeColor/0*<b>', [0, 0, 0], '\u201c<b>\u201d'],
    ['an unknown easing', '60;emission.rate/0*1*bounce', [0, 0, 0], '\u201cbounce\u201d'],
    ['handles out of range', '60;emission.rate/0*1*2,0,0,1', [0, 0, 0], 'x from 0 to 1'],
    ['empty handles', '60;emission.rate/0*1*,,,', [0, 0, 0], 'x1,y1,x2,y2'],
    ['parts too many', '60;emission.rate/0*1*h*h*h', [0, 0, 0], 'a number from'],
    ['a length of 0', '0;emission.rate/0*1', [1, 1, 0], '1 to 36000'],
    ['a length without end', '99999999999999999999;emission.rate/0*1', [1, 1, 0], '1 to 36000'],
    ['only separators', ';;//**;;burst//;burst', [0, 0, 0], 'timeline'],
    ['bursts of nothing and of too much', '60;burst/0*0*0/0*8*1/0*0*20001/5*0*5', [0, 0, 1], 'a count from 1'],
    [
      'too many lanes',
      `9;${many(80, (index) => `${lists[index].key}/0*0`, ';')}`,
      [MAX_LANES, MAX_LANES, 0],
      '64 lanes',
    ],
    ['too many keyframes', `9;emission.rate/${many(600, (index) => `${index}*1`, '/')}`, [1, MAX_KEYFRAMES, 0], '512'],
    ['too many bursts', `9;burst/${many(300, (index) => `${index}*0*1`, '/')}`, [0, 0, MAX_BURSTS], '256 bursts'],
    ['a megabyte', `9;${'emission.rate/0*1;'.repeat(60_000)}`, [1, 1, 0], '16000 characters'],
  ];

describe('a hostile text', () => {
  it.each(HOSTILE)('with %s keeps the rest, says so, and is an error of a caller', (_, text, remaining, problem) => {
    const { timeline, problems } = readTimeline(text);
    const keyframes = timeline.lanes.flatMap((lane) => lane.keyframes);
    expect([timeline.lanes.length, keyframes.length, timeline.bursts.length]).toEqual(remaining);
    expect(problems.join('\n')).toContain(problem);
    expect(problems.every((sentence) => sentence.length < 300)).toBe(true);
    expect(readTimeline(writeTimeline(timeline))).toEqual({ timeline, problems: [] });
    expect(() => requireTimeline(text)).toThrow(ParameterError);
  });
});

const lanes = (...given: unknown[]) => ({ length: 60, loops: false, lanes: given, bursts: [] });
const frames = (...given: unknown[]) => lanes({ key: 'emission.rate', keyframes: given });
const cyclic: Record<string, unknown> = { length: 60 };
cyclic.lanes = [cyclic];

const HOSTILE_OBJECTS: readonly [what: string, given: unknown, place: string][] = [
  ['null', null, 'timeline'],
  ['a number', 5, 'timeline'],
  ['a function', () => {}, 'timeline'],
  ['no length', { lanes: [] }, 'timeline.length'],
  ['a length of infinity', { length: Infinity }, 'timeline.length'],
  ['loops as text', { length: 60, loops: 'yes' }, 'timeline.loops'],
  ['lanes that are no list', { length: 60, lanes: { length: 1e9 } }, 'timeline.lanes'],
  ['a list of a billion lanes', { length: 60, lanes: Array(1e9) }, 'timeline.lanes'],
  ['a lane that is null', lanes(null), 'timeline.lanes'],
  ['a lane that is the timeline', cyclic, 'timeline.lanes.key'],
  ['a key that is an object', lanes({ key: {}, keyframes: [] }), 'timeline.lanes.key'],
  ['a key of the prototype', lanes({ key: '__proto__', keyframes: [] }), 'timeline.__proto__'],
  ['keyframes without end', lanes({ key: 'emission.rate', keyframes: Array(1e9) }), 'timeline.emission.rate'],
  ['a keyframe that is text', frames('0*1'), 'timeline.emission.rate'],
  ['a value of NaN', frames({ step: 0, value: NaN }), 'timeline.emission.rate'],
  ['a value out of range', frames({ step: 0, value: 1e300 }), 'timeline.emission.rate'],
  ['a number as text', frames({ step: 0, value: '60' }), 'timeline.emission.rate'],
  ['a step of NaN', frames({ step: NaN, value: 60 }), 'timeline.emission.rate'],
  ['a step as an object without text', frames({ step: Object.create(null), value: 60 }), 'timeline.emission.rate'],
  ['an easing of five', frames({ step: 0, value: 60, easing: [0, 0, 1, 1, 1] }), 'timeline.emission.rate'],
  ['an easing of NaN', frames({ step: 0, value: 60, easing: [0, NaN, 1, 1] }), 'timeline.emission.rate'],
  ['a burst of a symbol', { length: 60, bursts: [{ step: Symbol('a'), emitter: 0, count: 1 }] }, 'timeline.bursts'],
  [
    'a text that is too long',
    {
      length: 60,
      lanes: ['style.ramp', 'style.ageRamp'].map((key) => ({
        key,
        keyframes: Array.from({ length: 99 }, (_, step) => ({
          step,
          value: many(16, (index) => `${index === 0 ? '0' : `.${100 + index}`}:333344`, ','),
        })),
      })),
    },
    'timeline',
  ],
];

describe('a hostile object', () => {
  it.each(HOSTILE_OBJECTS)('that is or has %s is an error with its place', (_, given, place) => {
    const act = () => requireTimeline(given);
    expect(act).toThrow(ParameterError);
    expect(act).toThrow(expect.objectContaining({ key: place }));
  });

  it('does not stay connected with the timeline', () => {
    const given = frames({ step: 0, value: 60, easing: [0, 0, 1, 1] });
    const timeline = requireTimeline(given);
    (given.lanes as { keyframes: { easing: number[] }[] }[])[0].keyframes[0].easing[0] = 9;
    given.lanes.length = 0;
    expect(timeline.lanes[0].keyframes[0].easing).toEqual([0, 0, 1, 1]);
  });
});

describe('the value of a lane', () => {
  it('is constant before the first and after the last keyframe, and exact at each', () => {
    const lane = laneOf('emission.rate', [10, 60], [20, 0.1 + 0.2, 'ease'], [37, 90.7, [0.3, -2, 0.1, 3]], [40, 7]);
    expect([0, 10, 20, 37, 40, 1e6].map((time) => valueAt(lane, time))).toEqual([60, 60, 0.1 + 0.2, 90.7, 7, 7]);
  });

  it('is on the straight line between keyframes', () => {
    const lane = laneOf('emission.rate', [0, 100], [8, 20]);
    expect([1, 4, 6.5].map((time) => valueAt(lane, time))).toEqual([90, 60, 35]);
  });

  it('holds where it is told to, and where its kind has nothing between', () => {
    expect(valueAt(laneOf('emission.rate', [0, 100, 'hold'], [8, 20]), 7.99)).toBe(100);
    expect(valueAt(laneOf('style.outlines', [0, 1], [8, 0]), 7.99)).toBe(1);
    expect(valueAt(laneOf('style.gradient', [0, 'puff'], [8, 'age']), 7.99)).toBe('puff');
    expect(valueAt(laneOf('style.gradient', [0, 'puff'], [8, 'age']), 8)).toBe('age');
  });

  it('is rounded for whole numbers and for channels of colours', () => {
    expect(valueAt(laneOf('style.shadowDepth', [0, 2], [4, 5]), 1)).toBe(3);
    expect(valueAt(laneOf('style.smokeColor', [0, '#000000'], [4, '#ff8001']), 1)).toBe('#402000');
    expect(valueAt(laneOf('style.smokeColor', [0, '#ff0000', [0.5, 3, 0.5, 3]], [4, '#0000ff']), 2)).toMatch(
      /^#[0-9a-f]{6}$/,
    );
  });

  it('goes stop by stop between ramps and curves with as many stops, and holds otherwise', () => {
    const ramp = (time: number) =>
      valueAt(laneOf('style.ramp', [0, '0:000000,.5:ffffff'], [4, '.4:ff0000,1:ffffff']), time);
    expect(ramp(2)).toBe('.2:800000,.75:ffffff');
    const curve = laneOf('emission.density', [0, '0:1,1:0'], [4, '.5:1,1:1']);
    expect(valueAt(curve, 1)).toBe('.125:1,1:.25');
    expect(valueAt(laneOf('emission.density', [0, '0:1,1:0'], [4, '0:1,.5:1,1:0']), 3)).toBe('0:1,1:0');
    expect(valueAt(laneOf('style.ramp', [0, ''], [4, '0:000000,.5:ffffff']), 3)).toBe('');
    // Three decimals would give both stops one place.
    const close = laneOf('emission.density', [0, '.0001:1,.0002:0'], [4, '.0001:1,.0002:1']);
    expect(valueAt(close, 2)).toBe('.0001:1,.0002:0');
  });

  it('is accepted by the table at any time', () => {
    const anyMoment = fc.tuple(
      fc.nat(animated.length - 1).chain((row) => anyLane(animated[row].key)),
      fc.double({ min: 0, max: MAX_STEP, noNaN: true }),
    );
    fc.assert(
      fc.property(anyMoment, ([lane, time]) => {
        expect(isAccepted(findParameter(lane.key)!, valueAt(lane, time))).toBe(true);
      }),
      { numRuns: 1000 },
    );
  });
});

describe('an easing', () => {
  it('with handles on the diagonal is straight', () => {
    for (const share of [0, 0.1, 0.37, 0.5, 0.9, 1])
      expect(eased([1 / 3, 1 / 3, 2 / 3, 2 / 3], share)).toBeCloseTo(share, 10);
  });

  it('has the closed form of its curve', () => {
    // x = t, so y is the cubic polynomial itself.
    const of = (y1: number, y2: number, t: number) =>
      3 * (1 - t) * (1 - t) * t * y1 + 3 * (1 - t) * t * t * y2 + t * t * t;
    for (const share of [0.2, 0.5, 0.7]) expect(eased([1 / 3, 2, 2 / 3, -1], share)).toBeCloseTo(of(2, -1, share), 9);
  });

  it('starts and ends as its name says', () => {
    const slope = (easing: Easing, at: number) => (eased(easing, at + 0.001) - eased(easing, at)) / 0.001;
    expect(slope('ease', 0)).toBeLessThan(0.05);
    expect(slope('ease', 0.999)).toBeLessThan(0.05);
    expect(slope('easeIn', 0)).toBeLessThan(0.05);
    expect(slope('easeIn', 0.999)).toBeGreaterThan(1.5);
    expect(slope('easeOut', 0)).toBeGreaterThan(1.5);
    expect(slope('easeOut', 0.999)).toBeLessThan(0.05);
    expect(eased('ease', 0.5)).toBeCloseTo(0.5, 9);
  });
});

it('time starts again with a loop, and stays at the end without', () => {
  expect([0, 59.5, 60, 60.25, 185].map((time) => timeIn({ length: 60, loops: true }, time))).toEqual([
    0, 59.5, 0, 0.25, 5,
  ]);
  expect([0, 59.5, 60, 185].map((time) => timeIn({ length: 60, loops: false }, time))).toEqual([0, 59.5, 60, 60]);
});

describe('each row of the table', () => {
  const fixed = table.filter(({ key }) => whyNotAnimated(key)).map(({ key }) => key);

  it('says whether it can be animated', () => {
    const isOfLook = (key: string) => /^emitters\.\d\.look\./.test(key);
    expect(fixed.filter(isOfLook)).toEqual(table.map(({ key }) => key).filter(isOfLook));
    expect(fixed.filter((key) => !isOfLook(key))).toEqual([
      'scene',
      'seed',
      'emission.dissolve',
      'puff.variations',
      'puff.turn',
      'puff.stretch',
      'puff.billow',
      'puff.form',
      'puff.drawing',
      'puff.views',
      'puff.precision',
      'puff.lumpiness',
      'puff.flatness',
      'puff.roughness',
      'puff.lobes',
      'puff.seed',
      'style.volumes',
      'style.pattern',
      'style.renderer',
      'simulation.integrator',
      'simulation.maxParticles',
      'timeline',
      ...Array.from({ length: 8 }, (_, item) => `shapes.${item}.outline`),
    ]);
  });

  it('is fixed if a change makes puffs anew', () => {
    const baked = table.filter(({ key }) => findWords(key)?.isBaked).map(({ key }) => key);
    expect(fixed).toEqual(expect.arrayContaining(baked));
  });

  it('has a reason where it cannot', () => {
    for (const key of [...fixed, 'no.such', '__proto__']) expect(whyNotAnimated(key)).toMatch(/^[A-Z].*\.$/);
  });
});
