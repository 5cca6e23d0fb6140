import { describe, expect, it } from 'vitest';
import { Governor, SCALES } from '../../../src/stage/governor.ts';

const REFRESH = 1000 / 60;
const LOWEST = SCALES.at(-1)!;

/** Frame time in milliseconds, by elapsed time and scale. */
type Load = (seconds: number, scale: number) => number;

/** A machine with a 60 Hz screen: each frame waits for the next refresh. */
class Machine {
  readonly governor = new Governor();
  /** Every change of scale with its time in seconds. */
  readonly changes: { seconds: number; scale: number }[] = [];
  private now = 5_000;
  private readonly load: Load;

  constructor(load: Load) {
    this.load = load;
  }

  run(seconds: number): this {
    const end = this.now + 1000 * seconds;
    while (this.now < end) {
      const before = this.governor.scale;
      this.governor.tick(this.now);
      const { scale } = this.governor;
      if (scale !== before) this.changes.push({ seconds: this.now / 1000 - 5, scale });
      this.now += Math.ceil(this.load(this.now / 1000 - 5, scale) / REFRESH - 1e-6) * REFRESH;
    }
    return this;
  }

  /** Time without frames, as in a hidden tab. */
  sleep(seconds: number): this {
    this.now += 1000 * seconds;
    return this;
  }
}

/** Frame time proportional to the pixels, with this number of milliseconds at full scale. */
function pixels(fullScaleMs: number): Load {
  return (_, scale) => fullScaleMs * scale * scale;
}

describe('Governor', () => {
  it('does not change the scale on a fast machine', () => {
    expect(new Machine(pixels(12)).run(60).changes).toEqual([]);
  });

  it('lowers the scale within two seconds of slow frames, and then keeps the budget', () => {
    const machine = new Machine(pixels(40)).run(2);
    const { scale } = machine.governor;
    expect(40 * scale ** 2).toBeLessThan(22);
    expect(scale).toBeGreaterThan(LOWEST);
  });

  it('lowers the scale within five seconds at two frames a second', () => {
    expect(new Machine(pixels(500)).run(5).governor.scale).toBe(LOWEST);
  });

  it('stops at the lowest scale', () => {
    const machine = new Machine(pixels(400)).run(60);
    expect(machine.governor.scale).toBe(LOWEST);
    expect(machine.changes).toHaveLength(1);
  });

  it('ignores the first frames, long pauses and half a second of load', () => {
    const first = new Machine((seconds) => (seconds < 0.3 ? 90 : 10));
    expect(first.run(20).changes).toEqual([]);
    const pauses = new Machine((seconds) => (Math.floor(seconds * 10) % 15 === 0 ? 160 : 10));
    expect(pauses.run(60).changes).toEqual([]);
    const spikes = new Machine((seconds) => (seconds % 10 > 9.5 ? 60 : 10));
    expect(spikes.run(60).changes).toEqual([]);
  });

  it('ignores time in which nothing is drawn', () => {
    const machine = new Machine(pixels(12));
    for (let round = 0; round < 20; ++round) machine.run(0.35).sleep(40);
    expect(machine.changes).toEqual([]);
    for (let round = 0; round < 20; ++round) {
      machine.run(0.1).sleep(3).governor.pause();
    }
    expect(machine.changes).toEqual([]);
  });

  it('keeps its scale while resting', () => {
    const machine = new Machine(pixels(40)).run(3);
    const { scale } = machine.governor;
    machine.governor.pause();
    machine.sleep(60).run(1);
    expect(machine.governor.scale).toBe(scale);
  });

  it('returns to full scale after the load, one level at a time', () => {
    const machine = new Machine((seconds, scale) => (seconds < 5 ? 80 : 10) * scale * scale).run(60);
    const rise = machine.changes.filter(({ seconds }) => seconds > 5).map(({ scale }) => scale);
    expect(machine.governor.scale).toBe(1);
    expect(rise).toEqual(SCALES.slice(0, rise.length).toReversed());
  });

  it('retries a higher scale less and less often if it fails', () => {
    const machine = new Machine(pixels(40)).run(600);
    expect(machine.changes.filter(({ seconds }) => seconds < 300).length).toBeLessThan(16);
    expect(machine.changes.filter(({ seconds }) => seconds >= 300).length).toBeLessThan(8);
  });

  it('returns to full scale if fewer pixels do not help', () => {
    for (const load of [() => 70, () => 30] as Load[]) {
      const machine = new Machine(load).run(120);
      expect(machine.governor.scale).toBe(1);
      expect(machine.changes.at(-1)!.seconds).toBeLessThan(8);
    }
  });
});
