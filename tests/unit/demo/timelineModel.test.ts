import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import {
  allMarks,
  boxed,
  burstLane,
  burstOf,
  changed,
  copied,
  duplicated,
  existing,
  keyframeOf,
  laneNames,
  markOf,
  moved,
  onGrid,
  pasted,
  placeOf,
  recorded,
  removed,
  snapped,
  stepsOf,
  valuesAt,
  withBurst,
  withKeyframe,
  type Mark,
} from '../../../src/demo/timeline/model.ts';
import {
  EMPTY_TIMELINE,
  MAX_BURSTS,
  MAX_KEYFRAMES,
  MAX_STEP,
  readTimeline,
  writeTimeline,
  type Timeline,
} from '../../../src/parameters/timeline.ts';

const RATE = 'emission.rate';
const TEXT = `600;${RATE}/0*60/120*240*e/300*10;style.smokeColor/60*ff0000/120*0000ff;burst/60*0*24/120*1*8`;
const timeline = readTimeline(TEXT).timeline;
const marks = (...all: Mark[]): ReadonlySet<Mark> => new Set(all);
const of = (text: string): Timeline => readTimeline(text).timeline;
const steps = (after: Timeline, lane = RATE) => stepsOf(after, lane);

/** A timeline with some keyframes and bursts, and some of its marks. */
const anyEdit = fc
  .record({
    rates: fc.uniqueArray(fc.integer({ min: 0, max: 600 }), { minLength: 1, maxLength: 9 }),
    colors: fc.uniqueArray(fc.integer({ min: 0, max: 600 }), { minLength: 1, maxLength: 9 }),
    bursts: fc.uniqueArray(fc.integer({ min: 0, max: 600 }), { minLength: 1, maxLength: 9 }),
    chosen: fc.array(fc.nat(26), { minLength: 1 }),
    by: fc.integer({ min: -700, max: 700 }),
  })
  .map(({ rates, colors, bursts, chosen, by }) => {
    const parts = [
      `${RATE}/${rates.map((step) => `${step}*${step}`).join('/')}`,
      `style.smokeColor/${colors.map((step) => `${step}*ff0000*h`).join('/')}`,
      `burst/${bursts.map((step) => `${step}*2*${step + 1}`).join('/')}`,
    ];
    const before = of(`600;${parts.join(';')}`);
    const all = allMarks(before);
    return { before, selected: new Set(chosen.map((at) => all[at % all.length])), by };
  });

describe('marks', () => {
  it('name the lane and the step of keyframes and bursts', () => {
    expect(laneNames(timeline)).toEqual([RATE, 'style.smokeColor', 'burst.0', 'burst.1']);
    expect(placeOf(markOf(RATE, 120))).toEqual({ lane: RATE, step: 120 });
    expect(keyframeOf(timeline, markOf(RATE, 120))).toEqual({ step: 120, value: 240, easing: 'ease' });
    expect(burstOf(timeline, markOf(burstLane(1), 120))).toEqual({ step: 120, emitter: 1, count: 8 });
    expect(keyframeOf(timeline, markOf(burstLane(1), 120))).toBeUndefined();
    expect(existing(timeline, [markOf(RATE, 120), markOf(RATE, 121)])).toEqual(marks(markOf(RATE, 120)));
  });

  it('are in the order of the table, whatever the order of the lanes is', () => {
    const swapped = { ...timeline, lanes: timeline.lanes.toReversed() };
    expect(laneNames(swapped)).toEqual(laneNames(timeline));
  });

  it('are selected by a box, from any corner', () => {
    const inBox = marks(markOf(RATE, 120), markOf('style.smokeColor', 60), markOf('style.smokeColor', 120));
    const lanes = [RATE, 'style.smokeColor'];
    expect(boxed(timeline, lanes, 60, 120)).toEqual(inBox);
    expect(boxed(timeline, lanes, 120, 60)).toEqual(inBox);
    expect(boxed(timeline, [burstLane(0)], 0, 60)).toEqual(marks(markOf(burstLane(0), 60)));
  });
});

