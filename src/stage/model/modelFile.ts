/** The content of a GLB file that models use: nodes, triangles, skins, animations and materials, all checked. */
import { COMPRESSED, embedded, Glb, isIndex, isObject, refuse, shown, type Json } from './glb.ts';

const MAX_TRIANGLES = 200_000;
const MAX_VERTICES = 600_000;
const MAX_MATERIALS = 64;
const MAX_NODES = 4_000;
/** Characters of a name. */
const LONGEST_NAME = 60;
/** Metres; greater than any coordinate of a usable model. */
const FAR = 1e9;
/** Extensions without which a file can be used, because the model needs nothing of them or has it. */
const HARMLESS =
  /^KHR_(materials_\w+|texture_transform|mesh_quantization|lights_punctual|node_visibility|animation_pointer|xmp\w*)$/;

/** Translation, rotation as a unit quaternion, and scale: ten numbers. */
export type Transform = readonly number[];

export interface FileNode {
  readonly name: string;
  /** Index of the node that carries it; -1 for none. */
  parent: number;
  readonly rest: Transform;
  /** Column-major 4 x 4 matrix in place of `rest`. */
  readonly matrix: readonly number[] | undefined;
  readonly mesh: number | undefined;
  readonly skin: number | undefined;
}

/** Triangles with one material. */
export interface Primitive {
  /** x, y, z for each vertex. */
  readonly positions: Float32Array;
  readonly normals: Float32Array | undefined;
  /** Three for each triangle. */
  readonly indices: Uint32Array;
  /** Four joints of the skin for each vertex, and their weights, whose sum is 1. */
  readonly joints: Uint32Array | undefined;
  readonly weights: Float32Array | undefined;
  /** Two for each vertex, of the texture of the base colour. */
  readonly places: Float32Array | undefined;
  /** Factors on the colour: linear, three for each vertex. */
  readonly colors: Float32Array | undefined;
  /** -1 for none. */
  readonly material: number;
}

export interface Skin {
  /** Indices of nodes. */
  readonly joints: readonly number[];
  /** A column-major matrix for each joint. */
  readonly inverse: Float32Array;
}

/** Keys of one property of a node. */
export interface Channel {
  readonly node: number;
  readonly path: 'translation' | 'rotation' | 'scale';
  /** Seconds, ascending. */
  readonly times: Float32Array;
  /** For each key; three times as many with `CUBICSPLINE`. */
  readonly values: Float32Array;
  readonly interpolation: 'LINEAR' | 'STEP' | 'CUBICSPLINE';
}

export interface FileAnimation {
  readonly name: string;
  readonly seconds: number;
  readonly channels: readonly Channel[];
}

export interface Material {
  /** Linear red, green, blue, and opacity. */
  readonly color: readonly [number, number, number, number];
  /** The image of its base colour. */
  readonly image: number | undefined;
}

/** An embedded image. */
export interface FileImage {
  readonly bytes: Uint8Array;
  readonly type: 'image/png' | 'image/jpeg';
}

export interface ModelFile {
  readonly nodes: readonly FileNode[];
  /** Nodes of the scene, each after its parent. */
  readonly order: readonly number[];
  /** Primitives of each mesh. */
  readonly meshes: readonly (readonly Primitive[])[];
  readonly skins: readonly Skin[];
  readonly animations: readonly FileAnimation[];
  readonly materials: readonly Material[];
  /** By their index; undefined for those that cannot be read. */
  readonly images: readonly (FileImage | undefined)[];
  readonly triangles: number;
  readonly notices: readonly string[];
}

/**
 * Reads a GLB file. Addresses in the file are not fetched.
 * @throws FileError with the fault, for a file that is damaged, too large or compressed
 */
