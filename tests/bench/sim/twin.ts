/**
 * The simulator's step in optimized JavaScript: the reference of sim.vsJavaScript. Struct of arrays, one loop over all
 * particles, no objects, no calls, all constants in locals. It computes in double precision and rounds on store:
 * rounding each operation with Math.fround is slower by measurement.
 *
 * Equations, hashes and order of the step are those of sim-wasm/sim/src: emission at rest, forces, motion by air and
 * slip, ageing, cooling and expiry. It only has the features of the comparison: exactly one vortex, one octave, no
 * colliders. tests/unit/bench/twin.test.ts compares it with the WASM.
 */
import { FLOAT_COLUMNS, type Memory, type Particles } from '../support/snapshot.ts';
import type { ForceValues } from './cloud.ts';
import { constantsOf } from './twinConstants.ts';

const STRIDE_X = 0x8da6b343 | 0;
const STRIDE_Y = 0xd8163841 | 0;
const STRIDE_Z = 0xcb1ab31f | 0;
const MIX = 0x2c1b3c6d;
const SIDE = Math.fround(Math.sqrt(6));
const HALF_WAVE = 2 ** 30;
const WORLD_RADIUS = 10_000;
/** Squared distance in core radii beyond which a vortex is a free one. */
const END_OF_CORE = 12.75;

export class TwinSimulator {
  readonly particles: Particles;
  alive: number;
  private readonly values: ForceValues;
  private readonly memory: Memory;

  constructor(values: ForceValues, memory: Memory, particles: Particles) {
    this.values = values;
    this.memory = { ...memory, drift: [...memory.drift] };
    this.particles = particles;
    this.alive = particles.x.length;
  }

  /** Advances by 1/60 s. */
  step(): void {
    const { values, memory } = this;
    this.alive = advance(this.particles, this.alive, constantsOf(values, memory));
    memory.drift[0] += values['forces.wind.x'] / 60;
    memory.drift[2] += values['forces.wind.z'] / 60;
    memory.phase += values['turbulence.evolution'] / 60;
  }
}

/**
 * Moves and ages the first `alive` particles and returns the number of remaining ones. It is one long function, because
 * the compiler does not always inline smaller ones, which then cost calls and memory access.
 */
