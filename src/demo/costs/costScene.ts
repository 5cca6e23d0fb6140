/** The scene whose frames are measured by the documentation and by `npm run bench -- costs`. */
import {
  AmbientLight,
  Color,
  DirectionalLight,
  Mesh,
  PerspectiveCamera,
  PlaneGeometry,
  Scene,
  TorusKnotGeometry,
  WebGLRenderer,
  type Material,
} from 'three';
import { CartoonSmoke } from '../../index.ts';
import { nextTask } from '../../internal.ts';
import type { CostCase } from './cases.ts';

const LIFETIME = 4;
/** More puffs than there is room for, so that the smoke is always full. */
const SURPLUS = 1.25;
/** Steps until it is full. */
const STEPS = 60 * LIFETIME;
const STEPS_AT_ONCE = 10;
/** Share of the puffs that may be missing: those that ended in the latest step. */
const MISSING = 0.02;
const LOST = 'The browser took the graphics context away. Close other pages that draw, and measure again.';

/** Smoke of a case. */
export interface CostSmoke {
  readonly case: CostCase;
  readonly smoke: CartoonSmoke;
}

/** A floor, a mesh of 2,048 triangles in the smoke, and the smoke of one case at a time. */
export class CostScene {
  readonly scene = new Scene();
  readonly camera: PerspectiveCamera;
  readonly renderer: WebGLRenderer;
  private readonly keyLight = new DirectionalLight('#fff0d0', 2.5);
  private readonly knot: Mesh<TorusKnotGeometry, Material>;
  private readonly floor: Mesh<PlaneGeometry, Material>;
  private readonly errors: unknown[] = [];
  private shown: CartoonSmoke | undefined;

  /**
   * @param width, height of the picture in CSS pixels
   * @param paint makes the material of a mesh
   */
  constructor(
    canvas: HTMLCanvasElement | OffscreenCanvas,
    width: number,
    height: number,
    paint: (color: string) => Material,
  ) {
    this.knot = new Mesh(new TorusKnotGeometry(0.3, 0.1, 128, 8), paint('#40bea8'));
    this.floor = new Mesh(new PlaneGeometry(12, 12), paint('#c08860'));
    this.renderer = new WebGLRenderer({ canvas, stencil: true });
    this.renderer.setSize(width, height, false);
    this.camera = new PerspectiveCamera(40, width / height, 0.1, 50);
    this.camera.position.set(0, 1.9, 5);
    this.camera.lookAt(0, 1.3, 0);
    this.scene.background = new Color('#4d5f9e');
    this.keyLight.position.set(2, 5, 3);
    this.knot.position.set(0.25, 1.3, 0);
    this.floor.rotation.x = -Math.PI / 2;
    this.scene.add(this.keyLight, new AmbientLight('#8899ff', 0.8), this.floor, this.knot);
    this.scene.updateMatrixWorld();
  }

  /**
   * Smoke of a case with all of its puffs and all of its code.
   * @throws what `CartoonSmoke` throws; the reason of `signal`
   */
  async create(given: CostCase, signal?: AbortSignal): Promise<CostSmoke> {
    const { renderer, keyLight } = this;
    const smoke = await CartoonSmoke.create({
      renderer,
      keyLight,
      values: {
        'emission.rate': (SURPLUS * given.puffs) / LIFETIME,
        'emission.lifetime': LIFETIME,
        'emitters.0.radius': 0.25,
        'emitters.0.speed': 0.7,
        'emitters.0.size': 0.3,
        'simulation.maxParticles': given.puffs,
        ...given.values,
      },
    });
    try {
      smoke.addEventListener('error', ({ error }) => this.errors.push(error));
      if (given.collides) smoke.collide(this.knot);
      if (given.casts) smoke.cast(this.knot);
      await smoke.complete();
      for (let step = 0; step < STEPS; step += STEPS_AT_ONCE) {
        signal?.throwIfAborted();
        smoke.step(STEPS_AT_ONCE);
        await nextTask();
      }
      const created = { case: given, smoke };
      // Compiles the programs, and finds what else has to be loaded.
      this.show(created);
      this.frame();
      await smoke.complete();
      this.frame();
      this.finish();
      this.check(created);
      return created;
    } catch (error) {
      this.remove(smoke);
      throw error;
    }
  }

  /** Shows the smoke of a case alone, or none, at its pixel ratio. @returns whether that changed, which a frame has to adopt */
  show(next: CostSmoke | undefined): boolean {
    this.shown?.removeFromParent();
    this.shown = next?.smoke;
    if (next) this.scene.add(next.smoke);
    const { renderer } = this;
    const pixelRatio = next?.case.pixelRatio ?? 1;
    if (renderer.getPixelRatio() === pixelRatio) return false;
    renderer.setPixelRatio(pixelRatio);
    return true;
  }

  /** One step and one picture, drawn by `draw`. */
  frame(draw = () => this.renderer.render(this.scene, this.camera)): void {
    this.shown?.step();
    draw();
  }

  /** Waits until the GPU has drawn everything. */
  finish(): void {
    const gl = this.renderer.getContext();
    this.renderer.setRenderTarget(null);
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
  }

  /** @throws the first error of the render loop; an Error unless the case is what its name says */
  check({ case: { name, puffs }, smoke }: CostSmoke): void {
    // First, because it is the reason of the errors.
    if (this.renderer.getContext().isContextLost()) throw new Error(LOST);
    if (this.errors.length > 0) throw this.errors[0];
    const { alive, bodiesDrawn } = smoke.stats;
    if (alive > puffs || alive < (1 - MISSING) * puffs) throw new Error(`${name}: ${alive} puffs are alive.`);
    if (bodiesDrawn < puffs / 50) throw new Error(`${name}: ${bodiesDrawn} puffs are drawn.`);
  }

  remove(smoke: CartoonSmoke): void {
    if (this.shown === smoke) this.show(undefined);
    smoke.dispose();
  }

  dispose(): void {
    if (this.shown) this.remove(this.shown);
    for (const mesh of [this.knot, this.floor]) {
      mesh.geometry.dispose();
      mesh.material.dispose();
    }
    this.renderer.dispose();
    if (!this.renderer.getContext().isContextLost()) this.renderer.forceContextLoss();
  }
}
