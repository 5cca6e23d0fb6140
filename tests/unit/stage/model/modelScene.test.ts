/** Models in scenes: what is drawn, casts, collides and emits, and the same state after a seek. */
import { createHash } from 'node:crypto';
import { beforeAll, describe, expect, test } from 'vitest';
import { finished } from '../../../../src/base/work.ts';
import { defaults } from '../../../../src/parameters/values.ts';
import { memoizedCreases } from '../../../../src/renderer/passes/creases.ts';
import { extrude } from '../../../../src/renderer/passes/extrusion.ts';
import { memoizedExtrusion } from '../../../../src/renderer/passes/meshVolumes.ts';
import { memoizedHullNormals } from '../../../../src/renderer/passes/surfaceGeometry.ts';
import { preparingSurfaces } from '../../../../src/renderer/prepare.ts';
import { air } from '../../../../src/scenes/air.ts';
import type { SurfaceDescription } from '../../../../src/renderer/passes/surface.ts';
import type { Scene } from '../../../../src/scenes/scene.ts';
import type { SimulatorFactory } from '../../../../src/simulator/load.ts';
import type { ModelOptions } from '../../../../src/stage/contract.ts';
import type { Decode } from '../../../../src/stage/model/colors.ts';
import { coveringBalls, fittedCapsule, insideOut, partsOf } from '../../../../src/stage/model/solids.ts';
import { faultOf, openModel } from '../../../../src/stage/model/stageModel.ts';
import { Simulation } from '../../../../src/stage/simulation.ts';
import { ALL_PARTICLES } from '../../../../src/simulator/view.ts';
import { bendingColumn, GlbFile, house, turningBox } from '../../../support/files/glb.ts';
import { MODEL_HASHES, modelHashes } from '../../../support/sim/modelHashes.ts';
import { loadVariant } from '../../../support/sim/simWasm.ts';

const PLACE: ModelOptions = { position: { x: 0, y: 0, z: 0 }, size: 2 };
const withModel = async (file: GlbFile, options: ModelOptions = {}, scene: Scene = air(), decode?: Decode) =>
  finished((await openModel(file.pack(), { ...PLACE, ...options }, decode))(scene));

let factory: SimulatorFactory;
beforeAll(async () => {
  factory = await loadVariant('meshes');
});

function begin(scene: Scene, values = {}): Simulation {
  return new Simulation(factory, scene, { ...defaults(), scene: 'air', ...values }, 1e8);
}

test('stands where it is told, with the size that it is told', async () => {
  const { scene, model } = await withModel(turningBox(), { position: { x: 1, y: 2, z: 3 }, size: 4 });
  expect(model.model.box.map((side) => side.toFixed(4))).toEqual(['2.2857', '4.0000', '2.2857']);
  const heights = scene.surfaces.flatMap(({ mesh, part, hidden }) =>
    part === undefined && !hidden ? Array.from(mesh.positions).filter((_, at) => at % 3 === 1) : [],
  );
  expect(Math.min(...heights)).toBeCloseTo(2, 5);
});

test('without a place, the middle is at the target of the camera', async () => {
  const { model } = finished((await openModel(turningBox().pack(), {}))(air()));
  expect(Math.max(...model.model.box)).toBeCloseTo(0.6 * 12 * Math.tan(0.15));
});

test('one surface for each colour and each part that moves; closed parts cast by volumes, open ones by balls', async () => {
  const { scene } = await withModel(turningBox());
  const drawn = scene.surfaces.filter(({ hidden }) => !hidden);
  const casters = scene.surfaces.filter(({ hidden }) => hidden);
  expect(drawn.map(({ color, part }) => [color, part])).toEqual([[[0, 0, 255], undefined], [[255, 0, 0], 1]]); // prettier-ignore
  expect(drawn.every(({ casts, inked }) => !casts && inked)).toBe(true);
  expect(casters.map(({ mesh, part }) => [mesh.indices.length > 36, part])).toEqual([[true, undefined], [false, 1]]); // prettier-ignore
  expect(casters.every(({ casts }) => casts)).toBe(true);
  finished(preparingSurfaces(scene.surfaces));
});

