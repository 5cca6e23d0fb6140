/** Adds a model to a scene: its surfaces, what casts and collides, and the parts that emitters ride on. */
import type { Work } from '../../base/work.ts';
import type { Color } from '../../renderer/gpu/ramps.ts';
import { hullNormals, type TriangleMesh } from '../../renderer/passes/extrusion.ts';
import { memoize } from '../../renderer/passes/memoize.ts';
import type { SurfaceDescription } from '../../renderer/passes/surface.ts';
import type { CameraPose, MovingPart, Placement, Scene, Vector } from '../../scenes/scene.ts';
import { cos, sin } from '../../simulator/exact/sine.ts';
import { secondsAt } from '../../simulator/clock.ts';
import { tan } from '../../simulator/exact/arc.ts';
import { rotate } from '../../simulator/exact/rotation.ts';
import { FIRST_PART } from '../../simulator/layout.ts';
import type { RigidDescription, RigidPart } from '../../simulator/rigid.ts';
import type { Model, ModelNode, ModelOptions, ModelPoint } from '../contract.ts';
import { crossOf, piecesOf, normalized, normalOf, writeRow, type Piece, type Row } from './geometry.ts';
import { refuse } from './glb.ts';
import type { ModelFile, Primitive } from './modelFile.ts';
import { inSpaceOf, inverted, matrixOf, movedBy, Poser, type Place } from './pose.ts';
import { areaOf, coveringBalls, fittedCapsule, insideOut, partsOf, type Capsule, type Parts } from './solids.ts';

/** Parts and emission surfaces of a scene, as the simulator accepts. */
const [MAX_PARTS, MAX_EMISSION_SURFACES] = [64, 16];
/** Surfaces that are drawn as parts; more are drawn by rows. Casters. Surfaces with lines between them. */
const [MAX_PLACED, MAX_CASTERS, MAX_SEPARATED] = [100, 96, 24];
/** Casters that are smaller cast nothing, metres. */
const SMALLEST_BALL = 0.004;
/** Longest side of a model as a share of the height of the picture. */
const SHARE = 0.3;
/** Thickness of what is not closed, as a share of the longest side. */
const THICKNESS = 0.01;
const WORLD: Placement = { position: [0, 0, 0], rotation: [0, 0, 0, 1] };

/** A scene with a model. */
export interface SceneWithModel {
  readonly scene: Scene;
  readonly model: SceneModel;
  /** Whether it needs a simulator with meshes. */
  readonly hasRigids: boolean;
}

/** The model of a scene. */
export interface SceneModel {
  readonly model: Model;
  /** The nearest place of the model at a position in the picture, in CSS pixels; null if it is not there, or behind another surface. */
  pick(x: number, y: number, shown: ShownPicture): ModelPoint | null;
}

/** What a stage shows. */
interface ShownPicture {
  readonly loop: { readonly clock: { readonly blend: number } };
  readonly simulation: { readonly simulator: { readonly steps: number } };
  readonly picture: {
    deviceCoordinates(x: number, y: number): { readonly x: number; readonly y: number };
    readonly eye: { readonly camera: PickCamera };
  };
  /** Transforms of the rigids and the parts of the scene, as they are drawn. */
  transforms(): { readonly rigids: readonly Matrix[]; readonly parts: readonly Matrix[] };
}

interface Matrix {
  readonly elements: ArrayLike<number>;
}

/** The matrices of a perspective camera. */
interface PickCamera {
  readonly matrixWorld: Matrix;
  readonly projectionMatrix: Matrix;
}

interface Picked {
  /** From the camera, metres. */
  readonly distance: number;
  readonly node: number;
  readonly position: Vector;
  readonly direction: Vector;
}

/** A group of nodes that move together. */
interface Carrier {
  /** -1 for all that do not move. */
  readonly node: number;
  readonly name: string;
  /** Whether the animation moves it. */
  readonly isMoving: boolean;
}

/**
 * The scene with a model, in pieces of work.
 * @param file whose animation `options.animation` names, if it names one
 * @param colors of all primitives
 */
