import type { Device } from './gpu/device.ts';
import { FrameView } from './gpu/frameView.ts';
import { PuffTextures, type BakedPuffs } from './gpu/puffTextures.ts';
import { RampTexture, type Color, type Ramp } from './gpu/ramps.ts';
import { bakedPuffs } from './bakedPuffs.ts';
import type { AdditionalLights } from './additionalLights.ts';
import type { LampLight } from './falloff.ts';
import type { FrameInput } from './frameInput.ts';
import { bandsOf, plainColorOf, rampOf, surfaceToning, litThresholdOf, washed } from './palette.ts';
import { codeOf, ExtraPasses, hasExtras, hasPattern, hasStrokes } from './extraPasses.ts';
import type { DrawnSurfaces } from './sceneSurfaces.ts';
import type { ShaderVariant } from './gpu/shaderVariant.ts';
import { leastThresholdOf, setStyle, styleUniforms, type Looks, type Style } from './style.ts';
import { SmokePasses } from './smokePasses.ts';
import { TINTS } from '../base/constants.ts';

export interface SmokeOptions {
  /** Largest number of particles that can be drawn. */
  capacity: number;
  /** The surfaces of its scene, such as `drawnSurfaces(descriptions)`; none if absent. */
  surfaces?: DrawnSurfaces;
  /** Display-encoded colours at the top and the bottom of the background; transparent if absent. */
  backdrop?: { top: Color; bottom: Color };
  /** The shapes of the puffs, such as `bakedPuffs(shapes)`; defaults to the built-in puffs. */
  puffs?: BakedPuffs;
}

/** The parameters of a style that needs no further modules. */
const PLAIN_PICTURE = {
  renderer: 'nailboards',
  form: 'lobes',
  isDeformed: true,
  volumes: 'receiver',
  simplify: 0,
  plumeForm: 0,
  strokes: 0,
  pattern: 'none',
  isEroded: false,
  lampLight: undefined,
  hasAdditionalLights: false,
  hasLooks: false,
  looks: undefined,
} as const;
// Ramp 0 is that of untinted smoke; the tints have ramps 1 and up.
const FIRST_SURFACE_RAMP = 1 + TINTS;

/**
 * Cartoon smoke on a device: draws a simulator's particles for any camera and light. After McGuire and Fein, 'Real-Time
 * Rendering of Cartoon Smoke and Clouds' (NPAR 2006). frame.ts has the order of the passes.
 */
export class SmokeRenderer {
  readonly passes: SmokePasses;
  private readonly device: Device;
  private readonly ramps: RampTexture;
  private readonly puffs: PuffTextures;
  private readonly stopListening: () => void;
  private readonly surfaces: DrawnSurfaces['descriptions'];
  private readonly backdrop: SmokeOptions['backdrop'];
  private style: Style | undefined;
  private pixelRatio = 0;
  private lampLight: LampLight | undefined;
  private additionalLights: AdditionalLights | undefined;
  private looks: (ShaderVariant & { apply(looks: Looks): void }) | undefined;
  /** The last style whose modules are not loaded yet; `meanwhile` is drawn until they are. */
  private asked: Style | undefined;
  private meanwhile: Style | undefined;

  constructor(device: Device, { capacity, surfaces, backdrop, puffs = bakedPuffs() }: SmokeOptions) {
    this.device = device;
    this.surfaces = surfaces?.descriptions ?? [];
    this.backdrop = backdrop;
    this.puffs = new PuffTextures(device.puffs, puffs);
    this.ramps = new RampTexture(FIRST_SURFACE_RAMP + this.surfaces.length);
    const eye = new FrameView(styleUniforms());
    this.passes = new SmokePasses({
      device,
      eye,
      puffs: this.puffs,
      ramps: this.ramps,
      capacity,
      scene: surfaces?.make(eye, this.ramps, FIRST_SURFACE_RAMP),
      hasSurfaces: this.surfaces.length > 0,
      hasBackdrop: backdrop !== undefined,
      extras: new ExtraPasses({ eye, puffs: this.puffs, ramps: this.ramps }),
    });
    // Released on the loss, not on the restoration: three.js would delete resources of the lost context in the restored
    // one.
    this.stopListening = device.onContext((event) => (event === 'lost' ? this.release() : undefined));
  }

  /**
   * Applies the style of a frame to all passes, and returns the frame that they can draw: while `fetchExtras` has not
   * loaded the modules that it needs, one with lobe nailboards.
   * @throws ContextError if the device has lost its context
   */
  prepare(input: FrameInput): FrameInput {
    this.device.requireUsable();
    const drawn = this.availableStyle(input);
    const { style, pixelRatio } = drawn;
    if (style !== this.style || pixelRatio !== this.pixelRatio) this.apply(style, pixelRatio);
    return drawn;
  }

