import { Box3, Vector2, Vector4, type Object3D } from 'three';
import { STEP_SECONDS } from '../simulator/clock.ts';
import type { Rows } from '../simulator/rows.ts';
import type { Simulator } from '../simulator/simulator.ts';
import { hasPattern, isSimplified } from '../renderer/extraPasses.ts';
import { arrangeFrame, drawSmoke, reportOf } from '../renderer/frame.ts';
import type { FrameInput, FrameReport } from '../renderer/frameInput.ts';
import { receiversIn } from './casters.ts';
import type { SmokeFrame } from './smokeSpace.ts';
import type { HostPasses } from './hostPasses.ts';
import { lightFrom } from './keyLight.ts';
import type { LitSmoke } from './sceneLight.ts';
import { hasStencilBuffer, isLinearPicture, laterToneMapping, requireDrawable } from './requirements.ts';
import { RendererState } from './rendererState.ts';
import { straightened } from './target/straightCamera.ts';
import { insertShadow, type HostView } from './target/insertion.ts';

/** The smoke that a host's frame shows. */
interface HostedSmoke extends Pick<FrameInput, 'style' | 'blend'>, Pick<LitSmoke, 'lights'> {
  object: Object3D;
  frame: SmokeFrame;
  simulator: Simulator;
}

type Host = Omit<HostView, 'scale' | 'planes' | 'origin'>;

/**
 * Draws smoke in the middle of the host's frame, between its opaque and its blended objects:
 * arrange -> copy the host's depth (if ink or shadow need it) -> smoke with its shadow as a picture, like the frame of a stage
 * -> shadow volumes on the host's objects into the stencil -> there, the scene without its key light, and deep shadow.
 * The picture of the smoke follows with its depth, as the first blended object.
 *
 * Without a stencil buffer, the shadow is drawn into a target with one; see {@link OwnStencil}. Until its code is loaded, the
 * host's objects have none.
 * @throws UnsupportedError when smoke cannot be drawn into the renderer's current target
 */
export function drawIntoHost(passes: HostPasses, host: Host, hosted: HostedSmoke): FrameReport {
  const { smoke, picture, depth, casters, volumes, insert } = passes;
  const { renderer, scene, camera } = host;
  requireDrawable(renderer, camera);
  const { view, boxes, asked } = lookFrom(host, hosted);
  const { eye, targets } = smoke.passes;
  const target = renderer.getRenderTarget();
  const hasStencil = hasStencilBuffer(target);
  const own = hasStencil ? undefined : passes.ownStencil.loaded();
  const state = new RendererState(renderer);
  state.beginInnerRenders();
  try {
    const { camera: straight, hosts, isMirrored } = straightened(asked.camera);
    const input = smoke.prepare({ ...asked, camera: straight, output: picture });
    const { style } = input;
    const take = (rows: Rows) =>
      volumes.fill(
        rows,
        boxes,
        eye,
        smoke.passes.extentsOf(style.form),
        smoke.passes.isFlat ? Infinity : smoke.passes.volumes.minCap,
      );
    const arranged = arrangeFrame(smoke.passes, { ...input, others: { boxes, captureCasters: take } });
    const size = new Vector2(input.width, input.height);
    const origin = own ? new Vector2() : view.origin;
    own?.begin(renderer, scene, camera, size, target!.samples);
    const surface = depth.copyDepth(
      renderer,
      origin,
      size,
      own !== undefined || (hasStencil && (style.outlines || style.shadows)),
    );

    eye.clip(view.planes);
    eye.uniforms.viewportOrigin.value.set(0, 0);
    picture.setSize(size.x, size.y);
    targets.begin(renderer, false, isSimplified(style), hasPattern(style));
    // The depth of an oblique projection is not that of the smoke, and a mirrored one is elsewhere.
    const touched = style.outlines && !hosts ? surface : undefined;
    drawSmoke(smoke.passes, input, arranged, touched, () => casters.draw(renderer, scene));

    eye.uniforms.viewportOrigin.value.copy(origin);
    insert.setHost(hosts && straight.projectionMatrix, isMirrored);
    if (hosts) eye.uniforms.clipFromView.value.copy(hosts);
    const returnToTarget = () => state.returnToTarget();
    // One depth for each pixel.
    const receivers = hosts || surface?.slack ? undefined : surface?.inPlace;
    if (arranged.casters && boxes.length > 0 && !(volumes.isEmpty && casters.isEmpty)) {
      eye.receive(boxes.reduce((all, box) => all.union(box), new Box3()));
      if (own) own.insert(passes, { ...view, returnToTarget }, style, receivers, surface?.depth);
      else if (hasStencil) {
        returnToTarget();
        insertShadow(passes, view, style, receivers, surface?.depth);
      }
    }
    returnToTarget();
    eye.uniforms.viewportOrigin.value.copy(view.origin);
    insert.setSmoke(picture.texture, targets.depth, isLinearPicture(renderer));
    insert.setToneMapping(laterToneMapping(renderer), renderer.toneMappingExposure);
    insert.setFog(scene.fog, view.scale);
    insert.draw(renderer, camera);
    renderer.clearStencil();
    return reportOf(arranged);
  } finally {
    state.restore();
  }
}

const viewport = new Vector4();

/** What a frame is drawn from. */
function lookFrom(host: Host, { object, frame, simulator, style, lights: ofScene, blend }: HostedSmoke) {
  const { renderer, scene, keyLight } = host;
  const { clippingPlanes } = renderer;
  const { camera, light, lights, boxes, planes } = frame.view(object, {
    camera: host.camera,
    light: lightFrom(keyLight),
    lights: ofScene,
    boxes: receiversIn(scene),
    planes: clippingPlanes,
  });
  const { x, y, z: width, w: height } = renderer.getCurrentViewport(viewport);
  const view: HostView = { ...host, planes, scale: frame.drawn.scale, origin: new Vector2(x, y) };
  const asked = {
    simulator,
    camera,
    light,
    lights,
    style,
    blend,
    time: simulator.steps * STEP_SECONDS,
    width,
    height,
    pixelRatio: renderer.getPixelRatio(),
    rigids: [],
    // What is cut off hides nothing.
    cull: clippingPlanes.length === 0,
  };
  return { view, boxes, asked };
}