export function readModel(bytes: Uint8Array): ModelFile {
  const glb = new Glb(bytes);
  const notices = new Set<string>();
  requireExtensions(glb, notices);
  const materials = glb.list('materials', MAX_MATERIALS).map((material) => materialOf(glb, material));
  const nodes = nodesOf(glb);
  const order = orderOf(glb, nodes);
  const meshes = glb.list('meshes').map(() => undefined as readonly Primitive[] | undefined);
  let [triangles, vertices] = [0, 0];
  for (const index of order) {
    const { mesh } = nodes[index];
    if (mesh === undefined) continue;
    meshes[mesh] ??= primitivesOf(glb, mesh, notices);
    for (const { indices, positions } of meshes[mesh]) {
      triangles += indices.length / 3;
      vertices += positions.length / 3;
    }
    if (triangles > MAX_TRIANGLES)
      refuse(
        `it has ${triangles} triangles or more. At most 200,000 are accepted. Simplify it, for example in Blender with Decimate.`,
      );
    if (vertices > MAX_VERTICES) refuse(`it has ${vertices} vertices or more. At most 600,000 are accepted.`);
  }
  if (triangles === 0) refuse('it has no triangles.');
  const skins = glb.list('skins', MAX_NODES).map((skin, index) => skinOf(glb, skin, index, nodes.length));
  requireJoints(nodes, order, meshes, skins);
  return {
    nodes,
    order,
    meshes: meshes.map((each) => each ?? []),
    skins,
    animations: animationsOf(glb, nodes, notices),
    materials,
    images: glb.list('images', 1000).map((image) => imageOf(glb, image, notices)),
    triangles,
    notices: [...notices],
  };
}

function requireExtensions({ json }: Glb, notices: Set<string>): void {
  const required = json.extensionsRequired ?? [];
  if (!Array.isArray(required)) return refuse('extensionsRequired is not a list.');
  for (const name of required) {
    if (name === 'KHR_draco_mesh_compression') refuse(COMPRESSED('Draco'));
    if (name === 'EXT_meshopt_compression' || name === 'KHR_meshopt_compression') refuse(COMPRESSED('meshopt'));
    if (name === 'KHR_texture_basisu' || name === 'EXT_texture_webp' || name === 'EXT_texture_avif')
      notices.add('Its textures are not PNG or JPEG images, so their colours are missing.');
    else if (typeof name !== 'string' || !HARMLESS.test(name))
      refuse(`it requires the extension ${shown(name)}, which is not supported.`);
  }
}

function nodesOf(glb: Glb): FileNode[] {
  const meshes = glb.list('meshes').length;
  const skins = glb.list('skins', MAX_NODES).length;
  const nodes = glb.list('nodes', MAX_NODES).map((node, index): FileNode => {
    const { mesh, skin, matrix } = node;
    if (mesh !== undefined && !isIndex(mesh, meshes)) refuse(`node ${index} has the mesh ${shown(mesh)}.`);
    if (skin !== undefined && !isIndex(skin, skins)) refuse(`node ${index} has the skin ${shown(skin)}.`);
    return {
      name: nameOf(node, `node ${index}`),
      parent: -1,
      rest: [
        ...numbers(node.translation, [0, 0, 0], `the translation of node ${index}`),
        ...unit(numbers(node.rotation, [0, 0, 0, 1], `the rotation of node ${index}`)),
        ...numbers(node.scale, [1, 1, 1], `the scale of node ${index}`),
      ],
      matrix:
        matrix === undefined
          ? undefined
          : numbers(
              matrix,
              Array.from({ length: 16 }, () => 0),
              `the matrix of node ${index}`,
            ),
      mesh,
      skin,
    };
  });
  glb.list('nodes').forEach(({ children = [] }, index) => {
    if (!Array.isArray(children)) return refuse(`node ${index} has invalid children.`);
    for (const child of children) {
      if (!isIndex(child, nodes.length)) return refuse(`node ${index} has the child ${shown(child)}.`);
      if (nodes[child].parent >= 0) return refuse(`node ${child} is carried by two nodes.`);
      nodes[child].parent = index;
    }
  });
  return nodes;
}

