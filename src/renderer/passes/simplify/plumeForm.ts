import { ClampToEdgeWrapping, Data3DTexture, LinearFilter, Matrix4, NoColorSpace, Vector3 } from 'three';
import {
  FORM_CELL,
  FORM_CELLS,
  FORM_EMPTY,
  FORM_FADING,
  FORM_FAINT,
  FORM_MARGIN,
  FORM_ROUNDS,
  FORM_SLOPE,
  FORM_SPREAD,
  FORM_STEPS,
} from '../../../base/constants.ts';

/** Places and radii of all particles: four floats for each. */
export interface Particles {
  readonly count: number;
  readonly place: Float32Array;
}

const [ROW, LAYER] = [FORM_CELLS, FORM_CELLS * FORM_CELLS];
const STRIDES = [1, ROW, LAYER];
/** Cells along each axis that a particle reaches: one by its spline, one in each round of smoothing, one by gradients. */
const REACH = 2 + FORM_ROUNDS;

/**
 * Which way the outside of the whole smoke faces at each place: the direction in which the density of particles falls, as a
 * texture. It depends only on the particles, and continuously: the grid has its middle at their centre of mass, its size
 * follows from their spread, and each particle counts by its volume, so that births and deaths change little.
 */
export class PlumeForm {
  /** Vectors of length 0 to 1: 0 where the density is even or where there is no smoke. See simplify/tones.frag. */
  readonly texture = new Data3DTexture(new Uint8Array(4 * FORM_CELLS ** 3), FORM_CELLS, FORM_CELLS, FORM_CELLS);
  /** From world space to coordinates of the texture. */
  readonly fromWorld = new Matrix4();
  private readonly corner = new Vector3();
  private cell = 1;
  private density = new Float32Array(FORM_CELLS ** 3);
  private smoothed = new Float32Array(FORM_CELLS ** 3);
  /** First and last column, row and layer that particles reach. Most of the grid around a tall plume is empty. */
  private readonly first = [0, 0, 0];
  private readonly last = [0, 0, 0];

  constructor() {
    this.texture.colorSpace = NoColorSpace;
    this.texture.minFilter = this.texture.magFilter = LinearFilter;
    this.texture.wrapR = this.texture.wrapS = this.texture.wrapT = ClampToEdgeWrapping;
  }

  /** Takes the form of these particles. */
  fit(particles: Particles): void {
    const radius = this.place(particles);
    this.density.fill(0);
    this.smoothed.fill(0);
    this.first.fill(FORM_CELLS);
    this.last.fill(-1);
    for (let particle = 0; particle < particles.count; particle++) this.add(particles.place, 4 * particle);
    for (let round = 0; round < FORM_ROUNDS; round++) for (const stride of STRIDES) this.smooth(stride);
    this.write(FORM_FAINT * radius ** 3);
    this.texture.needsUpdate = true;
  }

  dispose(): void {
    this.texture.dispose();
  }

  /** Places the grid, and returns the mean radius. */
  private place({ count, place }: Particles): number {
    const [sum, squares] = [new Vector3(), new Vector3()];
    let [mass, radii] = [0, 0];
    const at = new Vector3();
    for (let particle = 0; particle < count; particle++) {
      const radius = place[4 * particle + 3];
      const volume = radius ** 3;
      at.fromArray(place, 4 * particle);
      mass += volume;
      radii += volume * radius;
      sum.addScaledVector(at, volume);
      squares.addScaledVector(at.multiply(at), volume);
    }
    mass ||= 1;
    const mean = sum.divideScalar(mass);
    const spread = (axis: 'x' | 'y' | 'z') => Math.sqrt(Math.max(0, squares[axis] / mass - mean[axis] ** 2));
    const radius = radii / mass || 1;
    const half = FORM_SPREAD * Math.max(spread('x'), spread('y'), spread('z')) + FORM_MARGIN * radius;
    this.cell = Math.max(FORM_CELL * radius, (2 * half) / (FORM_CELLS - 1));
    this.corner.copy(mean).subScalar(0.5 * FORM_CELLS * this.cell);
    const scale = 1 / (FORM_CELLS * this.cell);
    this.fromWorld.makeScale(scale, scale, scale).setPosition(this.corner.clone().multiplyScalar(-scale));
    return radius;
  }

