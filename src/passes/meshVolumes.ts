import {
  Box3,
  BufferAttribute,
  BufferGeometry,
  DynamicDrawUsage,
  Matrix4,
  Ray,
  Sphere,
  Vector4,
  type WebGLRenderer,
} from 'three';
import fragmentShader from '../../shaders/meshVolumes/meshVolumes.frag';
import vertexShader from '../../shaders/meshVolumes/meshVolumes.vert';
import { DrawnMesh } from '../device/drawnMesh.ts';
import type { FrameView } from '../device/frameView.ts';
import { countFaces, countingMaterial } from '../device/stencil.ts';
import { extrude, inOne, writeVolume, type Extrusion } from './extrusion.ts';
import { memoize } from './memoize.ts';
import type { SurfaceDescription } from './surface.ts';
import type { SurfaceTransforms } from './surfaceTransforms.ts';
import { SHADOW_INSET } from '../constants.ts';

export const memoizedExtrusion = memoize(extrude);

/** A mesh that casts shadow. */
interface Caster {
  readonly mesh: Extrusion;
  /** Number of its first vertex among those of all casters. */
  readonly first: number;
  readonly facesLight: Uint8Array;
  /** Bounding sphere in model space. */
  readonly sphere: Sphere;
  /** As in the triangles that were written last. */
  isVisible: boolean;
  /** The light of `facesLight` in the frame of the model, and whether it is a lamp (w); NaN at first. */
  readonly light: Vector4;
}

/**
 * Counts the shadow volumes of closed meshes. All meshes are one draw call. Triangles of a mesh come in any order, so the
 * stencil operations wrap. This pass must run before the volumes of particles, which clamp: the count of meshes over a
 * pixel must stay below 256.
 *
 * Depth fail is correct even if the camera is inside a volume, but needs closed volumes. Depth pass needs no far ends
 * while the camera looks along with the light, because no receiver is behind them.
 */
export class MeshVolumesPass {
  private readonly eye: FrameView;
  /** The casters by the index of their surface. */
  private readonly casters = new Map<number, Caster>();
  private readonly transforms: SurfaceTransforms;
  private readonly volumes: DrawnMesh;
  private readonly indices: Uint32Array;
  private isClosed = false;

  constructor(eye: FrameView, surfaces: readonly SurfaceDescription[], transforms: SurfaceTransforms) {
    this.eye = eye;
    this.transforms = transforms;
    let [vertices, capacity] = [0, 0];
    surfaces.forEach((surface, index) => {
      if (!surface.casts) return;
      const mesh = memoizedExtrusion(surface.mesh);
      this.casters.set(index, casterOf(mesh, vertices));
      vertices += mesh.positions.length / 3;
      capacity += mesh.corners.length + 1.5 * mesh.edges.length;
    });
    this.indices = new Uint32Array(capacity);
    const material = countingMaterial({
      vertexShader,
      fragmentShader,
      uniforms: {
        ...eye.uniforms,
        transforms: { value: transforms.texture },
        firstFar: { value: vertices },
        inset: { value: SHADOW_INSET },
      },
    });
    this.volumes = new DrawnMesh(material, geometryOf(this.casters, this.indices));
  }

  /** @param countsFar whether the counts of pixels at the far plane must be right, too */
  draw(renderer: WebGLRenderer, countsFar = true): void {
    if (this.casters.size === 0) return;
    this.follow(this.eye.uniforms.lightInWorld.value, countsFar || this.needsFarEnds());
    const { KEEP, INCR_WRAP, DECR_WRAP } = WebGL2RenderingContext;
    const counting = (behind: number, before: number) =>
      this.isClosed ? { depthFail: behind, depthPass: KEEP } : { depthFail: KEEP, depthPass: before };
    countFaces(this.volumes.mesh, counting(DECR_WRAP, INCR_WRAP), counting(INCR_WRAP, DECR_WRAP));
    this.volumes.draw(renderer);
  }

  dispose(): void {
    this.volumes.mesh.geometry.dispose();
    this.volumes.material.dispose();
  }

