import {
  FloatType,
  HalfFloatType,
  LinearSRGBColorSpace,
  Matrix4,
  NoToneMapping,
  SRGBColorSpace,
  Vector4,
  type Camera,
  type Scene,
  type ToneMapping,
  type WebGLRenderer,
  type WebGLRenderTarget,
} from 'three';
import { MAX_PLANES } from '../renderer/gpu/frameView.ts';
import { ParameterError, UnsupportedError } from '../base/errors.ts';

/**
 * Checks the renderer settings that are fixed at creation.
 * @throws ParameterError without a renderer, UnsupportedError that names the required options
 */
export function requireRenderer(renderer: WebGLRenderer): void {
  if (typeof renderer !== 'object' || renderer === null)
    throw new ParameterError('renderer', renderer, 'the WebGLRenderer that renders your scene');
  if (!('isWebGLRenderer' in renderer)) throw new UnsupportedError('Smoke needs a WebGLRenderer of three.js.');
  if (renderer.capabilities.logarithmicDepthBuffer)
    throw new UnsupportedError(
      'Smoke cannot use a logarithmic depth buffer: create the renderer without logarithmicDepthBuffer.',
    );
  const attributes = renderer.getContext().getContextAttributes();
  if (attributes?.stencil && attributes.depth) return;
  throw new UnsupportedError('Smoke needs stencil and depth: create the renderer with { stencil: true, depth: true }.');
}

/**
 * Whether a view shows nothing. A canvas that is hidden or being resized has no size, and its camera an aspect of 0/0.
 */
export function isEmptyView(renderer: WebGLRenderer, { projectionMatrix, matrixWorldInverse }: Camera): boolean {
  const { z: width, w: height } = renderer.getCurrentViewport(viewport);
  const size = width * height * clip.multiplyMatrices(projectionMatrix, matrixWorldInverse).determinant();
  // NaN fails every comparison.
  return !(Math.abs(size) > 0 && Math.abs(size) < Infinity);
}

/** @throws UnsupportedError when smoke cannot be drawn into the renderer's current target */
export function requireDrawable(renderer: WebGLRenderer, camera: Camera): void {
  const target = renderer.getRenderTarget();
  if (renderer.xr.isPresenting) throw new UnsupportedError('Smoke cannot be drawn in an XR session.');
  // The cameras of an ArrayCamera have their own viewports, which a draw in between would lose.
  if ('viewport' in camera && camera.viewport)
    throw new UnsupportedError('Smoke cannot be drawn by an ArrayCamera: render with one camera at a time.');
  if (target && target.textures.length > 1)
    throw new UnsupportedError('Smoke cannot be drawn into a render target with several textures.');
  const { z: width, w: height } = renderer.getCurrentViewport(viewport);
  const { maxTextureSize } = renderer.capabilities;
  if (Math.max(width, height) > maxTextureSize)
    throw new UnsupportedError(
      `Smoke cannot be drawn into a viewport of ${width} x ${height} pixels: this GPU allows ${maxTextureSize}.`,
    );
  const { length } = renderer.clippingPlanes;
  if (length > MAX_PLANES)
    throw new UnsupportedError(
      `Smoke cannot be cut by ${length} clippingPlanes of the renderer: it takes ${MAX_PLANES}.`,
    );
  const { outputColorSpace } = renderer;
  if (outputColorSpace !== SRGBColorSpace && outputColorSpace !== LinearSRGBColorSpace)
    throw new UnsupportedError(
      `renderer.outputColorSpace cannot be ${outputColorSpace}: smoke needs SRGBColorSpace or LinearSRGBColorSpace.`,
    );
}

const viewport = new Vector4();
const clip = new Matrix4();

/** Whether shadow volumes can be counted in a target, or in the canvas (null), whose renderer was checked at creation. */
export function hasStencilBuffer(target: WebGLRenderTarget | null): boolean {
  return target === null || (target.stencilBuffer && target.depthBuffer);
}

/**
 * Whether a pass draws the scene with one material into the current target, as ambient occlusion does for normals and for
 * depth. Smoke has neither, and its light would be darkened.
 */
export function isOverridden(renderer: WebGLRenderer, { overrideMaterial }: Scene): boolean {
  return overrideMaterial !== null && renderer.getRenderTarget() !== null;
}

/** Whether the current target holds linear colour, as render targets do, instead of display-encoded colour. */
export function isLinearPicture(renderer: WebGLRenderer): boolean {
  return renderer.getRenderTarget() !== null || renderer.outputColorSpace === LinearSRGBColorSpace;
}

/**
 * The tone mapping that a later pass applies to the current target. three.js maps tones on the canvas only; a half-float target
 * holds the light that `OutputPass` maps by the operator of the renderer.
 */
export function laterToneMapping(renderer: WebGLRenderer): ToneMapping {
  const type = renderer.getRenderTarget()?.texture.type;
  return type === HalfFloatType || type === FloatType ? renderer.toneMapping : NoToneMapping;
}
