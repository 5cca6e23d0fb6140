/** Closed meshes that a few balls do not stand for, some with colours, for tests of puffs from meshes. */
import { ExtrudeGeometry, Path, Shape, SphereGeometry, TorusGeometry, type BufferGeometry } from 'three';
import type { PlainMesh } from '../../src/renderer/puffs/fit/closedMesh.ts';
import { puffMesh } from '../../src/renderer/puffs/billboards/mesh.ts';
import { LOBE_SHAPES } from '../../src/renderer/puffs/lobeShapes.ts';

/** Radius of the ring of the torus, and of its tube. */
export const TORUS = [0.7, 0.25] as const;

/** A ring around the z axis: seen from +z it has a hole. */
export function torus(): PlainMesh {
  return plain(new TorusGeometry(...TORUS, 48, 96));
}

/** Three rings at right angles, which have deep steps behind their fronts. */
export function rings(): PlainMesh {
  const [a, b, c] = [0, 1, 2].map((axis) => {
    const ring = new TorusGeometry(0.8, 0.14, 16, 64);
    return axis === 0 ? ring : axis === 1 ? ring.rotateX(Math.PI / 2) : ring.rotateY(Math.PI / 2);
  });
  return joined([a, b, c].map(plain));
}

/**
 * A heart, upright and facing +z, with a hemisphere of radii along each direction: the zero set of a polynomial of
 * Taubin, 'An Accurate Algorithm for Rasterizing Algebraic Curves and Surfaces' (1994).
 */
export function heart(): PlainMesh {
  const ball = new SphereGeometry(1, 96, 64);
  const positions = ball.attributes.position.array;
  for (let at = 0; at < positions.length; at += 3) {
    const out = [positions[at], positions[at + 1], positions[at + 2]];
    const radius = firstRoot((r) => taubin(r * out[0], r * out[1], r * out[2]));
    for (const axis of [0, 1, 2]) positions[at + axis] = radius * out[axis];
  }
  const { positions: points, indices } = plain(ball);
  return { positions: points, indices };
}

function taubin(x: number, y: number, z: number): number {
  const inner = x * x + 2.25 * z * z + y * y - 1;
  return inner ** 3 - x * x * y ** 3 - 0.1125 * z * z * y ** 3;
}

function firstRoot(of: (r: number) => number): number {
  let [low, high] = [0, 2];
  for (let r = 0; r < 2; r += 0.01) if (of(r) > 0) { high = r; break; } // prettier-ignore
  low = high - 0.01;
  for (let step = 0; step < 30; step++) {
    const middle = (low + high) / 2;
    if (of(middle) > 0) high = middle;
    else low = middle;
  }
  return low;
}

/** Popcorn: overlapping balls, pale above, and a brown shell below. */
export function popcorn(): PlainMesh {
  const { positions, normals, indices } = puffMesh(LOBE_SHAPES[2].lobes, 0);
  const colors = new Float32Array(positions.length);
  for (let at = 0; at < positions.length; at += 3) {
    const isShell = positions[at + 1] < -0.35 - 0.3 * positions[at];
    colors.set(isShell ? [0.62, 0.36, 0.14] : [1, 0.97, 0.86], at);
  }
  return { positions, normals, indices, colors };
}

/** A ball of one colour per half: `upper` where y is above 0. */
export function halves(upper: readonly number[], lower: readonly number[]): PlainMesh {
  const mesh = plain(new SphereGeometry(1, 64, 33));
  const { positions } = mesh;
  const colors = Array.from({ length: positions.length / 3 }, (_, at) => (positions[3 * at + 1] > 0 ? upper : lower));
  return { ...mesh, colors: colors.flat() };
}

/** A ball with a painted face that looks at +z. */
export function face(): PlainMesh {
  const [width, height] = [512, 256];
  const data = new Uint8ClampedArray(4 * width * height);
  for (let at = 0; at < width * height; at++) data.set([...faceColor(at % width, Math.floor(at / width)), 255], 4 * at);
  // The sphere of three.js has u = 0.25 at +z; its v grows upwards.
  const ball = new SphereGeometry(1, 64, 48);
  const uvs = Array.from(ball.attributes.uv.array, (at, index) => (index % 2 === 0 ? at : 1 - at));
  return { ...plain(ball), uvs, texture: { width, height, data } };
}

function faceColor(x: number, y: number): readonly [number, number, number] {
  const [right, down] = [(x - 128) / 40, (y - 128) / 40];
  const isEye = ((Math.abs(right) - 0.7) / 0.28) ** 2 + ((down + 0.35) / 0.48) ** 2 < 1;
  const smile = Math.hypot(right, down - 0.15);
  const isMouth = down > 0.3 && smile > 0.85 && smile < 1.12;
  const isCheek = ((Math.abs(right) - 1.25) / 0.35) ** 2 + ((down - 0.35) / 0.25) ** 2 < 1;
  if (isEye || isMouth) return [40, 30, 60];
  return isCheek ? [255, 150, 150] : [255, 255, 255];
}

/** Cut out of a board, facing +z: a heart, a letter O that is higher than wide, and a slanted leaf with a stalk. */
export const CARDS = {
  heartCard: () => board(heartOutline()),
  letterO: () => board(ellipse(new Shape(), 0.7, 0.95), ellipse(new Path(), 0.4, 0.62)),
  leaf: () => board(leafOutline()),
} as const;

function heartOutline(): Shape {
  const outline = new Shape();
  outline.moveTo(0, -0.9);
  outline.bezierCurveTo(-0.4, -0.5, -1, -0.1, -1, 0.35);
  outline.bezierCurveTo(-1, 0.95, -0.2, 0.95, 0, 0.4);
  outline.bezierCurveTo(0.2, 0.95, 1, 0.95, 1, 0.35);
  outline.bezierCurveTo(1, -0.1, 0.4, -0.5, 0, -0.9);
  return outline;
}

function leafOutline(): Shape {
  const outline = new Shape();
  outline.moveTo(0.8, 0.8);
  outline.bezierCurveTo(-0.1, 1, -0.7, 0.3, -0.5, -0.42);
  outline.lineTo(-0.9, -0.82);
  outline.lineTo(-0.8, -0.9);
  outline.lineTo(-0.4, -0.5);
  outline.bezierCurveTo(0.2, -0.7, 0.95, -0.1, 0.8, 0.8);
  return outline;
}

function ellipse<Outline extends Path>(outline: Outline, width: number, height: number): Outline {
  outline.absellipse(0, 0, width, height, 0, 2 * Math.PI);
  return outline;
}

function board(outline: Shape, ...holes: Path[]): PlainMesh {
  outline.holes.push(...holes);
  const solid = new ExtrudeGeometry(outline, { depth: 0.3, bevelEnabled: false, curveSegments: 32 });
  return { positions: Float32Array.from(solid.attributes.position.array) };
}

function plain(geometry: BufferGeometry): PlainMesh & { positions: Float32Array; indices: Uint32Array } {
  const { position, normal } = geometry.attributes;
  return {
    positions: Float32Array.from(position.array),
    normals: Float32Array.from(normal.array),
    indices: Uint32Array.from(geometry.index!.array),
  };
}

function joined(meshes: readonly PlainMesh[]): PlainMesh {
  const all = { positions: [] as number[], normals: [] as number[], indices: [] as number[] };
  for (const { positions, normals, indices } of meshes) {
    const first = all.positions.length / 3;
    all.indices.push(...Array.from(indices!, (index) => first + index));
    all.positions.push(...Array.from(positions));
    all.normals.push(...Array.from(normals!));
  }
  return all;
}
