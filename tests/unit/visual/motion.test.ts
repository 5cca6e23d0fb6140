import { describe, expect, test } from 'vitest';
import { suddenChange } from '../../visual/motion.ts';
import type { LabPicture } from '../../visual/lab.ts';

const [SIZE, REACH, INK, SKY, RED] = [40, 4, 0xff201710, 0xffd08040, 0xff2020c0];
const strip = { width: 2, ink: INK };

describe('the difference of two pictures', () => {
  test('counts an area that appears at once', () => {
    expect(suddenChange(picture(), picture(rectangle(6, 5, RED)), { reach: REACH, strip })).toEqual({
      all: 30,
      largest: 30,
    });
  });

  test('does not count an area that can have moved there', () => {
    expect(
      suddenChange(picture(rectangle(6, 5, RED, 12)), picture(rectangle(6, 5, RED, 15)), { reach: REACH }),
    ).toEqual({
      all: 0,
      largest: 0,
    });
  });

  test('allows a moving edge to uncover a strip as wide as its motion, and no wider', () => {
    const after = (width: number) => picture(rectangle(width, 20, RED));
    expect(suddenChange(picture(), after(2), { reach: REACH, strip }).largest).toBe(0);
    expect(suddenChange(picture(), after(3), { reach: REACH, strip }).largest).toBe(60);
    expect(suddenChange(picture(), after(2), { reach: REACH }).largest).toBe(40);
  });

  test('counts a line of ink that appears at once, however thin', () => {
    expect(suddenChange(picture(), picture(rectangle(1, 20, INK)), { reach: REACH, strip }).largest).toBe(20);
  });

  test('ignores excluded areas', () => {
    const besides = new Set(Array.from({ length: 12 * SIZE }, (_, pixel) => pixel));
    expect(suddenChange(picture(), picture(rectangle(6, 5, RED)), { reach: REACH, besides }).all).toBe(18);
  });

  test('allows a fading line to turn into the colour of its smoke, and into nothing else', () => {
    const where = new Uint8Array(SIZE * SIZE).fill(1, 0, 20 * SIZE);
    const change = (color: number) =>
      suddenChange(picture(), picture(rectangle(1, 20, color)), { reach: REACH, strip, paling: { where, ink: INK } });
    const halfInked = 0xff784c28;
    expect(change(halfInked).all).toBe(0);
    // The lower half, where no line is faded.
    expect(change(INK).all).toBe(10);
    expect(
      suddenChange(picture(), picture(rectangle(6, 5, RED)), { reach: REACH, paling: { where, ink: INK } }).all,
    ).toBe(30);
  });
});

type Paint = (x: number, y: number) => number | undefined;

function rectangle(width: number, height: number, color: number, left = 12): Paint {
  return (x, y) => (x >= left && x < left + width && y >= 10 && y < 10 + height ? color : undefined);
}

function picture(paint: Paint = () => undefined): LabPicture {
  const colors = Uint32Array.from(
    { length: SIZE * SIZE },
    (_, pixel) => paint(pixel % SIZE, Math.floor(pixel / SIZE)) ?? SKY,
  );
  return { width: SIZE, height: SIZE, pixels: new Uint8Array(colors.buffer), counts: new Uint8Array(0) };
}
