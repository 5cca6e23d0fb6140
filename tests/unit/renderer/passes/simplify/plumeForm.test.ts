import { Vector3 } from 'three';
import { expect, it } from 'vitest';
import { FORM_CELL, FORM_CELLS, FORM_STEPS } from '../../../../../src/base/constants.ts';
import { PlumeForm, type Particles } from '../../../../../src/renderer/passes/simplify/plumeForm.ts';
import { random } from '../../../../visual/random.ts';

const CENTRE = new Vector3(3, 1, -2);

/** Particles on a lattice in a ball of 1 m about {@link CENTRE}. @param spacing metres */
function ball(spacing = 0.13, shift = 0): number[][] {
  const steps = Array.from({ length: Math.floor(2 / spacing) }, (_, step) => spacing * step - 1 + 0.5 * spacing);
  const places = steps.flatMap((x) => steps.flatMap((y) => steps.map((z) => new Vector3(x, y, z))));
  const inside = places.filter((place) => place.length() < 1);
  return inside.map((place) => [...place.add(CENTRE).addScalar(shift).toArray(), 0.1]);
}

function rowsOf(places: readonly number[][]): Particles {
  return { count: places.length, place: Float32Array.from(places.flat()) };
}

function formOf(...all: readonly (readonly number[][])[]): PlumeForm {
  const form = new PlumeForm();
  for (const places of all) form.fit(rowsOf(places));
  return form;
}

/** The vector in the cell at a place. */
function vectorAt({ texture, fromWorld }: PlumeForm, place: Vector3): Vector3 {
  const [x, y, z] = place.clone().applyMatrix4(fromWorld).multiplyScalar(FORM_CELLS).floor().toArray();
  const first = 4 * (x + FORM_CELLS * (y + FORM_CELLS * z));
  const bytes = texture.image.data as Uint8Array;
  return new Vector3()
    .fromArray(bytes, first)
    .subScalar(FORM_STEPS + 1)
    .divideScalar(FORM_STEPS);
}

function bytesOf(form: PlumeForm): Uint8Array {
  return form.texture.image.data as Uint8Array;
}

function largestChange(form: PlumeForm, other: PlumeForm): number {
  const others = bytesOf(other);
  return bytesOf(form).reduce((most, byte, at) => Math.max(most, Math.abs(byte - others[at])), 0);
}

it('faces away from the middle of a ball on all sides, and nowhere in the middle', () => {
  const form = formOf(ball());
  const next = random(9);
  for (let side = 0; side < 40; side++) {
    const outward = new Vector3(next() - 0.5, next() - 0.5, next() - 0.5).normalize();
    const vector = vectorAt(form, CENTRE.clone().add(outward));
    expect.soft(vector.length()).toBeGreaterThan(0.5);
    expect.soft(vector.normalize().dot(outward)).toBeGreaterThan(0.93);
  }
  expect(vectorAt(form, CENTRE).length()).toBeLessThan(0.15);
  expect(vectorAt(form, CENTRE.clone().addScalar(1.2)).length()).toBeLessThan(0.05);
});

it('reaches four cells around a single particle, and no farther', () => {
  const radius = 0.1;
  const form = formOf([[...CENTRE.toArray(), radius]]);
  const cells = (x: number) => vectorAt(form, new Vector3(FORM_CELL * radius * x, 0, 0).add(CENTRE)).x;
  expect([-4, 4].map((side) => Math.sign(cells(side)))).toEqual([-1, 1]);
  expect([-5, 5].map(cells)).toEqual([0, 0]);
});

it('depends on the particles alone, not on those before', () => {
  expect(largestChange(formOf(ball(0.2), ball(0.13, 0.4), ball(0.2)), formOf(ball(0.2)))).toBe(0);
});

it('changes little when particles move little, are born or die', () => {
  const form = formOf(ball());
  const newborn = [CENTRE.x + 1.5, CENTRE.y, CENTRE.z, 0.01];
  expect(largestChange(form, formOf([...ball(), newborn]))).toBeLessThan(3);
  const moved = ball().map(([x, y, z, radius], index) => [x + (index % 2 ? 0.002 : -0.002), y, z, radius]);
  expect(largestChange(form, formOf(moved))).toBeLessThan(6);
});

it('does not change at once when a single particle leaves the grid', () => {
  const at = (distance: number) => formOf([...ball(), [CENTRE.x + distance, CENTRE.y, CENTRE.z, 0.1]]);
  const steps = Array.from({ length: 24 }, (_, step) => at(1 + 0.05 * step));
  const changes = steps.slice(1).map((form, index) => largestChange(form, steps[index]));
  expect(Math.max(...changes)).toBeLessThan(80);
});

it('has no direction without particles', () => {
  expect(new Set(bytesOf(formOf([])))).toEqual(new Set([FORM_STEPS + 1]));
});