export function* withModel(
  base: Scene,
  file: ModelFile,
  colors: ReadonlyMap<Primitive, Color>,
  options: ModelOptions,
  notices: readonly string[],
): Work<SceneWithModel> {
  const {
    animation: wanted = file.animations[0]?.name,
    speed = 1,
    collides = true,
    casts = true,
    inked = true,
  } = options;
  const animation = file.animations.find(({ name }) => name === wanted);
  const colorOf = (primitive: Primitive) => colors.get(primitive)!;
  const poserAt = (place: Place) => new Poser(file, animation, speed, place);
  const unplaced = piecesOf(file, poserAt({ scale: 1, ...WORLD }).at(0), colorOf).pieces;
  yield;
  const place = placeOf(boxOf(unplaced), base, options);
  const poser = poserAt(place);
  const { pieces, rows } = piecesOf(file, poser.at(0), colorOf);
  yield;
  const built = new Build(base, file, poser, place, pieces, rows);
  yield* built.separate();
  const colliders = collides ? built.colliders() : [];
  yield;
  const emission = built.emissionSurfaces();
  yield;
  const surfaces = built.surfaces(inked);
  const casters = casts ? yield* built.casters() : [];
  const model: Model = {
    triangles: file.triangles,
    materials: file.materials.length,
    box: sidesOf(boxOf(pieces)),
    nodes: built.carriers
      .map(({ name }, index): ModelNode => ({
        name,
        rigid: FIRST_PART + built.firstPart + index,
        surface: emission.findIndex(({ carrier }) => carrier === index) + (base.emissionSurfaces?.length ?? 0),
      }))
      .map((node, index) => (emission.some(({ carrier }) => carrier === index) ? node : { ...node, surface: -1 })),
    animations: file.animations.map(({ name, seconds }) => ({ name, seconds })),
    notices,
  };
  const moves = colliders.flatMap(({ carrier }, index) =>
    carrier !== undefined ? [{ carrier, rigid: base.rigids.length + index }] : [],
  );
  const { guide } = base;
  const scene: Scene = {
    ...base,
    rigids: [...base.rigids, ...colliders.map(({ rigid }) => rigid)],
    surfaces: [...base.surfaces, ...surfaces, ...casters],
    parts: [...(base.parts ?? []), ...built.parts()],
    emissionSurfaces: [...(base.emissionSurfaces ?? []), ...emission.map(({ mesh }) => mesh)],
    skin: rows.length > 0 ? { count: rows.length, at: (seconds) => built.rowsAt(seconds) } : undefined,
    ...(moves.length > 0 && {
      guide: (moment) => [
        ...(guide?.(moment) ?? []),
        ...moves.map(({ carrier, rigid }) => ({ rigid, ...built.placement(carrier, moment.seconds) })),
      ],
    }),
  };
  const pick: SceneModel['pick'] = (x, y, shown) => {
    const { loop, picture, simulation } = shown;
    const { origin, direction } = rayOf(picture.deviceCoordinates(x, y), picture.eye.camera);
    const seconds = secondsAt(simulation.simulator.steps, loop.clock.blend);
    const found = built.pick(surfaces, origin, direction, seconds);
    if (!found || isBehind(base.surfaces, shown.transforms(), origin, direction, found.distance)) return null;
    const { node, position, direction: outward } = found;
    return { node: model.nodes[node], position, direction: outward };
  };
  return { scene, model: { model, pick }, hasRigids: scene.rigids.length > 0 };
}

/** The ray from a camera through a position in its picture. */
function rayOf({ x, y }: { readonly x: number; readonly y: number }, { matrixWorld, projectionMatrix }: PickCamera) {
  const [m, p] = [matrixWorld.elements, projectionMatrix.elements];
  const inView = [(x + p[8]) / p[0], (y + p[9]) / p[5], -1];
  const along = [0, 1, 2].map((row) => m[row] * inView[0] + m[4 + row] * inView[1] + m[8 + row] * inView[2]);
  const direction = normalized(along[0], along[1], along[2]);
  return { origin: [m[12], m[13], m[14]] as Vector, direction };
}

/** Whether the front of a surface that is drawn is nearer on a ray than a distance. */
function isBehind(
  surfaces: readonly SurfaceDescription[],
  { rigids, parts }: ReturnType<ShownPicture['transforms']>,
  origin: Vector,
  direction: Vector,
  distance: number,
): boolean {
  return surfaces.some(({ mesh: { positions, indices }, hidden, rigid, part }) => {
    const transform = part !== undefined ? parts[part] : rigid !== undefined ? rigids[rigid] : undefined;
    const inverse = transform && inverted(transform.elements);
    if (hidden || (transform && !inverse)) return false;
    const [start, along] = inverse
      ? [transformed(inverse, origin, 1), transformed(inverse, direction, 0)]
      : [origin, direction];
    for (let first = 0; first < indices.length; first += 3) {
      const [a, b, c] = [indices[first], indices[first + 1], indices[first + 2]];
      if (distanceTo(positions, a, b, c, start, along) < distance) {
        const [x, y, z] = crossOf(positions, a, b, c);
        if (x * along[0] + y * along[1] + z * along[2] < 0) return true;
      }
    }
    return false;
  });
}

/** A vector that a matrix transforms. @param place 1 for a position, 0 for a direction */
function transformed(m: ArrayLike<number>, [x, y, z]: Vector, place: 0 | 1): Vector {
  const of = (row: number) => m[row] * x + m[4 + row] * y + m[8 + row] * z + place * m[12 + row];
  return [of(0), of(1), of(2)];
}

interface Box {
  readonly low: Vector;
  readonly high: Vector;
}

