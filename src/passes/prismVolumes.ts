import type { InstancedBufferGeometry, RawShaderMaterial, WebGLRenderer } from 'three';
import fragmentShader from '../../shaders/meshVolumes/meshVolumes.frag';
import vertexShader from '../../shaders/prismVolumes/prismVolumes.vert';
import { DrawnMesh } from '../device/drawnMesh.ts';
import type { FrameView } from '../device/frameView.ts';
import type { PuffTextures } from '../device/puffTextures.ts';
import { countFaces, countingMaterial } from '../device/stencil.ts';
import { prisms } from './prisms.ts';

/** Number of directions around the centre in which the silhouette of a puff is sampled. */
const DIRECTIONS = 48;
/** Scale of the prism radius relative to the circle of equal area: overlapping puffs fill each other's dents. */
const FULLNESS = 1.06;

/**
 * Counts the shadow volumes of particles on GPUs that do not keep the depth that fragments write. The volumes are
 * closed prisms, counted by depth fail. The back faces of each prism precede its front faces, so that clamping stencil
 * operations are exact, as for the nailboard volumes.
 */
export class PrismVolumesPass {
  private readonly prisms: DrawnMesh<InstancedBufferGeometry>;
  private readonly puffs: PuffTextures;
  private readonly shadowRadius = { value: 1 };

  constructor(eye: FrameView, puffs: PuffTextures) {
    this.puffs = puffs;
    const uniforms = { ...eye.uniforms, shadowRadius: this.shadowRadius };
    this.prisms = new DrawnMesh(countingMaterial({ vertexShader, fragmentShader, uniforms }), prisms());
    const { KEEP, INCR, DECR } = WebGL2RenderingContext;
    countFaces(this.prisms.mesh, { depthFail: DECR, depthPass: KEEP }, { depthFail: INCR, depthPass: KEEP });
    this.follow();
  }

  /**
   * Updates the radius after the puffs changed. Volumes use lobes for every puff form, and never darken the lit part of
   * their own puff.
   */
  follow(): void {
    const { table, lobeCount, count } = this.puffs.lobes.puffs;
    this.shadowRadius.value = FULLNESS * meanRadius(table, lobeCount, count);
  }

  /** @param rows casters */
  draw(renderer: WebGLRenderer, rows: InstancedBufferGeometry): void {
    this.take(rows);
    this.prisms.draw(renderer);
  }

  /** The material of the draw call. */
  get material(): RawShaderMaterial {
    return this.prisms.material;
  }

  /** Draws once with a variant of the material. */
  drawAs(renderer: WebGLRenderer, material: RawShaderMaterial, rows: InstancedBufferGeometry): void {
    this.take(rows);
    this.prisms.drawAs(renderer, material);
  }

  dispose(): void {
    this.prisms.mesh.geometry.dispose();
    this.prisms.material.dispose();
  }

  private take(rows: InstancedBufferGeometry): void {
    const { geometry } = this.prisms.mesh;
    geometry.setAttribute('place', rows.getAttribute('place'));
    geometry.instanceCount = rows.instanceCount;
  }
}

/**
 * Returns the radius of the circle with the area of a puff's silhouette along z, averaged over all variations, in puff
 * radii.
 * @param table rows of `lobeCount` lobes (centre and radius) and one more entry
 */
function meanRadius(table: Float32Array, lobeCount: number, count: number): number {
  let squares = 0;
  for (let variation = 0; variation < count; ++variation) {
    const first = 4 * (lobeCount + 1) * variation;
    for (let direction = 0; direction < DIRECTIONS; ++direction) {
      const angle = (2 * Math.PI * direction) / DIRECTIONS;
      squares += reachOf(table.subarray(first, first + 4 * lobeCount), Math.cos(angle), Math.sin(angle)) ** 2;
    }
  }
  return Math.sqrt(squares / (DIRECTIONS * count));
}

/** Distance from the centre to the silhouette along z in a direction of the xy plane. */
function reachOf(lobes: Float32Array, towardsX: number, towardsY: number): number {
  let reach = 0;
  for (let at = 0; at < lobes.length; at += 4) {
    const [x, y, , radius] = lobes.subarray(at, at + 4);
    const chord = radius ** 2 - (x * towardsY - y * towardsX) ** 2;
    if (chord > 0) reach = Math.max(reach, x * towardsX + y * towardsY + Math.sqrt(chord));
  }
  return reach;
}
