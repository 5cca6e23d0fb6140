/** Drivers with fake sources: what they measure, and what they set when. */
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { ParameterError, UnsupportedError } from '../../../../src/base/errors.ts';
import {
  driveByAudio,
  driveByMidi,
  driveByPointer,
  driveByScroll,
  type DrivenRanges,
  type Driver,
} from '../../../../src/index.ts';
import type { AnyValues, Values } from '../../../../src/parameters/parameter.ts';
import { FakeContext, FakeElement, FakeMedia, FakeNode, FakePage, spectrum, Target } from './fakePage.ts';

/** Smoke that takes a step in each frame. */
class Smoke {
  stats = { steps: 0 };
  readonly sets: AnyValues[] = [];

  set(values: Values): void {
    this.sets.push(values);
  }

  get values(): AnyValues {
    return Object.assign({}, ...this.sets) as AnyValues;
  }

  step(): void {
    this.stats = { steps: this.stats.steps + 1 };
  }
}

const RATE: DrivenRanges = { 'emission.rate': [0, 256] };
let page: FakePage;
let smoke: Smoke;

beforeEach(() => {
  page = new FakePage();
  smoke = new Smoke();
  FakeContext.isAllowed = true;
});
afterEach(() => vi.unstubAllGlobals());

function frames(count: number, seconds = 1 / 60): void {
  for (let frame = 0; frame < count; ++frame) {
    smoke.step();
    page.frame(seconds);
  }
}

/** A knob of a device that is plugged in. */
class Midi extends Target {
  readonly input = new Target();
  readonly inputs = new Map([['first', this.input]]);

  turn(knob: number, value: number, channel = 1, status = 0xb0): void {
    this.input.emit('midimessage', { data: new Uint8Array([status + channel - 1, knob, value]) });
  }
}

function plugIn(): Midi {
  const midi = new Midi();
  vi.stubGlobal('navigator', { requestMIDIAccess: async () => midi });
  return midi;
}

/** A sound that plays, with an own context. */
function sound(): FakeNode {
  const context = new FakeContext();
  context.state = 'running';
  return new FakeNode(context);
}

type Start = (options: { smoothing: number }) => Driver | Promise<Driver>;
const drivers: readonly (readonly [string, () => readonly [Start, () => void], rate: number])[] = [
  [
    'a page that is scrolled by a quarter',
    () => [(options) => driveByScroll(smoke, { drives: RATE, ...options }), () => page.scrollTo(500)],
    64,
  ],
  [
    'a box that is scrolled by half',
    () => {
      const scroller = new FakeElement();
      const scroll = () => {
        scroller.scrollTop = 1000;
        page.window.emit('scroll');
      };
      return [(options) => driveByScroll(smoke, { drives: RATE, scroller: scroller as never, ...options }), scroll];
    },
    128,
  ],
  [
    'an element of 600 px whose top is at 200 of 1,000 px',
    () => {
      const along = new FakeElement();
      along.box = { top: 5000, height: 600 };
      const scroll = () => {
        along.box = { top: 200, height: 600 };
        page.window.emit('scroll');
      };
      return [(options) => driveByScroll(smoke, { drives: RATE, along: along as never, ...options }), scroll];
    },
    128,
  ],
  [
    'scrolling by 10 px in a frame, of 1,200 px/s',
    () => [
      (options) => driveByScroll(smoke, { drives: RATE, by: 'speed', fullSpeed: 1200, ...options }),
      () => page.scrollTo(page.root.scrollTop + 10),
    ],
    128,
  ],
  [
    'a pointer that moves by 3 and 4 px in a frame, of 1,200 px/s',
    () => {
      const place = { x: 0, y: 0 };
      const move = () => {
        page.move(place.x, place.y);
        page.move((place.x += 3), (place.y += 4));
      };
      return [(options) => driveByPointer(smoke, { drives: RATE, fullSpeed: 1200, ...options }), move];
    },
    64,
  ],
  [
    'two bins of -33 dB, which are -30 dB together, from -60 to 0',
    () => {
      const play = () => [5, 6].forEach((bin) => spectrum.set(bin, 10 * Math.log10(0.0005)));
      return [
        (options) => driveByAudio(smoke, { audio: sound() as never, low: RATE, decibels: [-60, 0], ...options }),
        play,
      ];
    },
    128,
  ],
  [
    'a knob at 127',
    () => {
      const midi = plugIn();
      return [(options) => driveByMidi(smoke, { knobs: { 21: RATE }, ...options }), () => midi.turn(21, 127)];
    },
    256,
  ],
];