/** The nodes of the scene, each after its parent. Nodes that carry each other are in no scene. */
function orderOf(glb: Glb, nodes: readonly FileNode[]): number[] {
  const scenes = glb.list('scenes');
  const { scene = 0 } = glb.json;
  const roots =
    scenes.length > 0
      ? (glb.at('scenes', scene).nodes ?? [])
      : nodes.flatMap(({ parent }, node) => (parent < 0 ? [node] : []));
  if (!Array.isArray(roots)) return refuse('the scene has invalid nodes.');
  const children = nodes.map((): number[] => []);
  nodes.forEach(({ parent }, node) => parent >= 0 && children[parent].push(node));
  const order: number[] = [];
  const seen = new Set<number>();
  const add = (node: unknown) => {
    if (!isIndex(node, nodes.length)) return refuse(`the scene has the node ${shown(node)}.`);
    if (seen.has(node)) refuse(`node ${node} carries itself.`);
    seen.add(node);
    order.push(node);
  };
  roots.forEach((root: unknown) => {
    if (isIndex(root, nodes.length) && nodes[root].parent >= 0) refuse(`node ${root} of the scene has a parent.`);
    add(root);
  });
  for (let at = 0; at < order.length; at++) children[order[at]].forEach(add);
  return order;
}

function primitivesOf(glb: Glb, mesh: number, notices: Set<string>): Primitive[] {
  const { primitives } = glb.at('meshes', mesh);
  if (!Array.isArray(primitives) || !primitives.every(isObject)) return refuse(`mesh ${mesh} has no primitives.`);
  return primitives.flatMap((primitive) => {
    const { mode = 4, targets } = primitive;
    if (mode !== 4 && mode !== 5 && mode !== 6) {
      notices.add('Its points and lines are not shown.');
      return [];
    }
    if (targets !== undefined) notices.add('Its morph targets are not shown.');
    return [primitiveOf(glb, primitive, mode, mesh)];
  });
}

function primitiveOf(
  glb: Glb,
  { attributes, indices, material, extensions }: Json,
  mode: number,
  mesh: number,
): Primitive {
  if (!isObject(attributes) || attributes.POSITION === undefined) {
    if (isObject(extensions) && 'KHR_draco_mesh_compression' in extensions) refuse(COMPRESSED('Draco'));
    return refuse(`mesh ${mesh} has no positions.`);
  }
  const positions = floats(glb.accessor(attributes.POSITION, 'VEC3').values);
  if (positions.some((value) => Math.abs(value) > FAR)) refuse(`mesh ${mesh} has positions that are too large.`);
  const count = positions.length / 3;
  const read = (name: string, size: number, ...types: string[]) => {
    if (attributes[name] === undefined) return undefined;
    const found = glb.accessor(attributes[name], ...types);
    if (found.values.length / found.size < count) refuse(`mesh ${mesh} has too few values of ${name}.`);
    return found.size === size ? found.values : without(found.values, found.size, size);
  };
  const materials = glb.list('materials').length;
  if (material !== undefined && !isIndex(material, materials))
    refuse(`mesh ${mesh} has the material ${shown(material)}.`);
  const joints = read('JOINTS_0', 4, 'VEC4');
  const weights = read('WEIGHTS_0', 4, 'VEC4');
  const hasSkin = joints && weights;
  const normals = read('NORMAL', 3, 'VEC3');
  const places = read('TEXCOORD_0', 2, 'VEC2');
  const colors = read('COLOR_0', 3, 'VEC3', 'VEC4');
  return {
    positions,
    normals: normals && floats(normals),
    indices: trianglesOf(indices === undefined ? undefined : glb.accessor(indices, 'SCALAR').values, count, mode, mesh),
    joints: hasSkin && Uint32Array.from(joints),
    weights: hasSkin && summingToOne(floats(weights)),
    places: places && floats(places),
    colors: colors && floats(colors),
    material: material ?? -1,
  };
}

