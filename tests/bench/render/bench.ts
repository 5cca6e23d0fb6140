/** The production frame with the seeded plume, and its passes one at a time. */
import { Matrix4, PerspectiveCamera, type Camera, type RawShaderMaterial } from 'three';
import { createDevice } from '../../../src/renderer/gpu/device.ts';
import { ballMesh } from '../../../src/scenes/models/ball.ts';
import { tableMesh } from '../../../src/scenes/models/table.ts';
import type { Scene } from '../../../src/scenes/scene.ts';
import { loadSimulators } from '../../../src/simulator/load.ts';
import type { Simulator } from '../../../src/simulator/simulator.ts';
import { fetchExtras } from '../../../src/renderer/extraPasses.ts';
import { arrangeFrame, drawFrame, reportOf } from '../../../src/renderer/frame.ts';
import type { Arranger, FrameInput, FrameReport } from '../../../src/renderer/frameInput.ts';
import { towardsLight } from '../../../src/renderer/light.ts';
import { drawnSurfaces } from '../../../src/renderer/sceneSurfaces.ts';
import { SmokeRenderer } from '../../../src/renderer/smoke.ts';
import { styleOf, type Style } from '../../../src/renderer/style.ts';
import type { Values } from '../../../src/parameters/parameter.ts';
import { simulatorValues } from '../../../src/simulator/simulatorValues.ts';
import { PLAIN_STYLE } from '../../visual/lab.ts';
import { timeDrawing } from '../support/figures.ts';
import { withParticles } from '../support/snapshot.ts';
import { countFragments, type Fragments, type Redraw } from './fragments.ts';
import { seededPlume } from './plume.ts';

export const WIDTH = 640;
export const HEIGHT = 360;
export const PARTICLES = 3000;

/** A table below the plume and a ball next to it: surfaces and casters independent of the demo's scenes. */
export const SURROUNDINGS: Pick<Scene, 'surfaces' | 'backdrop'> = {
  surfaces: [
    { name: 'table', mesh: tableMesh(1.75, 0.12), color: [178, 92, 96], casts: false, inked: true },
    { name: 'ball', mesh: ballMesh(0.26), color: [64, 190, 178], casts: true, inked: true, rigid: 0 },
  ],
  backdrop: { top: [43, 45, 92], bottom: [214, 110, 122] },
};

/** Milliseconds. */
export interface FrameTimes {
  bodies: number;
  volumes: number;
  resolve: number;
  frame: number;
}

export class RenderBench {
  readonly device = createDevice(new OffscreenCanvas(1, 1));
  readonly smoke: SmokeRenderer;
  readonly simulator: Simulator;
  /** The source of rows. */
  arranger: Arranger;
  /** Assign a new object to change it. */
  style: Style = PLAIN_STYLE;
  private readonly width: number;
  private readonly height: number;
  readonly camera = frontCamera();
  private readonly light = { kind: 'sun', towards: towardsLight(-40, 45) } as const;
  private readonly rigids = [new Matrix4().makeTranslation(-0.9, 1.4, 0.3)];

  private constructor(simulator: Simulator, particles: number, width: number, height: number) {
    this.simulator = this.arranger = simulator;
    this.width = width;
    this.height = height;
    this.device.renderer.setSize(width, height, false);
    const surfaces = drawnSurfaces(SURROUNDINGS.surfaces);
    this.smoke = new SmokeRenderer(this.device, { capacity: particles, ...SURROUNDINGS, surfaces });
  }

  /**
   * A picture with the suite's aspect ratio, smaller where only its rows matter.
   * @param look values of the style and of the puffs; the plain look if absent
   */
  static async create(scale = 1, particles = PARTICLES, smoke = seededPlume, look?: Values): Promise<RenderBench> {
    const style = look ? styleOf(look) : PLAIN_STYLE;
    await fetchExtras({ ...PLAIN_STYLE, strokes: 1, isTiled: true });
    await fetchExtras(style);
    const factory = await loadSimulators({ physics: false });
    const simulator = factory.create({ capacity: particles, seed: 1 });
    // The paper's equations, with which particles spawn at full size.
    const still = { 'emission.rate': 0, 'turbulence.speed': 0 };
    simulator.set({ ...still, 'emission.growthTime': 0, 'simulation.integrator': 1 });
    simulator.restore(withParticles(simulator, smoke(particles, 9)));
    // What the look changes about the rows.
    const rows = Object.entries(look ?? {}).filter(([key]) => /^puff\.(turn|stretch|billow)$/.test(key));
    simulator.set(simulatorValues(Object.fromEntries(rows)));
    const bench = new RenderBench(simulator, particles, WIDTH * scale, HEIGHT * scale);
    bench.style = style;
    return bench;
  }

