/**
 * The scenario of `sim-wasm/sim/tests/collide_fixture.txt`, for Node and for pages. The crate's own test runs it
 * natively; all platforms must produce the same hashes.
 */
import type { SimulatorFactory } from '../../../src/simulator/load.ts';
import type { RigidDescription, RigidShape } from '../../../src/simulator/rigid.ts';
import type { Simulator } from '../../../src/simulator/simulator.ts';

const KINDS = ['fixed', 'kinematic', 'dynamic'] as const;

/** The rest of each line that starts with a word. */
export function linesOf(fixture: string, word: string): string[] {
  const found = fixture.split('\n').filter((line) => line.startsWith(word));
  return found.map((line) => line.slice(word.length).trim());
}

/** The hash after the scenario without its rigids. */
export function hashWithoutRigids(factory: SimulatorFactory, fixture: string): string {
  const simulator = start(factory, fixture);
  simulator.step(stepsOf(fixture));
  return end(simulator);
}

/** The hash after the scenario with its rigids, the first of which moves. */
export function hashWithRigids(factory: SimulatorFactory, fixture: string): string {
  const simulator = start(factory, fixture);
  for (const line of linesOf(fixture, 'rigid ')) simulator.addRigid(rigidOf(line));
  for (let step = 0; step < stepsOf(fixture); step++) {
    simulator.moveRigid(0, [-1 + step / 128, 0.75, 0]);
    simulator.step();
  }
  return end(simulator);
}

/** The hash after the scenario with its meshes, both of which move and turn, restored without them. */
export function hashWithMeshes(factory: SimulatorFactory, fixture: string): string {
  const simulator = start(factory, fixture);
  for (const line of linesOf(fixture, 'mesh ')) {
    const [[boundaryLayer], vertices, indices] = line.split(' | ').map((part) => part.split(' ').map(Number));
    const shape = { type: 'trimesh', vertices, indices } as const;
    simulator.addRigid({ kind: 'kinematic', shape, position: [-1, 0.75, 0], boundaryLayer });
  }
  for (let step = 0; step < stepsOf(fixture); step++) {
    const x = step / 128;
    for (let index = 0; index < 2; index++) simulator.moveRigid(index, [x - 1, 0.75 + index / 2, 0], [x, 0.5, 0.25, 1]);
    simulator.step();
  }
  simulator.restore(simulator.save(), false);
  return end(simulator);
}

/** The hash after the scenario with its colliders outside the table, all of which move and turn. */
export function hashWithColliders(factory: SimulatorFactory, fixture: string): string {
  const simulator = start(factory, fixture);
  linesOf(fixture, 'collider ').forEach((line, index) =>
    simulator.setCollider(index, Float32Array.from(line.split(' '), Number)),
  );
  for (let step = 0; step < stepsOf(fixture); step++) {
    const x = step / 128;
    for (let index = 0; index < 3; index++)
      simulator.setCollider(index, Float32Array.of(x - 1, 0.75 + index / 2, 0, x, 0.5, 0.25, 1));
    simulator.step();
  }
  return end(simulator);
}

function stepsOf(fixture: string): number {
  return Number(linesOf(fixture, 'steps ')[0]);
}

function start(factory: SimulatorFactory, fixture: string): Simulator {
  const [capacity, seed] = ['capacity ', 'seed '].map((word) => Number(linesOf(fixture, word)[0]));
  const simulator = factory.create({ capacity, seed });
  const pairs = linesOf(fixture, 'set ').map((line) => line.split(' '));
  simulator.set(Object.fromEntries(pairs.map(([key, value]) => [key, Number(value)])));
  return simulator;
}

function end(simulator: Simulator): string {
  const hash = simulator.hash();
  simulator.dispose();
  return hash;
}

/** Converts the boundary format of the fixture to a description. */
function rigidOf(line: string): RigidDescription {
  const [form, pose] = line.split(' | ');
  const [kind, shape, dimensions] = form.split(' ');
  const [x, y, z, ...rotation] = pose.split(' ').map(Number);
  const sizes = dimensions.split(',').map(Number);
  const shapes: RigidShape[] = [
    { type: 'ball', radius: sizes[0] },
    { type: 'cuboid', halfExtents: sizes },
    { type: 'capsule', halfHeight: sizes[0], radius: sizes[1] },
    { type: 'cylinder', halfHeight: sizes[0], radius: sizes[1] },
  ];
  const touch = { restitution: 0.1, friction: 0.3, density: 500 };
  return { kind: KINDS[Number(kind)], shape: shapes[Number(shape)], position: [x, y, z], rotation, ...touch };
}
