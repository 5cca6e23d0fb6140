import {
  Box3,
  GLSL3,
  MathUtils,
  Matrix4,
  OrthographicCamera,
  PerspectiveCamera,
  RawShaderMaterial,
  Sphere,
  Vector3,
  type WebGLRenderTarget,
  type Camera,
  type Texture,
  type WebGLRenderer,
} from 'three';
import applyFragmentShader from '../../shaders/shadowMap/apply.frag';
import lobesFragmentShader from '../../shaders/shadowMap/lobes.frag';
import lobesVertexShader from '../../shaders/shadowMap/lobes.vert';
import shadowedFragmentShader from '../../shaders/shadowMap/shadowed.frag';
import { DrawnRows, type RowGeometry } from '../device/drawnRows.ts';
import { FrameView } from '../device/frameView.ts';
import { ADDS, FullScreen } from '../device/fullScreen.ts';
import { pictureTarget } from '../device/pictureTarget.ts';
import type { PuffTextures } from '../device/puffTextures.ts';
import type { RampTexture } from '../device/ramps.ts';
import type { Shaders } from '../device/programsAhead.ts';
import { DEFORMED, withLobes } from '../device/unroll.ts';
import { BodiesPass } from './bodies.ts';
import { SurfaceTransforms } from './surfaceTransforms.ts';
import type { SurfaceDescription } from './surface.ts';
import { SurfacesPass } from './surfaces.ts';
import { Targets } from './targets.ts';

/** Width and height of the depth map, texels. */
const SIZE = 1024;
/** Depth bias against shadow acne, in texels of the map. Smaller values show as stripes on lit surfaces. */
const BIAS_TEXELS = 3;
/** Near plane of the lamp's camera, metres. */
const NEAREST = 0.02;
/**
 * Largest field of view that covers all receivers with one map, degrees. A lamp that is closer uses a cube of six
 * views.
 */
const WIDEST = 90;
/** Rotations from one cube face to the next: axis in the camera's own space and angle in radians. */
const ROTATIONS = [
  [new Vector3(0, 1, 0), 0],
  [new Vector3(0, 1, 0), Math.PI / 2],
  [new Vector3(0, 1, 0), Math.PI / 2],
  [new Vector3(0, 1, 0), Math.PI / 2],
  [new Vector3(1, 0, 0), Math.PI / 2],
  [new Vector3(1, 0, 0), Math.PI],
] as const;

/** The resources from which the map is drawn. */
export interface ShadowMapSources {
  readonly eye: FrameView;
  readonly puffs: PuffTextures;
  readonly ramps: RampTexture;
  /** Ramp index of the first surface; the other surfaces follow in order. */
  readonly firstSurface: number;
  readonly surfaces: readonly SurfaceDescription[];
}

/**
 * Shadows from a depth map drawn from the light, for comparison with shadow volumes (Williams, 'Casting Curved Shadows
 * on Curved Surfaces', 1978). The cost hardly depends on the number of puffs, and edges are as coarse as the texels.
 * The pass writes the mask that the resolve pass reads.
 * A sun uses an orthographic projection. A lamp uses a perspective projection, or six of 90 degrees if it is among the
 * receivers. Lobe puffs are rendered as exact spheres: nailboards far from the view axis would be narrower than the
 * puffs that the camera shows, and nearer. Billboards are rendered as billboards.
 */
export class ShadowMapPass {
  private readonly eye: FrameView;
  private readonly lightEye: FrameView;
  private readonly sun = new OrthographicCamera();
  private readonly lamp = new PerspectiveCamera();
  private readonly map = new Targets();
  private readonly lobes: LobeDepths;
  private readonly billboards: BodiesPass;
  private hasBillboards = false;
  private readonly surfaces: SurfacesPass;
  private readonly transforms: SurfaceTransforms;
  /** Indices of the surfaces that cast shadows. */
  private readonly casting: readonly number[];
  private readonly shadowed: WebGLRenderTarget;
  private readonly uniforms;
  private readonly measure: FullScreen;
  private readonly apply: FullScreen;

  constructor({ eye, puffs, ramps, firstSurface, surfaces }: ShadowMapSources) {
    this.eye = eye;
    this.lightEye = new FrameView({ ...eye.style, inkPixels: { value: 0 } });
    this.casting = surfaces.flatMap(({ casts }, surface) => (casts ? [surface] : []));
    this.lobes = new LobeDepths(this.lightEye, puffs);
    this.billboards = new BodiesPass(this.lightEye, puffs, ramps);
    const casting = this.casting.map((surface) => surfaces[surface]);
    this.transforms = new SurfaceTransforms(casting.length);
    this.surfaces = new SurfacesPass(this.lightEye, ramps, firstSurface, casting, this.transforms);
    this.shadowed = pictureTarget();
    this.uniforms = {
      clipFromView: eye.uniforms.clipFromView,
      viewport: eye.uniforms.viewport,
      depth: { value: null as Texture | null },
      lightDepth: { value: this.map.depth },
      lightClipFromView: this.lightEye.uniforms.clipFromView,
      lightViewFromView: { value: new Matrix4() },
      bias: { value: BIAS_TEXELS / SIZE },
    };
    this.measure = new FullScreen(shadowedFragmentShader, this.uniforms);
    const shadowed = { value: this.shadowed.texture };
    this.apply = new FullScreen(applyFragmentShader, { shadowed }, ADDS);
  }

  /** @see BodiesPass.setForm */
  setForm(billboards?: Shaders): void {
    this.hasBillboards = billboards !== undefined;
    this.billboards.setForm(billboards);
  }