  get context(): WebGL2RenderingContext {
    return this.device.renderer.getContext() as WebGL2RenderingContext;
  }

  draw(cull: boolean, camera: Camera = this.camera): FrameReport {
    return drawFrame(this.smoke, { ...this.input(cull), camera });
  }

  /** The first half of a frame, without drawing. */
  arrange(cull: boolean): FrameReport {
    return reportOf(arrangeFrame(this.smoke.passes, this.smoke.prepare(this.input(cull))));
  }

  /**
   * Milliseconds of a frame and of three of its passes, all in the same frame. The wait after each pass costs some
   * tenths of a millisecond. It does not remove parallelism, because SwiftShader executes draw calls one by one.
   */
  timeFrame(cull: boolean): FrameTimes {
    const times: FrameTimes = { bodies: 0, volumes: 0, resolve: 0, frame: 0 };
    const { body, volumes, resolve } = this.smoke.passes;
    const watched = { bodies: body, volumes, resolve };
    for (const [name, pass] of Object.entries(watched) as [keyof typeof watched, { draw(...all: unknown[]): void }][]) {
      const draw = pass.draw.bind(pass);
      pass.draw = (...all) => (times[name] = this.timeDrawing(() => draw(...all)));
    }
    times.frame = this.timeDrawing(() => this.draw(cull));
    // The instance properties hid the methods of the passes' classes.
    for (const pass of Object.values(watched)) Reflect.deleteProperty(pass, 'draw');
    return times;
  }

  /** x, y, z and radius of every puff, without culling. */
  places(): Float32Array {
    this.draw(false);
    return this.smoke.passes.bodies.places.slice();
  }

  /** The picture of the last frame: RGBA bytes. */
  picture(): Uint8Array {
    const pixels = new Uint8Array(4 * this.width * this.height);
    this.context.readPixels(0, 0, this.width, this.height, this.context.RGBA, this.context.UNSIGNED_BYTE, pixels);
    return pixels;
  }

  /**
   * Fragments of the bodies and of the volumes in the last frame.
   * @param isTiled whether its volumes were drawn in tiles
   */
  countFragments(isTiled = false): { bodies: Fragments; volumes: Fragments } {
    const { renderer, bodies, casters, body, volumes, extras } = this.smoke.passes;
    const tiled = isTiled ? extras.tiledVolumes : undefined;
    const count = (material: RawShaderMaterial, redraw: Redraw) =>
      countFragments(renderer, material, redraw, this.width, this.height);
    return {
      bodies: count(body.material, (material) => body.drawAs(renderer, material, bodies.geometry)),
      volumes: tiled
        ? count(tiled.material, (material) => tiled.drawTilesAs(renderer, material))
        : count(volumes.material, (material) => volumes.drawAs(renderer, material, casters.geometry)),
    };
  }

  /** See `timeDrawing` of figures.ts. */
  timeDrawing(draw: () => void): number {
    return timeDrawing(this.context, draw);
  }

  dispose(): void {
    this.smoke.dispose();
    this.device.dispose();
    this.simulator.dispose();
  }

  private input(cull: boolean): FrameInput {
    return {
      simulator: this.arranger,
      camera: this.camera,
      light: this.light,
      style: this.style,
      blend: 1,
      width: this.width,
      height: this.height,
      pixelRatio: 1,
      rigids: this.rigids,
      cull,
      output: null,
    };
  }
}

/**
 * At the same distance from the plume as in the demo. The upper third of the plume is outside the picture on the right.
 */
function frontCamera(): PerspectiveCamera {
  const camera = new PerspectiveCamera(33, WIDTH / HEIGHT, 0.1, 100);
  camera.position.set(-1.3, 1.9, 6.6);
  camera.lookAt(-1.3, 1.5, 0);
  camera.updateMatrixWorld();
  return camera;
}
