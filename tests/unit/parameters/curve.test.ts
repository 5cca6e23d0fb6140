import { describe, expect, it } from 'vitest';
import { moved } from '../../../src/demo/panel/curveControl.ts';
import { readCurve, writeCurve, valueAt } from '../../../src/parameters/curve.ts';
import { simulatorValues } from '../../../src/simulator/simulatorValues.ts';

describe('curves', () => {
  it('are read as written', () => {
    const text = '0:1,.25:.875,1:0';
    expect(readCurve(text)).toEqual([
      { at: 0, value: 1 },
      { at: 0.25, value: 0.875 },
      { at: 1, value: 0 },
    ]);
    expect(writeCurve(readCurve(text)!)).toBe(text);
  });

  it('are rejected if malformed', () => {
    const wrong = [
      '',
      '0:1',
      '0:1,0:0',
      '1:0,0:1',
      '0:1,1:2',
      '0:1,1',
      'a:1,1:0',
      '0:1,,1:0',
      '0:-1,1:0',
      '0:1,NaN:0',
      '0:1,1e0:0',
    ];
    const nine = Array.from({ length: 9 }, (_, index) => `.${index + 1}:0`).join();
    for (const text of [...wrong, nine]) expect(readCurve(text), text).toBeUndefined();
  });

  it('are passed to the simulator as eight stops, with the last one repeated', () => {
    const numbers = simulatorValues({ 'emission.density': '0:.5,.5:1,1:0' });
    expect(Object.keys(numbers)).toHaveLength(16);
    expect(numbers).toMatchObject({
      'density.0.value': 0.5,
      'density.1.age': 0.5,
      'density.2.age': 1,
      'density.7.value': 0,
    });
  });

  it('keep the order of their stops while one is moved', () => {
    const stops = readCurve('0:1,.5:.5,1:0')!;
    expect(moved(stops, 1, { at: 2, value: -1 })[1]).toEqual({ at: 0.98, value: 0 });
    expect(moved(stops, 0, { at: -1, value: 3 })[0]).toEqual({ at: 0, value: 1 });
    expect(moved(stops, 2, { at: 0.1, value: 0.3 })[2]).toEqual({ at: 0.52, value: 0.3 });
  });
});

it('has a value at each position, constant before the first stop and after the last', () => {
  const stops = readCurve('.2:.4,.6:1,.8:0')!;
  const values = [0, 0.2, 0.3, 0.6, 0.7, 0.8, 1].map((at) => valueAt(stops, at));
  expect(values.map((value) => Number(value.toFixed(9)))).toEqual([0.4, 0.4, 0.55, 1, 0.5, 0, 0]);
});
