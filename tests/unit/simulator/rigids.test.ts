import { describe, expect, it } from 'vitest';
import { ParameterError, SimulatorError } from '../../../src/base/errors.ts';
import type { RigidDescription, RigidPart, RigidShape } from '../../../src/simulator/rigid.ts';
import { readAttributes } from '../../../src/simulator/rows.ts';
import { EVERYTHING } from '../../support/sim/everything.ts';
import { JET, loadVariant } from '../../support/sim/simWasm.ts';

const TETRAHEDRON = [0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1];
const FACES = [0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3];

const SHAPES: RigidShape[] = [
  { type: 'ball', radius: 0.5 },
  { type: 'cuboid', halfExtents: [0.5, 0.4, 0.3] },
  { type: 'capsule', halfHeight: 0.4, radius: 0.2 },
  { type: 'cylinder', halfHeight: 0.4, radius: 0.2 },
  { type: 'convexHull', vertices: TETRAHEDRON },
  { type: 'trimesh', vertices: TETRAHEDRON, indices: FACES },
  {
    type: 'compound',
    parts: [
      { shape: { type: 'ball', radius: 0.3 }, position: [0.5, 0, 0] },
      {
        shape: { type: 'trimesh', vertices: TETRAHEDRON, indices: FACES },
        position: [0, 1, 0],
        rotation: [1, 0, 0, 0],
      },
    ],
  },
];

function still(shape: RigidShape): RigidDescription {
  return { kind: 'kinematic', shape, position: [0, 0, 0] };
}

async function create() {
  return (await loadVariant('physics')).create({ capacity: 256, seed: 1 });
}

