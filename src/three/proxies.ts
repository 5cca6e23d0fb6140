import {
  Matrix4,
  Vector3,
  type BatchedMesh,
  type Bone,
  type InstancedMesh,
  type Mesh,
  type Object3D,
  type SkinnedMesh,
} from 'three';
import { ParameterError, requireOptions } from '../base/errors.ts';
import { instancesOf } from './shapes.ts';

/** A ball that approximates a part of a deforming object. It follows an object, such as a bone. */
export interface ProxyBall {
  follows: Object3D;
  /** Centre in the local space of `follows`. Default: its origin. */
  center?: Vector3;
  /** Radius in the local space of `follows`, which may be scaled. */
  radius: number;
}

/** A capsule that approximates a limb or a beam: a segment in the local space of `follows`, and a radius. */
export interface ProxyCapsule {
  follows: Object3D;
  from: Vector3;
  to: Vector3;
  radius: number;
}

/**
 * Maximum distance between the balls of a capsule, as a fraction of its radius. The outline then dips by 3 % of the
 * radius.
 */
const CAPSULE_PITCH = 0.5;

/**
 * Converts a capsule to overlapping balls for `cast` and `collide`.
 * @throws ParameterError when the radius is not above 0
 */
export function capsule(given: ProxyCapsule): ProxyBall[] {
  requireOptions('capsule', given, ['follows', 'from', 'to', 'radius']);
  const { follows, from, to, radius } = given;
  for (const [key, end] of Object.entries({ from, to }))
    if (!(end as Vector3 | undefined)?.isVector3) throw new ParameterError(`capsule.${key}`, end, 'a Vector3');
  if (!(radius > 0)) throw new ParameterError('capsule.radius', radius, 'a length above 0');
  const steps = Math.ceil(from.distanceTo(to) / (CAPSULE_PITCH * radius));
  return Array.from({ length: steps + 1 }, (_, step) => ({
    follows,
    center: from.clone().lerp(to, steps > 0 ? step / steps : 0),
    radius,
  }));
}

/** @throws ParameterError for a proxy that follows no object, or without a finite centre and radius */
export function requireProxies(call: string, proxies: readonly ProxyBall[] | undefined): void {
  if (proxies === undefined) return;
  if (!Array.isArray(proxies)) throw new ParameterError(`${call}.proxies`, proxies, 'an array of proxy balls');
  (proxies as readonly ProxyBall[]).forEach((proxy, index) => {
    const key = `${call}.proxies.${index}`;
    if (!proxy?.follows?.isObject3D)
      throw new ParameterError(`${key}.follows`, proxy?.follows, 'an Object3D of three.js');
    const { center, radius } = proxy;
    if (!(radius > 0 && radius < Infinity)) throw new ParameterError(`${key}.radius`, radius, 'a length above 0');
    if (center && !Number.isFinite(center.x + center.y + center.z))
      throw new ParameterError(`${key}.center`, `${center.x}, ${center.y}, ${center.z}`, 'a finite vector');
  });
}

/** A ball in world space. */
export interface Ball {
  center: Vector3;
  radius: number;
}

/** Returns the current ball; the same object on each call. */
export type BallAt = () => Ball;

/** Keeps balls inside the skin, so that their shadows do not touch its lit side. */
const FILLING = 0.9;
/** Limits a thin limb to this number of balls plus one. */
const MAX_GAPS = 7;

/** Tracks a proxy in world space. */
export function worldBall({ follows, center, radius }: ProxyBall): BallAt {
  const ball = { center: new Vector3(), radius };
  return () => {
    if (center) ball.center.copy(center).applyMatrix4(follows.matrixWorld);
    else ball.center.setFromMatrixPosition(follows.matrixWorld);
    ball.radius = radius * follows.matrixWorld.getMaxScaleOnAxis();
    return ball;
  };
}

/** One ball for each instance of a mesh, from the bounding sphere of its geometry. That of a hidden instance has no radius. */
export function instanceBalls(mesh: InstancedMesh | BatchedMesh): BallAt[] {
  const batch = 'isBatchedMesh' in mesh ? mesh : undefined;
  if (!mesh.geometry.boundingSphere) mesh.geometry.computeBoundingSphere();
  const sphere = mesh.geometry.boundingSphere!.clone();
  const world = new Matrix4();
  const ids = batch ? instancesOf(batch) : Array.from({ length: (mesh as InstancedMesh).count }, (_, index) => index);
  return ids.map((id) => {
    const ball = { center: new Vector3(), radius: 0 };
    return () => {
      ball.radius = 0;
      if (batch ? !instancesOf(batch).includes(id) || !batch.getVisibleAt(id) : id >= (mesh as InstancedMesh).count)
        return ball;
      if (batch) batch.getBoundingSphereAt(batch.getGeometryIdAt(id), sphere);
      mesh.getMatrixAt(id, world);
      world.premultiply(mesh.matrixWorld);
      ball.center.copy(sphere.center).applyMatrix4(world);
      ball.radius = sphere.radius * world.getMaxScaleOnAxis();
      return ball;
    };
  });
}

/**
 * Balls along each bone. A bone covers the vertices that have their largest skin weight on it; the radius follows their
 * distance from its axis.
 */
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
  return [...parts].flatMap(([number, places]) => {
    const bone = mesh.skeleton.bones[number];
    return ballsAlong(places, axisOf(bone)).map((ball) => ({ follows: bone, ...ball }));
  });
}

/** The proxy balls of a skinned or instanced mesh; empty for a rigid mesh. */
export function ballsOf(mesh: Mesh): BallAt[] {
  if ('isSkinnedMesh' in mesh) return boneBalls(mesh as SkinnedMesh).map(worldBall);
  if ('isInstancedMesh' in mesh || 'isBatchedMesh' in mesh) return instanceBalls(mesh as InstancedMesh | BatchedMesh);
  return [];
}

/** Direction of a bone: towards its first child bone, otherwise away from its parent. */
function axisOf(bone: Bone): Vector3 {
  const child = bone.children.find((each) => 'isBone' in each);
  const axis = (child ?? bone).position.clone();
  return axis.lengthSq() > 0 ? axis.normalize() : axis.set(0, 1, 0);
}

/**
 * A row of balls along an axis through the centroid of the vertices. The radius follows their mean distance from the
 * axis.
 */
function ballsAlong(places: readonly Vector3[], axis: Vector3): Ball[] {
  const middle = new Vector3();
  for (const place of places) middle.addScaledVector(place, 1 / places.length);
  const along = places.map((place) => place.clone().sub(middle).dot(axis));
  const across = places.map((place, index) => place.distanceTo(middle.clone().addScaledVector(axis, along[index])));
  const radius = (FILLING * across.reduce((sum, distance) => sum + distance, 0)) / places.length;
  const [first, last] = [Math.min(...along) + radius, Math.max(...along) - radius];
  const gaps = Math.min(MAX_GAPS, Math.max(0, Math.ceil((last - first) / radius)));
  return Array.from({ length: gaps + 1 }, (_, ball) => {
    const at = gaps === 0 ? (first + last) / 2 : first + ((last - first) * ball) / gaps;
    return { center: middle.clone().addScaledVector(axis, at), radius };
  });
}
