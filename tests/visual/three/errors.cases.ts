/** Errors for unsupported settings in a host's scene. */
import {
  ArrayCamera,
  Group,
  HemisphereLight,
  Mesh,
  PlaneGeometry,
  TorusGeometry,
  Vector4,
  WebGLRenderTarget,
  type WebGLRenderer,
} from 'three';
import { dispose, emptyHost, HANGING, makeRenderer, smokeIn } from './scene.ts';

/** Error messages by unsupported setting. */
export async function errors(): Promise<Record<string, string>> {
  const said: Record<string, string> = {};
  const attempt = async (name: string, act: () => unknown) => {
    try {
      await act();
      said[name] = 'nothing';
    } catch (error) {
      said[name] = `${(error as Error).name}: ${(error as Error).message}`;
    }
  };
  const create = (renderer: WebGLRenderer, more = {}) => smokeIn(emptyHost(renderer), HANGING, more);
  for (const [name, parameters] of Object.entries({
    stencil: { stencil: false },
    logarithmic: { logarithmicDepthBuffer: true },
  })) {
    const renderer = makeRenderer(parameters);
    await attempt(name, () => create(renderer));
    dispose(renderer);
  }
  const host = emptyHost();
  await attempt('light', () => create(host.renderer, { keyLight: new HemisphereLight() as never }));
  await attempt('preset', () => create(host.renderer, { preset: 'lampp' }));
  await attempt('value', () => create(host.renderer, { values: { 'emission.rate': -1 } }));
  const smoke = await smokeIn(host);
  // `update` never throws: it dispatches an event.
  let reported = 'nothing';
  smoke.addEventListener('error', ({ error }) => (reported = `${error.name}: ${error.message}`));
  const update = (name: string, seconds: number) => {
    reported = 'nothing';
    smoke.update(seconds);
    said[name] = reported;
  };
  await attempt('fixed', () => smoke.set({ seed: 2 }));
  await attempt('given', () => smoke.set({ 'light.azimuth': 20 }));
  await attempt('open', () => smoke.cast(new Mesh(new PlaneGeometry())));
  await attempt('empty', () => smoke.cast(new Group()));
  await attempt('emitter', () => smoke.emitFrom(new Group(), 8));
  await attempt('clone', () => host.scene.clone());
  await attempt('json', () => smoke.toJSON());
  update('seconds', NaN);
  await attempt('count', () => smoke.step(NaN));
  await attempt('fraction', () => smoke.step(1.5));
  await attempt('afterwards', () => {
    smoke.update(1 / 60);
    host.renderer.render(host.scene, host.camera);
  });
  await attempt('physics', () => smoke.collide(new Mesh(new TorusGeometry())));
  const target = new WebGLRenderTarget(32, 32, { count: 2 });
  host.renderer.setRenderTarget(target);
  host.renderer.render(host.scene, host.camera);
  update('target', 0);
  host.renderer.render(host.scene, host.camera);
  update('repeated', 0);
  host.renderer.setRenderTarget(null);
  const array = new ArrayCamera([Object.assign(host.camera.clone(), { viewport: new Vector4(0, 0, 50, 50) })]);
  array.projectionMatrix.copy(host.camera.projectionMatrix);
  host.renderer.render(host.scene, array);
  update('array', 0);
  update('again', 0);
  host.renderer.setViewport(0, 0, 1e6, 50);
  host.renderer.render(host.scene, host.camera);
  update('viewport', 0);
  host.renderer.setViewport(0, 0, 200, 140);
  host.renderer.xr.isPresenting = true;
  host.renderer.render(host.scene, host.camera);
  update('session', 0);
  host.renderer.render(host.scene, host.camera);
  update('sessionAgain', 0);
  host.renderer.xr.isPresenting = false;
  smoke.dispose();
  smoke.dispose();
  update('disposed', 0);
  await attempt('call', () => smoke.emitFrom(new Group()));
  target.dispose();
  dispose(host.renderer);
  return said;
}
