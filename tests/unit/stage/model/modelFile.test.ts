/** GLB files: what is read of them, and what is refused. */
import { describe, expect, test } from 'vitest';
import { FileError } from '../../../../src/base/errors.ts';
import { readModel } from '../../../../src/stage/model/modelFile.ts';
import { bendingColumn, GlbFile, turningBox, type GltfJson } from '../../../support/files/glb.ts';

const CUBE = [
  [-1, -1], [1, -1], [1, 1], [-1, 1],
].flatMap(([x, y]) => [x, y, 0]); // prettier-ignore

/** A square, whose parts `change` replaces. */
function square(change: (file: GlbFile, primitive: GltfJson) => void = () => {}): GlbFile {
  const file = new GlbFile();
  const primitive: GltfJson = {
    attributes: { POSITION: file.accessor({ values: CUBE, type: 'VEC3' }) },
    indices: file.accessor({ values: [0, 1, 2, 0, 2, 3], type: 'SCALAR', component: 5121 }),
  };
  file.node({ mesh: file.mesh(primitive) });
  change(file, primitive);
  return file;
}

/** The file of `square` with its JSON changed. */
const changed = (change: (json: GltfJson) => void) => square((file) => change(file.json)).pack();

test('nodes, triangles, materials and animations', () => {
  const { nodes, order, triangles, materials, animations, notices } = readModel(turningBox().pack());
  expect(nodes.map(({ name, parent }) => [name, parent])).toEqual([['Base', -1], ['Top', 0]]); // prettier-ignore
  expect(order).toEqual([0, 1]);
  expect(triangles).toBe(22);
  expect(materials.map(({ color }) => color.slice(0, 3))).toEqual([[1, 0, 0], [0, 0, 1]]); // prettier-ignore
  expect(animations.map(({ name, seconds }) => [name, seconds])).toEqual([['Turn', 4]]);
  expect(notices).toEqual([]);
});

test('weights of a skin have the sum 1', () => {
  const [{ joints, weights }] = readModel(bendingColumn().pack()).meshes[0];
  expect(joints!.length).toBe(160);
  for (let first = 0; first < 160; first += 4) expect(weights![first] + weights![first + 1]).toBeCloseTo(1);
});

describe('accessors', () => {
  const positionsOf = (change: (file: GlbFile, primitive: GltfJson) => void) => [
    ...readModel(square(change).pack()).meshes[0][0].positions,
  ];

  test('of normalised integers are fractions', () => {
    const values = CUBE.map((value) => 32_767 * value);
    const read = positionsOf((file, { attributes }) => {
      attributes.POSITION = file.accessor({ values, type: 'VEC3', component: 5122, normalized: true });
    });
    expect(read).toEqual(CUBE);
  });

  test('that are interleaved skip what is between', () => {
    const read = positionsOf((file, { attributes }) => {
      const wide = CUBE.flatMap((value, at) => (at % 3 === 2 ? [value, 7, 7] : [value]));
      const bufferView = file.view(new Uint8Array(Float32Array.from([9, ...wide]).buffer));
      file.json.bufferViews[bufferView].byteStride = 20;
      attributes.POSITION =
        file.json.accessors.push({ bufferView, byteOffset: 4, componentType: 5126, count: 4, type: 'VEC3' }) - 1;
    });
    expect(read).toEqual(CUBE);
  });

  test('that are sparse replace elements', () => {
    const read = positionsOf((file, { attributes }) => {
      const indices = { bufferView: file.view(Uint8Array.of(1, 3)), componentType: 5121 };
      const values = { bufferView: file.view(new Uint8Array(Float32Array.of(5, 5, 5, 6, 6, 6).buffer)) };
      file.json.accessors[attributes.POSITION].sparse = { count: 2, indices, values };
    });
    expect(read).toEqual([-1, -1, 0, 5, 5, 5, 1, 1, 0, 6, 6, 6]);
  });
});

