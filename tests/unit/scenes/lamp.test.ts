import { describe, expect, test } from 'vitest';
import { extrude, type TriangleMesh } from '../../../src/renderer/passes/extrusion.ts';
import { lampModel } from '../../../src/scenes/models/lamp.ts';
import { spline } from '../../../src/scenes/models/revolve.ts';
import { finished } from '../../../src/base/work.ts';

type Vector = readonly [x: number, y: number, z: number];

const { parts, spout, collision } = lampModel();

const dot = (a: Vector, b: Vector): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const minus = (a: Vector, b: Vector): Vector => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const cross = (a: Vector, b: Vector): Vector => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];

function triple(array: ArrayLike<number>, index: number): Vector {
  return [array[3 * index], array[3 * index + 1], array[3 * index + 2]];
}

function triples(array: ArrayLike<number>): Vector[] {
  return Array.from({ length: array.length / 3 }, (_, i) => triple(array, i));
}

function faces({ indices }: TriangleMesh): Vector[] {
  return triples(indices);
}

const partMesh = (name: string): TriangleMesh => parts.find((part) => part.name === name)!.mesh;

/** The point at `distance` metres outside the mouth. */
function beforeMouth(distance: number): Vector {
  const [x, y, z] = spout.position;
  const [dx, dy, dz] = spout.direction;
  return [x + distance * dx, y + distance * dy, z + distance * dz];
}

describe.each(parts)('the $name', ({ mesh }) => {
  test('is closed: at each edge two triangles meet that pass it in opposite directions', () => {
    const places = triples(mesh.positions).map((point) => point.join());
    const edges = faces(mesh).flatMap(([a, b, c]) =>
      [[a, b], [b, c], [c, a]].map(([from, to]) => `${places[from]}>${places[to]}`),
    ); // prettier-ignore
    const passed = new Set(edges);
    expect(passed.size).toBe(edges.length);
    expect(edges.filter((edge) => !passed.has(edge.split('>').toReversed().join('>')))).toEqual([]);
    expect(() => finished(extrude(mesh))).not.toThrow();
  });

  test('is wound outwards and encloses a volume; no triangle is degenerate', () => {
    let volume = 0;
    for (const [a, b, c] of faces(mesh)) {
      const [p, q, r] = [a, b, c].map((vertex) => triple(mesh.positions, vertex));
      volume += dot(p, cross(q, r)) / 6;
      expect(Math.hypot(...cross(minus(q, p), minus(r, p)))).toBeGreaterThan(1e-7);
    }
    expect(volume).toBeGreaterThan(1e-4);
  });

  test('has unit normals that agree with the winding', () => {
    for (const normal of triples(mesh.normals)) expect(Math.hypot(...normal)).toBeCloseTo(1, 5);
    for (const face of faces(mesh)) {
      const [p, q, r] = face.map((vertex) => triple(mesh.positions, vertex));
      const flat = cross(minus(q, p), minus(r, p));
      const length = Math.hypot(...flat);
      for (const vertex of face) expect(dot(flat, triple(mesh.normals, vertex)) / length).toBeGreaterThan(0.5);
    }
  });
});

describe('the lamp', () => {
  const points = parts.flatMap(({ mesh }) => triples(mesh.positions));

  test('stands on the ground, has the given size and 3,000 to 6,000 triangles', () => {
    expect(Math.min(...points.map(([, y]) => y))).toBe(0);
    expect(Math.max(...points.map(([, y]) => y))).toBeLessThan(0.8);
    const belly = triples(partMesh('belly').positions);
    expect(Math.max(...belly.map(([x, , z]) => (Math.abs(x) < 0.02 ? Math.abs(z) : 0)))).toBeCloseTo(0.45, 2);
    const triangles = parts.reduce((sum, { mesh }) => sum + mesh.indices.length / 3, 0);
    expect(triangles).toBeGreaterThan(3000);
    expect(triangles).toBeLessThan(6000);
  });

  test('is the same on both sides of z = 0', () => {
    for (const { mesh } of parts) {
      const sum = triples(mesh.positions).reduce((total, [, , z]) => total + z, 0);
      expect(Math.abs(sum)).toBeLessThan(1e-4);
    }
  });

  test('has a sharp edge under its foot and a smooth belly', () => {
    const sharpest = (mesh: TriangleMesh, isHere: (point: Vector) => boolean): number => {
      const at = new Map<string, Vector[]>();
      triples(mesh.positions).forEach((point, vertex) => {
        if (!isHere(point)) return;
        at.set(point.join(), [...(at.get(point.join()) ?? []), triple(mesh.normals, vertex)]);
      });
      return Math.min(...[...at.values()].flatMap((normals) => normals.map((normal) => dot(normal, normals[0]))));
    };
    expect(sharpest(partMesh('foot'), ([, y]) => y === 0)).toBeLessThan(0.8);
    expect(sharpest(partMesh('belly'), ([, y]) => y < 0.44)).toBeGreaterThan(0.999);
  });
});