  /** Returns true if the near plane may intersect a volume, or if a view ray may enter a volume through its far end. */
  private needsFarEnds(): boolean {
    const { casters, eye, transforms } = this;
    if (!eye.isLitBySun) return true;
    const { place, nearReach, forward, steepestSlope } = eye;
    const travel = eye.travelAt(place);
    // Else all view rays go along with the light.
    if (forward.dot(travel) * Math.hypot(1, steepestSlope) <= steepestSlope) return true;
    return [...casters].some(([surface, caster]) => {
      const { center, radius } = sphere.copy(caster.sphere).applyMatrix4(transforms.worldFromModel(surface));
      const isNear = ray.set(center, travel).distanceToPoint(place) < radius + SHADOW_INSET + nearReach;
      return isNear && transforms.isVisible(surface);
    });
  }

  /**
   * Writes the triangles again if a caster has turned in the light, if one appeared or disappeared, or if the far
   * ends are needed or not needed any more.
   */
  private follow(light: Vector4, isClosed: boolean): void {
    let isStale = this.isClosed !== isClosed;
    this.isClosed = isClosed;
    for (const [surface, caster] of this.casters) {
      const isVisible = this.transforms.isVisible(surface);
      const hasMoved = isVisible && followLight(caster, this.transforms.worldFromModel(surface), light);
      isStale ||= hasMoved || caster.isVisible !== isVisible;
      caster.isVisible = isVisible;
    }
    if (!isStale) return;
    const { geometry } = this.volumes.mesh;
    const vertices = geometry.getAttribute('position').count / 2;
    let end = 0;
    for (const { mesh, first, facesLight, isVisible } of this.casters.values()) {
      if (isVisible) end = writeVolume(mesh, facesLight, first, vertices + first, this.indices, end, isClosed);
    }
    const index = geometry.index!;
    geometry.setDrawRange(0, end);
    index.clearUpdateRanges();
    index.addUpdateRange(0, end);
    index.needsUpdate = true;
  }
}

function casterOf(mesh: Extrusion, first: number): Caster {
  return {
    mesh,
    first,
    facesLight: new Uint8Array(mesh.corners.length / 3),
    sphere: new Box3().setFromArray(mesh.positions).getBoundingSphere(new Sphere()),
    isVisible: false,
    light: new Vector4(NaN, NaN, NaN, NaN),
  };
}

/** All vertices at the start of the volumes, then the same ones at their end. */
function geometryOf(casters: ReadonlyMap<number, Caster>, indices: Uint32Array): BufferGeometry {
  const all = [...casters, ...casters];
  const surfaces = all.map(([surface, { mesh }]) =>
    Float32Array.from({ length: (2 * mesh.positions.length) / 3 }, (_, at) =>
      at % 2 === 0 ? surface : mesh.longestEdge,
    ),
  );
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(inOne(all.map(([, { mesh }]) => mesh.positions)), 3));
  geometry.setAttribute('surfaceAndEdge', new BufferAttribute(inOne(surfaces), 2));
  geometry.setIndex(new BufferAttribute(indices, 1).setUsage(DynamicDrawUsage));
  return geometry;
}

const seen = new Vector4();
const modelFromWorld = new Matrix4();
const ray = new Ray();
const sphere = new Sphere();

/**
 * Finds the faces of a caster that face the light.
 * @returns false if they are known: the light has not moved in the frame of the model
 */
function followLight(caster: Caster, worldFromModel: Matrix4, light: Vector4): boolean {
  const { mesh, facesLight } = caster;
  const { x, y, z, w } = seen.copy(light).applyMatrix4(modelFromWorld.copy(worldFromModel).invert());
  if (caster.light.equals(seen)) return false;
  caster.light.copy(seen);
  const { corners, normals, positions } = mesh;
  for (let face = 0; face < facesLight.length; ++face) {
    const first = 3 * face;
    const corner = 3 * corners[first];
    // Towards the light from a point p: L - p for a lamp at L, L for a sun.
    const facing =
      normals[first] * (x - w * positions[corner]) +
      normals[first + 1] * (y - w * positions[corner + 1]) +
      normals[first + 2] * (z - w * positions[corner + 2]);
    facesLight[face] = facing > 0 ? 1 : 0;
  }
  return true;
}
