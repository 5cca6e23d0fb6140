/** Public objects behind a Proxy of each kind: what their members return or do, as without one. */
import { reactive } from '@vue/reactivity';
import { BoxGeometry, Group, Mesh, MeshBasicMaterial, type Object3D } from 'three';
import { CartoonSmokeElement } from '../../src/page/element/cartoonSmokeElement.ts';
import { openStage } from '../../src/stage/remote/openStage.ts';
import { createStage } from '../../src/stage/stage.ts';
import { CartoonSmoke } from '../../src/three/cartoonSmoke.ts';
import { draw, emptyHost, HANGING, makeRenderer } from './three/scene.ts';

type Wrap = <Kind extends object>(target: Kind) => Kind;

/** As observable libraries do: every object that is read is a Proxy, and equal objects have equal Proxies. */
function deep<Kind extends object>(target: Kind, known = new WeakMap<object, object>()): Kind {
  const isOpaque = ArrayBuffer.isView(target) || target instanceof Promise || target instanceof Node;
  if (isOpaque) return target;
  if (!known.has(target)) {
    const get = (from: object, key: PropertyKey, receiver: unknown): unknown => {
      const value: unknown = Reflect.get(from, key, receiver);
      const { configurable = true } = Reflect.getOwnPropertyDescriptor(from, key) ?? {};
      return configurable && typeof value === 'object' && value !== null ? deep(value, known) : value;
    };
    known.set(target, new Proxy(target, { get }));
  }
  return known.get(target) as Kind;
}

const known = new WeakMap<object, object>();
const kinds: Record<string, Wrap> = {
  none: (target) => target,
  shallow: (target) => new Proxy(target, {}),
  deep: (target) => deep(target, known),
  // ref() and other reactive objects hold the same Proxy.
  reactive: (target) => reactive(target) as typeof target,
};

/** Runs it with each kind of Proxy. Errors are results. */
async function withEach(run: (wrap: Wrap) => Promise<unknown>): Promise<Record<string, unknown>> {
  const results: Record<string, unknown> = {};
  for (const [kind, wrap] of Object.entries(kinds)) {
    try {
      results[kind] = await run(wrap);
    } catch (error) {
      results[kind] = (error as Error).stack;
    }
  }
  return results;
}

export function ofSmoke(): Promise<Record<string, unknown>> {
  return withEach(async (wrap) => {
    const host = emptyHost(makeRenderer({ canvas: canvas() }));
    const { renderer, keyLight, scene } = host;
    const itself = await CartoonSmoke.create({ renderer, keyLight: wrap(keyLight), values: HANGING });
    const smoke = wrap(itself);
    // three.js cannot draw what it only reaches through Proxies.
    scene.add(wrap === kinds.deep ? itself : smoke);
    const errors: string[] = [];
    smoke.addEventListener('error', ({ error }) => errors.push(error.message));
    const object = (x: number): Object3D => {
      const box = new Mesh(new BoxGeometry(0.4, 0.4, 0.4), new MeshBasicMaterial());
      box.position.set(x, 0.5, 0);
      scene.add(box);
      return wrap(box as Object3D);
    };
    const emitter = wrap(smoke.emitFrom(object(0)));
    emitter.set({ speed: 1 });
    const handles = [
      emitter,
      wrap(smoke.emitFrom(object(1), wrap({ rate: 50 }))),
      wrap(smoke.emitFrom(object(-1), 0)),
      wrap(smoke.collide(object(0.5))),
      wrap(smoke.collide(object(1.5), { feelsSmoke: true })),
      wrap(smoke.cast(object(-0.5))),
      wrap(smoke.attach('vortices.0', object(0))),
    ];
    void smoke.burst(wrap({ position: { x: 0, y: 1, z: 0 }, count: 5 }));
    smoke.set(wrap({ 'style.tones': 3, 'vortices.0.circulation': 2 }));
    smoke.step(20);
    void emitter.burst(3);
    smoke.update(0.1);
    smoke.update(0.1);
    await smoke.complete();
    const picture = draw(host).reduce((sum, value) => (sum * 31 + value) % 1_000_003, 0);
    const state = smoke.save();
    const seen = [smoke.hash(), smoke.stats.alive > 0, smoke.stats.bodiesDrawn, smoke.get()['style.tones'], picture];
    smoke.clear();
    seen.push(smoke.stats.alive);
    smoke.restore(state);
    seen.push(smoke.hash());
    for (const handle of handles) {
      handle.enabled = !handle.enabled;
      seen.push(handle.enabled);
      handle.remove();
    }
    const child = new Group();
    smoke.add(child);
    seen.push(smoke.children.length, new Set(handles).has(handles[0]), String(thrown(() => emitter.set({}))));
    smoke.step(3);
    smoke.restart();
    seen.push(smoke.stats.steps, smoke.space, smoke.isObject3D, ...errors, String(thrown(() => smoke.clone())));
    smoke.removeFromParent();
    seen.push(scene.children.some(({ name }) => name === 'CartoonSmoke'));
    smoke.dispose();
    smoke.dispose();
    renderer.dispose();
    return JSON.stringify(seen);
  });
}