function advance(particles: Particles, alive: number, constants: ReturnType<typeof constantsOf>): number {
  const { x: X, y: Y, z: Z, px: PX, py: PY, pz: PZ, sx: SX, sy: SY, sz: SZ } = particles;
  const { age: AGE, lifetime: LIFETIME, temperature: TEMPERATURE } = particles;
  const { dt, kept, first, second, gravity, buoyancy, cooling, windX, windZ } = constants;
  const { frequency, fractionX, fractionY, fractionZ, key, parity, wave, amplitude } = constants;
  const { axisX, axisY, axisZ, originX, originY, originZ, swirl, perCore, perReach } = constants;
  const quarter = dt * 0.25;
  const perQuarter = 1 / quarter;

  for (let i = alive - 1; i >= 0; i--) {
    const x = X[i];
    const y = Y[i];
    const z = Z[i];
    const slipX = SX[i];
    const slipY = SY[i];
    const slipZ = SZ[i];
    const heat = TEMPERATURE[i];

    // Gravity, buoyancy and drag change the slip.
    const lift = buoyancy * heat - gravity;
    const slippedX = slipX * first;
    const slippedY = slipY * first + lift * second;
    const slippedZ = slipZ * first;

    // Turbulence, sampled half of the last step's displacement ahead.
    const aheadX = (x - PX[i]) * 0.5 + x;
    const aheadY = (y - PY[i]) * 0.5 + y;
    const aheadZ = (z - PZ[i]) * 0.5 + z;
    const skew = (aheadX + aheadY + aheadZ) * (1 / 3);
    const cellsX = (aheadX + skew) * frequency - fractionX;
    const cellsY = (aheadY + skew) * frequency - fractionY;
    const cellsZ = (aheadZ + skew) * frequency - fractionZ;
    const cellX = Math.floor(cellsX);
    const cellY = Math.floor(cellsY);
    const cellZ = Math.floor(cellsZ);
    const fx = cellsX - cellX;
    const fy = cellsY - cellY;
    const fz = cellsZ - cellZ;
    const hash0 = (key + Math.imul(cellX, STRIDE_X) + Math.imul(cellY, STRIDE_Y) + Math.imul(cellZ, STRIDE_Z)) | 0;
    const hash3 = (hash0 + STRIDE_X + STRIDE_Y + STRIDE_Z) | 0;
    const sense = 1 - 2 * ((cellX + cellY + cellZ + parity) & 1);

    // Offsets from the corners of the tetrahedron to the position. The largest and the smallest fraction select two
    // corners.
    const lean = (fx + fy + fz) * (SIDE / 6);
    const x0 = fx * SIDE - lean;
    const y0 = fy * SIDE - lean;
    const z0 = fz * SIDE - lean;
    let x1 = x0 + SIDE / 6;
    let y1 = y0 + SIDE / 6;
    let z1 = z0 + SIDE / 6;
    let x2 = x0 - SIDE / 1.5;
    let y2 = y0 - SIDE / 1.5;
    let z2 = z0 - SIDE / 1.5;
    let hash1 = hash0;
    let hash2 = hash3;
    if (fx >= fy && fx >= fz) {
      x1 -= SIDE;
      hash1 += STRIDE_X;
    } else if (fy >= fz) {
      y1 -= SIDE;
      hash1 += STRIDE_Y;
    } else {
      z1 -= SIDE;
      hash1 += STRIDE_Z;
    }
    if (fx >= fz && fy >= fz) {
      z2 += SIDE;
      hash2 -= STRIDE_Z;
    } else if (fx >= fy) {
      y2 += SIDE;
      hash2 -= STRIDE_Y;
    } else {
      x2 += SIDE;
      hash2 -= STRIDE_X;
    }
    const x3 = x0 - SIDE / 2;
    const y3 = y0 - SIDE / 2;
    const z3 = z0 - SIDE / 2;

    let flowX = 0;
    let flowY = 0;
    let flowZ = 0;

    // The first corner.
    const s0 = x0 * x0 + y0 * y0 + z0 * z0;
    if (s0 < 3) {
      let h = hash0;
      h = Math.imul(h ^ (h >>> 15), MIX);
      h ^= h >>> 15;
      const t = 3 - s0;
      const tt = t * t;
      const vx = (Math.abs((h + wave) | 0) - HALF_WAVE) * tt;
      const vy = (Math.abs(((h << 11) + wave) | 0) - HALF_WAVE) * tt;
      const vz = (Math.abs(((h << 22) + wave) | 0) - HALF_WAVE) * tt;
      const straight = 0.5 - s0 * (2 / 3);
      const along = (x0 * vx + y0 * vy + z0 * vz) * 0.5;
      flowX += vx * straight + x0 * along + (y0 * vz - z0 * vy) * sense;
      flowY += vy * straight + y0 * along + (z0 * vx - x0 * vz) * sense;
      flowZ += vz * straight + z0 * along + (x0 * vy - y0 * vx) * sense;
    }

    // The second.
    const s1 = x1 * x1 + y1 * y1 + z1 * z1;
    if (s1 < 3) {
      let h = hash1;
      h = Math.imul(h ^ (h >>> 15), MIX);
      h ^= h >>> 15;
      const t = 3 - s1;
      const tt = t * t;
      const vx = (Math.abs((h + wave) | 0) - HALF_WAVE) * tt;
      const vy = (Math.abs(((h << 11) + wave) | 0) - HALF_WAVE) * tt;
      const vz = (Math.abs(((h << 22) + wave) | 0) - HALF_WAVE) * tt;
      const straight = 0.5 - s1 * (2 / 3);
      const along = (x1 * vx + y1 * vy + z1 * vz) * 0.5;
      flowX += vx * straight + x1 * along - (y1 * vz - z1 * vy) * sense;
      flowY += vy * straight + y1 * along - (z1 * vx - x1 * vz) * sense;
      flowZ += vz * straight + z1 * along - (x1 * vy - y1 * vx) * sense;
    }

    // The third.
    const s2 = x2 * x2 + y2 * y2 + z2 * z2;
    if (s2 < 3) {
      let h = hash2;
      h = Math.imul(h ^ (h >>> 15), MIX);
      h ^= h >>> 15;
      const t = 3 - s2;
      const tt = t * t;
      const vx = (Math.abs((h + wave) | 0) - HALF_WAVE) * tt;
      const vy = (Math.abs(((h << 11) + wave) | 0) - HALF_WAVE) * tt;
      const vz = (Math.abs(((h << 22) + wave) | 0) - HALF_WAVE) * tt;
      const straight = 0.5 - s2 * (2 / 3);
      const along = (x2 * vx + y2 * vy + z2 * vz) * 0.5;
      flowX += vx * straight + x2 * along + (y2 * vz - z2 * vy) * sense;
      flowY += vy * straight + y2 * along + (z2 * vx - x2 * vz) * sense;
      flowZ += vz * straight + z2 * along + (x2 * vy - y2 * vx) * sense;
    }

    // The last.
    const s3 = x3 * x3 + y3 * y3 + z3 * z3;
    if (s3 < 3) {
      let h = hash3;
      h = Math.imul(h ^ (h >>> 15), MIX);
      h ^= h >>> 15;
      const t = 3 - s3;
      const tt = t * t;
      const vx = (Math.abs((h + wave) | 0) - HALF_WAVE) * tt;
      const vy = (Math.abs(((h << 11) + wave) | 0) - HALF_WAVE) * tt;
      const vz = (Math.abs(((h << 22) + wave) | 0) - HALF_WAVE) * tt;
      const straight = 0.5 - s3 * (2 / 3);
      const along = (x3 * vx + y3 * vy + z3 * vz) * 0.5;
      flowX += vx * straight + x3 * along - (y3 * vz - z3 * vy) * sense;
      flowY += vy * straight + y3 * along - (z3 * vx - x3 * vz) * sense;
      flowZ += vz * straight + z3 * along - (x3 * vy - y3 * vx) * sense;
    }

    flowX = flowX * amplitude + windX;
    flowY = flowY * amplitude;
    flowZ = flowZ * amplitude + windZ;

    // The vortex: speed at the sampling position of the turbulence, direction at the middle of the step.
    const offX = aheadX - originX;
    const offY = aheadY - originY;
    const offZ = aheadZ - originZ;
    const aroundX = axisY * offZ - axisZ * offY;
    const aroundY = axisZ * offX - axisX * offZ;
    const aroundZ = axisX * offY - axisY * offX;
    const squared = aroundX * aroundX + aroundY * aroundY + aroundZ * aroundZ;
    const beyond = 1 - squared * perReach;
    if (beyond > 0) {
      const q = squared * perCore;
      let divisor = q;
      if (q < END_OF_CORE) {
        const left = 1 - q / END_OF_CORE;
        const square = left * left;
        divisor += square * square * square * (1 + q * (-0.029029946 + q * (-0.024458739 + q * 0.0034428624)));
      }
      const dividend = swirl * beyond * beyond * quarter;
      const share = dividend / (divisor * divisor + dividend * dividend);
      const sine = divisor * share;
      const cosineLack = dividend * share;
      const fromX = x - originX;
      const fromY = y - originY;
      const fromZ = z - originZ;
      const acrossX = axisY * fromZ - axisZ * fromY;
      const acrossY = axisZ * fromX - axisX * fromZ;
      const acrossZ = axisX * fromY - axisY * fromX;
      const middleX =
        fromX + (flowX * dt + slippedX) * 0.5 + 2 * (acrossX * sine + (axisY * acrossZ - axisZ * acrossY) * cosineLack);
      const middleY =
        fromY + (flowY * dt + slippedY) * 0.5 + 2 * (acrossY * sine + (axisZ * acrossX - axisX * acrossZ) * cosineLack);
      const middleZ =
        fromZ + (flowZ * dt + slippedZ) * 0.5 + 2 * (acrossZ * sine + (axisX * acrossY - axisY * acrossX) * cosineLack);
      const speed = sine * perQuarter;
      flowX += (axisY * middleZ - axisZ * middleY) * speed;
      flowY += (axisZ * middleX - axisX * middleZ) * speed;
      flowZ += (axisX * middleY - axisY * middleX) * speed;
    }

    const movedX = x + flowX * dt + slippedX;
    const movedY = y + flowY * dt + slippedY;
    const movedZ = z + flowZ * dt + slippedZ;
    const old = AGE[i];
    PX[i] = x;
    PY[i] = y;
    PZ[i] = z;
    X[i] = movedX;
    Y[i] = movedY;
    Z[i] = movedZ;
    SX[i] = slipX * kept;
    SY[i] = slipY * kept + lift * first;
    SZ[i] = slipZ * kept;
    AGE[i] = old + dt;
    TEMPERATURE[i] = heat * cooling;
    const distance = movedX * movedX + movedY * movedY + movedZ * movedZ;
    if (!(old < LIFETIME[i] && distance <= WORLD_RADIUS * WORLD_RADIUS)) {
      alive--;
      bury(particles, i, alive);
    }
  }
  return alive;
}

/** Moves the last living particle to the index of an expired one. */
function bury(particles: Particles, dead: number, last: number): void {
  for (const name of FLOAT_COLUMNS) particles[name][dead] = particles[name][last];
  particles.attributes[dead] = particles.attributes[last];
}

/** The largest difference between two sets of particles in position (m), slip (m/s), age (s) and temperature. */
export function largestDifference(one: Particles, other: Particles): number {
  let largest = 0;
  for (const name of ['x', 'y', 'z', 'px', 'py', 'pz', 'sx', 'sy', 'sz', 'age', 'temperature'] as const) {
    one[name].forEach((value, i) => (largest = Math.max(largest, Math.abs(value - other[name][i]))));
  }
  return largest;
}
