/** Builds GLB files by code, for tests of models. */

/** A number array of an accessor, with its type. */
interface Numbers {
  readonly values: readonly number[];
  readonly type: 'SCALAR' | 'VEC2' | 'VEC3' | 'VEC4' | 'MAT4';
  /** Component type of glTF. Default: 5126, floats. */
  readonly component?: number;
  readonly normalized?: boolean;
}

const ARRAYS = {
  5120: Int8Array,
  5121: Uint8Array,
  5122: Int16Array,
  5123: Uint16Array,
  5125: Uint32Array,
  5126: Float32Array,
} as const;
const SIZES = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4, MAT4: 16 } as const;

/** The JSON of a file that is being built, whose lists can be changed freely. */
// oxlint-disable-next-line typescript/no-explicit-any -- Tests write invalid files, too.
export type GltfJson = Record<string, any>;

/** A file that is being built: its JSON, and the bytes that accessors refer to. */
export class GlbFile {
  readonly json: GltfJson = {
    asset: { version: '2.0' },
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [],
    meshes: [],
    accessors: [],
    bufferViews: [],
    buffers: [],
  };
  private bytes: number[] = [];

  /** Adds bytes. @returns the index of the buffer view */
  view(bytes: Uint8Array): number {
    while (this.bytes.length % 4 > 0) this.bytes.push(0);
    const { length: byteOffset } = this.bytes;
    for (const byte of bytes) this.bytes.push(byte);
    return this.json.bufferViews.push({ buffer: 0, byteOffset, byteLength: bytes.length }) - 1;
  }

  /** @returns the index of the accessor */
  accessor({ values, type, component = 5126, normalized }: Numbers): number {
    const array = new ARRAYS[component as keyof typeof ARRAYS](values);
    const bufferView = this.view(new Uint8Array(array.buffer));
    const count = values.length / SIZES[type];
    return this.json.accessors.push({ bufferView, componentType: component, count, type, normalized }) - 1;
  }

  /** Adds a mesh. @returns its index */
  mesh(...primitives: readonly GltfJson[]): number {
    return this.json.meshes.push({ primitives }) - 1;
  }

  /** Adds a node. @returns its index */
  node(node: GltfJson): number {
    return this.json.nodes.push(node) - 1;
  }