function trianglesOf(given: ArrayLike<number> | undefined, count: number, mode: number, mesh: number): Uint32Array {
  const corners = given ?? Uint32Array.from({ length: count }, (_, vertex) => vertex);
  for (let corner = 0; corner < corners.length; corner++) {
    if (!isIndex(corners[corner], count))
      refuse(`mesh ${mesh} has the index ${corners[corner]}, but ${count} vertices.`);
  }
  if (mode === 4) return new Uint32Array(corners).slice(0, corners.length - (corners.length % 3));
  const triangles = Math.max(0, corners.length - 2);
  const indices = new Uint32Array(3 * triangles);
  for (let triangle = 0; triangle < triangles; triangle++) {
    // Every other triangle of a strip winds the other way.
    const odd = mode === 5 ? triangle % 2 : 0;
    const [first, second] = mode === 5 ? [triangle, triangle + 1 + odd] : [0, triangle + 1];
    indices.set([corners[first], corners[second], corners[triangle + 2 - odd]], 3 * triangle);
  }
  return indices;
}

function skinOf(glb: Glb, { joints, inverseBindMatrices }: Json, skin: number, nodes: number): Skin {
  if (
    !Array.isArray(joints) ||
    joints.length === 0 ||
    joints.length > MAX_NODES ||
    !joints.every((joint) => isIndex(joint, nodes))
  )
    return refuse(`skin ${skin} has invalid joints.`);
  const identities = () => Float32Array.from({ length: 16 * joints.length }, (_, at) => ((at % 16) % 5 === 0 ? 1 : 0));
  const inverse =
    inverseBindMatrices === undefined ? identities() : floats(glb.accessor(inverseBindMatrices, 'MAT4').values);
  if (inverse.length < 16 * joints.length) refuse(`skin ${skin} has too few inverse bind matrices.`);
  return { joints, inverse };
}

function requireJoints(
  nodes: readonly FileNode[],
  order: readonly number[],
  meshes: readonly (readonly Primitive[] | undefined)[],
  skins: readonly Skin[],
): void {
  const isInScene = new Set(order);
  for (const node of order) {
    const { mesh, skin } = nodes[node];
    if (mesh === undefined || skin === undefined) continue;
    const { joints } = skins[skin];
    if (!joints.every((joint) => isInScene.has(joint))) refuse(`skin ${skin} has a joint that is not in the scene.`);
    for (const primitive of meshes[mesh]!) {
      if (primitive.joints?.some((joint) => joint >= joints.length))
        refuse(`mesh ${mesh} has a vertex with a joint that skin ${skin} lacks.`);
    }
  }
}

function animationsOf(glb: Glb, nodes: readonly FileNode[], notices: Set<string>): FileAnimation[] {
  const names = new Set<string>();
  return glb.list('animations', 1000).map((animation, index) => {
    const { channels, samplers } = animation;
    if (!Array.isArray(channels) || !channels.every(isObject) || !Array.isArray(samplers) || !samplers.every(isObject))
      return refuse(`animation ${index} is invalid.`);
    const wanted = nameOf(animation, `animation ${index}`);
    const name = names.has(wanted) ? `${wanted} ${index}` : wanted;
    names.add(name);
    const read = channels.flatMap(({ sampler, target }): Channel[] => {
      if (!isIndex(sampler, samplers.length) || !isObject(target)) return refuse(`${name} has an invalid channel.`);
      const { node, path } = target;
      if (path === 'weights') notices.add('Its morph targets are not shown.');
      if (node === undefined || (path !== 'translation' && path !== 'rotation' && path !== 'scale')) return [];
      if (!isIndex(node, nodes.length)) return refuse(`${name} moves the node ${shown(node)}.`);
      return [channelOf(glb, samplers[sampler], node, path, name)];
    });
    // Not Math.max of all at once: there can be more than a call takes.
    const seconds = read.reduce((longest, { times }) => Math.max(longest, times[times.length - 1]), 0);
    return { name, seconds, channels: read };
  });
}

