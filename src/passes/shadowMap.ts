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
  type BufferGeometry,
  type Camera,
  type Texture,
  type WebGLRenderer,
} from 'three';
import applyFragmentShader from '../../shaders/shadowMap/apply.frag';
import lobesFragmentShader from '../../shaders/shadowMap/lobes.frag';
import lobesVertexShader from '../../shaders/shadowMap/lobes.vert';
import shadowedFragmentShader from '../../shaders/shadowMap/shadowed.frag';
import { DrawnMesh } from '../device/drawnMesh.ts';
import { FrameView } from '../device/frameView.ts';
import { ADDS, FullScreen } from '../device/fullScreen.ts';
import { pictureTarget } from '../device/pictureTarget.ts';
import type { PuffTextures } from '../device/puffTextures.ts';
import type { RampTexture } from '../device/ramps.ts';
import type { Shaders } from '../device/programsAhead.ts';
import { withLobes } from '../device/unroll.ts';
import { BodiesPass } from './bodies.ts';
import type { InkLine } from './ink.ts';
import { SurfacesPass, type SurfaceDescription } from './surfaces.ts';
import { Targets } from './targets.ts';

/** Texels along a side of the map. */
const SIZE = 1024;
/** Texels of the map by which a surface must lie behind what the light sees: less shows as stripes. */
const BIAS_TEXELS = 3;
/** Nearest view depth that a lamp's camera draws, metres. */
const NEAREST = 0.02;
/** The widest view by which a lamp sees all receivers at once, degrees; from a nearer place it looks to six sides. */
const WIDEST = 90;
/** How a lamp's camera turns from each of the six sides to the next, in its own space: about an axis, by radians. */
const ROTATIONS = [
  [new Vector3(0, 1, 0), 0],
  [new Vector3(0, 1, 0), Math.PI / 2],
  [new Vector3(0, 1, 0), Math.PI / 2],
  [new Vector3(0, 1, 0), Math.PI / 2],
  [new Vector3(1, 0, 0), Math.PI / 2],
  [new Vector3(1, 0, 0), Math.PI],
] as const;

const NO_INK: InkLine = { color: [0, 0, 0], pixels: 0, swell: 0 };

/** What the map is drawn from. */
export interface ShadowMapSources {
  readonly eye: FrameView;
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
 * A sun has a parallel projection. A lamp has a perspective one, or six of 90 degrees, one after the other, where it
 * stands among the receivers. Puffs are the balls that they are made of there: nailboards far from the axis of a view would
 * be narrower, and nearer than what the eye sees. Billboards stay what they are.
 */
export class ShadowMapPass {
  private readonly eye: FrameView;
  private readonly lightEye = new FrameView();
  private readonly sun = new OrthographicCamera();
  private readonly lamp = new PerspectiveCamera();
  private readonly map = new Targets();
  private readonly lobes: LobeDepths;
  private readonly billboards: BodiesPass;
  private hasBillboards = false;
  private readonly surfaces: SurfacesPass;
  /** Which of the surfaces cast. */
  private readonly casting: readonly number[];
  private readonly shadowed: WebGLRenderTarget;
  private readonly uniforms;
  private readonly measure: FullScreen;
  private readonly apply: FullScreen;

