/**
 * The simulator's step in JavaScript, as fast as it would go: what sim.vsJavaScript divides by. Struct of arrays, one
 * loop over all particles, no objects, no calls, all constants in locals. It computes in double precision and rounds
 * where it stores: rounding each operation by Math.fround was measured to be slower.
 *
 * Equations, hashes and the order of the step are those of sim-wasm/sim/src: emission at rest, forces and motion by air
 * and slip, ageing, cooling and death. Only what the comparison needs exists here: exactly one vortex, one octave, no
 * colliders. tests/unit/bench.twin.test.ts holds it against the WASM.
 */
import { FLOAT_COLUMNS, type Memory, type Particles } from '../support/snapshot.ts';
import type { ForceValues } from './cloud.ts';
import { constantsOf } from './twinConstants.ts';

const STRIDE_X = 0x8da6b343 | 0;
const STRIDE_Y = 0xd8163841 | 0;
const STRIDE_Z = 0xcb1ab31f | 0;
const MIX = 0x2c1b3c6d;
const WORLD_RADIUS = 10_000;
/** Adding 1.5 * 2^52 leaves the nearest whole number in the low bits. */
const MAGIC = 6_755_399_441_055_744;
const DEEPEST_POWER = 120;
const POWERS_OF_HALF = Float64Array.from({ length: DEEPEST_POWER + 1 }, (_, n) => 2 ** -n);

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
 * Moves and ages the first `alive` particles and returns how many are left. One function of this length, because
 * what is split up is not always put together again by the compiler, and then pays for calls and memory.
 */
