import {
  DoubleSide,
  GLSL3,
  GreaterStencilFunc,
  IncrementStencilOp,
  RawShaderMaterial,
  type DepthTexture,
  type IUniform,
  type Texture,
  type WebGLRenderer,
} from 'three';
import fragmentShader from '../../../shaders/volumes/volumes.frag';
import vertexShader from '../../../shaders/volumes/volumes.vert';
import { DrawnRows, type RowGeometry } from '../gpu/drawnRows.ts';
import type { FrameView } from '../gpu/frameView.ts';
import { DEFORMED, withLobes, type Shaders } from '../gpu/programsAhead.ts';
import type { PuffForm, PuffTextures } from '../gpu/puffTextures.ts';
import { FIRST_BORDER } from '../gpu/ramps.ts';

/** Distance behind a puff's centre, in radii, beyond which the puff has no points, relief included. */
const BEHIND_THE_PUFF = 1.2;
/** The same for puffs that are drawn as discs, where the view axis is perpendicular to the light; with a margin. */
const DISC_REACH = 1.15;

/** Draws the shadow volumes of particles. Subclasses decide how the stencil buffer counts them. */
export abstract class ParticleVolumes {
  protected readonly uniforms: Record<string, IUniform>;
  private readonly puffs: PuffTextures;
  /**
   * Materials by lobe count, negative for deformed puffs, because the shaders unroll the loop over the lobes; of silhouettes by 0.
   */
  private readonly materials = new Map<number, RawShaderMaterial>();
  protected readonly form = {
    minCap: { value: 0 },
    facesEye: { value: false },
    keepsSize: { value: false },
    startCaps: { value: null as Texture | null },
    casterTable: { value: null as Texture | null },
    reach: { value: 1 },
    depth: { value: 0 },
  };

  /** @param isFlat whether puffs are drawn as discs, for GPUs that do not keep the depth that fragments write */
  constructor(eye: FrameView, puffs: PuffTextures, isFlat = false) {
    this.puffs = puffs;
    this.uniforms = { ...eye.uniforms, ...this.form, discReach: { value: isFlat ? DISC_REACH : 0 } };
  }

  /**
   * Selects the puff form and binds the current puffs, so that no volume darkens the lit part of its own puff.
   * @param litThreshold N . L from which a lit pixel differs from a shadowed one; below 0 if it differs for every N . L
   */
  setForm(form: PuffForm, litThreshold: number): void {
    const { startCaps = null, latestCap, casterTable, reach, depth, spread } = this.puffs.of(form);
    const uniforms = this.form;
    uniforms.minCap.value = spread * minCapOf(litThreshold, latestCap);
    uniforms.facesEye.value = form === 'billboards';
    uniforms.startCaps.value = startCaps;
    uniforms.casterTable.value = casterTable;
    uniforms.reach.value = reach;
    uniforms.depth.value = depth;
    this.quads.material = this.materialFor(form);
    this.quads.bites = this.puffs.bites?.volumes;
  }

  /** For puffs that stand for objects: they keep their size near the camera. */
  keepSize(): void {
    this.form.keepsSize.value = true;
  }

  /** Least distance behind a puff's centre at which volumes start, in radii. */
  get minCap(): number {
    return this.form.minCap.value;
  }

  /** The material of the draw call. */
  get material(): RawShaderMaterial {
    return this.quads.material;
  }

  /** Draws once with a variant of the material. */
  drawAs(renderer: WebGLRenderer, material: RawShaderMaterial, rows: RowGeometry): void {
    this.quads.drawAs(renderer, material, rows);
  }

  dispose(): void {
    for (const material of this.materials.values()) material.dispose();
  }

  protected abstract readonly quads: DrawnRows;

  protected abstract materialWith(lobes: number, isDeformed: boolean): RawShaderMaterial;

  /** The material for the lobe count of a puff form. */
  protected materialFor(form: PuffForm): RawShaderMaterial {
    const { casterLobes, silhouettes } = this.puffs.of(form);
    const { isDeformed } = this.puffs;
    const key = silhouettes ? 0 : isDeformed ? -casterLobes : casterLobes;
    const material = this.materials.get(key) ?? this.materialWith(casterLobes, isDeformed);
    this.materials.set(key, material);
    silhouettes?.(material);
    return material;
  }
}

/**
 * Counts, in the stencil buffer, the particles that shade the place that each pixel shows: one quad for each shadow
 * volume, whose fragments test whether the volume contains that place. The stencil test skips pixels that have reached
 * the limit. Each pixel must have one depth; `CountedVolumesPass` draws into multisampled buffers.
 */
export class VolumesPass extends ParticleVolumes {
  protected readonly quads: DrawnRows;
  private readonly receiverDepth = { value: null as DepthTexture | null };

  constructor(eye: FrameView, puffs: PuffTextures, isFlat = false) {
    super(eye, puffs, isFlat);
    this.uniforms.receiverDepth = this.receiverDepth;
    this.quads = new DrawnRows(this.materialFor('lobes'));
  }

  /**
   * @param rows one quad for each caster
   * @param depth a copy of the depth buffer of the bound target
   * @param limit count at which a pixel is dark enough, 1..255
   */
  draw(renderer: WebGLRenderer, rows: RowGeometry, depth: DepthTexture, limit: number): void {
    this.receiverDepth.value = depth;
    this.material.stencilRef = limit;
    this.quads.draw(renderer, rows);
  }

  protected shadersWith(lobes: number, isDeformed: boolean): Shaders {
    return volumeShaders(lobes, isDeformed);
  }

  protected materialWith(lobes: number, isDeformed: boolean): RawShaderMaterial {
    return new RawShaderMaterial({
      ...this.shadersWith(lobes, isDeformed),
      uniforms: this.uniforms,
      glslVersion: GLSL3,
      side: DoubleSide,
      colorWrite: false,
      depthWrite: false,
      stencilWrite: true,
      stencilFunc: GreaterStencilFunc,
      stencilZPass: IncrementStencilOp,
    });
  }
}

/** The shaders of volumes of puffs with a number of lobes, with their loops unrolled. */
export function volumeShaders(lobes: number, isDeformed: boolean): Shaders {
  return {
    vertexShader: withLobes(vertexShader, lobes),
    fragmentShader: withLobes(fragmentShader, lobes),
    defines: isDeformed ? DEFORMED : {},
  };
}

/**
 * Returns the least distance behind its centre at which a puff's volume starts, in radii.
 * @param litThreshold as in `ParticleVolumes.follow`
 * @param latestCap largest start cap of the puffs, see src/renderer/puffs/bake/startCaps.ts
 */
export function minCapOf(litThreshold: number, latestCap: number): number {
  if (litThreshold < 0) return BEHIND_THE_PUFF;
  return litThreshold < FIRST_BORDER ? latestCap : 0;
}
