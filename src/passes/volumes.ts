import { type BufferGeometry, type IUniform, type RawShaderMaterial, type Texture, type WebGLRenderer } from 'three';
import fragmentShader from '../../shaders/volumes/volumes.frag';
import vertexShader from '../../shaders/volumes/volumes.vert';
import { DrawnMesh } from '../device/drawnMesh.ts';
import type { FrameView } from '../device/frameView.ts';
import type { Shaders } from '../device/programsAhead.ts';
import type { PuffForm, PuffTextures } from '../device/puffTextures.ts';
import { FIRST_BORDER } from '../device/ramps.ts';
import { countFaces, countingMaterial } from '../device/stencil.ts';
import { withLobes } from '../device/unroll.ts';

/** Distance behind a puff's centre, in radii, beyond which the puff has no points, relief included. */
const BEHIND_THE_PUFF = 1.2;

/**
 * Counts the shadow volumes of particles in the stencil buffer by depth pass. The operations clamp. Each volume draws
 * its front face and then its back face in one draw call, so the running count is exact, and a saturated count can only
 * stay dark.
 */
export class VolumesPass {
  private readonly rows: DrawnMesh;
  /** Materials by lobe count, because the shaders unroll the loop over the lobes. */
  private readonly materials = new Map<number, RawShaderMaterial>();
  private readonly puffs: PuffTextures;
  private readonly common: Record<string, IUniform>;
  private readonly uniforms = {
    minCap: { value: 0 },
    facesEye: { value: false },
    startCaps: { value: null as Texture | null },
    casterTable: { value: null as Texture | null },
    reach: { value: 1 },
    depth: { value: 0 },
  };

  constructor(eye: FrameView, puffs: PuffTextures) {
    this.puffs = puffs;
    this.common = { ...eye.uniforms, ...this.uniforms };
    this.rows = new DrawnMesh(this.materialFor('lobes', FIRST_BORDER));
    countFaces(
      this.rows.mesh,
      { depthFail: WebGL2RenderingContext.KEEP, depthPass: WebGL2RenderingContext.INCR },
      { depthFail: WebGL2RenderingContext.KEEP, depthPass: WebGL2RenderingContext.DECR },
    );
  }

  /**
   * Selects the puff form and binds the current puffs, so that no volume darkens the lit part of its own puff.
   * @param litThreshold N . L from which a lit pixel differs from a shadowed one; below 0 if it differs for every N . L
   */
  follow(form: PuffForm, litThreshold: number): void {
    this.rows.material = this.materialFor(form, litThreshold);
  }

  /** Least distance behind a puff's centre at which volumes start, in radii. */
  get minCap(): number {
    return this.uniforms.minCap.value;
  }

  /** @param rows casters, with front and back faces */
  draw(renderer: WebGLRenderer, rows: BufferGeometry): void {
    this.rows.draw(renderer, rows);
  }

  /** The material of the draw call. */
  get material(): RawShaderMaterial {
    return this.rows.material;
  }

  /** Draws once with a variant of the material. */
  drawAs(renderer: WebGLRenderer, material: RawShaderMaterial, rows: BufferGeometry): void {
    this.rows.drawAs(renderer, material, rows);
  }

  dispose(): void {
    for (const material of this.materials.values()) material.dispose();
  }

  /** Binds the textures of a puff form and returns the material for its lobe count. */
  private materialFor(form: PuffForm, litThreshold: number): RawShaderMaterial {
    const { startCaps, latestCap, casterTable, casterLobes, reach, depth } = this.puffs.of(form);
    this.uniforms.minCap.value = minCapOf(litThreshold, latestCap);
    this.uniforms.facesEye.value = form === 'billboards';
    this.uniforms.startCaps.value = startCaps;
    this.uniforms.casterTable.value = casterTable;
    this.uniforms.reach.value = reach;
    this.uniforms.depth.value = depth;
    const material = this.materials.get(casterLobes) ?? this.materialWith(casterLobes);
    this.materials.set(casterLobes, material);
    return material;
  }

  private materialWith(lobes: number): RawShaderMaterial {
    return countingMaterial({ ...lobeVolumeShaders(lobes), uniforms: this.common });
  }
}

/** The shaders of volumes of puffs with a number of lobes, with their loops unrolled. */
export function lobeVolumeShaders(lobes: number): Shaders {
  return { vertexShader: withLobes(vertexShader, lobes), fragmentShader: withLobes(fragmentShader, lobes) };
}

/**
 * Returns the least distance behind its centre at which a puff's volume starts, in radii.
 * @param litThreshold as in `follow`
 * @param latestCap largest start cap of the puffs, see src/puffs/bake/startCaps.ts
 */
export function minCapOf(litThreshold: number, latestCap: number): number {
  if (litThreshold < 0) return BEHIND_THE_PUFF;
  return litThreshold < FIRST_BORDER ? latestCap : 0;
}
