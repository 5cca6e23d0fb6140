import {
  BufferAttribute,
  BufferGeometry,
  DataTexture,
  DynamicDrawUsage,
  FloatType,
  Matrix4,
  RGBAFormat,
  Vector3,
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
import type { SurfaceDescription } from './surfaces.ts';
import { SHADOW_INSET } from '../constants.ts';

export const memoizedExtrusion = memoize(extrude);

const IDENTITY = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];

/** World transforms of surfaces for the vertex shader: one row of four texels for each. */
class TransformTexture {
  readonly texture: DataTexture;
  private readonly elements: Float32Array;

  /** @param count number of surfaces, at most the maximum height of a texture */
  constructor(count: number) {
    this.elements = new Float32Array(16 * Math.max(1, count));
    for (let first = 0; first < this.elements.length; first += 16) this.elements.set(IDENTITY, first);
    this.texture = new DataTexture(this.elements, 4, Math.max(1, count), RGBAFormat, FloatType);
    this.texture.needsUpdate = true;
  }

  set(surface: number, worldFromModel: Matrix4): void {
    this.elements.set(worldFromModel.elements, 16 * surface);
    this.texture.needsUpdate = true;
  }

  dispose(): void {
    this.texture.dispose();
  }
}

/** A mesh that casts shadow. */
interface Caster {
  readonly mesh: Extrusion;
  /** Number of its first vertex among those of all casters. */
  readonly first: number;
  readonly facesLight: Uint8Array;
  readonly worldFromModel: Matrix4;
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
  private readonly transforms: TransformTexture;
  private readonly volumes: DrawnMesh;
  private readonly indices: Uint32Array;
  /** Whether the visibility of a caster has changed since the last draw. */
  private isStale = true;

  constructor(eye: FrameView, surfaces: readonly SurfaceDescription[]) {
    this.eye = eye;
    this.transforms = new TransformTexture(surfaces.length);
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
        transforms: { value: this.transforms.texture },
        firstFar: { value: vertices },
        inset: { value: SHADOW_INSET },
      },
    });
    this.volumes = new DrawnMesh(material, geometryOf(this.casters, this.indices));
    countFaces(
      this.volumes.mesh,
      { depthFail: WebGL2RenderingContext.DECR_WRAP, depthPass: WebGL2RenderingContext.KEEP },
      { depthFail: WebGL2RenderingContext.INCR_WRAP, depthPass: WebGL2RenderingContext.KEEP },
    );
  }

  /** Sets the world transform and the visibility of a surface. */
  place(surface: number, worldFromModel: Matrix4, isVisible = true): void {
    const caster = this.casters.get(surface);
    if (!caster) return;
    if (!caster.worldFromModel.equals(worldFromModel)) this.transforms.set(surface, worldFromModel);
    caster.worldFromModel.copy(worldFromModel);
    if (caster.isVisible !== isVisible) this.isStale = true;
    caster.isVisible = isVisible;
  }

  draw(renderer: WebGLRenderer): void {
    if (this.casters.size === 0) return;
    this.follow(this.eye.uniforms.lightInWorld.value);
    this.volumes.draw(renderer);
  }

  dispose(): void {
    this.volumes.mesh.geometry.dispose();
    this.volumes.material.dispose();
    this.transforms.dispose();
  }

  /** Writes the triangles again if a caster has turned in the light, or if one appeared or disappeared. */
  private follow(light: Vector4): void {
    for (const caster of this.casters.values()) {
      if (caster.isVisible && followLight(caster, light)) this.isStale = true;
    }
    if (!this.isStale) return;
    this.isStale = false;
    const { geometry } = this.volumes.mesh;
    const vertices = geometry.getAttribute('position').count / 2;
    let end = 0;
    for (const { mesh, first, facesLight, isVisible } of this.casters.values()) {
      if (isVisible) end = writeVolume(mesh, facesLight, first, vertices + first, this.indices, end);
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
    worldFromModel: new Matrix4(),
    isVisible: true,
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
function followLight(caster: Caster, { x, y, z, w }: Vector4): boolean {
  const { mesh, worldFromModel, facesLight } = caster;
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
