import {
  Matrix4,
  Vector3,
  type Mesh,
  type Object3D,
  type WebGLRenderer,
  Box3,
  type InstancedMesh,
  type SkinnedMesh,
} from 'three';
import type { Device } from '../renderer/gpu/device.ts';
import type { FrameView } from '../renderer/gpu/frameView.ts';
import { MeshVolumesPass } from '../renderer/passes/meshVolumes.ts';
import { SurfaceTransforms } from '../renderer/passes/surfaceTransforms.ts';
import { ParameterError } from '../base/errors.ts';
import { BallVolumes, isShown, type BallsOf } from './volumes/ballVolumes.ts';
import { toSmoke, type SmokeFrame } from './smokeSpace.ts';
import { ballsOf, worldBall, type ProxyBall } from './proxies.ts';
import { isBlended, materialsOf } from './relight.ts';
import { newPose, poseOf, partsOf, scaleOf, trianglesOf } from './shapes.ts';

/** A closed rigid mesh and its shadow volume. */
export interface MeshCaster {
  mesh: Mesh;
  transforms: SurfaceTransforms;
  volume: MeshVolumesPass;
  /** Scale of the smoke for which the volume was made. */
  scale: number;
}

/** A mesh or the balls that {@link HostCasters} draws. */
export type HostCaster = MeshCaster | BallsOf;

/**
 * Shadow casters of the host's scene besides smoke. Closed rigid meshes use their silhouettes; skinned, instanced and
 * open meshes use balls.
 */
export class HostCasters {
  private readonly eye: FrameView;
  private readonly frame: SmokeFrame;
  private readonly meshes = new Set<MeshCaster>();
  private readonly balls: BallVolumes;

  /** @param eye the view in the space of the smoke, which `frame` has */
  constructor(device: Device, eye: FrameView, frame: SmokeFrame) {
    this.eye = eye;
    this.frame = frame;
    this.balls = new BallVolumes(device, eye);
  }

  get isEmpty(): boolean {
    return this.meshes.size === 0 && this.balls.isEmpty;
  }

  /**
   * Adds every mesh of an object, or its proxies.
   * @returns the casters, for {@link remove}
   * @throws ParameterError without a mesh, for an open mesh without proxies, or for too many balls
   */
  add(object: Object3D, proxies: readonly ProxyBall[] | undefined): HostCaster[] {
    object.updateWorldMatrix(true, true);
    if (proxies) return [this.balls.add(proxies.map(worldBall), object)];
    const meshes: Mesh[] = [];
    object.traverse((part) => ('isMesh' in part ? meshes.push(part as Mesh) : undefined));
    if (meshes.length === 0)
      throw new ParameterError('cast', object.name || object.type, 'an object that contains a mesh');
    const added: HostCaster[] = [];
    try {
      for (const mesh of meshes) added.push(this.addMesh(mesh));
    } catch (error) {
      this.remove(added);
      throw error;
    }
    return added;
  }

  /** Removes casters and frees their GPU resources. */
  remove(casters: readonly HostCaster[]): void {
    for (const caster of casters) {
      if ('balls' in caster) this.balls.remove(caster);
      else if (this.meshes.delete(caster)) for (const part of [caster.transforms, caster.volume]) part.dispose();
    }
  }

  /**
   * Draws mesh volumes first, whose stencil operations wrap. Ball volumes follow and clamp, like those of particles.
   */
  draw(renderer: WebGLRenderer, scene: Object3D): void {
    const { drawn } = this.frame;
    for (const { mesh, transforms, volume, scale } of this.meshes) {
      if (!isShown(mesh, scene)) continue;
      toSmoke(poseOf(mesh.matrixWorld, pose), drawn);
      // Local smoke may have another scale since the last `update`.
      transforms.place(0, world.compose(pose.position, pose.rotation, size.setScalar(scale / drawn.scale)));
      volume.draw(renderer);
    }
    this.balls.draw(renderer, scene, drawn);
  }

  /** Frees the GPU resources. The next draw recreates them. */
  release(): void {
    for (const { transforms, volume } of this.meshes) for (const part of [transforms, volume]) part.dispose();
    this.balls.release();
  }

  dispose(): void {
    this.release();
    this.balls.dispose();
  }

  private addMesh(mesh: Mesh): HostCaster {
    const [{ geometry }] = partsOf('cast', mesh);
    const balls = ballsOf(mesh);
    if (balls.length > 0) return this.balls.add(balls, mesh);
    const { scale } = this.frame.now;
    const triangles = trianglesOf(geometry, scaleOf(mesh.matrixWorld).divideScalar(scale));
    try {
      const surface = { name: mesh.name, mesh: triangles, color: [0, 0, 0], casts: true, inked: false } as const;
      const transforms = new SurfaceTransforms(1);
      const caster = { mesh, transforms, volume: new MeshVolumesPass(this.eye, transforms), scale };
      caster.volume.show([surface]);
      this.meshes.add(caster);
      return caster;
    } catch (error) {
      if (error instanceof RangeError) throw openMesh(mesh);
      throw error;
    }
  }
}

const world = new Matrix4();
const size = new Vector3();
const pose = newPose();

function openMesh({ name, type }: Mesh): ParameterError {
  return new ParameterError(
    'cast',
    name || type,
    'a closed mesh (every edge joins two triangles) or an object with proxies: cast(mesh, { proxies })',
  );
}

/** World-space bounding boxes of the opaque objects in a scene. No shadow is visible outside them. */
export function receiversIn(scene: Object3D): Box3[] {
  const boxes: Box3[] = [];
  scene.traverseVisible((object) => {
    if (!('isMesh' in object)) return;
    const mesh = object as Mesh;
    if (!materialsOf(mesh).some((material) => !isBlended(material))) return;
    const box = boxOf(mesh, new Box3());
    // An object with a broken transform is not drawn, and must not break the shadows of all others.
    if (box.min.distanceToSquared(box.max) < Infinity) boxes.push(box);
  });
  return boxes;
}

/** Bounds as three.js uses them for culling: skinned meshes provide their own bounding sphere. That of instances is too wide. */
function boxOf(mesh: Mesh, into: Box3): Box3 {
  const deformed = mesh as Mesh & Partial<Pick<SkinnedMesh, 'boundingSphere' | 'computeBoundingSphere'>>;
  if ('isInstancedMesh' in mesh) {
    into.copy(boxOfInstances(mesh as InstancedMesh));
  } else if (deformed.computeBoundingSphere) {
    if (!deformed.boundingSphere) deformed.computeBoundingSphere();
    deformed.boundingSphere!.getBoundingBox(into);
  } else {
    if (!mesh.geometry.boundingBox) mesh.geometry.computeBoundingBox();
    into.copy(mesh.geometry.boundingBox!);
  }
  return into.applyMatrix4(mesh.matrixWorld);
}

/** The version and number of instances that each box was computed from. */
const boxed = new WeakMap<InstancedMesh, string>();

function boxOfInstances(mesh: InstancedMesh): Box3 {
  const key = `${mesh.instanceMatrix.version} ${mesh.count}`;
  if (!mesh.boundingBox || boxed.get(mesh) !== key) mesh.computeBoundingBox();
  boxed.set(mesh, key);
  return mesh.boundingBox!;
}