function boxOf(pieces: readonly Piece[]): Box {
  const low: [number, number, number] = [Infinity, Infinity, Infinity];
  const high: [number, number, number] = [-Infinity, -Infinity, -Infinity];
  for (const { positions } of pieces) {
    for (let at = 0; at < positions.length; at++) {
      const axis = at % 3;
      if (positions[at] < low[axis]) low[axis] = positions[at];
      if (positions[at] > high[axis]) high[axis] = positions[at];
    }
  }
  return { low, high };
}

function sidesOf({ low, high }: Box): Vector {
  return [high[0] - low[0], high[1] - low[1], high[2] - low[2]];
}

/** A part of the height of the picture. */
function sizeIn({ distance, fieldOfView }: CameraPose): number {
  return 2 * SHARE * distance * tan(fieldOfView / 2);
}

function placeOf(box: Box, { camera }: Scene, { position, size = sizeIn(camera), turn = 0 }: ModelOptions): Place {
  const { low, high } = box;
  const longest = Math.max(...sidesOf(box));
  if (!(longest > 0 && longest < Infinity)) refuse('it has no extent.');
  const scale = size / longest;
  const middle = [0, 1, 2].map((axis) => (low[axis] + high[axis]) / 2);
  // The point of the model that is placed, and where.
  const anchor: Vector = [middle[0], position ? low[1] : middle[1], middle[2]];
  const [x, y, z] = position ? [position.x, position.y, position.z] : camera.target;
  const rotation = [0, sin(turn / 2), 0, cos(turn / 2)] as const;
  const moved = rotate(rotation, [scale * anchor[0], scale * anchor[1], scale * anchor[2]]);
  return { scale, rotation, position: [x - moved[0], y - moved[1], z - moved[2]] };
}

/** A surface of the model, with what moves each vertex. */
interface ModelSurface extends SurfaceDescription {
  readonly carriers: Uint16Array;
  /** Whether its vertices are in the space of the carrier of its part. */
  readonly carrier: number | undefined;
}

class Build {
  readonly firstPart: number;
  readonly carriers: readonly Carrier[];
  private readonly poser: Poser;
  private readonly place: Place;
  private readonly pieces: readonly Piece[];
  /** By node. */
  private readonly solids = new Map<number, Solid>();
  /** For the vertices of skins that each carrier moves most, in its space. */
  private readonly capsules: ReadonlyMap<number, Capsule>;
  private readonly rows: Row[];
  private readonly file: ModelFile;
  private readonly emissionCount: number;
  /** Index of the carrier of each node. */
  private readonly carrierOf: readonly number[];
  private readonly firsts: readonly Placement[];
  private readonly rowElements: Float32Array;

  constructor(base: Scene, file: ModelFile, poser: Poser, place: Place, pieces: readonly Piece[], rows: Row[]) {
    this.file = file;
    this.poser = poser;
    this.place = place;
    this.pieces = pieces;
    this.rows = rows;
    this.firstPart = base.parts?.length ?? 0;
    this.emissionCount = MAX_EMISSION_SURFACES - (base.emissionSurfaces?.length ?? 0);
    this.carriers = this.chooseCarriers(MAX_PARTS - this.firstPart);
    const index = new Map(this.carriers.map(({ node }, carrier) => [node, carrier]));
    const carrierOf = file.nodes.map(() => 0);
    for (const node of file.order) {
      const { parent } = file.nodes[node];
      carrierOf[node] = index.get(node) ?? (parent < 0 ? 0 : carrierOf[parent]);
    }
    this.carrierOf = carrierOf;
    this.firsts = this.carriers.map((_, carrier) => this.placement(carrier, 0));
    this.rowNodes();
    this.rowElements = new Float32Array(16 * this.rows.length);
    this.capsules = this.fittedCapsules();
  }

  /** Separates what encloses volumes from what does not. Surfaces and casters need it. */
  *separate(): Work<void> {
    const thickness = THICKNESS * Math.max(...sidesOf(boxOf(this.pieces)));
    for (const [node, own] of groupedBy(this.pieces, (piece) => piece.node)) {
      this.solids.set(node, yield* solidOf(own, thickness));
      yield;
    }
  }

  /** Where a carrier is. */
  placement(carrier: number, seconds: number): Placement {
    const { node } = this.carriers[carrier];
    return node < 0
      ? { position: this.place.position, rotation: this.place.rotation }
      : this.poser.placement(node, seconds);
  }

  parts(): MovingPart[] {
    return this.carriers.map(({ name }, carrier) => ({ name, pose: (seconds) => this.placement(carrier, seconds) }));
  }

  /** Matrices of the rows, from the first pose. Valid until the next call. */
  rowsAt(seconds: number): Float32Array {
    const poses = this.poser.at(seconds);
    this.rows.forEach((row, index) => writeRow(row, poses, this.rowElements, 16 * index));
    return this.rowElements;
  }