  constructor({ eye, puffs, ramps, firstSurface, surfaces, casters }: ShadowMapSources) {
    this.eye = eye;
    this.casting = surfaces.flatMap(({ casts }, surface) => (casts ? [surface] : []));
    this.lobes = new LobeDepths(this.lightEye, puffs, casters);
    this.billboards = new BodiesPass(this.lightEye, puffs, ramps, casters);
    const casting = this.casting.map((surface) => surfaces[surface]);
    this.surfaces = new SurfacesPass(this.lightEye, ramps, firstSurface, casting);
    this.billboards.setInk(NO_INK, 0, 0);
    this.surfaces.setInk(NO_INK, false);
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

  /** @see SurfacesPass.place */
  place(surface: number, worldFromModel: Matrix4, isVisible: boolean): void {
    const index = this.casting.indexOf(surface);
    if (index >= 0) this.surfaces.place(index, worldFromModel, isVisible);
  }

  /** Draws the map, then the mask into the targets, which stay what is drawn into. */
  draw(renderer: WebGLRenderer, targets: Targets): void {
    this.map.resize(SIZE, SIZE);
    this.uniforms.depth.value = targets.depth;
    this.shadowed.setSize(targets.width, targets.height);
    renderer.setRenderTarget(this.shadowed);
    renderer.clear(true, false, false);
    if (this.eye.isLitBySun) this.drawBy(this.sunCamera(), renderer);
    else for (const camera of this.lampCameras()) this.drawBy(camera, renderer);
    renderer.setRenderTarget(targets.renderTarget);
    this.apply.draw(renderer);
  }

  dispose(): void {
    for (const part of [this.lobes, this.billboards, this.surfaces, this.map]) part.dispose();
    for (const part of [this.shadowed, this.measure, this.apply]) part.dispose();
  }

  /** Draws the map by a camera of the light, then the shadow of what that camera sees. */
  private drawBy(camera: Camera, renderer: WebGLRenderer): void {
    const { viewFromWorld, lightInWorld } = this.eye.uniforms;
    this.lightEye.look(camera, lightInWorld.value, SIZE, SIZE);
    this.uniforms.lightViewFromView.value.copy(viewFromWorld.value).invert().premultiply(camera.matrixWorldInverse);
    this.map.begin(renderer);
    this.surfaces.draw(renderer);
    (this.hasBillboards ? this.billboards : this.lobes).draw(renderer);
    renderer.setRenderTarget(this.shadowed);
    this.measure.draw(renderer);
  }

  /** The ball round everything that receives shadow. */
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

  /** One camera after the other, each the same object. */
  private *lampCameras(): Generator<Camera> {
    const { center, radius } = this.receivers();
    const { lamp } = this;
    const { x, y, z } = this.eye.uniforms.lightInWorld.value;
    const distance = lamp.position.set(x, y, z).distanceTo(center);
    const seen = 2 * MathUtils.radToDeg(Math.asin(Math.min(1, radius / distance)));
    const isAmong = seen > WIDEST;
    // Billboards shrink before a near plane; those that come nearest stand well beyond it.
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

/** Draws the lobes of puffs into the depth of a light's view. */
class LobeDepths {
  private readonly puffs: PuffTextures;
  private readonly uniforms;
  private readonly rows: DrawnMesh;
  /** By the number of lobes that are unrolled in them. */
  private readonly materials = new Map<number, RawShaderMaterial>();

  constructor(lightEye: FrameView, puffs: PuffTextures, rows: BufferGeometry) {
    this.puffs = puffs;
    this.uniforms = {
      ...lightEye.uniforms,
      lobeTable: { value: null as Texture | null },
      reach: { value: 1 },
    };
    this.rows = new DrawnMesh(rows, this.material());
  }

  draw(renderer: WebGLRenderer): void {
    this.rows.material = this.material();
    this.rows.draw(renderer);
  }

  dispose(): void {
    for (const material of this.materials.values()) material.dispose();
  }

  /** Puts the puffs into the uniforms. */
  private material(): RawShaderMaterial {
    const { lobeTable, reach, puffs } = this.puffs.lobes;
    this.uniforms.lobeTable.value = lobeTable;
    this.uniforms.reach.value = reach;
    const material = this.materials.get(puffs.lobeCount) ?? this.makeMaterial(puffs.lobeCount);
    this.materials.set(puffs.lobeCount, material);
    return material;
  }

  private makeMaterial(lobes: number): RawShaderMaterial {
    return new RawShaderMaterial({
      glslVersion: GLSL3,
      vertexShader: withLobes(lobesVertexShader, lobes),
      fragmentShader: withLobes(lobesFragmentShader, lobes),
      uniforms: this.uniforms,
    });
  }
}