describe.each(drivers)('%s', (_, prepare, rate) => {
  it(`sets ${rate} of 0 to 256`, async () => {
    const [start, act] = prepare();
    const driver = await start({ smoothing: 0 });
    act();
    frames(1);
    expect(smoke.values).toEqual({ 'emission.rate': rate });
    driver.stop();
    act();
    frames(3);
    expect(page.isAwake).toBe(false);
    expect(smoke.values).toEqual({ 'emission.rate': rate });
  });

  it('is approached in the time of smoothing', async () => {
    const [start, act] = prepare();
    const driver = await start({ smoothing: 0.1 });
    const isKnob = smoke.sets.length === 0;
    for (let frame = 1; frame <= 12; ++frame) {
      act();
      frames(1);
      // A knob starts where it is.
      const share = isKnob ? 1 : 1 - (0.1 / (0.1 + 1 / 60)) ** frame;
      expect(Math.abs(Number(smoke.values['emission.rate']) - rate * share), `frame ${frame}`).toBeLessThan(0.51);
    }
    driver.stop();
  });
});

describe('a driver', () => {
  it('sets whole levels, at most once a step, and nothing that has not changed', () => {
    driveByScroll(smoke, { drives: { 'emission.rate': [0, 1], 'style.smokeColor': ['#000000', '#ffffff'] } });
    expect(smoke.sets).toEqual([{ 'emission.rate': 0, 'style.smokeColor': '#000000' }]);
    for (const top of [500, 1000, 2000]) {
      page.scrollTo(top);
      page.frame();
    }
    expect(smoke.sets, 'before a step').toHaveLength(1);
    frames(1);
    expect(smoke.sets[1]).toEqual({ 'emission.rate': 1, 'style.smokeColor': '#ffffff' });
    frames(5);
    expect(page.isAwake, 'while nothing moves').toBe(false);
    for (let top = 2000; top > 0; --top) {
      page.scrollTo(top);
      frames(1);
    }
    const levels = smoke.sets.map((values) => Number(values['emission.rate'] ?? 0) * 256);
    expect(levels.every(Number.isInteger)).toBe(true);
    expect(smoke.sets).toHaveLength(2 + 256);
  });

  it('maps to falling ranges, whole numbers and choices', () => {
    const drives: DrivenRanges = {
      'emission.rate': [60, 0],
      'jets.0.rigid': [0, 4],
      'light.kind': ['sun', 'lamp'],
    };
    driveByScroll(smoke, { drives });
    page.scrollTo(1000);
    frames(1);
    expect(smoke.values).toEqual({ 'emission.rate': 30, 'jets.0.rigid': 2, 'light.kind': 'sun' });
    page.scrollTo(9000);
    frames(1);
    expect(smoke.values).toEqual({ 'emission.rate': 0, 'jets.0.rigid': 4, 'light.kind': 'lamp' });
  });

  it('is 0 on a page that cannot scroll', () => {
    page.root.scrollHeight = 1000;
    driveByScroll(smoke, { drives: RATE });
    expect(smoke.sets).toEqual([{ 'emission.rate': 0 }]);
  });

  it('shows the start and stands with reduced motion, until the person allows motion', () => {
    page.stillness.matches = true;
    page.root.scrollTop = 1000;
    driveByScroll(smoke, { drives: RATE });
    page.scrollTo(2000);
    frames(3);
    expect(smoke.sets).toEqual([{ 'emission.rate': 128 }]);
    page.stillness.matches = false;
    page.stillness.emit('change');
    frames(1);
    expect(smoke.values).toEqual({ 'emission.rate': 256 });
  });

  it('of a knob works with reduced motion', async () => {
    page.stillness.matches = true;
    const midi = plugIn();
    await driveByMidi(smoke, { knobs: { 1: RATE } });
    midi.turn(1, 127);
    frames(1);
    expect(smoke.values).toEqual({ 'emission.rate': 256 });
  });

  it('goes on smoothly after the tab was hidden', () => {
    driveByScroll(smoke, { drives: RATE, smoothing: 0.1 });
    page.scrollTo(2000);
    frames(1);
    frames(1, 3600);
    const place = 1 - (0.1 / (0.1 + 1 / 60)) * 0.5;
    expect(smoke.values['emission.rate']).toBe(Math.round(256 * place));
  });

  it('stops by its signal, also before it starts', () => {
    const end = new AbortController();
    driveByScroll(smoke, { drives: RATE, signal: end.signal });
    end.abort();
    driveByScroll(smoke, { drives: RATE, signal: end.signal });
    page.scrollTo(2000);
    frames(1);
    expect(smoke.sets).toEqual([{ 'emission.rate': 0 }]);
  });

  it('stops and reports when a later change fails, and throws when the first one does', () => {
    const errors: unknown[] = [];
    driveByScroll(smoke, { drives: RATE, onError: (error) => errors.push(error) });
    const fault = new Error('disposed');
    smoke.set = () => {
      throw fault;
    };
    page.scrollTo(2000);
    frames(1);
    expect(errors).toEqual([fault]);
    expect(page.isAwake).toBe(false);
    expect(() => driveByScroll(smoke, { drives: RATE })).toThrow(fault);
  });

  it('waits for the answers of a remote stage', async () => {
    const answers: (() => void)[] = [];
    const sets: Values[] = [];
    const remote = {
      stats: async () => smoke.stats,
      set: (values: Values) => {
        sets.push(values);
        return new Promise<void>((resolve) => answers.push(resolve));
      },
    };
    const settle = () => new Promise((resolve) => setImmediate(resolve));
    driveByScroll(remote, { drives: RATE });
    await settle();
    expect(sets).toEqual([{ 'emission.rate': 0 }]);
    page.scrollTo(1000);
    frames(3);
    await settle();
    expect(sets, 'before the answer').toHaveLength(1);
    page.scrollTo(2000);
    answers.pop()!();
    await settle();
    frames(1);
    await settle();
    expect(sets).toEqual([{ 'emission.rate': 0 }, { 'emission.rate': 256 }]);
    answers.pop()!();
    await settle();
    frames(2);
    await settle();
    expect(page.isAwake).toBe(false);
  });
});

