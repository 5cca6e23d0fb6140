import type { Camera, DepthTexture, Plane, Scene, Texture, Vector2, WebGLRenderer } from 'three';
import type { InsertPass } from '../../renderer/passes/insert.ts';
import { hasPattern } from '../../renderer/extraPasses.ts';
import { limitOf, type SmokePasses } from '../../renderer/smokePasses.ts';
import type { Style } from '../../renderer/style.ts';
import type { HostCasters } from '../casters.ts';
import type { HostVolumes } from '../volumes/hostVolumes.ts';
import type { KeyLight } from '../keyLight.ts';
import { relight } from '../relight.ts';
import { isLinearPicture } from '../requirements.ts';

/** The host's view that smoke is drawn into. */
export interface HostView {
  renderer: WebGLRenderer;
  scene: Scene;
  camera: Camera;
  keyLight: KeyLight;
  /** Metres of the scene in a metre of the smoke. */
  scale: number;
  /** The renderer's clipping planes in the space of the smoke. */
  planes: readonly Plane[];
  /** Origin of the viewport in its render target, in pixels. */
  origin: Vector2;
  /** Called before and after the scene is drawn again in shadow. */
  onRelight: (isInShadow: boolean) => void;
}

/** What an insertion draws with. */
export interface InsertionPasses {
  readonly smoke: { readonly passes: SmokePasses };
  readonly casters: HostCasters;
  readonly volumes: HostVolumes;
  readonly insert: InsertPass;
}

/**
 * Draws the shadow on the host's objects into the bound framebuffer, which has a stencil buffer and their depth.
 * @param receivers the depth of its pixels, if they have one each
 * @param surfaceDepth depth of the host's opaque objects in the viewport of the smoke; without it they have no pattern
 */
export function insertShadow(
  { smoke: { passes }, casters, volumes, insert }: InsertionPasses,
  { renderer, scene, camera, keyLight, onRelight }: HostView,
  style: Style,
  receivers: DepthTexture | undefined,
  surfaceDepth: Texture | undefined,
): void {
  renderer.clearStencil();
  casters.draw(renderer, scene);
  passes.mask.countOnce(renderer);
  volumes.draw(renderer, passes, receivers, limitOf(style));
  onRelight(true);
  relight(renderer, scene, camera, keyLight);
  onRelight(false);
  if (hasPattern(style) && style.patternOn !== 'tones' && surfaceDepth) {
    passes.extras.patterns!.drawOnHost(renderer, surfaceDepth, isLinearPicture(renderer));
  }
  if (style.shadowSteps === 2) insert.darken(renderer, style.shadowDepth, style.deepShadow, isLinearPicture(renderer));
}
