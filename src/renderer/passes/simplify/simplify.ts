import { Matrix4, type Texture, type WebGLRenderer, type WebGLRenderTarget } from 'three';
import activeShader from '../../../../shaders/simplify/active.vert';
import acrossShader from '../../../../shaders/simplify/across.frag';
import fieldsShader from '../../../../shaders/simplify/fields.frag';
import flatShader from '../../../../shaders/simplify/flat.frag';
import tilesShader from '../../../../shaders/simplify/tiles.frag';
import tonesShader from '../../../../shaders/simplify/tones.frag';
import { FLAT_TILE } from '../../../base/constants.ts';
import type { FrameView } from '../../gpu/frameView.ts';
import { DrawnPoints, FEW_TILES, FullScreen } from '../../gpu/fullScreen.ts';
import { pictureTarget, type Targets } from '../targets.ts';
import type { RampTexture } from '../../gpu/ramps.ts';
import { PlumeForm, type Particles } from './plumeForm.ts';

/** Distance that is averaged, in standard deviations. */
const REACH = 2;
/** Keeps the weights finite without smoothing, pixels. */
const MIN_DEVIATION = 0.1;

/**
 * Chooses tones by smoothed light, so that light and shade become few large shapes. Light is averaged as numbers and then
 * cut into tones, so that regions grow and shrink continuously. The average stops at ink and at gaps in depth: a
 * separable approximation of the cross-bilateral filter of Eisemann and Durand, 'Flash Photography Enhancement via
 * Intrinsic Relighting' (2004). It runs in tiles of smoke and in those whose light differs within reach.
 */
export class SimplifyPass {
  private readonly uniforms = {
    unlit: { value: null as Texture | null },
    lit: { value: null as Texture | null },
    shading: { value: null as Texture | null },
    depth: { value: null as Texture | null },
    litFrom: { value: 0 },
    isBanded: { value: true },
    reach: { value: 0 },
    deviation: { value: 1 },
    across: { value: null as Texture | null },
    lightsAcross: { value: null as Texture | null },
    formFromView: { value: new Matrix4() },
  };

  private readonly fields = pictureTarget();
  private readonly tiles = pictureTarget();
  private readonly flatTiles = pictureTarget();
  private readonly across = pictureTarget();
  /** The averages along rows and those of additional lights. */
  private readonly lightsAcross = pictureTarget(2);
  private readonly passes: readonly (FullScreen | DrawnPoints)[];
  private readonly toneUniforms;
  /** The form of the whole smoke, and the last pass where light follows it. Created when a style needs them. */
  private leaning: { readonly form: PlumeForm; readonly tones: DrawnPoints } | undefined;
  private readonly eye: FrameView;
  private hasLights = false;

  constructor(eye: FrameView, ramps: RampTexture) {
    const [fields, tiles, flatTiles] = [this.fields, this.tiles, this.flatTiles].map(({ texture: value }) => ({
      value,
    }));
    const common = { ...eye.uniforms, ...this.uniforms, tiles, flatTiles, ramps: { value: ramps.texture } };
    const tones = { ...common, fields };
    this.passes = [
      new FullScreen(tilesShader, common),
      new FullScreen(flatShader, common),
      new DrawnPoints(activeShader, fieldsShader, common, NEARBY),
      new DrawnPoints(activeShader, acrossShader, { ...common, fields }, NEARBY),
      new DrawnPoints(activeShader, tonesShader, tones),
    ];
    this.toneUniforms = tones;
    this.eye = eye;
  }

  /**
   * @param deviation standard deviation of the Gaussian, pixels
   * @param isBanded whether bands of colour are smoothed separately
   * @param litFrom N.L from which a lit pixel differs from a shadowed one
   * @param hasLights whether there are lights besides the key light
   */
  setUniforms(deviation: number, isBanded: boolean, litFrom: number, hasLights: boolean): void {
    const { uniforms } = this;
    this.hasLights = hasLights;
    uniforms.deviation.value = Math.max(deviation, MIN_DEVIATION);
    uniforms.reach.value = Math.ceil(REACH * deviation);
    uniforms.isBanded.value = isBanded;
    uniforms.litFrom.value = litFrom;
  }

  /**
   * Replaces the tones of smoke and of where it casts shadow, after the mask is drawn.
   * @param shading the shading that the bodies wrote
   * @param particles all particles, culled or not, if light follows their form
   */
  draw(
    renderer: WebGLRenderer,
    targets: Targets,
    shading: Texture,
    output: WebGLRenderTarget,
    particles?: Particles,
  ): void {
    const { uniforms, fields, tiles, flatTiles, eye } = this;
    const across = this.hasLights ? this.lightsAcross : this.across;
    [uniforms.across.value, uniforms.lightsAcross.value = null] = across.textures;
    const meshes = this.meshes(particles !== undefined);
    if (particles) {
      const { form } = this.leaning!;
      form.fit(particles);
      uniforms.formFromView.value.copy(eye.uniforms.viewFromWorld.value).invert().premultiply(form.fromWorld);
    }
    const { unlit, lit, depth, width, height } = targets;
    Object.entries({ unlit, lit, shading, depth }).forEach(([name, texture]) => {
      uniforms[name as keyof typeof uniforms].value = texture;
    });
    for (const target of [fields, across]) target.setSize(width, height);
    const [columns, rows] = [width, height].map((pixels) => Math.ceil(pixels / FLAT_TILE));
    for (const target of [tiles, flatTiles]) target.setSize(columns, rows);
    const isSmall = columns * rows <= FEW_TILES;
    if (isSmall) {
      renderer.setRenderTarget(flatTiles);
      renderer.setClearColor(ACTIVE, 1);
      renderer.clear(true, false, false);
    }
    [tiles, flatTiles, fields, across, output].forEach((target, index) => {
      const pass = meshes[index];
      if (isSmall && index < 2) return;
      renderer.setRenderTarget(target);
      eye.asVariant(pass, () => {
        if (pass instanceof DrawnPoints) pass.draw(renderer, columns * rows);
        else pass.draw(renderer);
      });
    });
  }

  /** What it draws with. @param hasForm whether light follows the form of the smoke */
  meshes(hasForm: boolean): readonly (FullScreen | DrawnPoints)[] {
    if (!hasForm) return this.passes;
    this.leaning ??= this.createLeaning();
    return [...this.passes.slice(0, -1), this.leaning.tones];
  }

  /** Releases the render targets until the next draw. */
  releaseTargets(): void {
    const { fields, tiles, flatTiles, across, lightsAcross } = this;
    for (const target of [fields, tiles, flatTiles, across, lightsAcross]) target.dispose();
  }

  dispose(): void {
    for (const pass of this.passes) pass.dispose();
    this.leaning?.tones.dispose();
    this.leaning?.form.dispose();
    this.releaseTargets();
  }

  private createLeaning() {
    const form = new PlumeForm();
    const uniforms = { ...this.toneUniforms, form: { value: form.texture } };
    return { form, tones: new DrawnPoints(activeShader, tonesShader, uniforms, LEANING) };
  }
}

/** What flat.frag writes for tiles that are not flat. */
const ACTIVE = 0x00ff00;
/** Makes shaders mix in the light of the whole form. */
const LEANING = { FORM: '' };
/** Makes points cover what is averaged with active tiles, too. */
const NEARBY = { NEARBY: '' };