  /** What moves by itself comes first, then what has triangles, then the other nodes. */
  private chooseCarriers(most: number): Carrier[] {
    const { nodes, order, animations } = this.file;
    const own = new Set(animations.flatMap(({ channels }) => channels.map(({ node }) => node)));
    const joints = new Set(this.file.skins.flatMap(({ joints: all }) => all));
    const ever = movedBy(animations, nodes, order);
    const carries = nodes.map(({ mesh }, node) => mesh !== undefined || joints.has(node));
    for (const node of order.toReversed())
      if (carries[node] && nodes[node].parent >= 0) carries[nodes[node].parent] = true;
    const rank = (node: number) => {
      if (own.has(node)) return carries[node] ? 0 : 1;
      return nodes[node].mesh !== undefined && nodes[node].skin === undefined
        ? 2
        : ever[node] && joints.has(node)
          ? 4
          : 3;
    };
    const ranked = [...order].sort((one, other) => rank(one) - rank(other)).slice(0, Math.max(0, most - 1));
    const root = { node: -1, name: 'model', isMoving: false };
    return [
      root,
      ...ranked.map((node) => ({ node, name: nodes[node].name, isMoving: this.poser.isMoving[node] })),
    ].slice(0, Math.max(1, most));
  }

  /** Gives a row to each piece of a node that moves but that its part does not carry exactly. */
  private rowNodes(): void {
    const { nodes } = this.file;
    const scaled = new Set(
      this.file.animations.flatMap(({ channels }) =>
        channels.filter(({ path }) => path === 'scale').map(({ node }) => node),
      ),
    );
    const isExact = (node: number) => {
      for (let at = node; at >= 0; at = nodes[at].parent) if (scaled.has(at)) return false;
      const { node: carrier } = this.carriers[this.carrierOf[node]];
      return carrier < 0 ? !this.poser.isMoving[node] : this.movesWith(node, carrier);
    };
    const kinds = new Set<string>();
    const rowsOf = new Map<number, number>();
    const moving = this.pieces.filter(({ node, rows }) => !rows && this.poser.isMoving[node]);
    (this.pieces as Piece[]).forEach((piece, index) => {
      const { node } = piece;
      if (!moving.includes(piece)) return;
      kinds.add(`${this.carrierOf[node]} ${piece.color.join()}`);
      if (isExact(node) && kinds.size <= MAX_PLACED) return;
      const row = rowsOf.get(node) ?? this.rows.push(rigidRow(node, this.poser)) - 1;
      rowsOf.set(node, row);
      const rows = new Uint16Array(piece.movers.length).fill(row);
      (this.pieces as Piece[])[index] = { ...piece, rows };
    });
  }

  /** Whether nothing between a node and the one that carries it moves. */
  private movesWith(node: number, carrier: number): boolean {
    const { nodes, animations } = this.file;
    const own = new Set(animations.flatMap(({ channels }) => channels.map((channel) => channel.node)));
    for (let at = node; at !== carrier; at = nodes[at].parent) if (at < 0 || own.has(at)) return false;
    return true;
  }

  private isPlaced({ node, rows }: Piece): boolean {
    return rows === undefined && this.poser.isMoving[node];
  }

  /** What is drawn: a surface for each colour and for each part that moves. */
  surfaces(inked: boolean): ModelSurface[] {
    const groups = new Map<string, Piece[]>();
    for (const piece of [...this.solids.values()].flatMap(({ drawn }) => drawn)) {
      const mover = piece.rows ? 'rows' : this.isPlaced(piece) ? this.carrierOf[piece.node] : 'still';
      const key = `${mover} ${piece.color.join()}`;
      addTo(groups, key, piece);
    }
    const group = groups.size > MAX_SEPARATED ? { group: 'model' } : {};
    return [...groups.values()].map((pieces, index) => {
      const [first] = pieces;
      const carrier = this.isPlaced(first) ? this.carrierOf[first.node] : undefined;
      const joined = joinedPieces(pieces);
      const mesh = carrier === undefined ? joined : inSpace(joined, this.firsts[carrier]);
      return {
        name: `model ${index}`,
        mesh,
        color: first.color,
        casts: false,
        inked,
        ...group,
        ...(carrier !== undefined && { part: this.firstPart + carrier }),
        ...(first.rows && { skin: inOneArray(pieces.map(({ rows }) => rows!)) }),
        carriers: inOneArray(pieces.map(({ movers }) => movers.map((node) => this.carrierOf[node]))),
        carrier,
      };
    });
  }