function channelOf(glb: Glb, sampler: Json, node: number, path: Channel['path'], name: string): Channel {
  const { interpolation = 'LINEAR' } = sampler;
  if (interpolation !== 'LINEAR' && interpolation !== 'STEP' && interpolation !== 'CUBICSPLINE')
    return refuse(`${name} has the interpolation ${shown(interpolation)}.`);
  const times = floats(glb.accessor(sampler.input, 'SCALAR').values);
  const values = floats(glb.accessor(sampler.output, path === 'rotation' ? 'VEC4' : 'VEC3').values);
  const each = (path === 'rotation' ? 4 : 3) * (interpolation === 'CUBICSPLINE' ? 3 : 1);
  if (values.length < each * times.length) refuse(`${name} has fewer values than keys.`);
  if (times.some((time, key) => time < 0 || (key > 0 && time < times[key - 1])))
    refuse(`${name} has keys out of order.`);
  if (times[times.length - 1] > 3600) refuse(`${name} is longer than an hour.`);
  return { node, path, times, values, interpolation };
}

function materialOf(glb: Glb, { pbrMetallicRoughness: look = {} }: Json): Material {
  if (!isObject(look)) return refuse('a material is invalid.');
  const color = numbers(look.baseColorFactor, [1, 1, 1, 1], 'a colour');
  const texture = isObject(look.baseColorTexture) ? glb.at('textures', look.baseColorTexture.index) : {};
  const { source } = texture;
  if (source !== undefined) glb.at('images', source);
  return { color: color as unknown as Material['color'], image: source as number | undefined };
}

function imageOf(glb: Glb, { uri, bufferView, mimeType }: Json, notices: Set<string>): FileImage | undefined {
  const bytes = uri === undefined ? glb.bytesOf(bufferView).bytes : embedded(uri);
  if (!bytes) {
    notices.add(`The image ${shown(uri)} is in another file, so its colour is missing. Export with embedded images.`);
    return undefined;
  }
  const type = typeOf(bytes);
  if (!type)
    notices.add(
      `An image ${typeof mimeType === 'string' ? `of the type ${shown(mimeType)} ` : ''}is not PNG or JPEG, so its colour is missing.`,
    );
  return type && { bytes, type };
}

/** By its first bytes. */
function typeOf([first, second]: Uint8Array): FileImage['type'] | undefined {
  if (first === 0x89 && second === 0x50) return 'image/png';
  return first === 0xff && second === 0xd8 ? 'image/jpeg' : undefined;
}

function nameOf({ name }: Json, other: string): string {
  const clean = typeof name === 'string' ? name.replace(/\p{C}/gu, '').trim().slice(0, LONGEST_NAME) : '';
  return clean || other;
}

/** @param otherwise as many numbers, if there is no value */
function numbers(value: unknown, otherwise: readonly number[], what: string): readonly number[] {
  if (value === undefined) return otherwise;
  const isRight =
    Array.isArray(value) &&
    value.length === otherwise.length &&
    value.every((each) => Math.abs(each) < FAR && typeof each === 'number');
  return isRight ? value : refuse(`${what} is ${shown(value)}.`);
}

/** A quaternion of length 1; that of no rotation if it has no length. */
function unit(quaternion: readonly number[]): readonly number[] {
  const length = Math.sqrt(quaternion.reduce((sum, part) => sum + part * part, 0));
  return length > 0 && length < Infinity ? quaternion.map((part) => part / length) : [0, 0, 0, 1];
}

function floats(values: Float32Array | Uint32Array): Float32Array {
  return values instanceof Float32Array ? values : Float32Array.from(values);
}

/** The first numbers of each element. */
function without(values: ArrayLike<number>, size: number, kept: number): Float32Array {
  const elements = values.length / size;
  return Float32Array.from({ length: elements * kept }, (_, at) => values[size * Math.floor(at / kept) + (at % kept)]);
}

function summingToOne(weights: Float32Array): Float32Array {
  for (let first = 0; first < weights.length; first += 4) {
    let sum = 0;
    for (let part = first; part < first + 4; part++) sum += weights[part] = Math.max(0, weights[part]);
    if (!(sum > 0)) weights.set([1, 0, 0, 0], first);
    else for (let part = first; part < first + 4; part++) weights[part] /= sum;
  }
  return weights;
}
