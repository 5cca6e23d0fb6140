import { MathUtils, Vector2, type Matrix4 } from 'three';
import { DEBUG_VIEWS, LOWEST_QUALITY, type DebugView, type Quality } from '../preset/quality.ts';
import { ParameterError } from '../preset/errors.ts';
import type { Values } from '../preset/parameter.ts';
import type { Scene } from '../scenes/scene.ts';
import { secondsAt, STEP_SECONDS } from '../sim/clock.ts';
import type { Simulator } from '../sim/simulator.ts';
import type { PictureKind } from '../smoke/extraPasses.ts';
import type { FrameReport } from '../smoke/frameInput.ts';
import { OrbitCamera } from './orbit.ts';
import type { Presenter } from './presenter.ts';
import { ShownSmoke } from './shownSmoke.ts';

const LARGEST_PIXEL_RATIO = 4;
/** Spent with each picture on puffs that are being baked. */
const BAKING_MS = 5;

/** What a picture is drawn from. */
export interface PictureState {
  simulator: Simulator;
  /** World transforms of the rigids, by their number. */
  rigids: readonly Matrix4[];
  /** Those of the scene's parts. */
  parts: readonly Matrix4[];
  /** Where between the previous step (0) and now (1) it stands. */
  blend: number;
  /** Share of the pixel ratio to draw with. */
  scale: number;
  /** Whether the next picture follows at once: puffs whose knobs turn are then baked a little with each. */
  isPlaying: boolean;
}

/** A stage's picture: from where it is seen, how large it is, how it is drawn, and what of it is shown. */
export class Picture {
  /** Whether it shows what lies behind everything; it is transparent there if not. */
  hasBackground = true;
  /** Of the latest frame. */
  scale = 1;
  renderMs = 0;
  report: FrameReport = { bodiesDrawn: 0, castersDrawn: 0, arrangeMs: 0 };
  private readonly presenter: Presenter;
  private camera: OrbitCamera;
  private shown: ShownSmoke;
  private width = 0;
  private height = 0;
  private pixelRatio = 1;
  private chosenQuality: Quality = 1;
  private chosenView: DebugView | undefined;

  constructor(presenter: Presenter, scene: Scene, values: Values) {
    this.presenter = presenter;
    this.camera = new OrbitCamera(scene, values);
    this.shown = new ShownSmoke(presenter.device, scene, values);
  }

  get eye(): OrbitCamera {
    return this.camera;
  }

  get smoke(): ShownSmoke {
    return this.shown;
  }

  /** See StageOptions. */
  get quality(): Quality {
    return this.chosenQuality;
  }

  /** @throws ParameterError for what is neither 'auto' nor 0.25 to 1 */
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

  /** @throws ParameterError for a view that there is not */
  set view(view: DebugView | undefined) {
    if (view !== undefined && !DEBUG_VIEWS.includes(view)) {
      throw new ParameterError('view', view, DEBUG_VIEWS.join(', '));
    }
    this.chosenView = view;
  }

  /** What decides whether more code is needed. */
  get kind(): PictureKind {
    return { ...this.shown.kind, view: this.chosenView };
  }

  get isVisible(): boolean {
    return this.width > 0 && this.height > 0;
  }

  /** Width and height in CSS pixels. */
  get size(): [width: number, height: number] {
    return [this.width / this.pixelRatio, this.height / this.pixelRatio];
  }

  get drawCalls(): number {
    return this.presenter.device.renderer.info.render.calls;
  }

  get writesDepth(): boolean {
    return this.presenter.device.writesDepth;
  }

  /**
   * @param width, height in CSS pixels
   * @returns whether that changed something
   */
  resize(width: number, height: number, pixelRatio = this.pixelRatio): boolean {
    const before = [this.width, this.height, this.pixelRatio];
    this.pixelRatio = MathUtils.clamp(pixelRatio, 0.1, LARGEST_PIXEL_RATIO);
    this.width = Math.round(width * this.pixelRatio);
    this.height = Math.round(height * this.pixelRatio);
    if (this.isVisible) this.eye.setSize(...this.size);
    return [this.width, this.height, this.pixelRatio].some((value, index) => value !== before[index]);
  }

  /** Goes on with these values. */
  follow(values: Values): void {
    this.shown.follow(values);
    this.camera.hold(values);
  }

  /** Shows another scene from now on. */
  enter(scene: Scene, values: Values): void {
    this.shown.dispose();
    this.shown = new ShownSmoke(this.presenter.device, scene, values);
    this.camera = new OrbitCamera(scene, values);
    if (this.isVisible) this.camera.setSize(...this.size);
  }

  /** A place in CSS pixels from the top left, in normalised device coordinates: -1 to 1, y up. */
  deviceCoordinates(x: number, y: number): Vector2 {
    const [width, height] = this.size;
    return new Vector2((2 * x) / width - 1, 1 - (2 * y) / height);
  }

  /** @throws ContextError while the graphics context is lost */
  requireContext(): void {
    this.presenter.device.requireUsable();
  }

  /** Draws a moment and shows it; false where nothing can be seen, or where the context is lost, even on the way. */
  draw(moment: PictureState): boolean {
    const { device } = this.presenter;
    if (!this.isVisible || !device.isUsable) return false;
    try {
      this.drawNow(moment);
      return true;
    } catch (error) {
      if (device.isUsable) throw error;
      return false;
    }
  }

  /** What was just drawn as a PNG; must be called in the task that drew it. */
  encode(): Promise<Blob> {
    return this.presenter.encode();
  }

  /** Gives the device back as well, if it is the stage's own. */
  dispose(): void {
    this.smoke.dispose();
    this.presenter.dispose();
  }

  private drawNow({ simulator, rigids, parts, blend, scale, isPlaying }: PictureState): void {
    this.smoke.bake(isPlaying ? BAKING_MS : Infinity);
    this.eye.follow(secondsAt(simulator.steps, blend));
    const started = performance.now();
    const canvas = { width: this.width, height: this.height };
    const drawn = { width: Math.ceil(canvas.width * scale), height: Math.ceil(canvas.height * scale) };
    const output = this.presenter.prepare(canvas, drawn);
    this.report = this.smoke.draw({
      simulator,
      camera: this.eye.camera,
      blend,
      time: simulator.steps * STEP_SECONDS,
      ...drawn,
      pixelRatio: this.pixelRatio * scale,
      rigids,
      parts,
      cull: true,
      view: this.view,
      isTransparent: !this.hasBackground,
      output,
    });
    this.presenter.present();
    this.scale = scale;
    this.renderMs = performance.now() - started;
  }
}