test.each([
  [4, [0, 1, 2, 0, 2, 3]],
  [5, [0, 1, 2, 1, 3, 2, 2, 3, 0, 3, 1, 0]],
  [6, [0, 1, 2, 0, 2, 3, 0, 3, 0, 0, 0, 1]],
])('primitives of mode %i', (mode, expected) => {
  const file = square((own, primitive) => {
    primitive.mode = mode;
    const values = mode === 4 ? [0, 1, 2, 0, 2, 3] : [0, 1, 2, 3, 0, 1];
    primitive.indices = own.accessor({ values, type: 'SCALAR', component: 5125 });
  });
  expect([...readModel(file.pack()).meshes[0][0].indices]).toEqual(expected);
});

describe('notices', () => {
  test.each<[string, (file: GlbFile, primitive: GltfJson) => void, RegExp]>([
    [
      'an image of another file',
      ({ json }) => (json.images = [{ uri: 'https://example.org/a.png' }]),
      /a\.png is in another file/,
    ],
    [
      'an image of an unknown type',
      (file) => (file.json.images = [{ bufferView: file.view(Uint8Array.of(1, 2)) }]),
      /not PNG or JPEG/,
    ],
    ['morph targets', (_, primitive) => (primitive.targets = [{}]), /morph targets/],
    ['compressed textures', ({ json }) => (json.extensionsRequired = ['KHR_texture_basisu']), /not PNG or JPEG/],
    ['lines', ({ json }, primitive) => json.meshes[0].primitives.push({ ...primitive, mode: 1 }), /points and lines/],
  ])('about %s', (_, change, words) => {
    expect(readModel(square(change).pack()).notices.join()).toMatch(words);
  });
});

