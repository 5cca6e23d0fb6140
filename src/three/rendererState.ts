import { Color, type Scene, type WebGLRenderer, type WebGLRenderTarget } from 'three';

/** What drawing smoke changes of the host's renderer in mid-frame, kept to be put back. */
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
  /** What the context clears with, which is the scene's background when it has one. */
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

  /** Lets several draws add up to one frame, with the shadow maps as they are. */
  hold(): void {
    const { renderer } = this;
    renderer.autoClear = false;
    renderer.info.autoReset = false;
    renderer.shadowMap.autoUpdate = false;
    renderer.shadowMap.needsUpdate = false;
  }

  /** Goes on drawing where the renderer's owner did. */
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

/** Runs `draw` with a scene's background taken away: drawn again it would cover what stands. */
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