function advance(particles: Particles, alive: number, constants: ReturnType<typeof constantsOf>): number {
  const { x: X, y: Y, z: Z, px: PX, py: PY, pz: PZ, sx: SX, sy: SY, sz: SZ } = particles;
  const { age: AGE, lifetime: LIFETIME, temperature: TEMPERATURE } = particles;
  const { dt, kept, first, second, gravity, buoyancy, cooling, windX, windZ } = constants;
  const { frequency, fractionX, fractionY, fractionZ, key, cosine } = constants;
  const { axisX, axisY, axisZ, originX, originY, originZ, turn, perCore, perReach } = constants;
  const sines = constants.sines;
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

    // Gravity, buoyancy and drag act on the slip.
    const lift = buoyancy * heat - gravity;
    const slippedX = slipX * first;
    const slippedY = slipY * first + lift * second;
    const slippedZ = slipZ * first;

    // Turbulence, half of the last step's displacement ahead.
    const aheadX = (x - PX[i]) * 0.5 + x;
    const aheadY = (y - PY[i]) * 0.5 + y;
    const aheadZ = (z - PZ[i]) * 0.5 + z;
    const inCubesX = aheadX * frequency - fractionX;
    const inCubesY = aheadY * frequency - fractionY;
    const inCubesZ = aheadZ * frequency - fractionZ;
    const cellX = Math.floor(inCubesX);
    const cellY = Math.floor(inCubesY);
    const cellZ = Math.floor(inCubesZ);
    const fx = inCubesX - cellX;
    const fy = inCubesY - cellY;
    const fz = inCubesZ - cellZ;
    const hash = (key + Math.imul(cellX, STRIDE_X) + Math.imul(cellY, STRIDE_Y) + Math.imul(cellZ, STRIDE_Z)) | 0;

    const rx = 1 - fx;
    const ry = 1 - fy;
    const rz = 1 - fz;
    const wx1 = fx * fx * fx * (fx * (fx * 6 - 15) + 10);
    const wy1 = fy * fy * fy * (fy * (fy * 6 - 15) + 10);
    const wz1 = fz * fz * fz * (fz * (fz * 6 - 15) + 10);
    const wx0 = 1 - wx1;
    const wy0 = 1 - wy1;
    const wz0 = 1 - wz1;
    const gx = fx * fx * rx * rx * 15;
    const gy = fy * fy * ry * ry * 15;
    const gz = fz * fz * rz * rz * 15;
    const sx0 = wx0 - gx * fx;
    const sx1 = wx1 - gx * rx;
    const py0 = -gy * fy;
    const py1 = -gy * ry;
    const pz0 = -gz * fz;
    const pz1 = -gz * rz;

    let flowX = 0;
    let flowY = 0;
    let flowZ = 0;
    // The edge along x at y0 z0.
    const w00 = wy0 * wz0;
    const g00y = -gy * wz0;
    const g00z = wy0 * -gz;
    const p00 = py0 * wz0 + wy0 * pz0;
    let h000 = hash;
    h000 = Math.imul(h000 ^ (h000 >>> 15), MIX);
    h000 ^= h000 >>> 15;
    const a000 = h000 << 11;
    const b000 = h000 << 22;
    const s000 = sines[(h000 >>> 12) & 1];
    const x000 = h000 * cosine + a000 * s000;
    const y000 = a000 * cosine + b000 * s000;
    const z000 = b000 * cosine + h000 * s000;
    const f000 = w00 * sx0 + wx0 * p00;
    flowX += x000 * f000;
    flowY += y000 * f000;
    flowZ += z000 * f000;
    const c000 = -gx * w00 * x000 + wx0 * (g00y * y000 + g00z * z000);
    let h100 = (hash + STRIDE_X) | 0;
    h100 = Math.imul(h100 ^ (h100 >>> 15), MIX);
    h100 ^= h100 >>> 15;
    const a100 = h100 << 11;
    const b100 = h100 << 22;
    const s100 = sines[(h100 >>> 12) & 1];
    const x100 = h100 * cosine + a100 * s100;
    const y100 = a100 * cosine + b100 * s100;
    const z100 = b100 * cosine + h100 * s100;
    const f100 = w00 * sx1 + wx1 * p00;
    flowX += x100 * f100;
    flowY += y100 * f100;
    flowZ += z100 * f100;
    const c100 = gx * w00 * x100 + wx1 * (g00y * y100 + g00z * z100);

    // The edge along x at y1 z0.
    const w10 = wy1 * wz0;
    const g10y = gy * wz0;
    const g10z = wy1 * -gz;
    const p10 = py1 * wz0 + wy1 * pz0;
    let h010 = (hash + STRIDE_Y) | 0;
    h010 = Math.imul(h010 ^ (h010 >>> 15), MIX);
    h010 ^= h010 >>> 15;
    const a010 = h010 << 11;
    const b010 = h010 << 22;
    const s010 = sines[(h010 >>> 12) & 1];
    const x010 = h010 * cosine + a010 * s010;
    const y010 = a010 * cosine + b010 * s010;
    const z010 = b010 * cosine + h010 * s010;
    const f010 = w10 * sx0 + wx0 * p10;
    flowX += x010 * f010;
    flowY += y010 * f010;
    flowZ += z010 * f010;
    const c010 = -gx * w10 * x010 + wx0 * (g10y * y010 + g10z * z010);
    let h110 = (hash + STRIDE_X + STRIDE_Y) | 0;
    h110 = Math.imul(h110 ^ (h110 >>> 15), MIX);
    h110 ^= h110 >>> 15;
    const a110 = h110 << 11;
    const b110 = h110 << 22;
    const s110 = sines[(h110 >>> 12) & 1];
    const x110 = h110 * cosine + a110 * s110;
    const y110 = a110 * cosine + b110 * s110;
    const z110 = b110 * cosine + h110 * s110;
    const f110 = w10 * sx1 + wx1 * p10;
    flowX += x110 * f110;
    flowY += y110 * f110;
    flowZ += z110 * f110;
    const c110 = gx * w10 * x110 + wx1 * (g10y * y110 + g10z * z110);

    // The edge along x at y0 z1.
    const w01 = wy0 * wz1;
    const g01y = -gy * wz1;
    const g01z = wy0 * gz;
    const p01 = py0 * wz1 + wy0 * pz1;
    let h001 = (hash + STRIDE_Z) | 0;
    h001 = Math.imul(h001 ^ (h001 >>> 15), MIX);
    h001 ^= h001 >>> 15;
    const a001 = h001 << 11;
    const b001 = h001 << 22;
    const s001 = sines[(h001 >>> 12) & 1];
    const x001 = h001 * cosine + a001 * s001;
    const y001 = a001 * cosine + b001 * s001;
    const z001 = b001 * cosine + h001 * s001;
    const f001 = w01 * sx0 + wx0 * p01;
    flowX += x001 * f001;
    flowY += y001 * f001;
    flowZ += z001 * f001;
    const c001 = -gx * w01 * x001 + wx0 * (g01y * y001 + g01z * z001);
    let h101 = (hash + STRIDE_X + STRIDE_Z) | 0;
    h101 = Math.imul(h101 ^ (h101 >>> 15), MIX);
    h101 ^= h101 >>> 15;
    const a101 = h101 << 11;
    const b101 = h101 << 22;
    const s101 = sines[(h101 >>> 12) & 1];
    const x101 = h101 * cosine + a101 * s101;
    const y101 = a101 * cosine + b101 * s101;
    const z101 = b101 * cosine + h101 * s101;
    const f101 = w01 * sx1 + wx1 * p01;
    flowX += x101 * f101;
    flowY += y101 * f101;
    flowZ += z101 * f101;
    const c101 = gx * w01 * x101 + wx1 * (g01y * y101 + g01z * z101);

    // The edge along x at y1 z1.
    const w11 = wy1 * wz1;
    const g11y = gy * wz1;
    const g11z = wy1 * gz;
    const p11 = py1 * wz1 + wy1 * pz1;
    let h011 = (hash + STRIDE_Y + STRIDE_Z) | 0;
    h011 = Math.imul(h011 ^ (h011 >>> 15), MIX);
    h011 ^= h011 >>> 15;
    const a011 = h011 << 11;
    const b011 = h011 << 22;
    const s011 = sines[(h011 >>> 12) & 1];
    const x011 = h011 * cosine + a011 * s011;
    const y011 = a011 * cosine + b011 * s011;
    const z011 = b011 * cosine + h011 * s011;
    const f011 = w11 * sx0 + wx0 * p11;
    flowX += x011 * f011;
    flowY += y011 * f011;
    flowZ += z011 * f011;
    const c011 = -gx * w11 * x011 + wx0 * (g11y * y011 + g11z * z011);
    let h111 = (hash + STRIDE_X + STRIDE_Y + STRIDE_Z) | 0;
    h111 = Math.imul(h111 ^ (h111 >>> 15), MIX);
    h111 ^= h111 >>> 15;
    const a111 = h111 << 11;
    const b111 = h111 << 22;
    const s111 = sines[(h111 >>> 12) & 1];
    const x111 = h111 * cosine + a111 * s111;
    const y111 = a111 * cosine + b111 * s111;
    const z111 = b111 * cosine + h111 * s111;
    const f111 = w11 * sx1 + wx1 * p11;
    flowX += x111 * f111;
    flowY += y111 * f111;
    flowZ += z111 * f111;
    const c111 = gx * w11 * x111 + wx1 * (g11y * y111 + g11z * z111);

    const lowerX = c000 + c010 + c001 + c011;
    const upperX = c100 + c110 + c101 + c111;
    const upperY = c010 + c110 + c011 + c111;
    const upperZ = c001 + c101 + c011 + c111;
    const all = lowerX + upperX;
    flowX = flowX - fx * all + upperX + windX;
    flowY = flowY - fy * all + upperY;
    flowZ = flowZ - fz * all + upperZ + windZ;

    // The vortex: its speed where turbulence was taken, its direction in the middle of the step.
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
      let dividend = turn * beyond * beyond * quarter;
      let divisor = 1;
      if (q < 0.01) {
        dividend *= 1 - q * (0.5 - q * (1 / 6));
      } else {
        const exponent = (q < 80 ? q : 80) * Math.LOG2E;
        const whole = exponent + MAGIC - MAGIC;
        const f = whole - exponent;
        const ff = f * f;
        const series =
          1 +
          Math.LN2 * f +
          ff * (0.2402265 + 0.05550411 * f + ff * (0.009618129 + 0.0013333558 * f + ff * 0.0001540353));
        dividend *= 1 - series * POWERS_OF_HALF[whole];
        divisor = q;
      }
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
    const older = AGE[i] + dt;
    PX[i] = x;
    PY[i] = y;
    PZ[i] = z;
    X[i] = movedX;
    Y[i] = movedY;
    Z[i] = movedZ;
    SX[i] = slipX * kept;
    SY[i] = slipY * kept + lift * first;
    SZ[i] = slipZ * kept;
    AGE[i] = older;
    TEMPERATURE[i] = heat * cooling;
    const distance = movedX * movedX + movedY * movedY + movedZ * movedZ;
    if (!(older < LIFETIME[i] && distance <= WORLD_RADIUS * WORLD_RADIUS)) {
      alive--;
      bury(particles, i, alive);
    }
  }
  return alive;
}

/** Puts the last living particle into the place of a dead one. */
function bury(particles: Particles, dead: number, last: number): void {
  for (const name of FLOAT_COLUMNS) particles[name][dead] = particles[name][last];
  particles.look[dead] = particles.look[last];
}

/** The largest difference between two sets of particles in place (m), slip (m/s), age (s) and temperature. */
export function largestDifference(one: Particles, other: Particles): number {
  let largest = 0;
  for (const name of ['x', 'y', 'z', 'px', 'py', 'pz', 'sx', 'sy', 'sz', 'age', 'temperature'] as const) {
    one[name].forEach((value, i) => (largest = Math.max(largest, Math.abs(value - other[name][i]))));
  }
  return largest;
}