  /** Closed parts cast by volumes, tangled ones by balls, and skins by capsules along their bones. */
  *casters(): Work<SurfaceDescription[]> {
    const found: { mesh: TriangleMesh; carrier: number; isMoving: boolean; area: number }[] = [];
    for (const [node, solid] of this.solids) {
      const pieces = solid.pieces.filter(({ isSkinned }) => !isSkinned);
      if (pieces.length === 0) continue;
      yield;
      const { mesh, parts } = pieces.length === solid.pieces.length ? solid : yield* solidOf(pieces, 0);
      const isClosed = solid.drawn === solid.pieces;
      const thick = isClosed ? solid.mesh : joinedPieces(solid.drawn);
      const own = {
        carrier: this.carrierOf[node],
        isMoving: this.poser.isMoving[node],
        area: areaOf(mesh, mesh.indices),
      };
      const { closed } = isClosed ? solid.parts : partsOf(thick);
      // The same mesh if it is all closed, so that what the renderer derives from it is derived once.
      const isWhole = closed.length === thick.indices.length;
      if (closed.length > 0)
        found.push({ ...own, mesh: isWhole ? thick : { ...thick, indices: verticesOf(thick, closed) } });
      const balls = parts.tangled
        .flatMap((corners) => coveringBalls(mesh, verticesOf(mesh, corners)))
        .filter(({ radius }) => radius > SMALLEST_BALL);
      if (balls.length > 0) found.push({ ...own, mesh: insideOut(balls) });
    }
    const rigid = found.map(({ carrier, isMoving, mesh, area }) => ({
      area,
      part: isMoving ? carrier : undefined,
      mesh: isMoving ? inSpace(mesh, this.firsts[carrier]) : mesh,
    }));
    const skinned = [...this.capsules]
      .filter(([, { radius }]) => radius > SMALLEST_BALL)
      .map(([carrier, capsule]) => ({
        area: Infinity,
        part: carrier as number | undefined,
        mesh: insideOut([capsule]),
      }));
    return [...rigid, ...skinned]
      .sort((one, other) => other.area - one.area || 0)
      .slice(0, MAX_CASTERS)
      .map(({ mesh, part }, index) => ({
        name: `shadow of the model ${index}`,
        mesh,
        color: [0, 0, 0],
        casts: true,
        inked: false,
        hidden: true,
        ...(part !== undefined && { part: this.firstPart + part }),
      }));
  }

  /** What smoke collides with: triangles, and capsules along bones. */
  colliders(): { rigid: RigidDescription; carrier: number | undefined }[] {
    const shapes = new Map<number, RigidPart[]>();
    const add = (carrier: number, part: RigidPart) => addTo(shapes, carrier, part);
    const groups = groupedBy(this.rigidPieces, ({ node }) => (this.poser.isMoving[node] ? this.carrierOf[node] : 0));
    for (const [carrier, pieces] of groups) {
      const { positions, indices } = inSpace(joinedPieces(pieces), this.firsts[carrier]);
      add(carrier, { shape: { type: 'trimesh', vertices: positions, indices }, position: [0, 0, 0] });
    }
    for (const [carrier, { position, rotation, halfHeight, radius }] of this.capsules) {
      const shape =
        halfHeight > 0 ? ({ type: 'capsule', halfHeight, radius } as const) : ({ type: 'ball', radius } as const);
      add(carrier, { shape, position, rotation });
    }
    return [...shapes].map(([carrier, parts]) => {
      const { isMoving } = this.carriers[carrier];
      const isPlain = parts.length === 1 && parts[0].shape.type === 'trimesh';
      return {
        rigid: {
          kind: isMoving ? 'kinematic' : 'fixed',
          shape: isPlain ? parts[0].shape : { type: 'compound', parts },
          ...this.firsts[carrier],
        },
        carrier: isMoving ? carrier : undefined,
      };
    });
  }

  /** Triangles of the carriers with the most of them, in their spaces. */
  emissionSurfaces(): { carrier: number; mesh: Pick<TriangleMesh, 'positions' | 'indices'> }[] {
    const { carrierOf } = this;
    const byCarrier = new Map<number, { piece: Piece; indices: number[] }[]>();
    for (const piece of this.pieces) {
      const own = new Map<number, number[]>();
      const { indices, movers } = piece;
      for (let first = 0; first < indices.length; first += 3) {
        const carrier = carrierOf[movers[indices[first]]];
        const into = own.get(carrier) ?? [];
        if (into.length === 0) own.set(carrier, into);
        into.push(indices[first], indices[first + 1], indices[first + 2]);
      }
      for (const [carrier, some] of own) addTo(byCarrier, carrier, { piece, indices: some });
    }
    const triangles = (parts: readonly { indices: number[] }[]) =>
      parts.reduce((sum, { indices }) => sum + indices.length, 0);
    return [...byCarrier]
      .sort(([one, few], [other, many]) => triangles(many) - triangles(few) || one - other)
      .map(([carrier, parts]) => {
        const joined = joinedPieces(
          parts.map(({ piece, indices }) => only({ ...piece, indices: Uint32Array.from(indices) })),
        );
        return { carrier, mesh: inSpace(joined, this.firsts[carrier]) };
      })
      .filter(({ mesh }) => areaOf(mesh, mesh.indices) > 1e-8)
      .slice(0, Math.max(0, this.emissionCount))
      .sort((one, other) => one.carrier - other.carrier);
  }