  /** Replaces the puffs from the next frame on. Particles keep their variation. */
  setPuffs(puffs: BakedPuffs): void {
    this.puffs.show(puffs);
    this.style = undefined;
  }

  /** Releases the render targets until the next frame. */
  releaseTargets(): void {
    this.passes.targets.dispose();
    this.passes.resolve.releaseTargets();
    this.passes.extras.releaseTargets();
  }

  /** Releases all resources on the device, but not the device. */
  dispose(): void {
    this.stopListening();
    this.release();
    this.puffs.dispose();
  }

  /** Frees all buffers, textures and programs. They are created again when they are next drawn. */
  private release(): void {
    this.passes.release();
    this.ramps.dispose();
    this.lampLight?.dispose();
    this.additionalLights?.dispose();
  }

  private availableStyle(input: FrameInput): FrameInput {
    const { style, view } = input;
    // While the code of looks, or what they need, is not loaded, all smoke has the same look.
    for (const each of [style, style.looks?.plain])
      if (each && hasExtras({ ...each, view, hasLooks: false }))
        return each === style ? input : { ...input, style: each };
    if (this.asked !== style) this.meanwhile = { ...style, ...PLAIN_PICTURE };
    this.asked = style;
    return { ...input, style: this.meanwhile!, view: undefined };
  }

  private apply(style: Style, pixelRatio: number): void {
    const { eye, body, volumes, mask, resolve, extras } = this.passes;
    setStyle(eye.style, style, pixelRatio);
    const pattern = hasPattern(style) ? extras.patterns : undefined;
    pattern?.setStyle(style, pixelRatio);
    this.selectLights(style);
    if (pattern) eye.variants = [...eye.variants, ...pattern.variants];
    if (style.looks) {
      this.looks ??= new (codeOf('looks').LookVariant)();
      this.looks.apply(style.looks);
      eye.variants = [...eye.variants, this.looks];
    }
    this.writeRamps(style);
    this.paintBackdrop(style);
    body.setGradient(style.gradient, style.gradientHeights);
    this.puffs.deform(style.isDeformed ? style.stretch : undefined);
    this.puffs.bites = style.isEroded ? codeOf('bites').bitesOf(this.puffs) : undefined;
    body.setForm(extras.billboardsOf(style.form));
    extras.simplify?.setUniforms(
      style.simplify * pixelRatio,
      !style.softColors,
      litThresholdOf(style),
      style.hasAdditionalLights,
    );
    const strokes = hasStrokes(style) ? extras.strokes : undefined;
    strokes?.setUniforms(style.strokes, pixelRatio);
    resolve.overlay = strokes;
    resolve.pattern = pattern;
    volumes.setForm(style.form, leastThresholdOf(style));
    extras.countedVolumes?.setForm(style.form, leastThresholdOf(style));
    mask.setDepth(style.shadowSteps === 2 ? style.shadowDepth : Infinity);
    this.style = style;
    this.pixelRatio = pixelRatio;
  }

  /** Selects the code for light that few styles need. */
  private selectLights({ lampLight, hasAdditionalLights }: Style): void {
    const { passes } = this;
    passes.lampLight = lampLight && (this.lampLight ??= new (codeOf('falloff').LampLight)());
    passes.additionalLights = hasAdditionalLights
      ? (this.additionalLights ??= new (codeOf('additionalLights').AdditionalLights)())
      : undefined;
    passes.eye.variants = [passes.lampLight, passes.additionalLights].filter((light) => light !== undefined);
  }

  private paintBackdrop({ backdropColors = [] }: Style): void {
    if (!this.backdrop) return;
    const { bottom, top } = this.backdrop;
    const own = [bottom, top].map((color, from) => ({ from, color }));
    this.passes.backdrop.setColors(backdropColors.length > 0 ? backdropColors : own);
  }

  /** Writes the ramps in the order: smoke, tints, surfaces, smoke for each band of age and temperature, then looks. */
  private writeRamps(style: Style): void {
    const surfaces = surfaceToning(style);
    const first = FIRST_SURFACE_RAMP + this.surfaces.length;
    const { colors, glows: shares, bands } = bandsOf(style, first);
    const ramps: Ramp[] = [
      rampOf(plainColorOf(style), style),
      ...style.tints.map((tint) => rampOf(tint, style)),
      ...this.surfaces.map(({ color, glows }) => ({ ...rampOf(washed(color, style.wash), surfaces), glows })),
      ...colors.map((color, band) => ({ ...rampOf(color, style), glow: shares[band] })),
    ];
    const rows = style.looks ? codeOf('looks').addRamps(style, ramps, bands) : [bands];
    this.ramps.resize(ramps.length, rows.length);
    ramps.forEach((ramp, material) => this.ramps.write(material, ramp, style.illumination));
    rows.forEach((each, look) => this.ramps.writeBands(each, look));
    this.passes.lampLight?.apply(style, ramps);
    this.passes.additionalLights?.apply(ramps);
  }
}