describe('sound', () => {
  it('has three bands', () => {
    const audio = sound();
    const driver = driveByAudio(smoke, {
      audio: audio as never,
      low: { 'emission.rate': [0, 256] },
      mid: { 'forces.wind.x': [0, 1] },
      high: { 'gravity.acceleration': [0, 1] },
      smoothing: 0,
    });
    expect(smoke.values).toEqual({ 'emission.rate': 0, 'forces.wind.x': 0, 'gravity.acceleration': 0 });
    // Bins of 20 Hz: 240, 1,980 and 15,980 Hz belong to the bands, 0 Hz and 16,000 Hz do not.
    for (const [bin, key] of [
      [12, 'emission.rate'],
      [99, 'forces.wind.x'],
      [799, 'gravity.acceleration'],
      [0, ''],
      [800, ''],
    ] as const) {
      spectrum.clear();
      spectrum.set(bin, 0);
      frames(1);
      const on = Object.entries(smoke.values).filter(([, value]) => Number(value) > 0);
      expect(on.map(([name]) => name)).toEqual(key ? [key] : []);
    }
    expect(page.isAwake, 'sound comes without events').toBe(true);
    driver.stop();
    expect(audio.outputs.size).toBe(0);
  });

  it('of an element plays as before until a gesture lets it be heard', async () => {
    FakeContext.isAllowed = false;
    spectrum.set(5, 0);
    const element = new FakeMedia();
    const start = () => driveByAudio(smoke, { audio: element as never, low: RATE, smoothing: 0 });
    const driver = start();
    const context = FakeContext.last!;
    element.paused = false;
    element.emit('play');
    element.emit('playing');
    frames(2);
    expect(element.isTaken).toBe(false);
    expect(smoke.values).toEqual({ 'emission.rate': 0 });
    FakeContext.isAllowed = true;
    page.window.emit('pointerup');
    frames(1);
    expect(element.isTaken).toBe(true);
    expect(smoke.values).toEqual({ 'emission.rate': 256 });
    expect(page.isAwake).toBe(true);
    context.become('interrupted');
    frames(2);
    expect(smoke.values).toEqual({ 'emission.rate': 0 });
    expect(page.isAwake).toBe(false);
    driver.stop();
    // Another driver of the same element.
    context.become('running');
    start().stop();
    const taken = new FakeMedia();
    taken.isTaken = true;
    expect(() => driveByAudio(smoke, { audio: taken as never, low: RATE })).toThrow('another AudioContext');
  });
});