  /** @returns the primitive of a box with flat faces, of which `without` are left out, in the order +x -x +y -y +z -z */
  box(half: readonly [number, number, number], without: readonly number[] = [], material?: number): GltfJson {
    const positions: number[] = [];
    const normals: number[] = [];
    const indices: number[] = [];
    for (let face = 0; face < 6; face++) {
      if (without.includes(face)) continue;
      const axis = face >> 1;
      const sign = face % 2 === 0 ? 1 : -1;
      const [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
      const first = positions.length / 3;
      for (const [a, b] of [
        [-1, -1],
        [1, -1],
        [1, 1],
        [-1, 1],
      ]) {
        const corner = [0, 0, 0];
        corner[axis] = sign * half[axis];
        corner[u] = a * half[u];
        corner[v] = b * half[v];
        positions.push(...corner);
        const normal = [0, 0, 0];
        normal[axis] = sign;
        normals.push(...normal);
      }
      const winding = sign > 0 ? [0, 1, 2, 0, 2, 3] : [0, 2, 1, 0, 3, 2];
      indices.push(...winding.map((corner) => first + corner));
    }
    return {
      attributes: {
        POSITION: this.accessor({ values: positions, type: 'VEC3' }),
        NORMAL: this.accessor({ values: normals, type: 'VEC3' }),
      },
      indices: this.accessor({ values: indices, type: 'SCALAR', component: 5123 }),
      ...(material !== undefined && { material }),
    };
  }

  /** Adds an animation with one channel. */
  animate(
    name: string,
    node: number,
    path: 'translation' | 'rotation' | 'scale',
    times: readonly number[],
    values: readonly number[],
    interpolation = 'LINEAR',
  ): void {
    const input = this.accessor({ values: times, type: 'SCALAR' });
    const output = this.accessor({ values, type: path === 'rotation' ? 'VEC4' : 'VEC3' });
    this.json.animations ??= [];
    const known = this.json.animations.find((animation: GltfJson) => animation.name === name);
    const animation = known ?? { name, channels: [], samplers: [] };
    if (!known) this.json.animations.push(animation);
    animation.channels.push({ sampler: animation.samplers.length, target: { node, path } });
    animation.samplers.push({ input, output, interpolation });
  }

  /** The bytes of the file. */
  pack(): Uint8Array<ArrayBuffer> {
    if (this.bytes.length > 0) this.json.buffers[0] ??= { byteLength: this.bytes.length };
    const text = new TextEncoder().encode(JSON.stringify(this.json));
    const json = padded(text, 0x20);
    const binary = padded(Uint8Array.from(this.bytes), 0);
    const file = new Uint8Array(12 + 8 + json.length + 8 + binary.length);
    const view = new DataView(file.buffer);
    [0x46546c67, 2, file.length, json.length, 0x4e4f534a].forEach((word, at) => view.setUint32(4 * at, word, true));
    file.set(json, 20);
    view.setUint32(20 + json.length, binary.length, true);
    view.setUint32(24 + json.length, 0x004e4942, true);
    file.set(binary, 28 + json.length);
    return file;
  }
}

function padded(bytes: Uint8Array, filler: number): Uint8Array {
  const result = new Uint8Array(4 * Math.ceil(bytes.length / 4)).fill(filler);
  result.set(bytes);
  return result;
}

/** Half of the square root of two: a quarter of a turn as a quaternion. */
const Q = Math.SQRT1_2;
/** Cosines of eighths of a turn. Those of `Math` can differ between engines. */
const CIRCLE = [1, Q, 0, -Q, -1, -Q, 0, Q];

/** A closed red box that turns about y in four seconds, on a still open blue box without a top. */
export function turningBox(): GlbFile {
  const file = new GlbFile();
  file.json.materials = [
    { pbrMetallicRoughness: { baseColorFactor: [1, 0, 0, 1] } },
    { pbrMetallicRoughness: { baseColorFactor: [0, 0, 1, 1] } },
  ];
  const top = file.mesh(file.box([0.5, 0.25, 0.25], [], 0));
  const base = file.mesh(file.box([0.5, 0.5, 0.5], [2], 1));
  file.json.scenes[0].nodes = [file.node({ name: 'Base', mesh: base, children: [1] })];
  const node = file.node({ name: 'Top', mesh: top, translation: [0, 1, 0] });
  file.animate(
    'Turn',
    node,
    'rotation',
    [0, 1, 2, 3, 4],
    [0, 0, 0, 1, 0, Q, 0, Q, 0, 1, 0, 0, 0, Q, 0, -Q, 0, 0, 0, -1],
  );
  return file;
}

/** A column of four segments with a skin of two bones, of which the upper one bends to the side and back in two seconds. */
export function bendingColumn(): GlbFile {
  const file = new GlbFile();
  const positions: number[] = [];
  const weights: number[] = [];
  const indices: number[] = [];
  const [rings, around] = [5, 8];
  for (let ring = 0; ring < rings; ring++) {
    for (let turn = 0; turn < around; turn++) {
      positions.push(0.25 * CIRCLE[turn], ring / 2, 0.25 * CIRCLE[(turn + 6) % 8]);
      weights.push(1 - ring / (rings - 1), ring / (rings - 1), 0, 0);
    }
  }
  for (let ring = 0; ring + 1 < rings; ring++) {
    for (let turn = 0; turn < around; turn++) {
      const [a, b] = [ring * around + turn, ring * around + ((turn + 1) % around)];
      indices.push(a, a + around, b, b, a + around, b + around);
    }
  }
  for (const [first, flip] of [
    [0, 1],
    [(rings - 1) * around, 0],
  ] as const)
    for (let turn = 1; turn + 1 < around; turn++)
      indices.push(first, ...(flip ? [first + turn, first + turn + 1] : [first + turn + 1, first + turn]));
  const count = positions.length / 3;
  const mesh = file.mesh({
    attributes: {
      POSITION: file.accessor({ values: positions, type: 'VEC3' }),
      JOINTS_0: file.accessor({
        values: Array.from({ length: 4 * count }, (_, at) => (at % 4 === 1 ? 1 : 0)),
        type: 'VEC4',
        component: 5121,
      }),
      WEIGHTS_0: file.accessor({ values: weights, type: 'VEC4' }),
    },
    indices: file.accessor({ values: indices, type: 'SCALAR', component: 5123 }),
  });
  const inverse = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
  const up = [...inverse];
  up[13] = -1;
  file.json.skins = [
    { joints: [1, 2], inverseBindMatrices: file.accessor({ values: [...inverse, ...up], type: 'MAT4' }) },
  ];
  file.json.scenes[0].nodes = [
    file.node({ name: 'Column', mesh, skin: 0 }),
    file.node({ name: 'Lower', children: [2] }),
  ];
  const upper = file.node({ name: 'Upper', translation: [0, 1, 0] });
  file.animate('Bend', upper, 'rotation', [0, 1, 2], [0, 0, 0, 1, 0, 0, Q, Q, 0, 0, 0, 1]);
  return file;
}

/** A house with a chimney without a top, and a vane that turns. Its nodes are House, Roof, Chimney and Vane. */
export function house(): GlbFile {
  const file = new GlbFile();
  const colors = [
    [0.9, 0.75, 0.5],
    [0.55, 0.08, 0.06],
    [0.35, 0.2, 0.15],
    [0.95, 0.6, 0.05],
    [0.2, 0.1, 0.06],
  ];
  file.json.materials = colors.map((color) => ({ pbrMetallicRoughness: { baseColorFactor: [...color, 1] } }));
  const [w, h, d] = [1, 0.7, 1.1];
  const positions = [-w, 0, d, w, 0, d, 0, h, d, -w, 0, -d, w, 0, -d, 0, h, -d];
  const indices = [0, 1, 2, 5, 4, 3, 0, 3, 4, 0, 4, 1, 1, 4, 5, 1, 5, 2, 2, 5, 3, 2, 3, 0];
  const roof = file.mesh({
    attributes: { POSITION: file.accessor({ values: positions, type: 'VEC3' }) },
    indices: file.accessor({ values: indices, type: 'SCALAR', component: 5123 }),
    material: 1,
  });
  const children = [1, 2, 4];
  file.json.scenes[0].nodes = [
    file.node({ name: 'House', mesh: file.mesh(file.box([0.8, 0.6, 0.9], [], 0)), children }),
  ];
  file.node({ name: 'Roof', mesh: roof, translation: [0, 0.6, 0], children: [3] });
  file.node({ name: 'Chimney', mesh: file.mesh(file.box([0.2, 0.4, 0.2], [2], 2)), translation: [0.5, 1.1, -0.4] });
  const vane = file.node({
    name: 'Vane',
    mesh: file.mesh(file.box([0.3, 0.12, 0.02], [], 3)),
    translation: [0, 0.95, 0.8],
  });
  file.node({ name: 'Door', mesh: file.mesh(file.box([0.22, 0.36, 0.03], [], 4)), translation: [0, -0.23, 0.9] });
  file.animate('Wind', vane, 'rotation', [0, 1, 2], [0, 0, 0, 1, 0, Q, 0, Q, 0, 1, 0, 0]);
  return file;
}