test('rows of a skin move its vertices as the bones do', async () => {
  const { scene } = await withModel(bendingColumn(), { size: 2 });
  const [{ mesh, skin }] = scene.surfaces;
  expect(scene.skin!.count).toBe(5);
  const place = (seconds: number, vertex: number) => {
    const m = scene.skin!.at(seconds).subarray(16 * skin![vertex]);
    const [x, y, z] = mesh.positions.subarray(3 * vertex);
    return [0, 1, 2].map((row) => m[row] * x + m[4 + row] * y + m[8 + row] * z + m[12 + row]);
  };
  const top = [...mesh.positions].findIndex((value, at) => at % 3 === 1 && value > 1.99);
  const vertex = Math.floor(top / 3);
  const first = [...mesh.positions.subarray(3 * vertex, 3 * vertex + 3)];
  place(0, vertex).forEach((value, axis) => expect(value).toBeCloseTo(first[axis], 5));
  // A quarter of a turn about z at a height of 1 takes the top to the left.
  place(1, vertex).forEach((value, axis) => expect(value).toBeCloseTo([-1, 1 + first[0], first[2]][axis], 5));
});

test('nodes have names and the numbers that emitters take', async () => {
  const { scene, model } = await withModel(bendingColumn());
  expect(scene.parts!.map(({ name }) => name)).toEqual(['model', 'Upper', 'Column', 'Lower']);
  expect(model.model.nodes.map(({ name, rigid }) => [name, rigid])).toEqual([
    ['model', 4096], ['Upper', 4097], ['Column', 4098], ['Lower', 4099],
  ]); // prettier-ignore
  const surfaces = model.model.nodes.map(({ surface }) => surface);
  expect(surfaces.filter((surface) => surface >= 0)).toEqual([0, 1]);
  expect(scene.emissionSurfaces!.length).toBe(2);
});

test('a hundred nodes and bones share 64 parts', async () => {
  const file = turningBox();
  for (let node = 0; node < 100; node++) {
    file.node({ name: `Bone ${node}`, translation: [0, 0.1, 0] });
    file.json.nodes[node === 0 ? 1 : node + 1].children = [node + 2];
    file.animate('Turn', node + 2, 'translation', [0, 1], [0, 0.1, 0, 0, 0.2, 0]);
  }
  const { scene, model } = await withModel(file);
  expect(scene.parts!.length).toBe(64);
  expect(model.model.nodes.length).toBe(64);
  begin(scene).advance(3);
});

describe('smoke', () => {
  const emitter = (values: Record<string, number | string>) =>
    Object.fromEntries(Object.entries(values).map(([name, value]) => [`emitters.0.${name}`, value]));

  test('collides with what turns, and not without `collides`', async () => {
    const hashes = [];
    for (const collides of [true, false]) {
      const { scene, hasRigids } = await withModel(turningBox(), { collides });
      expect(hasRigids).toBe(collides);
      const simulation = begin(scene, emitter({ 'position.y': -0.5 }));
      simulation.advance(120);
      hashes.push(simulation.simulator.hash());
    }
    expect(hashes[0]).not.toBe(hashes[1]);
  });

  test('stays out of a closed box', async () => {
    const file = new GlbFile();
    file.node({ mesh: file.mesh(file.box([1, 1, 1])) });
    const { scene } = await withModel(file, { size: 1 });
    const simulation = begin(scene, emitter({ 'position.y': -0.4, radius: 0.1 }));
    let nearest = Infinity;
    for (let step = 0; step < 180; step++) {
      simulation.advance(1);
      for (const [x, y, z] of placesOf(simulation))
        nearest = Math.min(nearest, Math.max(Math.abs(x), Math.abs(y - 0.5), Math.abs(z)));
    }
    expect(nearest).toBeGreaterThan(0.499);
  });

  test.each([
    ['a node that turns', turningBox, 1],
    ['a bone that bends', bendingColumn, 1],
  ])('rides on %s', async (_, make, node) => {
    const { scene, model } = await withModel(make(), { collides: false });
    const { rigid } = model.model.nodes[node];
    const simulation = begin(
      scene,
      emitter({ rigid, shape: 'point', 'position.x': 0, 'position.y': 0, speed: 0, rate: 60 }),
    );
    simulation.advance(30);
    const { position } = scene.parts![node].pose(0.5);
    const distances = placesOf(simulation).map((place) =>
      Math.hypot(...place.map((value, axis) => value - position[axis])),
    );
    expect(Math.min(...distances)).toBeLessThan(0.1);
  });

  test('comes from the surface of a node', async () => {
    const { scene, model } = await withModel(turningBox(), { collides: false });
    const { rigid, surface } = model.model.nodes[1];
    const simulation = begin(scene, emitter({ rigid, shape: 'surface', surface, 'position.y': 0, speed: 0 }));
    simulation.advance(20);
    // The upper box is above a height of 8/7.
    const heights = placesOf(simulation).map(([, y]) => y);
    expect(heights.length).toBeGreaterThan(5);
    expect(Math.min(...heights)).toBeGreaterThan(1.1);
  });
});

