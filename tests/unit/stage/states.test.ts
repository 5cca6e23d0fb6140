/** The saved states of a stage for seeks: within their budget, and dense around frequent seeks. */
import { describe, expect, it } from 'vitest';
import { SavedStates } from '../../../src/stage/states.ts';

const SIZE = 1000;
const state = (step: number, size = SIZE) => ({ step, bytes: new Uint8Array(size) });

function filled(count: number, budget: number): SavedStates {
  const states = new SavedStates(budget);
  for (let index = 1; index <= count; ++index) states.add(state(60 * index));
  return states;
}

describe('saved states', () => {
  it('returns the latest one that is not later', () => {
    const states = filled(10, 1e6);
    expect(states.latest(59)).toBeUndefined();
    expect(states.latest(60)!.step).toBe(60);
    expect(states.latest(359)!.step).toBe(300);
    expect(states.latest(1e9)!.step).toBe(600);
    expect(states.has(300)).toBe(true);
    expect(states.has(301)).toBe(false);
  });

  it('never exceeds its budget, however long the run', () => {
    const budget = 20.5 * SIZE;
    const states = new SavedStates(budget);
    for (let index = 1; index <= 20_000; ++index) {
      states.add(state(60 * index));
      expect(states.bytes).toBeLessThanOrEqual(budget);
      expect(states.bytes).toBe(states.count * SIZE);
    }
    expect(states.count).toBe(20);
  });

  it('is dense near the present and still reaches far back', () => {
    const states = filled(10_000, 30 * SIZE);
    const now = 600_000;
    expect(states.latest(now)!.step).toBe(now);
    for (const ago of [100, 1000, 10_000, 100_000, 400_000]) {
      const step = states.latest(now - ago)!.step;
      expect(now - ago - step, `${ago} steps ago`).toBeLessThanOrEqual(Math.max(60, 0.6 * ago));
    }
  });

  it('drops states after a change, and releases their memory', () => {
    const states = filled(10, 1e6);
    states.dropFrom(300);
    expect(states.latest(1e9)!.step).toBe(240);
    expect(states.bytes).toBe(4 * SIZE);
    states.add(state(120.5));
    expect(states.latest(121)!.step).toBe(120.5);
    states.clear();
    expect([states.count, states.bytes]).toEqual([0, 0]);
  });

  it('stores no state larger than the budget', () => {
    const states = new SavedStates(SIZE);
    states.add(state(60, SIZE + 1));
    expect(states.count).toBe(0);
    states.add(state(120));
    states.add(state(180));
    expect(states.latest(1e9)!.step).toBe(180);
  });
});