describe('rigids', () => {
  it('accept every shape and every kind', async () => {
    const simulator = await create();
    for (const shape of SHAPES) {
      for (const kind of ['fixed', 'kinematic', 'dynamic'] as const) simulator.addRigid({ ...still(shape), kind });
    }
    expect(simulator.rigidCount).toBe(21);
    simulator.step(10);
    expect([...simulator.rigidPoses(1)].every(Number.isFinite)).toBe(true);
    simulator.dispose();
  });

  it('of every shape fall on every shape, fast enough to need continuous collision', async () => {
    const simulator = await create();
    SHAPES.forEach((falling, row) =>
      SHAPES.forEach((lying, column) => {
        const [x, z] = [10 * column, 10 * row];
        simulator.addRigid({ kind: 'fixed', shape: lying, position: [x, 0, z] });
        simulator.addRigid({ kind: 'dynamic', shape: falling, position: [x, 30, z] });
      }),
    );
    // A fall of 30 m takes 2.5 s; the final speed is 0.4 m per step.
    simulator.step(160);
    const poses = simulator.rigidPoses(1);
    expect(poses.every(Number.isFinite)).toBe(true);
    simulator.dispose();
  });

  it('are rejected with the name of the invalid value, and none is added', async () => {
    const simulator = await create();
    const mesh = (indices: number[], vertices = TETRAHEDRON): RigidShape => ({ type: 'trimesh', vertices, indices });
    const ball = still(SHAPES[0]);
    const compound = (shape: unknown, position = [0, 0, 0]): RigidDescription => {
      const parts = [
        { shape: SHAPES[0], position: [0, 0, 0] },
        { shape, position },
      ] as RigidPart[];
      return still({ type: 'compound', parts });
    };
    const wrong: [RigidDescription, string][] = [
      [still({ type: 'ball', radius: NaN }), 'rigid.dimensions.0'],
      [still({ type: 'ball', radius: 0 }), 'rigid.dimensions.0'],
      [still({ type: 'cuboid', halfExtents: [1, -1, 1] }), 'rigid.dimensions.1'],
      [still({ type: 'cuboid', halfExtents: [1, 1] }), 'rigid.dimensions'],
      [still({ type: 'cylinder', halfHeight: 1, radius: Infinity }), 'rigid.dimensions.1'],
      [still({ type: 'convexHull', vertices: [] }), 'rigid.vertices'],
      [still({ type: 'convexHull', vertices: TETRAHEDRON.slice(0, 9) }), 'rigid.vertices'],
      [still({ type: 'convexHull', vertices: [0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0] }), 'rigid.vertices'],
      [still({ type: 'convexHull', vertices: [...TETRAHEDRON, 0, NaN, 0] }), 'rigid.vertices.4.y'],
      [still(mesh([])), 'rigid.indices'],
      [still(mesh([0, 1])), 'rigid.indices'],
      [still(mesh([0, 1, 4])), 'rigid.indices.2'],
      [still(mesh([0, 1, -1])), 'rigid.indices.2'],
      [still(mesh([0, 0, 1])), 'rigid.indices'],
      [still(mesh([0, 1, 2], [0, 0, 0, 1, 0, 0])), 'rigid.indices.2'],
      [{ ...still(mesh([0, 1, 2])), kind: 'dynamic' }, 'rigid.shape'],
      [still({ type: 'torus' } as unknown as RigidShape), 'rigid.shape'],
      [still({ type: 'compound', parts: [] }), 'rigid.parts'],
      [compound({ type: 'ball', radius: -1 }), 'rigid.parts.1.dimensions.0'],
      [compound(mesh([0, 1, 9])), 'rigid.parts.1.indices.2'],
      [compound(SHAPES[0], [0, NaN, 0]), 'rigid.parts.1.position.y'],
      [compound({ type: 'compound', parts: [] }), 'rigid.parts.1.shape'],
      [{ ...ball, kind: 'ghost' as 'fixed' }, 'rigid.kind'],
      [{ ...ball, position: [0, NaN, 0] }, 'rigid.position.y'],
      [{ ...ball, rotation: [0, 0, 0, 0] }, 'rigid.rotation'],
      [{ ...ball, restitution: 2 }, 'rigid.restitution'],
      [{ ...ball, friction: -0.1 }, 'rigid.friction'],
      [{ ...ball, density: 0 }, 'rigid.density'],
      [{ ...ball, action: 'freeze' as 'kill' }, 'rigid.action'],
      [{ ...ball, action: 'tint', tint: 16 }, 'rigid.tint'],
      [{ ...ball, boundaryLayer: -1 }, 'rigid.boundaryLayer'],
      [{ ...ball, feelsSmoke: NaN }, 'rigid.feelsSmoke'],
    ];
    for (const [description, key] of wrong) {
      let error: unknown;
      try {
        simulator.addRigid(description);
      } catch (thrown) {
        error = thrown;
      }
      expect(error, key).toBeInstanceOf(ParameterError);
      expect((error as ParameterError).key).toBe(key);
    }
    expect(simulator.rigidCount).toBe(0);
    simulator.step();
    simulator.dispose();
  });

  it('can only be moved when they exist and are kinematic', async () => {
    const simulator = await create();
    const fixed = simulator.addRigid({ ...still(SHAPES[0]), kind: 'fixed' });
    const moving = simulator.addRigid(still(SHAPES[0]));
    expect(() => simulator.moveRigid(fixed, [1, 0, 0])).toThrow(/kinematic/);
    expect(() => simulator.moveRigid(7, [1, 0, 0])).toThrow(ParameterError);
    expect(() => simulator.moveRigid(moving, [1, NaN, 0])).toThrow(/rigid\.position\.y/);
    simulator.dispose();
  });

  it('follow springs, and reject invalid ones by name', async () => {
    const simulator = await create();
    const dragged = simulator.addRigid({ ...still(SHAPES[0]), kind: 'dynamic', position: [0, 5, 0] });
    simulator.step();
    simulator.dragRigid(dragged, [0, 0, 0], [3, 5, 0]);
    simulator.step(60);
    expect(simulator.rigidPoses(1)[0]).toBeCloseTo(3, 2);
    simulator.releaseRigid(dragged);
    simulator.step(10);
    expect(simulator.rigidPoses(1)[1]).toBeLessThan(5);
    expect(() => simulator.dragRigid(dragged, [0, 0, 0], [NaN, 0, 0])).toThrow(/rigid\.drag\.target\.x/);
    expect(() => simulator.dragRigid(9, [0, 0, 0], [0, 0, 0])).toThrow(/rigid\.index/);
    simulator.dispose();
  });

  it('kill or tint the smoke that touches them', async () => {
    for (const action of ['kill', 'tint'] as const) {
      const simulator = await create();
      // Few enough that spawns are never delayed: there is always new smoke below the plate.
      simulator.set({ ...JET, 'emission.rate': 60, 'emitters.0.spread': 0 });
      const plate: RigidShape = { type: 'cuboid', halfExtents: [2, 0.1, 2] };
      simulator.addRigid({ ...still(plate), position: [0, 1, 0], action, tint: 9 });
      simulator.step(120);
      const { rows, bounds } = simulator.arrange(EVERYTHING);
      const { count, attributes } = rows;
      const tints = new Set(Array.from({ length: count }, (_, row) => readAttributes(attributes, row).tint));
      expect(tints).toEqual(new Set(action === 'kill' ? [0] : [0, 9]));
      expect(bounds.max[1] > 1.5).toBe(action === 'tint');
      simulator.dispose();
    }
  });

  it('give poses between two steps', async () => {
    const simulator = await create();
    const ball = simulator.addRigid(still(SHAPES[0]));
    simulator.moveRigid(ball, [0.2, 0, 0], [0, Math.SQRT1_2, 0, Math.SQRT1_2]);
    simulator.step();
    simulator.moveRigid(ball, [0.3, 0, 0], [0, Math.SQRT1_2, 0, Math.SQRT1_2]);
    simulator.step();
    const at = (blend: number) => [...simulator.rigidPoses(blend)];
    expect(at(0)[0]).toBeCloseTo(0.2, 5);
    expect(at(0.5)[0]).toBeCloseTo(0.25, 5);
    expect(at(1)[0]).toBeCloseTo(0.3, 5);
    expect(at(0.5)[4]).toBeCloseTo(Math.SQRT1_2, 5);
    expect(Math.hypot(...at(0.3).slice(3))).toBeCloseTo(1, 6);
    const target = new Float32Array(7);
    expect(simulator.rigidPoses(1, target)).toBe(target);
    simulator.dispose();
  });

  it('push smoke out of their way', async () => {
    const simulator = await create();
    simulator.set({ ...JET, 'emitters.0.spread': 0 });
    simulator.addRigid({ ...still({ type: 'cuboid', halfExtents: [2, 0.1, 2] }), position: [0, 1, 0] });
    simulator.step(120);
    const { max } = simulator.arrange(EVERYTHING).bounds;
    expect(max[1]).toBeLessThan(0.9 + 0.01);
    expect(max[1]).toBeGreaterThan(0.8);
    simulator.dispose();
  });

  it('are restored from saved bytes', async () => {
    const simulator = await create();
    simulator.addRigid({ ...still(SHAPES[4]), kind: 'dynamic' });
    simulator.addRigid({ ...still(SHAPES[1]), kind: 'fixed', position: [0, -2, 0] });
    simulator.step(40);
    const other = await create();
    other.restore(simulator.save());
    simulator.step(60);
    other.step(60);
    expect(other.rigidCount).toBe(2);
    expect(other.hash()).toBe(simulator.hash());
    simulator.dispose();
    other.dispose();
  });

  it('that fall and hulls are rejected by the variant with meshes; all others are not', async () => {
    const simulator = (await loadVariant('meshes')).create({ capacity: 1, seed: 1 });
    for (const shape of SHAPES) {
      expect(() => simulator.addRigid({ ...still(shape), kind: 'dynamic' })).toThrow(/physics/);
      if (shape.type === 'convexHull') expect(() => simulator.addRigid(still(shape))).toThrow(/hull.* physics/);
      else simulator.addRigid(still(shape));
    }
    expect(simulator.rigidCount).toBe(SHAPES.length - 1);
    simulator.dispose();
  });

  it('are rejected by the core variant with the variant to load', async () => {
    const simulator = (await loadVariant('core')).create({ capacity: 1, seed: 1 });
    expect(() => simulator.addRigid(still(SHAPES[0]))).toThrow(SimulatorError);
    expect(() => simulator.addRigid(still(SHAPES[0]))).toThrow(/loadSimulators\(\{ physics: true \}\)/);
    expect(simulator.rigidCount).toBe(0);
    expect(simulator.rigidPoses(1).length).toBe(0);
    simulator.dispose();
  });
});