describe('the spout', () => {
  const points = triples(partMesh('spout').positions);
  const along = (point: Vector): number => dot(minus(point, spout.position), spout.direction);
  const aside = (point: Vector): number => Math.hypot(...cross(minus(point, spout.position), spout.direction));

  test('ends at its mouth, which points up and out', () => {
    expect(spout.position).toEqual([0.95, 0.62, 0]);
    expect(Math.hypot(...spout.direction)).toBeCloseTo(1, 6);
    expect(spout.direction[0]).toBeGreaterThan(0.3);
    expect(spout.direction[1]).toBeGreaterThan(0.3);
    const rim = points.filter((point) => Math.abs(along(point)) < 1e-3 && aside(point) < 0.12);
    expect(rim.length).toBeGreaterThanOrEqual(20);
    expect(Math.max(...points.map(along))).toBeLessThan(1e-3);
    const middle = rim.reduce<Vector>((sum, [x, y, z]) => [sum[0] + x, sum[1] + y, sum[2] + z], [0, 0, 0]);
    middle.forEach((sum, axis) => expect(sum / rim.length).toBeCloseTo(spout.position[axis], 4));
  });

  test('is hollow at the mouth, with the given width', () => {
    const near = points.filter((point) => along(point) > -0.04 && along(point) < 0.5);
    expect(Math.min(...near.map(aside))).toBeGreaterThan(spout.radius * 0.95);
    expect(Math.min(...near.map(aside))).toBeLessThan(spout.radius * 1.3);
  });
});

describe('the collision pieces', () => {
  /** Directions on a spiral over the sphere. */
  const directions = Array.from({ length: 600 }, (_, i): Vector => {
    const y = 1 - (2 * i + 1) / 600;
    const angle = i * Math.PI * (3 - Math.sqrt(5));
    return [Math.sqrt(1 - y * y) * Math.cos(angle), y, Math.sqrt(1 - y * y) * Math.sin(angle)];
  });

  /** Lower bound of a point's distance from the convex hull of some corners, negative inside. */
  function outsideHull(corners: readonly Vector[]): (point: Vector) => number {
    const supports = directions.map((direction) => Math.max(...corners.map((corner) => dot(corner, direction))));
    return (point) => Math.max(...directions.map((direction, i) => dot(point, direction) - supports[i]));
  }

  /** Distance of a point from a mesh, from samples on its triangles with a spacing of one centimetre. */
  function fromMesh(vertices: readonly Vector[], triangles: readonly Vector[]): (point: Vector) => number {
    const shares = [0, 1, 2, 3, 4, 5, 6].flatMap((i) => Array.from({ length: 7 - i }, (_, j) => [i / 6, j / 6]));
    const spread = triangles.flatMap(([a, b, c]) =>
      shares.map(([u, v]) => mixed(vertices[a], vertices[b], vertices[c], u, v)),
    );
    return (point) => spread.reduce((least, place) => Math.min(least, Math.hypot(...minus(point, place))), Infinity);
  }

  function mixed(a: Vector, b: Vector, c: Vector, u: number, v: number): Vector {
    const w = 1 - u - v;
    return [w * a[0] + u * b[0] + v * c[0], w * a[1] + u * b[1] + v * c[1], w * a[2] + u * b[2] + v * c[2]];
  }

  const outside = collision.map((shape) => {
    if (shape.type === 'convexHull') return outsideHull(triples(shape.vertices));
    if (shape.type === 'trimesh') return fromMesh(triples(shape.vertices), triples(shape.indices));
    throw new Error(`A ${shape.type} is not expected.`);
  });
  const clearance = (point: Vector): number => Math.min(...outside.map((from) => from(point)));

  test('leave the mouth and the space in front of it open', () => {
    for (let distance = -0.03; distance < 0.5; distance += 0.02) {
      expect(clearance(beforeMouth(distance))).toBeGreaterThan(0.03);
    }
  });

  test('contain the lamp except its lip, and do not extend beyond it', () => {
    for (const { mesh } of parts) {
      for (const point of triples(mesh.positions)) {
        if (Math.hypot(...minus(point, spout.position)) > 0.2) expect(clearance(point)).toBeLessThan(0.02);
      }
    }
    const corners = collision.flatMap((shape) => ('vertices' in shape ? triples(shape.vertices) : []));
    const vertices = parts.flatMap(({ mesh }) => triples(mesh.positions));
    for (const direction of directions) {
      const [ours, lamps] = [corners, vertices].map((list) => Math.max(...list.map((point) => dot(point, direction))));
      // Corners of the pieces are on the true surface; edges of the mesh are up to 2 mm inside it.
      expect(ours).toBeLessThan(lamps + 0.003);
    }
  });

  test('are few and coarse, and triangle meshes are closed', () => {
    expect(collision.length).toBeLessThanOrEqual(12);
    for (const shape of collision) {
      if (shape.type === 'convexHull') expect(shape.vertices.length / 3).toBeLessThanOrEqual(100);
      if (shape.type !== 'trimesh') continue;
      const [positions, indices] = [Float32Array.from(shape.vertices), Uint32Array.from(shape.indices)];
      expect(indices.length / 3).toBeLessThanOrEqual(200);
      expect(() =>
        finished(extrude({ positions, normals: new Float32Array(positions.length), indices })),
      ).not.toThrow();
    }
  });

  test('leave the loop of the handle open', () => {
    expect(clearance([-0.6, 0.37, 0])).toBeGreaterThan(0.03);
  });
});

test('a spline passes through its points and ends on them to the last bit', () => {
  const points = [[0.1, 0.7], [0.3, -0.2], [0.55, 0.4], [0.9, 0.1]]; // prettier-ignore
  const curve = spline(points);
  points.forEach((point, i) => expect(curve(i / 3)[1]).toBeCloseTo(point[1], 12));
  expect(curve(0)).toEqual(points[0]);
  expect(curve(1)).toEqual(points[3]);
  const [before, after] = [curve(1 / 3 - 1e-6), curve(1 / 3 + 1e-6)];
  const slope = (a: number[], b: number[]): number => (b[1] - a[1]) / 1e-6;
  expect(slope(before, curve(1 / 3))).toBeCloseTo(slope(curve(1 / 3), after), 3);
});