  /** Spreads the volume of a particle over 27 cells, by quadratic B-splines. */
  private add(place: Float32Array, at: number): void {
    const { density, corner, cell } = this;
    const [x, y, z] = [
      (place[at] - corner.x) / cell,
      (place[at + 1] - corner.y) / cell,
      (place[at + 2] - corner.z) / cell,
    ];
    const fade = (Math.min(x, y, z, FORM_CELLS - x, FORM_CELLS - y, FORM_CELLS - z) - FORM_EMPTY) / FORM_FADING;
    if (fade <= 0) return;
    const volume = Math.min(1, fade) * place[at + 3] ** 3;
    const [column, row, layer] = [Math.floor(x), Math.floor(y), Math.floor(z)];
    this.extendRange([column, row, layer]);
    const [across, up, through] = [splines(x - column), splines(y - row), splines(z - layer)];
    for (let k = 0; k < 3; k++) {
      for (let j = 0; j < 3; j++) {
        const share = volume * through[k] * up[j];
        const first = (layer + k - 1) * LAYER + (row + j - 1) * ROW + column - 1;
        for (let i = 0; i < 3; i++) density[first + i] += share * across[i];
      }
    }
  }

  /** Extends the range to the cells around a particle. The outermost cells of the grid lack a neighbour and stay empty. */
  private extendRange(cell: readonly number[]): void {
    const { first, last } = this;
    for (let axis = 0; axis < 3; axis++) {
      first[axis] = Math.min(first[axis], Math.max(1, cell[axis] - REACH));
      last[axis] = Math.max(last[axis], Math.min(FORM_CELLS - 2, cell[axis] + REACH));
    }
  }

  /** Calls a function with the first and the last cell of each row that particles reach. */
  private forEachRow(take: (from: number, to: number) => void): void {
    const { first, last } = this;
    for (let layer = first[2]; layer <= last[2]; layer++) {
      for (let row = first[1]; row <= last[1]; row++) {
        const start = layer * LAYER + row * ROW;
        take(start + first[0], start + last[0]);
      }
    }
  }

  /** Averages neighbours along an axis, 1 : 2 : 1. */
  private smooth(stride: number): void {
    const { density, smoothed } = this;
    this.forEachRow((from, to) => {
      for (let at = from; at <= to; at++)
        smoothed[at] = 0.25 * (density[at - stride] + density[at + stride]) + 0.5 * density[at];
    });
    this.density = smoothed;
    this.smoothed = density;
  }

  private write(faint: number): void {
    const { density } = this;
    const data = this.texture.image.data as Uint8Array;
    data.fill(FORM_STEPS + 1);
    const slope = 0.5 * FORM_SLOPE;
    const [steps, middle] = [FORM_STEPS * slope, FORM_STEPS + 1.5];
    this.forEachRow((from, to) => {
      for (let at = from; at <= to; at++) {
        const x = density[at - 1] - density[at + 1];
        const y = density[at - ROW] - density[at + ROW];
        const z = density[at - LAYER] - density[at + LAYER];
        const all = density[at] + faint;
        // Vectors are at most of length 1.
        const factor = steps / Math.max(all, slope * Math.sqrt(x * x + y * y + z * z));
        data[4 * at] = middle + factor * x;
        data[4 * at + 1] = middle + factor * y;
        data[4 * at + 2] = middle + factor * z;
      }
    });
  }
}

/** Shares of a cell and of its neighbours. @param place in the cell, 0..1 */
function splines(place: number): [number, number, number] {
  const rest = 1 - place;
  return [0.5 * rest * rest, 0.5 + place * rest, 0.5 * place * place];
}
