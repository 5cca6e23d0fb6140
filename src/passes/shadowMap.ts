import {
  Box3,
  Matrix4,
  OrthographicCamera,
  Sphere,
  type WebGLRenderTarget,
  type BufferGeometry,
  type Camera,
  type Texture,
  type WebGLRenderer,
} from 'three';
import applyFragmentShader from '../../shaders/shadowMap/apply.frag';
import shadowedFragmentShader from '../../shaders/shadowMap/shadowed.frag';
import { Eye } from '../device/eye.ts';
import { ADDS, FullScreen } from '../device/fullScreen.ts';
import { pictureTarget } from '../device/pictureTarget.ts';
import type { PuffTextures } from '../device/puffTextures.ts';
import type { RampTexture } from '../device/ramps.ts';
import type { Shaders } from '../device/programsAhead.ts';
import { BodiesPass } from './bodies.ts';
import type { InkLine } from './ink.ts';
import { SurfacesPass, type SurfaceDescription } from './surfaces.ts';
import { Targets } from './targets.ts';

/** Texels along a side of the map. */
const SIZE = 1024;
/** Texels of the map by which a surface must lie behind what the light sees: less shows as stripes. */
const BIAS_TEXELS = 3;

const NO_INK: InkLine = { color: [0, 0, 0], pixels: 0, swell: 0 };

/** What the map is drawn from. */
export interface ShadowMapSources {
  readonly eye: Eye;
  readonly puffs: PuffTextures;
  readonly ramps: RampTexture;
  /** Which ramp is that of the first surface; the others follow. */
  readonly firstSurface: number;
  readonly surfaces: readonly SurfaceDescription[];
  readonly casters: BufferGeometry;
}

/**
 * Shadow by a depth map drawn from the light, for comparison with volumes (Williams, 'Casting Curved Shadows on Curved
 * Surfaces', 1978): cheap for any number of puffs, with edges as coarse as its texels. Writes the mask that resolve reads.
 */
export class ShadowMapPass {
  private readonly eye: Eye;
  private readonly lightEye = new Eye();
  private readonly camera = new OrthographicCamera();
  private readonly map = new Targets();
  private readonly body: BodiesPass;
  private readonly surfaces: SurfacesPass;
  private readonly castingRigids: readonly (number | undefined)[];
  private readonly shadowed: WebGLRenderTarget;
  private readonly uniforms;
  private readonly measure: FullScreen;
  private readonly apply: FullScreen;

  constructor({ eye, puffs, ramps, firstSurface, surfaces, casters }: ShadowMapSources) {
    this.eye = eye;
    const casting = surfaces.filter((surface) => surface.casts);
    this.castingRigids = casting.map(({ rigid }) => rigid);
    this.body = new BodiesPass(this.lightEye, puffs, ramps, casters);
    this.surfaces = new SurfacesPass(this.lightEye, ramps, firstSurface, casting);
    this.body.setInk(NO_INK, 0, 0);
    this.surfaces.setInk(NO_INK, false);
    this.shadowed = pictureTarget();
    this.uniforms = {
      clipFromView: eye.uniforms.clipFromView,
      viewport: eye.uniforms.viewport,
      depth: { value: null as Texture | null },
      lightDepth: { value: this.map.depth },
      lightClipFromView: this.lightEye.uniforms.clipFromView,
      lightViewFromView: { value: new Matrix4() },
      bias: { value: 0 },
    };
    this.measure = new FullScreen(shadowedFragmentShader, this.uniforms);
    const shadowed = { value: this.shadowed.texture };
    this.apply = new FullScreen(applyFragmentShader, { shadowed }, ADDS);
  }

  /** @see BodiesPass.setForm */
  setForm(billboards?: Shaders): void {
    this.body.setForm(billboards);
  }

  /** Puts the surfaces where their rigids are. */
  place(rigids: readonly Matrix4[]): void {
    this.castingRigids.forEach((rigid, surface) => {
      if (rigid !== undefined) this.surfaces.place(surface, rigids[rigid]);
    });
  }

  /** Draws the map, then the mask into the targets, which stay what is drawn into. Takes a lamp for a sun. */
  draw(renderer: WebGLRenderer, targets: Targets): void {
    this.look();
    this.map.resize(SIZE, SIZE);
    this.map.begin(renderer);
    this.surfaces.draw(renderer);
    this.body.draw(renderer);
    this.uniforms.depth.value = targets.depth;
    this.shadowed.setSize(targets.width, targets.height);
    renderer.setRenderTarget(this.shadowed);
    this.measure.draw(renderer);
    renderer.setRenderTarget(targets.renderTarget);
    this.apply.draw(renderer);
  }

  dispose(): void {
    for (const part of [this.body, this.surfaces, this.map, this.shadowed, this.measure, this.apply]) part.dispose();
  }

  /** Fits the light's camera round the receivers. */
  private look(): void {
    const { receiversMin, receiversMax, viewFromWorld, lightInWorld } = this.eye.uniforms;
    const receivers = new Box3(receiversMin.value, receiversMax.value);
    const { center, radius } = receivers.getBoundingSphere(new Sphere());
    const camera: Camera & OrthographicCamera = this.camera;
    Object.assign(camera, { left: -radius, right: radius, bottom: -radius, top: radius, near: 0, far: 4 * radius });
    camera.updateProjectionMatrix();
    camera.position.copy(center).addScaledVector(this.eye.travelAt(center), -2 * radius);
    camera.lookAt(center);
    this.lightEye.look(camera, lightInWorld.value, SIZE, SIZE);
    this.uniforms.bias.value = (BIAS_TEXELS * 2 * radius) / SIZE;
    this.uniforms.lightViewFromView.value.copy(viewFromWorld.value).invert().premultiply(camera.matrixWorldInverse);
  }
}