describe('moving', () => {
  it('shifts all marks by the same steps, and back', () => {
    fc.assert(
      fc.property(anyEdit, ({ before, selected, by }) => {
        const chosen = [...selected].map(placeOf);
        const first = Math.min(...chosen.map(({ step }) => step));
        const last = Math.max(...chosen.map(({ step }) => step));
        const { timeline: after, marks: now } = moved(before, selected, by);
        const shift = Math.max(-first, Math.min(by, 600 - last));
        expect(now).toEqual(new Set(chosen.map(({ lane, step }) => markOf(lane, step + shift))));
        for (const { lane, step } of chosen) {
          const { step: _, ...is } =
            keyframeOf(after, markOf(lane, step + shift)) ?? burstOf(after, markOf(lane, step + shift))!;
          const { step: __, ...was } = keyframeOf(before, markOf(lane, step)) ?? burstOf(before, markOf(lane, step))!;
          expect(is).toEqual(was);
        }
        // What was neither moved nor hit is as before.
        const rest = allMarks(before).filter((mark) => !selected.has(mark) && !now.has(mark));
        expect(existing(after, rest)).toEqual(new Set(rest));
        expect(of(writeTimeline(after))).toEqual(after);
      }),
    );
  });

  it('stops at the start and at the end, and replaces what it meets', () => {
    expect(steps(moved(timeline, marks(markOf(RATE, 120)), -500).timeline)).toEqual([0, 300]);
    expect(steps(moved(timeline, marks(markOf(RATE, 120)), 500).timeline)).toEqual([0, 300, 600]);
    const both = moved(timeline, marks(markOf(RATE, 0), markOf(RATE, 300)), -60).timeline;
    expect(steps(both)).toEqual([0, 120, 300]);
    expect(keyframeOf(moved(timeline, marks(markOf(RATE, 0)), 120).timeline, markOf(RATE, 120))!.value).toBe(60);
  });

  it('leaves what is after the end in place', () => {
    const short = { ...timeline, length: 200 };
    expect(moved(short, marks(markOf(RATE, 300)), 60).timeline).toBe(short);
    expect(steps(moved(short, marks(markOf(RATE, 300)), -60).timeline)).toEqual([0, 120, 240]);
  });
});

describe('copies', () => {
  it('keep distances, values and easings, in all lanes', () => {
    const clip = copied(timeline, marks(markOf('style.smokeColor', 60), markOf(RATE, 120), markOf(burstLane(1), 120)));
    const { timeline: after, marks: now, leftOut } = pasted(timeline, clip, 400);
    expect(now).toEqual(marks(markOf('style.smokeColor', 400), markOf(RATE, 460), markOf(burstLane(1), 460)));
    expect(keyframeOf(after, markOf(RATE, 460))).toEqual({ step: 460, value: 240, easing: 'ease' });
    expect(burstOf(after, markOf(burstLane(1), 460))!.count).toBe(8);
    expect(leftOut).toBe(0);
    expect(allMarks(after)).toHaveLength(allMarks(timeline).length + 3);
  });

  it('make the timeline longer, up to ten minutes', () => {
    const clip = copied(timeline, marks(markOf(RATE, 0), markOf(RATE, 120)));
    expect(pasted(timeline, clip, 900).timeline.length).toBe(1020);
    const late = pasted(timeline, clip, MAX_STEP - 60);
    expect([late.timeline.length, late.leftOut]).toEqual([MAX_STEP - 60, 1]);
  });

  it('go behind the originals as duplicates', () => {
    expect(steps(duplicated(timeline, marks(markOf(RATE, 0), markOf(RATE, 120)), 30).timeline)).toEqual([
      0, 120, 150, 270, 300,
    ]);
  });

  it('respect the limits', () => {
    const frames = Array.from({ length: MAX_KEYFRAMES - 1 }, (_, step) => `${step}*1`);
    const full = of(`600;${RATE}/${frames.join('/')}`);
    const clip = copied(full, marks(markOf(RATE, 0), markOf(RATE, 1), markOf(RATE, 2)));
    const { timeline: after, leftOut } = pasted(full, clip, 550);
    expect([steps(after).length, leftOut]).toEqual([MAX_KEYFRAMES, 2]);
    expect(pasted(full, clip, 0).leftOut).toBe(0);
    const bursts = Array.from({ length: MAX_BURSTS }, (_, step) => `${step}*0*1`);
    const busy = of(`600;burst/${bursts.join('/')}`);
    expect(withBurst(busy, { step: 500, emitter: 0, count: 1 }).leftOut).toBe(1);
    expect(withBurst(busy, { step: 5, emitter: 0, count: 9 }).leftOut).toBe(0);
  });
});

describe('changes', () => {
  it('add and replace keyframes and bursts', () => {
    const added = withKeyframe(timeline, 'light.azimuth', { step: 30, value: 5, easing: 'linear' });
    expect(laneNames(added.timeline)).toContain('light.azimuth');
    expect(added.marks).toEqual(marks(markOf('light.azimuth', 30)));
    expect(withKeyframe(timeline, RATE, { step: 700, value: 5, easing: 'linear' }).timeline.length).toBe(700);
    expect(
      burstOf(withBurst(timeline, { step: 60, emitter: 0, count: 3 }).timeline, markOf(burstLane(0), 60))!.count,
    ).toBe(3);
  });

  it('set values, easings and counts of marks only', () => {
    const all = marks(markOf(RATE, 0), markOf(burstLane(0), 60));
    const after = changed(timeline, all, { easing: [0.1, 0, 0.5, 1], count: 5 });
    expect(keyframeOf(after, markOf(RATE, 0))).toEqual({ step: 0, value: 60, easing: [0.1, 0, 0.5, 1] });
    expect(keyframeOf(after, markOf(RATE, 120))).toEqual(keyframeOf(timeline, markOf(RATE, 120)));
    expect(after.bursts.map(({ count }) => count)).toEqual([5, 8]);
    expect(valuesAt(after, 0)[RATE]).toBe(60);
  });

  it('remove marks, and lanes without any', () => {
    const after = removed(timeline, marks(markOf('style.smokeColor', 60), markOf('style.smokeColor', 120)));
    expect(laneNames(after)).toEqual([RATE, 'burst.0', 'burst.1']);
    expect(writeTimeline(removed(timeline, new Set(allMarks(timeline))))).toBe(writeTimeline(EMPTY_TIMELINE));
  });
});

