import {
  MathUtils,
  Vector2,
  Vector3,
  type DepthTexture,
  type Matrix4,
  type PerspectiveCamera,
  type WebGLRenderer,
} from 'three';
import type { GpuTimer } from '../renderer/gpu/gpuTimer.ts';
import { DEBUG_VIEWS, LOWEST_QUALITY, type DebugView, type Quality } from '../parameters/quality.ts';
import { ParameterError } from '../base/errors.ts';
import type { Values } from '../parameters/parameter.ts';
import type { Scene } from '../scenes/scene.ts';
import { secondsAt, STEP_SECONDS } from '../simulator/clock.ts';
import type { Simulator } from '../simulator/simulator.ts';
import type { PictureKind } from '../renderer/extraPasses.ts';
import { deviationFor, drawnSurfaces } from '../renderer/sceneSurfaces.ts';
import { drawFrame } from '../renderer/frame.ts';
import type { FrameInput, FrameReport } from '../renderer/frameInput.ts';
import { lightOf, moved, type Light } from '../renderer/light.ts';
import { formatColor } from '../renderer/palette.ts';
import { ShownSmoke } from '../renderer/shownSmoke.ts';
import { SmokeRenderer, type SmokeOptions } from '../renderer/smoke.ts';
import { OrbitCamera } from './orbit.ts';
import type { PictureSize, Presenter } from './presenter.ts';

const LARGEST_PIXEL_RATIO = 4;
/** Milliseconds per picture spent on baking puffs. */
const BAKING_MS = 5;

/** The state that a picture is drawn from. */
export interface PictureState {
  simulator: Simulator;
  /** World transforms of the rigids, by index. */
  rigids: readonly Matrix4[];
  /** World transforms of the scene's parts, by index. */
  parts: readonly Matrix4[];
  /** Interpolation between the previous step (0) and the latest (1). */
  blend: number;
  /** Fraction of the pixel ratio to draw with. */
  scale: number;
  /** Whether playback is running: puffs whose parameters change are then baked over several pictures. */
  isPlaying: boolean;
}

/** The depth buffer of a picture, with the renderer that can read it and the camera of the picture. */
export interface DrawnDepth {
  readonly renderer: WebGLRenderer;
  /** 24-bit window depth. */
  readonly depth: DepthTexture;
  readonly camera: PerspectiveCamera;
}

/** A stage's picture: its camera, size, quality and contents. */
export class Picture {
  /** Whether to draw the background; without it, the picture is transparent there. */
  hasBackground = true;
  /** Device pixels per CSS pixel. */
  pixelRatio = 1;
  /** Scale of the latest frame. */
  scale = 1;
  renderMs = 0;
  /** Undefined unless frames are timed on the GPU. */
  timer: GpuTimer | undefined;
  report: FrameReport = { bodiesDrawn: 0, castersDrawn: 0, arrangeMs: 0 };
  /** Replaced when another scene is entered, as the smoke. */
  eye: OrbitCamera;
  smoke: ShownSmoke;
  readonly presenter: Presenter;
  private scene: Scene;
  private width = 0;
  private height = 0;
  private chosenQuality: Quality = 1;
  private chosenView: DebugView | undefined;
  private isTimed = false;

  constructor(presenter: Presenter, scene: Scene, values: Values) {
    this.presenter = presenter;
    this.scene = scene;
    this.eye = new OrbitCamera(scene, values);
    this.smoke = this.smokeOf(values);
  }

  /** See StageOptions. */
  get quality(): Quality {
    return this.chosenQuality;
  }

  /** @throws ParameterError unless the value is 'auto' or 0.25 to 1 */
  set quality(quality: Quality) {
    if (quality !== 'auto' && !(quality >= LOWEST_QUALITY && quality <= 1)) {
      throw new ParameterError('quality', quality, `auto or ${LOWEST_QUALITY} to 1`);
    }
    this.chosenQuality = quality;
  }

  /** See StageOptions. */
  get view(): DebugView | undefined {
    return this.chosenView;
  }

  /** @throws ParameterError for an unknown view */
  set view(view: DebugView | undefined) {
    if (view !== undefined && !DEBUG_VIEWS.includes(view)) {
      throw new ParameterError('view', view, DEBUG_VIEWS.join(', '));
    }
    this.chosenView = view;
  }

  /** See `Stage.timeGpu`. */
  timeGpu(isOn: boolean): void {
    this.isTimed = isOn;
    if (isOn) {
      void import('../renderer/gpu/gpuTimer.ts').then(
        ({ createGpuTimer }) => this.isTimed && (this.timer ??= createGpuTimer(this.presenter.device)),
        // The statistics are then without this time.
        () => {},
      );
    } else {
      this.timer?.dispose();
      this.timer = undefined;
    }
  }

  /** The settings that decide whether more code must be loaded. @param simulator whose smoke is drawn */
  kindOf(simulator: Simulator): PictureKind {
    this.smoke.followLooks(simulator);
    return { ...this.smoke.style, view: this.chosenView };
  }

  get isVisible(): boolean {
    return this.width > 0 && this.height > 0;
  }

  /** Width and height in CSS pixels. */
  get size(): [width: number, height: number] {
    return [this.width / this.pixelRatio, this.height / this.pixelRatio];
  }

