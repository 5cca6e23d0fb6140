/** `windowDepth` of the shaders, compared with the projection of the same points. */
import {
  type Camera,
  FloatType,
  type Matrix4,
  NearestFilter,
  OrthographicCamera,
  PerspectiveCamera,
  Vector4,
  WebGLRenderTarget,
} from 'three';
import depthChunk from '../../../../shaders/lib/depth.glsl';
import { createDevice } from '../../../../src/renderer/gpu/device.ts';
import { FullScreen } from '../../../../src/renderer/gpu/fullScreen.ts';

const SAMPLES = 64;
const [NEAR, FAR] = [0.1, 60];

function offAxis(): PerspectiveCamera {
  const camera = new PerspectiveCamera(50, 1.5, NEAR, FAR);
  camera.setViewOffset(300, 200, 90, 10, 150, 100);
  return camera;
}

const CAMERAS: Record<string, () => Camera> = {
  perspective: () => new PerspectiveCamera(50, 1.5, NEAR, FAR),
  offAxis,
  orthographic: () => new OrthographicCamera(-2, 3, 2, -1, NEAR, FAR),
};

/** The largest error for depths between near and far plane. */
export function largestError(cameraName: string): number {
  const { projectionMatrix } = CAMERAS[cameraName]();
  const computed = onTheGpu(projectionMatrix);
  let largest = 0;
  for (let sample = 0; sample < SAMPLES; ++sample) {
    const clip = new Vector4(0.3, -0.2, -depthOf(sample), 1).applyMatrix4(projectionMatrix);
    largest = Math.max(largest, Math.abs(computed[sample] - (0.5 * clip.z) / clip.w - 0.5));
  }
  return largest;
}

function depthOf(sample: number): number {
  return NEAR * (FAR / NEAR) ** (sample / (SAMPLES - 1));
}

function onTheGpu(clipFromView: Matrix4): Float32Array {
  const device = createDevice(new OffscreenCanvas(1, 1));
  device.renderer.getContext().getExtension('EXT_color_buffer_float');
  const triangle = new FullScreen(
    `precision highp float;
      uniform mat4 clipFromView;
      uniform float depths[${SAMPLES}];
      out vec4 result;
      ${depthChunk}
      void main() { result = vec4(windowDepth(clipFromView, -depths[int(gl_FragCoord.x)])); }`,
    {
      clipFromView: { value: clipFromView },
      depths: { value: Array.from({ length: SAMPLES }, (_, sample) => depthOf(sample)) },
    },
  );
  const target = new WebGLRenderTarget(SAMPLES, 1, { type: FloatType, minFilter: NearestFilter, depthBuffer: false });
  device.renderer.setRenderTarget(target);
  triangle.draw(device.renderer);
  const pixels = new Float32Array(4 * SAMPLES);
  device.renderer.readRenderTargetPixels(target, 0, 0, SAMPLES, 1, pixels);
  device.dispose();
  return pixels.filter((_, index) => index % 4 === 0);
}