describe('the grid', () => {
  it('has frames and beats', () => {
    expect([0, 1, 2.6, 59.5].map((time) => snapped(time, { name: 'frames', rate: 60 }))).toEqual([0, 1, 3, 60]);
    // 24 frames in 60 steps.
    expect([1, 2, 4, 6].map((time) => snapped(time, { name: 'frames', rate: 24 }))).toEqual([0, 3, 5, 5]);
    expect([0, 14, 16, 44].map((time) => snapped(time, { name: 'beats', bpm: 120 }))).toEqual([0, 0, 30, 30]);
    expect(snapped(999_999, { name: 'beats', bpm: 90 })).toBe(MAX_STEP);
  });

  it('leads on by lines, from any step', () => {
    const grid = { name: 'frames', rate: 24 } as const;
    expect([0, 3, 5, 8].map((step) => onGrid(step, 1, grid))).toEqual([3, 5, 8, 10]);
    expect([10, 8, 5, 3, 0].map((step) => onGrid(step, -1, grid))).toEqual([8, 5, 3, 0, 0]);
    expect([4, 6].map((step) => [onGrid(step, -1, grid), onGrid(step, 1, grid)])).toEqual([
      [3, 5],
      [5, 8],
    ]);
    expect(onGrid(45, 1, { name: 'beats', bpm: 120 })).toBe(60);
  });
});

describe('recording', () => {
  const line = (from: number, to: number, value: (step: number) => number | string) =>
    Array.from({ length: to - from + 1 }, (_, at) => ({ step: from + at, value: value(from + at) }));

  it('needs two keyframes for a straight gesture, and more for a bend', () => {
    const straight = recorded(
      EMPTY_TIMELINE,
      RATE,
      line(0, 60, (step) => step),
      7,
    ).timeline;
    expect(straight.lanes).toEqual([
      {
        key: RATE,
        keyframes: [
          { step: 0, value: 0, easing: 'linear' },
          { step: 60, value: 60, easing: 'ease' },
        ],
      },
    ]);
    const bent = recorded(
      EMPTY_TIMELINE,
      RATE,
      line(0, 100, (step) => 40 * Math.abs(step - 50)),
      7,
    ).timeline;
    expect(steps(bent)).toEqual([0, 50, 100]);
  });

  it('follows any gesture within a hundredth of the range', () => {
    const values = fc.array(fc.integer({ min: 0, max: 2000 }), { minLength: 2, maxLength: 80 });
    fc.assert(
      fc.property(values, (given) => {
        const samples = given.map((value, step) => ({ step, value }));
        const after = recorded(EMPTY_TIMELINE, RATE, samples, 0).timeline;
        for (const { step, value } of samples)
          expect(Math.abs(Number(valuesAt(after, step)[RATE]) - value)).toBeLessThanOrEqual(0.01 * 2000 + 1e-6);
      }),
    );
  });

  it('replaces the keyframes of its time, and keeps the others', () => {
    const after = recorded(
      timeline,
      RATE,
      line(100, 200, () => 5),
      60,
    ).timeline;
    expect(after.lanes.find(({ key }) => key === RATE)!.keyframes).toEqual([
      { step: 0, value: 60, easing: 'linear' },
      { step: 100, value: 5, easing: 'linear' },
      { step: 200, value: 5, easing: 'ease' },
      { step: 300, value: 10, easing: 'linear' },
    ]);
  });

  it('keeps the old value before the first change of a parameter', () => {
    const paused = recorded(EMPTY_TIMELINE, RATE, [{ step: 180, value: 5 }], 60).timeline;
    expect(paused.lanes[0].keyframes.map(({ step, value }) => [step, value])).toEqual([
      [0, 60],
      [180, 5],
    ]);
    const playing = recorded(
      EMPTY_TIMELINE,
      RATE,
      line(180, 200, () => 5),
      60,
    ).timeline;
    expect(playing.lanes[0].keyframes.map(({ step, value }) => [step, value])).toEqual([
      [179, 60],
      [180, 5],
      [200, 5],
    ]);
  });

  it('holds what cannot be blended until it changes', () => {
    const renderer = line(10, 40, (step) => (step < 25 ? 'none' : 'puff'));
    const after = recorded(EMPTY_TIMELINE, 'style.gradient', renderer, 'none').timeline;
    for (const { step, value } of renderer) expect(valuesAt(after, step)['style.gradient']).toBe(value);
    expect(after.lanes[0].keyframes.length).toBeLessThan(7);
  });
});
