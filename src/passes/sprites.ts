import {
  CustomBlending,
  GLSL3,
  Mesh,
  OneFactor,
  OneMinusSrcAlphaFactor,
  RawShaderMaterial,
  Scene,
  type BufferGeometry,
  type Texture,
  type WebGLRenderer,
  type WebGLRenderTarget,
} from 'three';
import { PassCamera } from '../device/passCamera.ts';
import fragmentShader from '../../shaders/sprites/sprites.frag';
import vertexShader from '../../shaders/sprites/sprites.vert';
import type { Eye } from '../device/eye.ts';
import type { RampTexture } from '../device/ramps.ts';
import type { Targets } from './targets.ts';

/**
 * Smoke as particle libraries draw it, for comparison: soft quads blended over the finished picture, far to near.
 * The rows must come in that order.
 */
export class SpritesPass {
  private readonly scene = new Scene();
  private readonly camera = new PassCamera();
  private readonly material: RawShaderMaterial;
  private readonly depth = { value: null as Texture | null };

  constructor(eye: Eye, ramps: RampTexture, rows: BufferGeometry) {
    this.material = new RawShaderMaterial({
      glslVersion: GLSL3,
      vertexShader,
      fragmentShader,
      uniforms: {
        ...eye.uniforms,
        depth: this.depth,
        ramps: { value: ramps.texture },
      },
      transparent: true,
      depthTest: false,
      depthWrite: false,
      blending: CustomBlending,
      blendSrc: OneFactor,
      blendDst: OneMinusSrcAlphaFactor,
    });
    const mesh = new Mesh(rows, this.material);
    mesh.frustumCulled = false;
    this.scene.add(mesh);
  }

  /** Blends over what the resolve pass has written to `output`; the depth of the surfaces is read from the targets. */
  draw(renderer: WebGLRenderer, targets: Targets, output: WebGLRenderTarget | null): void {
    this.depth.value = targets.depth;
    renderer.setRenderTarget(output);
    renderer.render(this.scene, this.camera);
  }

  dispose(): void {
    this.material.dispose();
  }
}