  private fittedCapsules(): Map<number, Capsule> {
    const points = new Map<number, number[]>();
    for (const { movers, positions, isSkinned } of this.pieces) {
      if (!isSkinned) continue;
      for (let vertex = 0; vertex < movers.length; vertex++) {
        const carrier = this.carrierOf[movers[vertex]];
        const into = points.get(carrier) ?? [];
        if (into.length === 0) points.set(carrier, into);
        const place = [positions[3 * vertex], positions[3 * vertex + 1], positions[3 * vertex + 2]] as const;
        const [x, y, z] = inSpaceOf(this.firsts[carrier], place);
        into.push(x, y, z);
      }
    }
    const isEnough = ([, numbers]: [number, number[]]) => numbers.length >= 12;
    return new Map(
      [...points].filter(isEnough).map(([carrier, numbers]) => [carrier, fittedCapsule(Float32Array.from(numbers))]),
    );
  }

  private get rigidPieces(): Piece[] {
    return this.pieces.filter(({ isSkinned }) => !isSkinned);
  }

  /** The nearest place on a ray. */
  pick(surfaces: readonly ModelSurface[], origin: Vector, direction: Vector, seconds: number): Picked | undefined {
    const rows = this.rows.length > 0 ? this.rowsAt(seconds) : undefined;
    let nearest = Infinity;
    let found: { carrier: number; normal: Vector } | undefined;
    for (const { mesh, carrier, carriers, skin } of surfaces) {
      const placement = carrier === undefined ? undefined : this.placement(carrier, seconds);
      const positions = placedPositions(mesh.positions, placement, skin, rows);
      for (let first = 0; first < mesh.indices.length; first += 3) {
        const [a, b, c] = mesh.indices.subarray(first, first + 3);
        const distance = distanceTo(positions, a, b, c, origin, direction);
        if (!(distance < nearest)) continue;
        nearest = distance;
        const normal = normalOf(positions, a, b, c);
        const isBack = normal[0] * direction[0] + normal[1] * direction[1] + normal[2] * direction[2] > 0;
        found = { carrier: carriers[a], normal: isBack ? [-normal[0], -normal[1], -normal[2]] : normal };
      }
    }
    if (!found) return undefined;
    const { carrier, normal } = found;
    const placement = this.placement(carrier, seconds);
    const place: Vector = [0, 1, 2].map((axis) => origin[axis] + nearest * direction[axis]) as unknown as Vector;
    return {
      distance: nearest,
      node: carrier,
      position: inSpaceOf(placement, place),
      direction: inSpaceOf({ ...placement, position: [0, 0, 0] }, normal),
    };
  }
}

function groupedBy<Item>(items: readonly Item[], keyOf: (item: Item) => number): Map<number, Item[]> {
  const groups = new Map<number, Item[]>();
  for (const item of items) addTo(groups, keyOf(item), item);
  return groups;
}

function addTo<Key, Item>(groups: Map<Key, Item[]>, key: Key, item: Item): void {
  const own = groups.get(key);
  if (own) own.push(item);
  else groups.set(key, [item]);
}

function rigidRow(node: number, poser: Poser): Row {
  const identity = Float64Array.of(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1);
  const { matrices } = poser.at(0);
  const inverse = inverted(matrices.subarray(16 * node, 16 * node + 16)) ?? identity;
  return { weights: [{ share: 1, node, inverse }], fromFirst: undefined };
}

/** The vertices of corners. */
function verticesOf({ indices }: TriangleMesh, corners: ArrayLike<number>): Uint32Array {
  const vertices = new Uint32Array(corners.length);
  for (let at = 0; at < corners.length; at++) vertices[at] = indices[corners[at]];
  return vertices;
}

/** The pieces of a node. */
interface Solid {
  readonly pieces: readonly Piece[];
  /** All of them in one mesh, and its parts. */
  readonly mesh: TriangleMesh;
  readonly parts: Parts;
  /** The pieces with thickness where they are not closed, as they are drawn; `pieces` if all are closed. */
  readonly drawn: readonly Piece[];
}

/** @param thickness metres; 0 for none */
function* solidOf(pieces: readonly Piece[], thickness: number): Work<Solid> {
  const mesh = joinedPieces(pieces);
  const parts = partsOf(mesh);
  yield;
  return { pieces, mesh, parts, drawn: thickness > 0 ? thickened(pieces, mesh, parts, thickness) : pieces };
}

/**
 * The pieces of a node, with a second layer behind triangles that enclose nothing, and walls at their borders: they are seen
 * from both sides and have outlines, and without tangles they cast as closed meshes do.
 * @param thickness metres
 */