  /**
   * @param width, height in CSS pixels
   * @returns whether the size or the pixel ratio changed
   */
  resize(width: number, height: number, pixelRatio = this.pixelRatio): boolean {
    const before = [this.width, this.height, this.pixelRatio];
    [this.width, this.height, this.pixelRatio] = pixelsOf(width, height, pixelRatio);
    if (this.isVisible) this.eye.setSize(...this.size);
    return [this.width, this.height, this.pixelRatio].some((value, index) => value !== before[index]);
  }

  /** Applies new values. */
  setValues(values: Values): void {
    this.smoke.setValues(values);
    this.eye.override(values);
  }

  /** Switches to another scene. */
  enter(scene: Scene, values: Values): void {
    this.smoke.dispose();
    this.scene = scene;
    this.smoke = this.smokeOf(values);
    this.eye = new OrbitCamera(scene, values);
    if (this.isVisible) this.eye.setSize(...this.size);
  }

  /** Converts CSS pixels from the top left to normalized device coordinates: -1 to 1, y up. */
  deviceCoordinates(x: number, y: number): Vector2 {
    const [width, height] = this.size;
    return new Vector2((2 * x) / width - 1, 1 - (2 * y) / height);
  }

  /**
   * Draws and presents a picture. Returns false when the picture has no area, or when the context is lost before or
   * during the draw.
   */
  draw(moment: PictureState): boolean {
    const { device } = this.presenter;
    if (!this.isVisible || !device.isUsable) return false;
    const end = this.timer?.begin();
    try {
      this.smoke.bake(moment.isPlaying ? BAKING_MS : Infinity);
      this.eye.moveTo(secondsAt(moment.simulator.steps, moment.blend));
      const started = performance.now();
      const canvas = { width: this.width, height: this.height };
      const drawn = scaled(canvas, moment.scale);
      const output = this.presenter.prepare(canvas, drawn);
      this.report = drawFrame(this.smoke.renderer, this.inputOf(moment, drawn, output));
      this.presenter.present();
      this.scale = moment.scale;
      this.renderMs = performance.now() - started;
      return true;
    } catch (error) {
      if (device.isUsable) throw error;
      return false;
    } finally {
      end?.();
    }
  }

  /** The depth buffer of the latest picture, and what it was drawn with. */
  get drawnDepth(): DrawnDepth {
    const { renderer, targets } = this.smoke.renderer.passes;
    return { renderer, depth: targets.depth, camera: this.eye.camera };
  }

  /** Also disposes the device if the stage owns it. */
  dispose(): void {
    this.timeGpu(false);
    this.smoke.dispose();
    this.presenter.dispose();
  }

  /** The scene's backdrop as a value of `style.backdrop`; no value if it has none. */
  get sceneBackdrop(): Values {
    const { backdrop } = this.scene;
    const [bottom, top] = backdrop ? [backdrop.bottom, backdrop.top].map((color) => formatColor(color).slice(1)) : [];
    return backdrop ? { 'style.backdrop': `0:${bottom},1:${top}` } : {};
  }

  private smokeOf(values: Values): ShownSmoke {
    const { backdrop, surfaces, skin } = this.scene;
    const { device } = this.presenter;
    const make = (given: Pick<SmokeOptions, 'capacity' | 'puffs'>) =>
      new SmokeRenderer(device, { ...given, backdrop, surfaces: drawnSurfaces(surfaces, skin) });
    return new ShownSmoke(values, make);
  }

  private inputOf(
    { simulator, rigids, parts, blend, scale }: PictureState,
    drawn: PictureSize,
    output: FrameInput['output'],
  ): FrameInput {
    const time = simulator.steps * STEP_SECONDS;
    return this.smoke.inputOf({
      simulator,
      camera: this.eye.camera,
      light: lightIn(this.scene, this.smoke.values, time),
      blend,
      time,
      ...drawn,
      pixelRatio: this.pixelRatio * scale,
      rigids,
      parts,
      deviation: deviationOf(this.eye, drawn.height),
      cull: true,
      view: this.view,
      isTransparent: !this.hasBackground,
      output,
    });
  }
}

/**
 * How far models deviate from their finest triangles in the first picture of a scene, metres.
 * @param values whose `camera.*` entries override the scene's camera
 * @param width, height in CSS pixels
 */
export function firstDeviation(scene: Scene, values: Values, width: number, height: number, pixelRatio = 1): number {
  if (!(width > 0 && height > 0)) return 0;
  const eye = new OrbitCamera(scene, values);
  eye.setSize(width, height);
  return deviationOf(eye, pixelsOf(width, height, pixelRatio)[1]);
}

/** @param seconds simulated */
function lightIn({ lightMove, lightCentre, camera }: Scene, values: Values, seconds: number): Light {
  const shift = lightMove?.(seconds);
  return lightOf(shift ? moved(values, shift) : values, new Vector3(...(lightCentre ?? camera.target)));
}

/** @param height in pixels */
function deviationOf(eye: OrbitCamera, height: number): number {
  return deviationFor(eye.metresPerPixel(height));
}

/**
 * Width and height in pixels, and the accepted pixel ratio.
 * @param width, height in CSS pixels
 */
export function pixelsOf(width: number, height: number, pixelRatio = 1): [number, number, number] {
  const ratio = MathUtils.clamp(pixelRatio, 0.1, LARGEST_PIXEL_RATIO);
  return [Math.round(width * ratio), Math.round(height * ratio), ratio];
}

function scaled({ width, height }: PictureSize, scale: number): PictureSize {
  return { width: Math.ceil(width * scale), height: Math.ceil(height * scale) };
}
