/** Statistics of the benchmark rounds. */
import { describe, expect, it } from 'vitest';
import { figure, type Figure } from '../../bench/support/figures.ts';
import { median, ratios, slope, spread } from '../../bench/support/statistics.ts';
import { meanDistance, type Contestant } from '../../bench/sim/contestant.ts';
import { interleave, type Plan } from '../../bench/sim/rounds.ts';

// Not a literal path, because plain JavaScript has no types here.
const path = '../../bench/sim/costsTable.mjs';
const { costsTable } = (await import(path)) as {
  costsTable(figures: Pick<Figure, 'name' | 'value' | 'unit'>[]): string | undefined;
};

describe('rounds become figures', () => {
  it('by their median, in any order, with the minimum and the maximum', () => {
    const rounds = [10, 2, 9, 30, 1];
    expect(figure('a.b', 'x', rounds, 'n')).toEqual({
      name: 'a.b',
      value: 9,
      unit: 'x',
      range: [1, 30],
      rounds: 5,
      note: 'n',
    });
    expect(rounds).toEqual([10, 2, 9, 30, 1]);
    expect(median([4, 10, 1, 2])).toBe(3);
  });

  it('by ratios within a round', () => {
    expect(ratios([6, 20], [3, 40])).toEqual([2, 0.5]);
    expect(() => ratios([1, 2], [1])).toThrow('2 rounds');
  });

  it('by the slope of a straight line, without symmetric noise', () => {
    expect(slope([7, 10, 13, 16])).toBeCloseTo(3, 12);
    // By the normal equations: (-1.5 * 1 - 0.5 * 3 + 0.5 * 2 + 1.5 * 8) / 5.
    expect(slope([1, 3, 2, 8])).toBeCloseTo(2, 12);
    expect(slope([5, 5, 5])).toBe(0);
  });

  it('by their spread', () => {
    expect(spread([6, 2, 3])).toBe(3);
  });
});

describe('distances', () => {
  it('are per particle, not of the sum', () => {
    const there = Float32Array.of(3, 4, 0, -1, 0, 0);
    expect(meanDistance(new Float32Array(6), there)).toBe(3);
  });
});

/** Reports `cost` milliseconds per step. */
class Clockwork implements Contestant {
  readonly name: string;
  restarts = 0;
  private readonly log: string[];
  private readonly cost: number;

  constructor(name: string, cost: number, log: string[]) {
    this.name = name;
    this.cost = cost;
    this.log = log;
  }

  restart(): void {
    this.restarts++;
  }

  advance(steps: number): Promise<number> {
    this.log.push(this.name);
    return Promise.resolve(steps * this.cost);
  }

  dispose(): void {}
}

describe('interleaved slices', () => {
  const plan: Plan = { rounds: 3, share: 40, warming: 50, slice: 10, cost: 'mean' };

  it('give nanoseconds per particle and step at any machine speed', async () => {
    const log: string[] = [];
    const [quick, slow] = [new Clockwork('quick', 0.5, log), new Clockwork('slow', 100, log)];
    const costs = await interleave([quick, slow], [1000, 500], plan, 'test');
    expect(costs.quick).toHaveLength(3);
    for (const cost of costs.quick) expect(cost).toBeCloseTo(500, 9);
    for (const cost of costs.slow) expect(cost).toBeCloseTo(200_000, 6);
    expect([quick.restarts, slow.restarts]).toEqual([4, 4]);
  });

  it('cost the mean of their slices, or the cheapest', async () => {
    // After warm-up runs of one and of ten steps each round has four slices of ten steps.
    const moody = () => {
      let slice = 0;
      return {
        name: 'moody',
        restart() {},
        advance: (steps: number) => (slice++ < 6 ? steps : steps * [2, 6, 3, 5][(slice - 7) % 4]),
        dispose() {},
      };
    };
    expect((await interleave([moody()], [1000], plan, 'test')).moody).toEqual([4000, 4000, 4000]);
    expect((await interleave([moody()], [1000], { ...plan, cost: 'cheapest' }, 'test')).moody).toEqual([
      2000, 2000, 2000,
    ]);
  });

  it('alternate the first contestant, and never run one of them in a single block', async () => {
    const log: string[] = [];
    await interleave([new Clockwork('a', 1, log), new Clockwork('b', 1, log)], [1, 1], plan, 'test');
    const played = log.slice(-24);
    expect(played).toHaveLength(24);
    expect(played.join('')).not.toMatch(/aaa|bbb/);
    expect(played.filter((name, i) => i % 2 === 0 && name === 'b').length).toBe(6);
  });
});

describe('the table of costs', () => {
  it('has a row for each contestant, sorted numbers, and a note for missing measurements', () => {
    const cost = (name: string, value: number) => ({ name: `sim.cost.${name}`, value, unit: 'ns/particle' });
    const table = costsTable([
      cost('us.10000', 2.345),
      cost('us.1000', 1),
      cost('them.1000', 70.04),
      { name: 'sim.vsThem', value: 70, unit: 'x' },
    ]);
    expect(table?.split('\n').map((line) => line.trim().split(/ {2,}/))).toEqual([
      ['ns a particle and step', '1,000', '10,000'],
      ['us', '1.00', '2.35'],
      ['them', '70.0', 'not measured'],
    ]);
    expect(costsTable([{ name: 'render.frame', value: 1, unit: 'ms' }])).toBeUndefined();
  });
});
