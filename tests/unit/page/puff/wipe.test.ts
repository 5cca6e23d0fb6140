/** `puff.wipe()` where nothing can be drawn, and its options. */
import { afterEach, describe, expect, it, vi } from 'vitest';
import { puff } from '../../../../src/page/puff/puff.ts';
import { requireWipeOptions, type WipeOptions } from '../../../../src/page/puff/options.ts';
import { wipeEmissions } from '../../../../src/page/puff/wipeSmoke.ts';

afterEach(() => vi.unstubAllGlobals());

const PLACES: Readonly<Record<string, () => void>> = {
  'on a server': () => undefined,
  'in a simulated DOM': () => vi.stubGlobal('document', { hidden: false }),
  'with reduced motion': () => {
    vi.stubGlobal('document', { hidden: false });
    vi.stubGlobal('WebGL2RenderingContext', () => undefined);
    vi.stubGlobal('matchMedia', () => ({ matches: true }));
  },
  'in a hidden tab': () => {
    vi.stubGlobal('document', { hidden: true });
    vi.stubGlobal('WebGL2RenderingContext', () => undefined);
    vi.stubGlobal('matchMedia', () => ({ matches: false }));
  },
};

describe.each(Object.entries(PLACES))('%s', (_, enter) => {
  it('changes the page once and resolves after it', async () => {
    enter();
    const done: string[] = [];
    await puff.wipe(undefined, {
      async to() {
        await Promise.resolve();
        done.push('to');
      },
    });
    expect(done).toEqual(['to']);
  });

  it('rejects with the error of the page', async () => {
    enter();
    const to = () => Promise.reject(new RangeError('of the page'));
    await expect(puff.wipe(undefined, { to })).rejects.toThrow('of the page');
  });
});

const nothing = () => undefined;

it.each([
  [undefined, /^to cannot be/],
  [{}, /^to cannot be/],
  [{ to: nothing, duration: 0.1 }, /^duration cannot be 0.1: it takes a number from 0.4 to 10/],
  [{ to: nothing, direction: NaN }, /^direction cannot be NaN/],
  [{ to: nothing, effect: 'boom' }, /^effect cannot be .*The options are to, direction/],
])('rejects %j and names the option', (options, message) => {
  expect(() => requireWipeOptions(options as unknown as WipeOptions)).toThrow(message);
});

it.each([
  [1440, 900],
  [390, 844],
  [7680, 300],
  [40, 40],
])('no place is farther than 0.72 radii from a puff on a canvas of %i x %i', (width, height) => {
  const puffs = wipeEmissions({ width, height, pixelRatio: 1 }, 30, 0.9);
  expect(puffs.length).toBeLessThanOrEqual(384);
  const [halfWidth, halfHeight] = [width / 300, height / 300];
  for (let step = 0; step <= 400; step++) {
    const x = halfWidth * (((step * 0.618) % 1) * 2 - 1);
    const y = halfHeight * ((step / 400) * 2 - 1);
    const nearest = Math.min(...puffs.map((each) => Math.hypot(each.x - x, each.y - y)));
    expect(nearest, `${x}, ${y}`).toBeLessThan(0.72 * puffs[0].size);
  }
});