describe('knobs', () => {
  it('change nothing before they are turned, and only by messages of controllers on the channel', async () => {
    const midi = plugIn();
    const turned: number[] = [];
    await driveByMidi(smoke, {
      knobs: { 7: RATE, 8: { 'forces.wind.x': [-1, 1] } },
      channel: 2,
      onTurn: (knob) => turned.push(knob),
    });
    midi.turn(7, 127, 1);
    midi.turn(7, 127, 2, 0x90);
    midi.input.emit('midimessage', { data: new Uint8Array([0xb1, 7]) });
    midi.input.emit('midimessage', { data: null });
    frames(1);
    expect(smoke.sets).toEqual([]);
    midi.turn(9, 3, 2);
    midi.turn(8, 127, 2);
    frames(1);
    expect(smoke.sets).toEqual([{ 'forces.wind.x': 1 }]);
    expect(turned).toEqual([9, 8]);
  });

  it('of a device that is plugged in later are heard once', async () => {
    const midi = plugIn();
    const turned: number[] = [];
    const driver = await driveByMidi(smoke, { knobs: { 1: RATE }, onTurn: (knob) => turned.push(knob) });
    const later = new Target();
    midi.inputs.set('later', later);
    midi.emit('statechange');
    midi.emit('statechange');
    later.emit('midimessage', { data: new Uint8Array([0xb0, 1, 127]) });
    midi.turn(1, 0);
    expect(turned).toEqual([1, 1]);
    driver.stop();
    midi.turn(1, 0);
    expect(turned).toHaveLength(2);
  });

  it.each([
    ['are missing', {}, true, 'This browser has no Web MIDI'],
    ['are missing without HTTPS', {}, false, 'served by HTTPS'],
    ['are refused', { requestMIDIAccess: () => Promise.reject(new Error('NotAllowedError')) }, true, 'was refused'],
  ])('%s: the message says what to do', async (_, navigator, isSecure, message) => {
    vi.stubGlobal('navigator', navigator);
    vi.stubGlobal('isSecureContext', isSecure);
    const error = await driveByMidi(smoke, { knobs: { 1: RATE } }).catch((reason: unknown) => reason);
    expect(error).toBeInstanceOf(UnsupportedError);
    expect((error as Error).message).toContain(message);
  });
});

describe('a pointer', () => {
  it('that enters elsewhere has not moved', () => {
    driveByPointer(smoke, { drives: RATE, smoothing: 0 });
    page.move(0);
    page.window.emit('pointerout', { pointerId: 1, pointerType: 'mouse', relatedTarget: {} });
    page.move(10);
    frames(1);
    const moving = smoke.values['emission.rate'];
    expect(moving).toBe(Math.round((256 * 10 * 60) / 2000));
    page.window.emit('pointerout', { pointerId: 1, pointerType: 'mouse', relatedTarget: null });
    page.move(900);
    frames(1);
    expect(smoke.values['emission.rate']).toBe(0);
    page.move(0, 0, { pointerId: 2, pointerType: 'touch' });
    page.window.emit('pointerup', { pointerId: 2, pointerType: 'touch' });
    page.move(900, 0, { pointerId: 2, pointerType: 'touch' });
    frames(1);
    expect(smoke.values['emission.rate']).toBe(0);
  });
});

const all: Record<string, (options: object) => unknown> = {
  driveByScroll: (options) => driveByScroll(smoke, { drives: RATE, ...options }),
  driveByPointer: (options) => driveByPointer(smoke, { drives: RATE, ...options }),
  driveByAudio: (options) => driveByAudio(smoke, { audio: sound() as never, low: RATE, ...options }),
  driveByMidi: (options) => driveByMidi(smoke, { knobs: { 1: RATE }, ...options }),
};
/** Ranges as an option of each call. */
const ranged: Record<string, (ranges: unknown) => object> = {
  driveByScroll: (drives) => ({ drives }),
  driveByPointer: (drives) => ({ drives }),
  driveByAudio: (low) => ({ low }),
  driveByMidi: (ranges) => ({ knobs: { 1: ranges } }),
};