function thickened(
  pieces: readonly Piece[],
  mesh: TriangleMesh,
  { bordered, borders, tangled }: Parts,
  thickness: number,
): readonly Piece[] {
  if (bordered.length === 0 && tangled.length === 0) return pieces;
  const outward = hullNormals(mesh);
  const firsts = [0];
  for (const { indices } of pieces) firsts.push(firsts.at(-1)! + indices.length);
  const open = sharedOut([bordered, ...tangled], firsts);
  const ends = sharedOut([borders], firsts);
  let firstVertex = 0;
  return pieces.map((piece, index) => {
    const own = outward.subarray(3 * firstVertex, 3 * firstVertex + piece.positions.length);
    firstVertex += piece.positions.length / 3;
    return doubled(piece, open[index], ends[index], own, thickness);
  });
}

/**
 * The corners of each piece, counted from its first one.
 * @param firsts first corner of each piece, and the end of the last
 */
function sharedOut(lists: readonly ArrayLike<number>[], firsts: readonly number[]): number[][] {
  const found = firsts.slice(1).map((): number[] => []);
  let piece = 0;
  for (const corners of lists) {
    for (let at = 0; at < corners.length; at++) {
      const corner = corners[at];
      if (corner < firsts[piece]) piece = 0;
      while (corner >= firsts[piece + 1]) piece++;
      found[piece].push(corner - firsts[piece]);
    }
  }
  return found;
}

/** @param corners of the triangles to double. @param borders corners where their borders begin */
function doubled(
  piece: Piece,
  corners: readonly number[],
  borders: readonly number[],
  outward: Float32Array,
  thickness: number,
): Piece {
  const count = piece.positions.length / 3;
  const most = count + Math.min(count, corners.length) + 4 * borders.length;
  const positions = longer(piece.positions, 3 * most);
  const normals = longer(piece.normals, 3 * most);
  const indices = longer(piece.indices, piece.indices.length + corners.length + 6 * borders.length);
  const movers = longer(piece.movers, most);
  const rows = piece.rows && longer(piece.rows, most);
  let [end, endIndex] = [count, piece.indices.length];
  const add = (vertex: number, depth: number, x: number, y: number, z: number) => {
    for (let axis = 0; axis < 3; axis++)
      positions[3 * end + axis] = piece.positions[3 * vertex + axis] - depth * outward[3 * vertex + axis];
    normals[3 * end] = x;
    normals[3 * end + 1] = y;
    normals[3 * end + 2] = z;
    movers[end] = piece.movers[vertex];
    if (rows) rows[end] = rows[vertex];
    return end++;
  };
  const behind = new Int32Array(count).fill(-1);
  const back = (corner: number) => {
    const vertex = piece.indices[corner];
    const at = 3 * vertex;
    if (behind[vertex] < 0)
      behind[vertex] = add(vertex, thickness, -piece.normals[at], -piece.normals[at + 1], -piece.normals[at + 2]);
    return behind[vertex];
  };
  for (let at = 0; at < corners.length; at += 3) {
    indices[endIndex++] = back(corners[at]);
    indices[endIndex++] = back(corners[at + 2]);
    indices[endIndex++] = back(corners[at + 1]);
  }
  for (const start of borders) {
    const [a, b] = [start, start % 3 < 2 ? start + 1 : start - 2].map((corner) => piece.indices[corner]);
    const along = [0, 1, 2].map((axis) => piece.positions[3 * b + axis] - piece.positions[3 * a + axis]);
    const up = outward.subarray(3 * a, 3 * a + 3);
    const normal = normalized(
      along[1] * up[2] - along[2] * up[1],
      along[2] * up[0] - along[0] * up[2],
      along[0] * up[1] - along[1] * up[0],
    );
    const [near, far] = [0, thickness].map((depth) => [a, b].map((vertex) => add(vertex, depth, ...normal)));
    indices.set([near[1], near[0], far[0], near[1], far[0], far[1]], endIndex);
    endIndex += 6;
  }
  return {
    ...piece,
    positions: positions.slice(0, 3 * end),
    normals: normals.slice(0, 3 * end),
    indices,
    movers: movers.slice(0, end),
    rows: rows?.slice(0, end),
  };
}

/** A copy with more room. */
function longer<Values extends Float32Array | Uint32Array | Uint16Array>(values: Values, length: number): Values {
  const copy = new (values.constructor as new (count: number) => Values)(length);
  copy.set(values);
  return copy;
}

