import { Matrix4, Vector3, type InstancedMesh, type Mesh, type Object3D, type SkinnedMesh } from 'three';

/** A ball that stands in for a part of something that bends: it follows an object, such as a bone. */
export interface ProxyBall {
  follows: Object3D;
  /** Its centre in the space of what it follows; the origin there when left out. */
  center?: Vector3;
  /** In the space of what it follows, which may be scaled. */
  radius: number;
}

/** A ball in world space. */
export interface Ball {
  center: Vector3;
  radius: number;
}

/** Tells where a ball is now; the same object each time. */
export type BallAt = () => Ball;

/** The share of a part's reach that its ball has: limbs are thinner than they are long. */
const FILLING = 0.75;

/** Follows a proxy through the world. */
export function follow({ follows, center, radius }: ProxyBall): BallAt {
  const ball = { center: new Vector3(), radius };
  return () => {
    if (center) ball.center.copy(center).applyMatrix4(follows.matrixWorld);
    else ball.center.setFromMatrixPosition(follows.matrixWorld);
    ball.radius = radius * follows.matrixWorld.getMaxScaleOnAxis();
    return ball;
  };
}

/** A ball for each instance of a mesh, as large as the mesh. */
export function instanceBalls(mesh: InstancedMesh): BallAt[] {
  if (!mesh.geometry.boundingSphere) mesh.geometry.computeBoundingSphere();
  const sphere = mesh.geometry.boundingSphere!;
  const world = new Matrix4();
  return Array.from({ length: mesh.count }, (_, index) => {
    const ball = { center: new Vector3(), radius: 0 };
    return () => {
      mesh.getMatrixAt(index, world);
      world.premultiply(mesh.matrixWorld);
      ball.center.copy(sphere.center).applyMatrix4(world);
      ball.radius = sphere.radius * world.getMaxScaleOnAxis();
      return ball;
    };
  });
}

/** A ball for each bone that moves some of the skin more than any other bone does, in its middle. */
export function boneBalls(mesh: SkinnedMesh): ProxyBall[] {
  const parts = new Map<number, Vector3[]>();
  const { position, skinIndex, skinWeight } = mesh.geometry.attributes;
  for (let vertex = 0; vertex < position.count; ++vertex) {
    const weights = [0, 1, 2, 3].map((slot) => skinWeight.getComponent(vertex, slot));
    const bone = skinIndex.getComponent(vertex, weights.indexOf(Math.max(...weights)));
    if (!parts.has(bone)) parts.set(bone, []);
    const place = new Vector3().fromBufferAttribute(position, vertex).applyMatrix4(mesh.bindMatrix);
    parts.get(bone)!.push(place.applyMatrix4(mesh.skeleton.boneInverses[bone]));
  }
  return [...parts].map(([bone, places]) => ({ follows: mesh.skeleton.bones[bone], ...ballAround(places) }));
}

/** The balls that stand in for a mesh of which the parts move by themselves; none for one that is rigid. */
export function ballsOf(mesh: Mesh): BallAt[] {
  if ('isSkinnedMesh' in mesh) return boneBalls(mesh as SkinnedMesh).map(follow);
  if ('isInstancedMesh' in mesh) return instanceBalls(mesh as InstancedMesh);
  return [];
}

function ballAround(places: readonly Vector3[]): { center: Vector3; radius: number } {
  const center = new Vector3();
  for (const place of places) center.addScaledVector(place, 1 / places.length);
  return { center, radius: FILLING * Math.max(...places.map((place) => place.distanceTo(center))) };
}
