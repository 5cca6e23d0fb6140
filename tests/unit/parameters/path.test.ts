import { beforeAll, describe, expect, it } from 'vitest';
import { readTimeline, valueAt } from '../../../src/parameters/timeline.ts';
import { MAX_POINTS, PATH, readPath, writePath, type PathPoint } from '../../../src/parameters/path.ts';
import type { SimulatorFactory } from '../../../src/simulator/load.ts';
import { simulatorValues, valuesIn } from '../../../src/simulator/simulatorValues.ts';
import { loadVariant } from '../../support/sim/simWasm.ts';

const KEY = 'flows.0.points';

describe('paths', () => {
  it('are read as written', () => {
    const points: PathPoint[] = [
      [-0.8, 0, 0.125],
      [12, -99.999, 1.5],
    ];
    expect(writePath(points)).toBe('-.8:0:.125,12:-99.999:1.5');
    expect(readPath(writePath(points))).toEqual(points);
    expect(writePath([[-0.0001, 1.0004, 0.0006]])).toBe('0:1:.001');
    expect(readPath('')).toEqual([]);
  });

  it('are rejected if malformed', () => {
    const many = Array.from({ length: MAX_POINTS + 1 }, () => '0:0:0');
    expect(PATH.test(many.slice(1).join())).toBe(true);
    const wrong = [
      '0:0:0',
      '0:0:0,',
      '0:0,1:1',
      '0:0:0,1:1:100',
      '0:0:0,1:1:.0001',
      '0:0:0,1:1:1e1',
      '0:0:0,1:1:-',
      'a',
    ];
    for (const text of [...wrong, many.join()]) expect(PATH.test(text), text).toBe(false);
  });

  it('move from keyframe to keyframe, if these have equally many points', () => {
    const [lane, other] = readTimeline(
      `60;${KEY}/0*0:0:0,1:1:1/40*0:2:0,1:1:-3;flows.1.points/0*0:0:0,1:1:1/40*0:0:0,1:1:1,2:2:2`,
    ).timeline.lanes;
    expect(valueAt(lane, 10)).toBe('0:.5:0,1:1:0');
    expect(valueAt(other, 10)).toBe('0:0:0,1:1:1');
  });
});

describe('the simulator', () => {
  let factory: SimulatorFactory;
  beforeAll(async () => {
    factory = await loadVariant('meshes');
  });

  it('returns each path, and forgets points that are gone', () => {
    const simulator = factory.create({ capacity: 4, seed: 1 });
    for (const path of ['-99.999:99.999:-.001,.001:0:99.999,1:-2:3', '0:0:0,.5:.25:-.125', '']) {
      const values = { [KEY]: path, 'flows.0.speed': 1 };
      simulator.set(simulatorValues(values));
      expect(valuesIn(simulator, values, {})).toMatchObject(path ? values : { 'flows.0.speed': 1 });
      expect(valuesIn(simulator, {}, {})).toMatchObject({ 'flows.0.speed': 1, ...(path && { [KEY]: path }) });
    }
    simulator.dispose();
  });
});