function joinedPieces(pieces: readonly Piece[]): TriangleMesh {
  if (pieces.length === 1) return meshOf(pieces[0]);
  const count = pieces.reduce((sum, { positions }) => sum + positions.length, 0);
  const [positions, normals] = [new Float32Array(count), new Float32Array(count)];
  const indices = new Uint32Array(pieces.reduce((sum, piece) => sum + piece.indices.length, 0));
  let [at, corner] = [0, 0];
  for (const piece of pieces) {
    positions.set(piece.positions, at);
    normals.set(piece.normals, at);
    const first = at / 3;
    for (let each = 0; each < piece.indices.length; each++) indices[corner++] = first + piece.indices[each];
    at += piece.positions.length;
  }
  return { positions, normals, indices };
}

/** The same mesh for each call, so that what the renderer derives from it is derived once. */
const meshOf = memoize(({ positions, normals, indices }: Piece): TriangleMesh => ({ positions, normals, indices }));

/** A piece with the vertices of its triangles only. */
function only(piece: Piece): Piece {
  const numbers = new Int32Array(piece.movers.length).fill(-1);
  const kept: number[] = [];
  const indices = piece.indices.map((vertex) => {
    if (numbers[vertex] < 0) numbers[vertex] = kept.push(vertex) - 1;
    return numbers[vertex];
  });
  const each = (values: Float32Array) => {
    const some = new Float32Array(3 * kept.length);
    for (let at = 0; at < some.length; at++) some[at] = values[3 * kept[Math.floor(at / 3)] + (at % 3)];
    return some;
  };
  return { ...piece, indices, positions: each(piece.positions), normals: each(piece.normals) };
}

function inOneArray(arrays: readonly Uint16Array[]): Uint16Array {
  const all = new Uint16Array(arrays.reduce((sum, { length }) => sum + length, 0));
  let at = 0;
  for (const array of arrays) {
    all.set(array, at);
    at += array.length;
  }
  return all;
}

/** A mesh of world space in the space of a placement. */
function inSpace({ positions, normals, indices }: TriangleMesh, { position, rotation }: Placement): TriangleMesh {
  const [x, y, z, w] = rotation;
  const turn = matrixOf([0, 0, 0, -x, -y, -z, w, 1, 1, 1]);
  const each = (values: Float32Array, from: Vector) => {
    const moved = new Float32Array(values.length);
    for (let first = 0; first < values.length; first += 3) {
      const a = values[first] - from[0];
      const b = values[first + 1] - from[1];
      const c = values[first + 2] - from[2];
      for (let axis = 0; axis < 3; axis++)
        moved[first + axis] = turn[axis] * a + turn[4 + axis] * b + turn[8 + axis] * c;
    }
    return moved;
  };
  return { positions: each(positions, position), normals: each(normals, [0, 0, 0]), indices };
}

function placedPositions(
  positions: Float32Array,
  placement: Placement | undefined,
  skin: Uint16Array | undefined,
  rows: Float32Array | undefined,
): Float32Array {
  if (!placement && !skin) return positions;
  const placed = new Float32Array(positions.length);
  for (let first = 0; first < positions.length; first += 3) {
    const [x, y, z] = [positions[first], positions[first + 1], positions[first + 2]];
    if (placement) {
      rotate(placement.rotation, [x, y, z]).forEach(
        (value, axis) => (placed[first + axis] = value + placement.position[axis]),
      );
      continue;
    }
    const row = 16 * skin![first / 3];
    for (let axis = 0; axis < 3; axis++)
      placed[first + axis] =
        rows![row + axis] * x + rows![row + 4 + axis] * y + rows![row + 8 + axis] * z + rows![row + 12 + axis];
  }
  return placed;
}

/**
 * Distance along a ray to a triangle, from either side; infinite if it misses (Möller and Trumbore, 'Fast, minimum storage
 * ray-triangle intersection', 1997).
 */
function distanceTo(
  positions: Float32Array,
  a: number,
  b: number,
  c: number,
  origin: Vector,
  direction: Vector,
): number {
  const side = (to: number, axis: number) => positions[3 * to + axis] - positions[3 * a + axis];
  const [ux, uy, uz] = [side(b, 0), side(b, 1), side(b, 2)];
  const [vx, vy, vz] = [side(c, 0), side(c, 1), side(c, 2)];
  const [dx, dy, dz] = direction;
  const [px, py, pz] = [dy * vz - dz * vy, dz * vx - dx * vz, dx * vy - dy * vx];
  const determinant = ux * px + uy * py + uz * pz;
  if (determinant === 0) return Infinity;
  const [tx, ty, tz] = [
    origin[0] - positions[3 * a],
    origin[1] - positions[3 * a + 1],
    origin[2] - positions[3 * a + 2],
  ];
  const u = (tx * px + ty * py + tz * pz) / determinant;
  const [qx, qy, qz] = [ty * uz - tz * uy, tz * ux - tx * uz, tx * uy - ty * ux];
  const v = (dx * qx + dy * qy + dz * qz) / determinant;
  const distance = (vx * qx + vy * qy + vz * qz) / determinant;
  return u >= 0 && v >= 0 && u + v <= 1 && distance > 0 ? distance : Infinity;
}