describe.each(Object.keys(all))('%s rejects', (name) => {
  beforeEach(() => void plugIn());

  it.each([
    ['a key that does not exist', { 'emission.speed.up': [0, 1] }, 'emission.speed.up', 'There is no parameter'],
    ['a key whose change compiles shaders', { 'style.volumes': ['receiver', 'counted'] }, 'style.volumes', 'compiles'],
    ['a key whose change bakes puffs', { 'puff.variations': [1, 8] }, 'puff.variations', 'puff shapes'],
    ['a key of the whole smoke', { seed: [1, 8] }, 'seed', 'cannot change'],
    ['NaN', { 'emission.rate': [0, NaN] }, 'emission.rate', 'number from'],
    ['a value outside of the range', { 'emission.rate': [-1, 9] }, 'emission.rate', 'number from'],
    ['a text for a number', { 'emission.rate': ['0', 9] }, 'emission.rate', 'number from'],
    ['no colour', { 'style.smokeColor': ['#fff', '#000000'] }, 'style.smokeColor', 'colour'],
    ['a single value', { 'emission.rate': 9 }, 'emission.rate', 'both ends'],
    ['three values', { 'emission.rate': [1, 2, 3] }, 'emission.rate', 'both ends'],
  ])('%s', async (_, ranges, key, accepted) => {
    const error = await attempt(() => all[name](ranged[name](ranges)));
    expect(error).toBeInstanceOf(ParameterError);
    expect((error as ParameterError).key).toBe(key);
    expect((error as ParameterError).accepted).toContain(accepted);
    expect(smoke.sets).toEqual([]);
    expect(page.isAwake).toBe(false);
  });

  it.each([
    ['smoothing', -1],
    ['smoothing', NaN],
    ['smoothing', 11],
    ['signal', {}],
    ['onError', 3],
  ])('%s: %s', async (option, value) => {
    const error = await attempt(() => all[name]({ [option]: value }));
    expect((error as ParameterError).key).toBe(option);
  });

  it.each([[{}], [[]], [null], [3]])('%o in place of ranges', async (ranges) => {
    expect(await attempt(() => all[name](ranged[name](ranges)))).toBeInstanceOf(ParameterError);
  });

  it('an unknown option', async () => {
    expect(((await attempt(() => all[name]({ key: 1 }))) as ParameterError).key).toBe(`${name}.key`);
  });
});

describe('each driver rejects its own options', () => {
  it.each([
    ['driveByScroll', { by: 'way' }, 'by'],
    ['driveByScroll', { along: 'h1' }, 'along'],
    ['driveByScroll', { scroller: 3 }, 'scroller'],
    ['driveByScroll', { fullSpeed: 0 }, 'fullSpeed'],
    ['driveByPointer', { over: 'h1' }, 'over'],
    ['driveByPointer', { fullSpeed: Infinity }, 'fullSpeed'],
    ['driveByAudio', { audio: 'song.mp3' }, 'audio'],
    ['driveByAudio', { decibels: [0, -60] }, 'decibels'],
    ['driveByAudio', { decibels: [NaN, 0] }, 'decibels'],
    ['driveByAudio', { low: undefined }, 'driveByAudio'],
    ['driveByMidi', { knobs: { 128: RATE } }, 'knobs.128'],
    ['driveByMidi', { knobs: { volume: RATE } }, 'knobs.volume'],
    ['driveByMidi', { knobs: {} }, 'knobs'],
    ['driveByMidi', { channel: 17 }, 'channel'],
    ['driveByMidi', { onTurn: 1 }, 'onTurn'],
  ])('%s: %o', async (name, options, key) => {
    plugIn();
    expect(((await attempt(() => all[name](options))) as ParameterError).key).toBe(key);
  });

  it.each([[undefined], [null], [{}], ['cartoon-smoke']])('%o is no smoke', (given) => {
    expect(() => driveByScroll(given as never, { drives: RATE })).toThrow('a Stage, a CartoonSmoke');
  });
});

async function attempt(act: () => unknown): Promise<unknown> {
  try {
    await act();
    return undefined;
  } catch (error) {
    return error;
  }
}