function placesOf(simulation: Simulation): [number, number, number][] {
  const { count, place } = simulation.simulator.arrange({ ...ALL_PARTICLES, blend: 1 }).rows;
  return Array.from({ length: count }, (_, row) => [place[4 * row], place[4 * row + 1], place[4 * row + 2]]);
}

describe.each([
  ['a box that turns', turningBox],
  ['a column that bends', bendingColumn],
])('%s', (_, make) => {
  test('gives the same hash after a seek, a saved state and a take', async () => {
    const { scene } = await withModel(make());
    const simulation = begin(scene);
    simulation.advance(70);
    const state = simulation.save({ ...defaults(), scene: 'air' });
    simulation.advance(80);
    const hash = simulation.simulator.hash();
    const take = simulation.take();
    simulation.approach(20);
    simulation.advance(150 - simulation.simulator.steps);
    expect(simulation.simulator.hash()).toBe(hash);
    simulation.restore(state, { ...defaults(), scene: 'air' });
    simulation.advance(80);
    expect(simulation.simulator.hash()).toBe(hash);
    const other = begin(scene);
    other.playTake(take);
    other.advance(150);
    expect(other.simulator.hash()).toBe(hash);
  });

  test('speed and animation change what smoke meets', async () => {
    const hashOf = async (options: ModelOptions) => {
      const simulation = begin((await withModel(make(), options)).scene, { 'emitters.0.position.y': 0.6 });
      simulation.advance(90);
      return simulation.simulator.hash();
    };
    const hashes = [await hashOf({}), await hashOf({ speed: 2 }), await hashOf({ animation: '' })];
    expect(new Set(hashes).size).toBe(3);
  });
});

test('models have the hashes that every engine must reach', async () => {
  expect(await modelHashes(factory)).toEqual(MODEL_HASHES);
});

describe('solids', () => {
  const box = [-1, -1, -1, 1, -1, -1, -1, 3, -1, 1, 3, -1, -1, -1, 1, 1, -1, 1, -1, 3, 1, 1, 3, 1];

  test('a capsule follows the longest axis', () => {
    const { position, rotation, halfHeight, radius } = fittedCapsule(Float32Array.from(box));
    expect(position.map((value) => value.toFixed(5))).toEqual(['0.00000', '1.00000', '0.00000']);
    expect(Math.abs(rotation[3])).toBeCloseTo(1, 3);
    expect(radius).toBeCloseTo(Math.SQRT2, 3);
    expect(halfHeight).toBeCloseTo(2 - Math.SQRT2, 3);
  });

  test.each([0, 0.5])('a capsule of half height %d is closed and inside out', (halfHeight) => {
    const mesh = insideOut([{ position: [1, 2, 3], rotation: [0.6, 0, 0, 0.8], halfHeight, radius: 0.5 }]);
    const { corners, positions } = finished(extrude(mesh));
    let volume = 0;
    for (let first = 0; first < corners.length; first += 3) {
      const [a, b, c] = [0, 1, 2].map((at) => positions.subarray(3 * corners[first + at], 3 * corners[first + at] + 3));
      volume +=
        (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0])) /
        6;
    }
    const exact = Math.PI * 0.25 * (2 / 3 + 2 * halfHeight);
    expect(-volume / exact).toBeGreaterThan(0.85);
    expect(-volume / exact).toBeLessThan(1);
  });

  test('balls cover an open surface', () => {
    const mesh = {
      positions: Float32Array.of(0, 0, 0, 4, 0, 0, 4, 2, 0, 0, 2, 0),
      normals: new Float32Array(12),
      indices: Uint32Array.of(0, 1, 2, 0, 2, 3),
    };
    const { closed, bordered, borders, tangled } = partsOf(mesh);
    expect([closed, bordered, borders].map((corners) => [...corners])).toEqual([[], [0, 1, 2, 3, 4, 5], [0, 1, 4, 5]]);
    expect(tangled).toEqual([]);
    const balls = coveringBalls(mesh, mesh.indices);
    for (const [x, y] of [
      [0.1, 0.1],
      [2, 1],
      [3.9, 1.9],
      [1, 1.5],
    ]) {
      const isCovered = balls.some(({ position, radius }) => Math.hypot(position[0] - x, position[1] - y) < radius);
      expect(isCovered, `${x} ${y}`).toBe(true);
    }
    finished(extrude(insideOut(balls)));
  });
});

