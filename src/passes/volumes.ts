import {
  Camera,
  Mesh,
  Scene,
  type BufferGeometry,
  type DataArrayTexture,
  type RawShaderMaterial,
  type WebGLRenderer,
} from 'three';
import fragmentShader from '../../shaders/volumes/volumes.frag';
import vertexShader from '../../shaders/volumes/volumes.vert';
import type { Eye } from '../device/eye.ts';
import type { PuffForm, PuffTextures } from '../device/puffTextures.ts';
import { FIRST_BORDER } from '../device/ramps.ts';
import { countFaces, countingMaterial } from '../device/stencil.ts';

/** Radii from a puff's centre to where nothing of it is left, relief included. */
const BEHIND_THE_PUFF = 1.2;

/**
 * Counts the particles' shadow volumes in the stencil by depth pass. The operations clamp: each volume draws its front
 * and then its back in one draw, so the running count is the true one and saturation can only stay dark.
 */
export class VolumesPass {
  private readonly scene = new Scene();
  private readonly camera = new Camera();
  private readonly material: RawShaderMaterial;
  private readonly puffs: PuffTextures;
  private readonly uniforms = {
    leastCap: { value: 0 },
    facesEye: { value: false },
    startCaps: { value: null as DataArrayTexture | null },
    shadowRadius: { value: 1 },
    depth: { value: 0 },
  };

  constructor(eye: Eye, puffs: PuffTextures, rows: BufferGeometry) {
    this.puffs = puffs;
    this.material = countingMaterial({
      vertexShader,
      fragmentShader,
      uniforms: { ...eye.uniforms, ...this.uniforms },
    });
    this.follow('lobes', FIRST_BORDER);
    const mesh = new Mesh(rows, this.material);
    mesh.frustumCulled = false;
    countFaces(
      mesh,
      { depthFail: WebGL2RenderingContext.KEEP, depthPass: WebGL2RenderingContext.INCR },
      { depthFail: WebGL2RenderingContext.KEEP, depthPass: WebGL2RenderingContext.DECR },
    );
    this.scene.add(mesh);
  }

  /**
   * Follows how puffs become pixels, and which they are, so that no volume takes away what its own puff shows of the light.
   * @param turn N . L from which a lit pixel differs from one in shadow; below 0 where it does even on the dark side
   */
  follow(form: PuffForm, turn: number): void {
    const { startCaps, latestCap, shadowRadius, depth } = this.puffs.of(form);
    this.uniforms.leastCap.value = leastCapOf(turn, latestCap);
    this.uniforms.facesEye.value = form === 'billboards';
    this.uniforms.startCaps.value = startCaps;
    this.uniforms.shadowRadius.value = shadowRadius;
    this.uniforms.depth.value = depth;
  }

  draw(renderer: WebGLRenderer): void {
    renderer.render(this.scene, this.camera);
  }

  dispose(): void {
    this.material.dispose();
  }
}

/**
 * How many radii behind its centre a puff's volume begins at the nearest.
 * @param turn as `follow` takes it
 * @param latestCap of the puffs, see src/puffs/startCaps.ts
 */
export function leastCapOf(turn: number, latestCap: number): number {
  if (turn < 0) return BEHIND_THE_PUFF;
  return turn < FIRST_BORDER ? latestCap : 0;
}
