import {
  BufferAttribute,
  BufferGeometry,
  DynamicDrawUsage,
  Matrix4,
  Vector3,
  Vector4,
  type IUniform,
  type WebGLRenderer,
} from 'three';
import fragmentShader from '../../../shaders/meshVolumes/meshVolumes.frag';
import vertexShader from '../../../shaders/meshVolumes/meshVolumes.vert';
import { DrawnMesh } from '../gpu/drawnMesh.ts';
import type { FrameView } from '../gpu/frameView.ts';
import { countFaces, countingMaterial } from '../gpu/stencil.ts';
import { extrude, inOne, writeVolume, type Extrusion } from './extrusion.ts';
import { memoizeWork } from './memoize.ts';
import type { SurfaceDescription } from './surface.ts';
import type { SurfaceTransforms } from './surfaceTransforms.ts';
import { SHADOW_INSET } from '../../base/constants.ts';

export const memoizedExtrusion = memoizeWork(extrude);

/** A mesh that casts shadow. */
interface Caster {
  readonly mesh: Extrusion;
  /** Number of its first vertex among those of all casters. */
  readonly first: number;
  readonly facesLight: Uint8Array;
  /** As in the triangles that were written last. */
  isVisible: boolean;
  /** The light of `facesLight` in the frame of the model, and whether it is a lamp (w); NaN at first. */
  readonly light: Vector4;
}

/**
 * Counts the shadow volumes of closed meshes by depth fail, which is correct even if the camera is inside a volume. All
 * meshes are one draw call. Triangles of a mesh come in any order, so the stencil operations wrap. This pass must run
 * before the volumes of particles, which clamp: the count of meshes over a pixel must stay below 256.
 */
export class MeshVolumesPass {
  private readonly eye: FrameView;
  /** The casters by the index of their surface. */
  private readonly casters = new Map<number, Caster>();
  private readonly transforms: SurfaceTransforms;
  private readonly volumes: DrawnMesh;
  private indices = new Uint32Array();
  private readonly firstFar: IUniform<number> = { value: 0 };

  constructor(eye: FrameView, transforms: SurfaceTransforms) {
    this.eye = eye;
    this.transforms = transforms;
    const material = countingMaterial({
      vertexShader,
      fragmentShader,
      uniforms: {
        ...eye.uniforms,
        transforms: { value: transforms.texture },
        firstFar: this.firstFar,
        inset: { value: SHADOW_INSET },
      },
    });
    this.volumes = new DrawnMesh(material, new BufferGeometry());
    countFaces(
      this.volumes.mesh,
      { depthFail: WebGL2RenderingContext.DECR_WRAP, depthPass: WebGL2RenderingContext.KEEP },
      { depthFail: WebGL2RenderingContext.INCR_WRAP, depthPass: WebGL2RenderingContext.KEEP },
    );
  }

  /** Replaces the surfaces; there are none at first. */
  show(surfaces: readonly SurfaceDescription[]): void {
    const { casters, firstFar } = this;
    let capacity = 0;
    casters.clear();
    firstFar.value = 0;
    surfaces.forEach((surface, index) => {
      if (!surface.casts) return;
      const mesh = memoizedExtrusion(surface.mesh);
      casters.set(index, casterOf(mesh, firstFar.value));
      firstFar.value += mesh.positions.length / 3;
      capacity += mesh.corners.length + 1.5 * mesh.edges.length;
    });
    this.indices = new Uint32Array(capacity);
    this.volumes.mesh.geometry.dispose();
    this.volumes.mesh.geometry = geometryOf(casters, this.indices);
  }

  draw(renderer: WebGLRenderer): void {
    if (this.casters.size === 0) return;
    this.updateCasters(this.eye.uniforms.lightInWorld.value);
    this.volumes.draw(renderer);
  }

  dispose(): void {
    this.volumes.mesh.geometry.dispose();
    this.volumes.material.dispose();
  }

  /** Writes the triangles again if a caster has turned in the light, or if one appeared or disappeared. */
  private updateCasters(light: Vector4): void {
    let isStale = false;
    for (const [surface, caster] of this.casters) {
      const isVisible = this.transforms.isVisible(surface);
      const hasMoved = isVisible && updateCaster(caster, this.transforms.worldFromModel(surface), light);
      isStale ||= hasMoved || caster.isVisible !== isVisible;
      caster.isVisible = isVisible;
    }
    if (!isStale) return;
    const { geometry } = this.volumes.mesh;
    let end = 0;
    for (const { mesh, first, facesLight, isVisible } of this.casters.values()) {
      if (isVisible) end = writeVolume(mesh, facesLight, first, this.firstFar.value + first, this.indices, end);
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

const light = new Vector3();
const seen = new Vector4();
const point = new Vector3();
const stretch = new Matrix4();

/**
 * Finds the faces of a caster that face the light.
 * @returns false if they are known: the light has not moved in the frame of the model
 */
function updateCaster(caster: Caster, worldFromModel: Matrix4, { x, y, z, w }: Vector4): boolean {
  const { mesh, facesLight } = caster;
  const e = worldFromModel.elements;
  // A normal n of the model is M n in the world. Its product with a world direction d is that of n with M^T d. The
  // light travels along p - L towards a point p, and along -L for a sun.
  light.set(w * e[12] - x, w * e[13] - y, w * e[14] - z);
  const [lightX, lightY, lightZ] = [0, 4, 8].map((at) => e[at] * light.x + e[at + 1] * light.y + e[at + 2] * light.z);
  seen.set(lightX, lightY, lightZ, w);
  if (caster.light.equals(seen)) return false;
  caster.light.copy(seen);
  stretch.copy(worldFromModel).setPosition(0, 0, 0).transpose().multiply(worldFromModel).setPosition(0, 0, 0);
  const { corners, normals, positions } = mesh;
  for (let face = 0; face < facesLight.length; ++face) {
    const first = 3 * face;
    let travel = normals[first] * lightX + normals[first + 1] * lightY + normals[first + 2] * lightZ;
    if (w > 0) {
      point.fromArray(positions, 3 * corners[first]).applyMatrix4(stretch);
      travel += normals[first] * point.x + normals[first + 1] * point.y + normals[first + 2] * point.z;
    }
    facesLight[face] = travel < 0 ? 1 : 0;
  }
  return true;
}