test('the colour is the mean of the texture where the triangles are, times the factor', async () => {
  const file = new GlbFile();
  const primitive = file.box([1, 1, 1], [], 0);
  const corners = Array.from({ length: 24 }, (_, vertex) => [[0.5, 0], [1, 0], [1, 1], [0.5, 1]][vertex % 4]); // prettier-ignore
  primitive.attributes.TEXCOORD_0 = file.accessor({ values: corners.flat(), type: 'VEC2' });
  file.json.images = [{ bufferView: file.view(Uint8Array.of(0x89, 0x50)) }];
  file.json.textures = [{ source: 0 }];
  file.json.materials = [{ pbrMetallicRoughness: { baseColorTexture: { index: 0 }, baseColorFactor: [1, 0.5, 1, 1] } }];
  file.node({ mesh: file.mesh(primitive) });
  // The right half is white above and black below; the left half is not used.
  const data = [255, 0, 0, 255, 255, 255, 255, 255, 255, 0, 0, 255, 0, 0, 0, 255];
  const { scene } = await withModel(file, {}, air(), async () => ({ width: 2, height: 2, data }));
  // 188 is half of white in linear light, 137 a quarter.
  expect(scene.surfaces[0].color).toEqual([188, 137, 188]);
  const torn = await withModel(file, {}, air(), async () => undefined);
  expect(torn.model.model.notices.join()).toMatch(/cannot be decoded/);
});

test.each([
  ['size', 0], ['size', '2'], ['speed', NaN], ['turn', 1e9], ['casts', 1], ['position', { x: 1, y: 2 }], ['position', null], ['animation', 3],
] as const)('the option %s cannot be %j', (name, value) => {
  expect(faultOf({ [name]: value })?.slice(0, 2)).toEqual([name, value]);
}); // prettier-ignore

/** A surface without normals: waves of 24 times 24 squares with a hole; with `layers`, every triangle as often. */
function waves(layers = 1): GlbFile {
  const file = new GlbFile();
  const cells = 24;
  const values: number[] = [];
  const indices: number[] = [];
  for (let row = 0; row <= cells; row++)
    for (let column = 0; column <= cells; column++)
      values.push(row, ((row * row + 3 * column) % 7) / 4, column + ((row * column) % 3) / 5);
  for (let cell = 0; cell < layers * cells * cells; cell++) {
    const [row, column] = [Math.floor(cell / cells) % cells, cell % cells];
    const [a, c] = [row * (cells + 1) + column, (row + 1) * (cells + 1) + column];
    if (row !== 9 || column !== 9) indices.push(a, a + 1, c, a + 1, c + 1, c);
  }
  const primitive = {
    attributes: { POSITION: file.accessor({ values, type: 'VEC3' }) },
    indices: file.accessor({ values: indices, type: 'SCALAR', component: 5125 }),
  };
  file.node({ mesh: file.mesh(primitive) });
  return file;
}

/** A digest of all numbers, rounded, since square roots of sums can differ between engines in the last bit. */
function digestOf(...values: readonly unknown[]): string {
  const hash = createHash('sha1');
  JSON.stringify(values, (_, value: unknown) => {
    if (!ArrayBuffer.isView(value)) return value;
    hash.update(Float64Array.from(value as Float32Array, (each) => Math.round(1e4 * each) || 0));
    return undefined;
  });
  return hash.digest('hex').slice(0, 12);
}

