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

/** Radii from a puff's centre to where nothing of it is left, relief included. */
const BEHIND_THE_PUFF = 1.2;

/**
 * Counts the particles' shadow volumes in the stencil by depth pass. The operations clamp: each volume draws its front
 * and then its back in one draw, so the running count is the true one and saturation can only stay dark.
 */
export class VolumesPass {
  private readonly rows: DrawnMesh;
  /** By the number of lobes that are unrolled in them. */
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

  constructor(eye: FrameView, puffs: PuffTextures, rows: BufferGeometry) {
    this.puffs = puffs;
    this.common = { ...eye.uniforms, ...this.uniforms };
    this.rows = new DrawnMesh(rows, this.materialFor('lobes', FIRST_BORDER));
    countFaces(
      this.rows.mesh,
      { depthFail: WebGL2RenderingContext.KEEP, depthPass: WebGL2RenderingContext.INCR },
      { depthFail: WebGL2RenderingContext.KEEP, depthPass: WebGL2RenderingContext.DECR },
    );
  }

  /**
   * Follows how puffs become pixels, and which they are, so that no volume takes away what its own puff shows of the light.
   * @param litThreshold N . L from which a lit pixel differs from one in shadow; below 0 where it does even on the dark side
   */
  follow(form: PuffForm, litThreshold: number): void {
    this.rows.material = this.materialFor(form, litThreshold);
  }

  /** Radii behind a puff's centre before which no volume begins. */
  get minCap(): number {
    return this.uniforms.minCap.value;
  }

  draw(renderer: WebGLRenderer): void {
    this.rows.draw(renderer);
  }

  /** What it draws with at present. */
  get material(): RawShaderMaterial {
    return this.rows.material;
  }

  /** Draws once in another material, made of the present one. */
  drawAs(renderer: WebGLRenderer, material: RawShaderMaterial): void {
    this.rows.drawAs(renderer, material);
  }

  dispose(): void {
    for (const material of this.materials.values()) material.dispose();
  }

  /** Puts the puffs of a form into the uniforms. */
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

/** By which the volumes of puffs with so many lobes are drawn. */
export function lobeVolumeShaders(lobes: number): Shaders {
  return { vertexShader: withLobes(vertexShader, lobes), fragmentShader: withLobes(fragmentShader, lobes) };
}

/**
 * How many radii behind its centre a puff's volume begins at the nearest.
 * @param litThreshold as `follow` takes it
 * @param latestCap of the puffs, see src/puffs/bake/startCaps.ts
 */
export function minCapOf(litThreshold: number, latestCap: number): number {
  if (litThreshold < 0) return BEHIND_THE_PUFF;
  return litThreshold < FIRST_BORDER ? latestCap : 0;
}
