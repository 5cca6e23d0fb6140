import type { Camera, Scene, Vector2, WebGLRenderer } from 'three';
import type { InsertPass } from '../../passes/insert.ts';
import type { SmokePictures } from '../../passes/pictures.ts';
import type { ArrangedFrame, SmokePasses } from '../../smoke/smokePasses.ts';
import type { Style } from '../../smoke/style.ts';
import type { HostCasters } from '../casters.ts';
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
  /** Origin of the viewport in its render target, in pixels. */
  origin: Vector2;
  /** Called before and after the scene is drawn again in shadow. */
  onRelight: (isInShadow: boolean) => void;
}

/** What an insertion draws with. */
export interface InsertionPasses {
  readonly smoke: { readonly passes: SmokePasses };
  readonly casters: HostCasters;
  readonly insert: InsertPass;
  readonly pictures: SmokePictures;
}

/** Whether deep shadow is a step of its own. */
export function hasDeep({ shadows, shadowSteps }: Style): boolean {
  return shadows && shadowSteps === 2;
}

/** Draws the depth of smoke and counts the shadow volumes in the bound framebuffer, which has a stencil buffer. */
export function countShadows(passes: InsertionPasses, view: HostView, casters: ArrangedFrame['casters']): void {
  const { insert, smoke } = passes;
  const { mask, extras } = smoke.passes;
  const { renderer, scene } = view;
  renderer.clearStencil();
  insert.drawDepth(renderer);
  if (!casters) return;
  passes.casters.draw(renderer, scene);
  mask.countOnce(renderer);
  extras.countedVolumes?.draw(renderer, casters.geometry);
}

/** Draws the scene without its key light where the stencil is not zero. */
export function drawShadow({ renderer, scene, camera, keyLight, onRelight }: HostView): void {
  onRelight(true);
  relight(renderer, scene, camera, keyLight);
  onRelight(false);
}

/** Inserts shadow and all smoke except the unlit into the bound framebuffer, which has a stencil buffer. */
export function insertSmoke(
  passes: InsertionPasses,
  view: HostView,
  style: Style,
  casters: ArrangedFrame['casters'],
): void {
  const { insert, pictures, smoke } = passes;
  const { renderer } = view;
  insert.setSmoke(pictures, smoke.passes.targets.depth, isLinearPicture(renderer));
  insert.setFog(view.scene.fog, view.scale);
  countShadows(passes, view, casters);
  insert.drawLit(renderer);
  if (casters) drawShadow(view);
  if (!hasDeep(style)) return;
  insert.darken(renderer, style.shadowDepth, style.deepShadow);
  insert.drawDeep(renderer);
}

/** Inserts lit smoke into the bound framebuffer without stencil buffer, except its colour, which the marker draws. */
export function insertLit({ insert, pictures, smoke }: InsertionPasses, { renderer, scene, scale }: HostView): void {
  const { lit } = pictures;
  insert.setSmoke({ lit, unlit: lit, deep: lit }, smoke.passes.targets.depth, isLinearPicture(renderer));
  insert.setFog(scene.fog, scale);
  insert.drawDepth(renderer);
}