// These numbers reach takes and saved states, so they must not change.
test.each<[string, () => GlbFile, string]>([
  ['a box that turns', turningBox, '657894e0b122'],
  ['a column with a skin', bendingColumn, '8bbcdf67d048'],
  ['a house', house, '4442679d2922'],
  ['a surface with borders', waves, '099450749231'],
  ['a surface whose edges have four triangles', () => waves(2), 'c51ed54e850a'],
])('the geometry of %s is the same as ever', async (_, make, digest) => {
  const { scene } = await withModel(make());
  const derived = scene.surfaces.map(({ mesh, casts, inked, skin }) => [
    memoizedHullNormals(mesh),
    casts && memoizedExtrusion(mesh),
    inked && !skin && memoizedCreases(mesh),
  ]);
  const { rigids, surfaces, emissionSurfaces } = scene;
  expect(digestOf(rigids, surfaces, emissionSurfaces, derived)).toBe(digest);
});

const at = (x: number, y: number, z: number) => ({ elements: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, y, z, 1] });

/** A camera at a height of 1.7 m, 10 m before the model, after a second. */
const shownWith = (rigids: { elements: number[] }[] = [], parts: { elements: number[] }[] = []) => ({
  loop: { clock: { blend: 1 } },
  simulation: { simulator: { steps: 60 } },
  picture: {
    deviceCoordinates: (x: number, y: number) => ({ x, y }),
    eye: {
      camera: {
        matrixWorld: at(0, 1.7, 10),
        projectionMatrix: { elements: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, -1, 0, 0, -1, 0] },
      },
    },
  },
  transforms: () => ({ rigids, parts }),
});

/** A square across the middle of the picture that faces the camera. */
function square(z: number): SurfaceDescription {
  const positions = Float32Array.of(-1, 0.7, z, 1, 0.7, z, 1, 2.7, z, -1, 2.7, z);
  const normals = Float32Array.of(0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1);
  const mesh = { positions, normals, indices: Uint32Array.of(0, 1, 2, 0, 2, 3) };
  return { name: 'square', mesh, color: [0, 0, 0], casts: false, inked: false };
}

test.each<[string, Partial<SurfaceDescription>, number, boolean]>([
  ['in front', {}, 5, true],
  ['behind the model', {}, -5, false],
  ['behind the camera', {}, 15, false],
  ['beside the pointer', { mesh: { ...square(5).mesh, positions: square(5).mesh.positions.map((x) => x + 3) } }, 5, false],
  ['seen from its back', { mesh: { ...square(5).mesh, indices: Uint32Array.of(0, 2, 1, 0, 3, 2) } }, 5, false],
  ['that is not drawn', { hidden: true }, 5, false],
  ['on a rigid that moved in front', { rigid: 1 }, -5, true],
  ['on a rigid that moved away', { rigid: 0 }, 5, false],
  ['on a part that moved in front', { part: 0 }, -5, true],
])('a surface %s', async (_, own, z, hides) => {
  const scene = { ...air(), surfaces: [{ ...square(z), ...own }] };
  const { model } = await withModel(turningBox(), {}, scene);
  const point = model.pick(0, 0, shownWith([at(4, 0, 0), at(0, 0, 10)], [at(0, 0, 10)]));
  expect(point === null).toBe(hides);
}); // prettier-ignore

test('the place under the pointer is on the node that carries it', async () => {
  const { model, scene } = await withModel(turningBox());
  const seconds = 1;
  const shown = shownWith();
  const point = model.pick(0, 0, shown)!;
  expect(point.node.name).toBe('Top');
  const { position, rotation } = scene.parts![1].pose(seconds);
  // After a quarter of a turn, the side of -x or +x faces the camera.
  expect(Math.abs(point.direction[0])).toBeCloseTo(1, 5);
  expect(Math.hypot(...point.position)).toBeCloseTo(Math.hypot(4 / 7, 1.7 - position[1]), 4);
  expect(rotation[3]).toBeCloseTo(Math.SQRT1_2, 5);
  expect(model.pick(0.9, 0.9, shown)).toBeNull();
});
