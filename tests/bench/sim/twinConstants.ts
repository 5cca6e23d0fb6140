/** Per-step constants of the twin: the same numbers as in sim-wasm/sim/src/forces, with the same rounding. */
import type { Memory } from '../support/snapshot.ts';
import type { ForceValues } from './cloud.ts';

const DT = 1 / 60;
const STRIDE = [0x8da6b343, 0xd8163841, 0xcb1ab31f];
const COMPONENT_VARIANCE = 2 ** 60 / 3;
const CELL_VARIANCE = 46.017793;
/** Side of the lattice's cubes in units of `turbulence.scale`. */
const CELLS = 0.765;
/** Offset of the lattice, so that no corner is at the world origin. */
const SHIFT = 0.37;

/** Constants of one step. The twin has one vortex and one octave of turbulence, and wind along x and z. */
export function constantsOf(values: ForceValues, memory: Memory) {
  return { ...dragOf(values), ...liftOf(values), ...turbulenceOf(values, memory), ...vortexOf(values) };
}

function dragOf(values: ForceValues) {
  const rate = values['drag.rate'];
  const first = -Math.expm1(-rate * DT) / rate;
  return {
    dt: Math.fround(DT),
    kept: Math.fround(Math.exp(-rate * DT)),
    first: Math.fround(first),
    second: Math.fround((DT - first) / rate),
  };
}

function liftOf(values: ForceValues) {
  return {
    gravity: Math.fround(values['gravity.acceleration']),
    buoyancy: Math.fround(values['buoyancy.acceleration']),
    cooling: Math.fround(Math.exp(-DT / values['buoyancy.coolingTime'])),
    windX: Math.fround(values['forces.wind.x']),
    windZ: Math.fround(values['forces.wind.z']),
  };
}

function turbulenceOf(values: ForceValues, { seed, drift, phase }: Memory) {
  const frequency = CELLS / values['turbulence.scale'];
  const straight = drift.map((metres) => metres * frequency);
  const skew = (straight[0] + straight[1] + straight[2]) / 3;
  const cells = straight.map((component) => component + skew + SHIFT);
  const [fractionX, fractionY, fractionZ] = cells.map((cell) => Math.fround(cell - Math.floor(cell)));
  const cycles = phase / (2 * Math.PI);
  return {
    frequency: Math.fround(frequency),
    fractionX,
    fractionY,
    fractionZ,
    key: cells.reduce(
      (sum, cell, axis) => (sum - Math.imul(Math.floor(cell), STRIDE[axis])) | 0,
      Math.imul(seed, 0x9e3779b9),
    ),
    parity: cells.reduce((sum, cell) => (sum - Math.floor(cell)) | 0, 0),
    wave: Math.floor((cycles - Math.floor(cycles)) * 2 ** 32) | 0,
    amplitude: Math.fround(values['turbulence.speed'] / Math.sqrt(COMPONENT_VARIANCE * CELL_VARIANCE)),
  };
}

function vortexOf(values: ForceValues) {
  const axis = (['x', 'y', 'z'] as const).map((name) => values[`vortices.0.axis.${name}`]);
  const length = Math.hypot(...axis);
  const [axisX, axisY, axisZ] = axis.map((component) => Math.fround(component / length));
  const coreSquared = values['vortices.0.coreRadius'] ** 2;
  return {
    axisX,
    axisY,
    axisZ,
    originX: Math.fround(values['vortices.0.position.x']),
    originY: 0,
    originZ: 0,
    swirl: Math.fround(values['vortices.0.circulation'] / (2 * Math.PI * coreSquared)),
    perCore: Math.fround(1 / coreSquared),
    perReach: Math.fround(1 / values['vortices.0.reach'] ** 2),
  };
}