export function ofStage(): Promise<Record<string, unknown>> {
  return withEach(async (wrap) => {
    const stage = wrap(await createStage(canvas(), { values: { 'emission.rate': 60 } }));
    await stage.ready;
    let frames = 0;
    const end = stage.on('frame', () => ++frames);
    stage.set(wrap({ 'emission.rate': 120 }));
    stage.step(20);
    stage.advance(0.1);
    await stage.seek(0.5);
    stage.camera.orbit(0.1, 0);
    stage.speed = 0.5;
    stage.background = false;
    stage.visible = true;
    const take = wrap(stage.take());
    const [hash, state] = [stage.hash(), stage.save()];
    const seen: unknown[] = [
      hash,
      stage.speed,
      stage.playing,
      stage.quality,
      stage.view,
      stage.stats.alive > 0,
      frames > 0,
    ];
    seen.push(stage.get()['emission.rate'], stage.rigidNames.length, stage.partNames.length, stage.dropCount);
    seen.push(
      wrap(stage.sight).centre.map((axis: number) => axis.toFixed(3)),
      (await stage.picture()).type,
    );
    stage.clear();
    stage.restore(state);
    seen.push(stage.hash() === hash);
    stage.playTake(take);
    seen.push(stage.stats.steps);
    stage.restart();
    stage.unset(wrap(['camera.azimuth']));
    stage.play();
    stage.pause();
    stage.resize(40, 30);
    stage.blow({ x: 20, y: 10 });
    stage.steer(1, 0.5);
    await stage.enter(wrap({ scene: 'lamp' }));
    end();
    stage.dispose();
    seen.push(String(thrown(() => stage.step())));
    return JSON.stringify(seen);
  });
}

/** @param thread where it runs */
export function ofRemote(thread: 'main' | 'worker'): Promise<Record<string, unknown>> {
  return withEach(async (wrap) => {
    const stage = wrap(await openStage(canvas, { thread, width: 80, height: 60, values: wrap({ seed: 3 }) }));
    await stage.ready;
    await stage.set(wrap({ 'emission.rate': 120 }));
    await stage.step(20);
    const take = wrap(await stage.take());
    const state = await stage.save();
    const seen: unknown[] = [await stage.hash(), (await stage.get())['emission.rate'], stage.thread];
    await stage.clear();
    seen.push((await stage.stats()).alive);
    await stage.restore(state);
    await stage.playTake(take);
    await stage.unset(wrap(['camera.azimuth']));
    await stage.pointer(wrap({ type: 'down', id: 1, x: 5, y: 5 } as const));
    await stage.blow(wrap({ x: 5, y: 5 }));
    await stage.enter(wrap({ scene: 'lamp' }));
    seen.push((await stage.stats()).steps);
    await stage.dispose();
    return JSON.stringify(seen);
  });
}

/** The element's own members. Those of the DOM work on no Proxy. */
export function ofElement(): Promise<Record<string, unknown>> {
  customElements.define('cartoon-smoke', CartoonSmokeElement);
  return withEach(async (wrap) => {
    const itself = new CartoonSmokeElement();
    itself.paused = true;
    itself.setAttribute('thread', 'main');
    document.body.append(itself);
    const element = wrap(itself);
    await element.ready;
    await element.set(wrap({ 'emission.rate': 90 }));
    await element.step(10);
    await element.clear();
    const seen: unknown[] = [
      (await element.stats()).alive,
      element.playing,
      element.paused,
      (await element.stage).thread,
    ];
    element.preset = 'wisp';
    element.play();
    element.pause();
    seen.push(element.preset, element.paused);
    itself.remove();
    return JSON.stringify(seen);
  });
}

/** WebKit draws on the canvas of a page only. */
function canvas(): HTMLCanvasElement {
  return Object.assign(document.createElement('canvas'), { width: 80, height: 60 });
}

function thrown(act: () => unknown): unknown {
  try {
    return act();
  } catch (error) {
    return error;
  }
}