  /** @see SurfaceTransforms.place */
  place(surface: number, worldFromModel: Matrix4, isVisible: boolean): void {
    const index = this.casting.indexOf(surface);
    if (index >= 0) this.transforms.place(index, worldFromModel, isVisible);
  }

  /** Draws the map of the casters and then adds the mask to the targets, which stay bound. */
  draw(renderer: WebGLRenderer, targets: Targets, casters: RowGeometry): void {
    this.map.resize(SIZE, SIZE);
    this.uniforms.depth.value = targets.depth;
    this.shadowed.setSize(targets.width, targets.height);
    renderer.setRenderTarget(this.shadowed);
    renderer.clear(true, false, false);
    if (!this.eye.lamp) this.drawBy(this.sunCamera(), renderer, casters);
    else for (const camera of this.lampCameras()) this.drawBy(camera, renderer, casters);
    renderer.setRenderTarget(targets.renderTarget);
    this.apply.draw(renderer);
  }

  dispose(): void {
    for (const part of [this.lobes, this.billboards, this.surfaces, this.map]) part.dispose();
    for (const part of [this.transforms, this.shadowed, this.measure, this.apply]) part.dispose();
  }

  /** Draws the map with one camera of the light, then evaluates the shadow of the pixels that this camera covers. */
  private drawBy(camera: Camera, renderer: WebGLRenderer, casters: RowGeometry): void {
    const { viewFromWorld, lightInWorld } = this.eye.uniforms;
    this.lightEye.look(camera, lightInWorld.value, SIZE, SIZE);
    this.uniforms.lightViewFromView.value.copy(viewFromWorld.value).invert().premultiply(camera.matrixWorldInverse);
    this.map.begin(renderer);
    this.surfaces.draw(renderer, this.map);
    (this.hasBillboards ? this.billboards : this.lobes).draw(renderer, casters);
    renderer.setRenderTarget(this.shadowed);
    this.measure.draw(renderer);
  }

  /** The bounding sphere of everything that receives shadow. */
  private receivers(): Sphere {
    const { receiversMin, receiversMax } = this.eye.uniforms;
    return new Box3(receiversMin.value, receiversMax.value).getBoundingSphere(new Sphere());
  }

  private sunCamera(): Camera {
    const { center, radius } = this.receivers();
    const { sun } = this;
    Object.assign(sun, { left: -radius, right: radius, bottom: -radius, top: radius, near: 0, far: 4 * radius });
    sun.updateProjectionMatrix();
    sun.position.copy(center).addScaledVector(this.eye.travelAt(center), -2 * radius);
    sun.lookAt(center);
    return sun;
  }

  /** Yields the cameras of the lamp. All are the same object, moved between iterations. */
  private *lampCameras(): Generator<Camera> {
    const { center, radius } = this.receivers();
    const { lamp } = this;
    const { x, y, z } = this.eye.uniforms.lightInWorld.value;
    const distance = lamp.position.set(x, y, z).distanceTo(center);
    const seen = 2 * MathUtils.radToDeg(Math.asin(Math.min(1, radius / distance)));
    const isAmong = seen > WIDEST;
    // Puffs shrink close to the near plane, so it must be well in front of the nearest receiver.
    const near = Math.max(NEAREST, (distance - radius) / 4);
    Object.assign(lamp, { fov: isAmong ? WIDEST : seen, near: isAmong ? NEAREST : near, far: distance + radius });
    lamp.updateProjectionMatrix();
    lamp.lookAt(center);
    for (const [axis, angle] of isAmong ? ROTATIONS : ROTATIONS.slice(0, 1)) {
      lamp.rotateOnAxis(axis, angle);
      yield lamp;
    }
  }
}

/** Renders lobe puffs into the depth map. */
class LobeDepths {
  private readonly puffs: PuffTextures;
  private readonly uniforms;
  private readonly rows: DrawnRows;
  /** Materials by lobe count, negative for deformed puffs, because the shaders unroll the loop over the lobes. */
  private readonly materials = new Map<number, RawShaderMaterial>();

  constructor(lightEye: FrameView, puffs: PuffTextures) {
    this.puffs = puffs;
    this.uniforms = {
      ...lightEye.uniforms,
      lobeTable: { value: null as Texture | null },
      reach: { value: 1 },
    };
    this.rows = new DrawnRows(this.material());
  }

  draw(renderer: WebGLRenderer, rows: RowGeometry): void {
    this.rows.material = this.material();
    this.rows.draw(renderer, rows);
  }

  dispose(): void {
    for (const material of this.materials.values()) material.dispose();
  }

  /** Binds the current puff textures and returns the material for their lobe count. */
  private material(): RawShaderMaterial {
    const { casterTable, casterLobes, reach } = this.puffs.of('lobes');
    const { isDeformed } = this.puffs;
    this.uniforms.lobeTable.value = casterTable;
    this.uniforms.reach.value = reach;
    const key = isDeformed ? -casterLobes : casterLobes;
    const material = this.materials.get(key) ?? this.makeMaterial(casterLobes, isDeformed);
    this.materials.set(key, material);
    return material;
  }

  private makeMaterial(lobes: number, isDeformed: boolean): RawShaderMaterial {
    return new RawShaderMaterial({
      defines: isDeformed ? DEFORMED : {},
      glslVersion: GLSL3,
      vertexShader: withLobes(lobesVertexShader, lobes),
      fragmentShader: withLobes(lobesFragmentShader, lobes),
      uniforms: this.uniforms,
    });
  }
}
