import { Color, type Scene, type WebGLRenderer, type WebGLRenderTarget } from 'three';

/** Saves the renderer state that drawing smoke in mid-frame changes, and restores it. */
export class RendererState {
  private readonly renderer: WebGLRenderer;
  private readonly target: WebGLRenderTarget | null;
  private readonly face: number;
  private readonly level: number;
  private readonly autoClear: boolean;
  private readonly autoReset: boolean;
  private readonly autoUpdate: boolean;
  private readonly needsUpdate: boolean;
  private readonly clearColor = new Color();
  private readonly clearAlpha: number;
  /** The clear colour of the context, which is the scene's background if it has one. */
  private readonly clearing: Float32Array;
  private readonly stencilTest: boolean;

  constructor(renderer: WebGLRenderer) {
    const gl = renderer.getContext();
    this.renderer = renderer;
    this.target = renderer.getRenderTarget();
    this.face = renderer.getActiveCubeFace();
    this.level = renderer.getActiveMipmapLevel();
    this.autoClear = renderer.autoClear;
    this.autoReset = renderer.info.autoReset;
    this.autoUpdate = renderer.shadowMap.autoUpdate;
    this.needsUpdate = renderer.shadowMap.needsUpdate;
    renderer.getClearColor(this.clearColor);
    this.clearAlpha = renderer.getClearAlpha();
    this.clearing = gl.getParameter(gl.COLOR_CLEAR_VALUE) as Float32Array;
    this.stencilTest = gl.isEnabled(gl.STENCIL_TEST);
  }

  /** Lets several render calls count as one frame, without updating the shadow maps. */
  beginInnerRenders(): void {
    const { renderer } = this;
    renderer.autoClear = false;
    renderer.info.autoReset = false;
    renderer.shadowMap.autoUpdate = false;
    renderer.shadowMap.needsUpdate = false;
  }

  /** Restores the host's render target. */
  returnToTarget(): void {
    this.renderer.setRenderTarget(this.target, this.face, this.level);
  }

  restore(): void {
    const { renderer } = this;
    renderer.autoClear = this.autoClear;
    renderer.info.autoReset = this.autoReset;
    renderer.shadowMap.autoUpdate = this.autoUpdate;
    renderer.shadowMap.needsUpdate = this.needsUpdate;
    renderer.setClearColor(this.clearColor, this.clearAlpha);
    const [red, green, blue, alpha] = this.clearing;
    renderer.state.buffers.color.setClear(red, green, blue, alpha, false);
    renderer.state.buffers.stencil.setTest(this.stencilTest);
    this.returnToTarget();
  }
}

/** Runs `draw` without the scene's background, which would overwrite the current frame. */
export function withoutBackground(scene: Scene, draw: () => void): void {
  const { background, matrixWorldAutoUpdate } = scene;
  scene.background = null;
  scene.matrixWorldAutoUpdate = false;
  try {
    draw();
  } finally {
    scene.background = background;
    scene.matrixWorldAutoUpdate = matrixWorldAutoUpdate;
  }
}