const bytesOf = (...words: number[]) => new Uint8Array(Uint32Array.from(words).buffer);
const hostile: readonly [string, () => Uint8Array, RegExp][] = [
  ['no bytes', () => new Uint8Array(), /not a GLB file/],
  ['text', () => new TextEncoder().encode('{"asset":{"version":"2.0"}}'), /not a GLB file/],
  ['version 1', () => bytesOf(0x46546c67, 1, 20, 0, 0), /version 1/],
  ['no JSON', () => bytesOf(0x46546c67, 2, 20, 0, 0), /no JSON/],
  ['a file that is cut off', () => square().pack().slice(0, 200), /cut off/],
  ['a chunk that is too long', () => bytesOf(0x46546c67, 2, 20, 9000, 0x4e4f534a), /a chunk is longer/],
  ['damaged JSON', () => new Uint8Array(bytesOf(0x46546c67, 2, 24, 4, 0x4e4f534a, 0x20207b7b)), /JSON is damaged/],
  ['more than 32 MB', () => new Uint8Array(33 * 1024 * 1024), /33\.0 MB/],
  ['no triangles', () => changed((json) => (json.scenes[0].nodes = [])), /no triangles/],
  ['a node that carries itself', () => changed((json) => (json.nodes[0].children = [0])), /has a parent|itself/],
  ['nodes that carry each other', () => changed((json) => { json.nodes[0].children = [1]; json.nodes.push({ children: [0] }); }), /has a parent/], // prettier-ignore
  ['a node with two parents', () => changed((json) => { json.nodes.push({}, { children: [1] }); json.nodes[0].children = [1]; }), /two nodes/], // prettier-ignore
  ['a child that is missing', () => changed((json) => (json.nodes[0].children = [9])), /child 9/],
  ['5,000 nodes', () => changed((json) => (json.nodes = Array.from({ length: 5000 }, () => ({})))), /5000 nodes/],
  ['65 materials', () => changed((json) => (json.materials = Array.from({ length: 65 }, () => ({})))), /65 materials/],
  ['nodes that are no list', () => changed((json) => (json.nodes = { length: 1 })), /nodes is not a list/],
  ['a mesh that is missing', () => changed((json) => (json.nodes[0].mesh = 3)), /the mesh 3/],
  [
    'a matrix that is infinite',
    () => changed((json) => (json.nodes[0].translation = [1e300, 0, 0])),
    /translation of node 0/,
  ],
  ['a scale that is text', () => changed((json) => (json.nodes[0].scale = ['1', '1', '1'])), /scale of node 0/],
  ['an index out of range', () => square((file, primitive) => (primitive.indices = file.accessor({ values: [0, 1, 4], type: 'SCALAR', component: 5121 }))).pack(), /the index 4, but 4 vertices/], // prettier-ignore
  ['positions that are not finite', () => square((file, { attributes }) => (attributes.POSITION = file.accessor({ values: [NaN, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0], type: 'VEC3' }))).pack(), /not finite/], // prettier-ignore
  ['positions that are missing', () => square((_, primitive) => (primitive.attributes = {})).pack(), /no positions/],
  ['positions without bytes', () => changed((json) => (json.accessors[0].count = 4e9)), /4000000000 elements/],
  [
    'zeros without end',
    () => changed((json) => json.accessors.splice(0, 1, { componentType: 5126, count: 2e7, type: 'VEC3' })),
    /too much data/,
  ],
  [
    'an accessor after its view',
    () => changed((json) => (json.accessors[0].byteOffset = 4)),
    /not within its buffer view/,
  ],
  ['a view after its buffer', () => changed((json) => (json.bufferViews[0].byteLength = 1e6)), /not within its buffer/],
  [
    'a view with a negative offset',
    () => changed((json) => (json.bufferViews[0].byteOffset = -4)),
    /not within its buffer/,
  ],
  ['a stride of 0.5', () => changed((json) => (json.bufferViews[0].byteStride = 0.5)), /stride/],
  [
    'an unknown component type',
    () => changed((json) => (json.accessors[0].componentType = 'constructor')),
    /component type/,
  ],
  ['a buffer of another file', () => changed((json) => (json.buffers = [{ byteLength: 4, uri: 'https://example.org/a.bin' }])), /a\.bin/], // prettier-ignore
  ['damaged base64', () => changed((json) => (json.buffers = [{ byteLength: 4, uri: 'data:;base64,%%' }])), /damaged/],
  [
    'Draco',
    () => changed((json) => (json.extensionsRequired = ['KHR_draco_mesh_compression'])),
    /Draco.*Export it without compression/,
  ],
  ['meshopt', () => changed((json) => (json.extensionsRequired = ['EXT_meshopt_compression'])), /meshopt/],
  ['an unknown extension', () => changed((json) => (json.extensionsRequired = ['EXT_instancing'])), /EXT_instancing/],
  ['a joint that is missing', () => { const file = bendingColumn(); file.json.skins[0].joints = [1, 9]; return file.pack(); }, /invalid joints/], // prettier-ignore
  ['a vertex with a joint that is missing', () => { const file = bendingColumn(); file.json.skins[0].joints = [1]; return file.pack(); }, /a joint that skin 0 lacks/], // prettier-ignore
  ['keys out of order', () => { const file = square(); file.animate('a', 0, 'translation', [1, 0], [0, 0, 0, 1, 1, 1]); return file.pack(); }, /out of order/], // prettier-ignore
  ['fewer values than keys', () => { const file = square(); file.animate('a', 0, 'translation', [0, 1], [0, 0, 0]); return file.pack(); }, /fewer values/], // prettier-ignore
  ['200,001 triangles', () => square((file, primitive) => (primitive.indices = file.accessor({ values: Array.from({ length: 600_003 }, () => 0), type: 'SCALAR', component: 5121 }))).pack(), /200001 triangles.*At most 200,000/], // prettier-ignore
];

test.each(hostile)('refuses %s', (_, make, words) => {
  const read = () => readModel(make());
  expect(read).toThrow(FileError);
  expect(read).toThrow(words);
});

test('any damaged byte is refused or harmless', () => {
  const whole = bendingColumn().pack();
  for (let at = 0; at < whole.length; at += 7) {
    const torn = whole.slice();
    torn[at] ^= 1 + (at % 255);
    try {
      expect(readModel(torn).triangles).toBeLessThan(1000);
    } catch (error) {
      expect(error).toBeInstanceOf(FileError);
    }
  }
});
