import type { InstancedBufferGeometry, RawShaderMaterial, WebGLRenderer } from 'three';
import fragmentShader from '../../shaders/meshVolumes/meshVolumes.frag';
import vertexShader from '../../shaders/prismVolumes/prismVolumes.vert';
import { DrawnMesh } from '../device/drawnMesh.ts';
import type { FrameView } from '../device/frameView.ts';
import type { PuffTextures } from '../device/puffTextures.ts';
import { countFaces, countingMaterial } from '../device/stencil.ts';
import { prismsOf } from './prisms.ts';

/** Directions from a puff's centre in which its silhouette is measured. */
const DIRECTIONS = 48;
/** Beyond the circle of the same area, because puffs fill each other's dents. */
const FULLNESS = 1.06;

/**
 * Counts the particles' shadow volumes where the depth that fragments write is not kept: as prisms, by depth fail. The
 * back faces of each come before its front faces, so that the operations may clamp as those of the nailboards do.
 */
export class PrismVolumesPass {
  private readonly rows: InstancedBufferGeometry;
  private readonly prisms: DrawnMesh<InstancedBufferGeometry>;
  private readonly puffs: PuffTextures;
  private readonly shadowRadius = { value: 1 };

  constructor(eye: FrameView, puffs: PuffTextures, rows: InstancedBufferGeometry) {
    this.puffs = puffs;
    this.rows = rows;
    const uniforms = { ...eye.uniforms, shadowRadius: this.shadowRadius };
    this.prisms = new DrawnMesh(prismsOf(rows), countingMaterial({ vertexShader, fragmentShader, uniforms }));
    const { KEEP, INCR, DECR } = WebGL2RenderingContext;
    countFaces(this.prisms.mesh, { depthFail: DECR, depthPass: KEEP }, { depthFail: INCR, depthPass: KEEP });
    this.follow();
  }

  /** Follows which puffs are drawn. They are lobes in any form, and never darken what they show of the light. */
  follow(): void {
    const { table, lobeCount, count } = this.puffs.lobes.puffs;
    this.shadowRadius.value = FULLNESS * meanRadius(table, lobeCount, count);
  }

  draw(renderer: WebGLRenderer): void {
    this.takeRows();
    this.prisms.draw(renderer);
  }

  /** What it draws with at present. */
  get material(): RawShaderMaterial {
    return this.prisms.material;
  }

  /** Draws once in another material, made of the present one. */
  drawAs(renderer: WebGLRenderer, material: RawShaderMaterial): void {
    this.takeRows();
    this.prisms.drawAs(renderer, material);
  }

  dispose(): void {
    this.prisms.mesh.geometry.dispose();
    this.prisms.material.dispose();
  }

  private takeRows(): void {
    this.prisms.mesh.geometry.instanceCount = this.rows.instanceCount;
  }
}

/**
 * Radius of the circle with the area of a puff's silhouette along z, over all variations; in puff radii.
 * @param table rows of `lobeCount` lobes, centre and radius, and one more entry
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

/** How far the silhouette of lobes along z reaches from the centre in a direction. */
function reachOf(lobes: Float32Array, towardsX: number, towardsY: number): number {
  let reach = 0;
  for (let at = 0; at < lobes.length; at += 4) {
    const [x, y, , radius] = lobes.subarray(at, at + 4);
    const chord = radius ** 2 - (x * towardsY - y * towardsX) ** 2;
    if (chord > 0) reach = Math.max(reach, x * towardsX + y * towardsY + Math.sqrt(chord));
  }
  return reach;
}
