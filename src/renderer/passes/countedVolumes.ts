import type { RawShaderMaterial, WebGLRenderer } from 'three';
import fragmentShader from '../../../shaders/countedVolumes/countedVolumes.frag';
import vertexShader from '../../../shaders/volumes/volumes.vert';
import { DrawnRows, ONE_QUAD, RowGeometry, type RowLayout } from '../gpu/drawnRows.ts';
import type { FrameView } from '../gpu/frameView.ts';
import type { PuffTextures } from '../gpu/puffTextures.ts';
import { countFaces, countingMaterial } from '../gpu/stencil.ts';
import { DEFORMED, withLobes } from '../gpu/programsAhead.ts';
import { ParticleVolumes } from './volumes.ts';

/** The front of a quad, then its back. */
const FRONT_AND_BACK: RowLayout = { vertices: 4, index: [...ONE_QUAD.index, ...ONE_QUAD.index.toReversed()] };

/**
 * Counts the shadow volumes of particles in the stencil buffer by depth pass, as McGuire and Fein do ('Real-Time
 * Rendering of Cartoon Smoke and Clouds', 2006): a quad at the depth where view rays enter a volume, and one where they
 * leave it. This works for each sample of a multisampled buffer. The operations clamp. Each volume draws its front face
 * and then its back face in one draw call, so the running count is exact, and a saturated count can only stay dark.
 */
export class CountedVolumesPass extends ParticleVolumes {
  protected readonly quads: DrawnRows;
  /** The geometry with the front and the back of each quad, by the geometry with the front. */
  private readonly doubled = new Map<RowGeometry, RowGeometry>();

  constructor(eye: FrameView, puffs: PuffTextures) {
    super(eye, puffs);
    this.quads = new DrawnRows(this.materialFor('lobes'));
    countFaces(
      this.quads.mesh,
      { depthFail: WebGL2RenderingContext.KEEP, depthPass: WebGL2RenderingContext.INCR },
      { depthFail: WebGL2RenderingContext.KEEP, depthPass: WebGL2RenderingContext.DECR },
    );
  }

  /** @param rows one quad for each caster */
  draw(renderer: WebGLRenderer, rows: RowGeometry): void {
    const geometry = this.doubled.get(rows) ?? new RowGeometry(rows.rows, FRONT_AND_BACK);
    this.doubled.set(rows, geometry);
    this.quads.draw(renderer, geometry);
  }

  override dispose(): void {
    for (const geometry of this.doubled.values()) geometry.dispose();
    this.doubled.clear();
    super.dispose();
  }

  protected materialWith(lobes: number, isDeformed: boolean): RawShaderMaterial {
    return countingMaterial({
      defines: isDeformed ? DEFORMED : {},
      vertexShader: withLobes(vertexShader, lobes),
      fragmentShader: withLobes(fragmentShader, lobes),
      uniforms: this.uniforms,
    });
  }
}
