/** Mistakes in a host's scene: nothing that a page does to its objects makes `update` or a render throw. */
import {
  Color,
  FogExp2,
  Group,
  Mesh,
  MeshStandardMaterial,
  Object3D,
  SphereGeometry,
  WebGLRenderTarget,
  type Camera,
} from 'three';
import type { CartoonSmoke } from '../../../src/three/cartoonSmoke.ts';
import { SmokeError } from '../../../src/base/errors.ts';
import { random } from '../random.ts';
import { changedPixels, dispose, draw, furnishedHost, smokeIn, type Host } from './scene.ts';

/** A mistake returns what undoes it. */
type Mistake = (
  host: Host,
  smoke: CartoonSmoke,
  object: Mesh,
  pick: <Item>(items: readonly Item[]) => Item,
) => () => void;

/** Sets a property and returns what restores it. */
function broken<Owner extends object>(owner: Owner, key: keyof Owner, value: unknown): () => void {
  const before = owner[key];
  owner[key] = value as never;
  return () => void (owner[key] = before);
}

const WRONG_NUMBERS = [NaN, Infinity, -Infinity, 1e308, -1, 0];
const WRONG_VALUES = [...WRONG_NUMBERS, undefined, null, '1', {}, [], () => 1, 1n, Symbol('wrong')];

const MISTAKES: readonly Mistake[] = [
  (_host, _smoke, object, pick) => broken(object.position, pick(['x', 'y', 'z'] as const), pick(WRONG_NUMBERS)),
  (_host, _smoke, object, pick) => broken(object.scale, pick(['x', 'y', 'z'] as const), pick(WRONG_NUMBERS)),
  (_host, _smoke, object, pick) => broken(object.quaternion, pick(['x', 'w'] as const), pick(WRONG_NUMBERS)),
  (_host, smoke, _object, pick) => broken(smoke.position, 'y', pick(WRONG_NUMBERS)),
  (_host, smoke, _object, pick) => broken(smoke.scale, 'x', pick(WRONG_NUMBERS)),
  (_host, _smoke, object) => broken(object, 'geometry', undefined),
  (_host, _smoke, object) => broken(object, 'geometry', null),
  (_host, _smoke, object) => broken(object.geometry.attributes, 'position', undefined),
  (_host, _smoke, object) => broken(object, 'material', undefined),
  (_host, _smoke, object) => broken(object, 'material', []),
  (_host, _smoke, object) => (object.geometry.dispose(), () => {}),
  (_host, _smoke, object) => {
    const { parent } = object;
    object.removeFromParent();
    return () => void parent!.add(object);
  },
  (host, smoke) => {
    smoke.removeFromParent();
    return () => void host.scene.add(smoke);
  },
  (_host, smoke) => broken(smoke, 'visible', false),
  (host, _smoke, _object, pick) => broken(host.keyLight.position, 'y', pick(WRONG_NUMBERS)),
  (host, _smoke, _object, pick) => broken(host.keyLight, 'intensity', pick(WRONG_NUMBERS)),
  (host) => broken(host.keyLight, 'target', new Object3D()),
  (host, _smoke, _object, pick) => broken(host.camera.position, 'z', pick(WRONG_NUMBERS)),
  (host, _smoke, _object, pick) => {
    const undo = broken(host.camera, pick(['near', 'far', 'fov', 'aspect'] as const), pick(WRONG_NUMBERS));
    host.camera.updateProjectionMatrix();
    return () => {
      undo();
      host.camera.updateProjectionMatrix();
    };
  },
  (host, _smoke, _object, pick) => broken(host.scene, 'fog', new FogExp2(0xffffff, pick(WRONG_NUMBERS))),
  (host) => broken(host.scene, 'background', new Color(NaN, NaN, NaN)),
  (host, _smoke, _object, pick) => {
    const target = new WebGLRenderTarget(pick([1, 3]), 1, { depthBuffer: pick([true, false]), count: pick([1, 2]) });
    host.renderer.setRenderTarget(target);
    return () => {
      host.renderer.setRenderTarget(null);
      target.dispose();
    };
  },
  (host, _smoke, _object, pick) => {
    host.renderer.setViewport(0, 0, pick([0, 1, 1e6]), pick([0, 5]));
    return () => host.renderer.setViewport(0, 0, 200, 140);
  },
  (_host, smoke, _object, pick) => (smoke.update(pick(WRONG_VALUES) as number), () => {}),
];

/** Calls with wrong arguments, each of which throws an error of the library and changes nothing. */
const CALLS: readonly ((smoke: CartoonSmoke, value: never) => unknown)[] = [
  (smoke, value) => smoke.emitFrom(value),
  (smoke, value) => smoke.emitFrom(new Group(), { speed: value, sped: 1 } as never),
  (smoke, value) => smoke.emitFrom(new Group(), { shape: value, sped: 1 } as never),
  (smoke, value) => smoke.burst(value),
  (smoke, value) => smoke.burst({ position: value, count: 1 }),
  (smoke, value) => smoke.burst({ position: new Group().position, count: 1.5, tint: value }),
  (smoke, value) => smoke.cast(value),
  (smoke, value) => smoke.cast(new Mesh(new SphereGeometry()), { proxies: [value] }),
  (smoke, value) => smoke.attach('vortices.0', value),
  (smoke, value) => smoke.attach(value, new Group()),
  (smoke, value) => smoke.set({ 'emission.rate': value, 'emission.rat': 1 } as object),
  (smoke) => smoke.step(-1),
  (smoke) => smoke.collide(new Group()),
];

export interface Survived {
  /** What `update` and renders threw. */
  thrown: string[];
  /** What calls with wrong arguments threw that is no error of the library, or nothing at all. */
  unclear: string[];
  /** Renders with a mistake that three.js itself survives. */
  renders: number;
  /** Events that are no errors of the library. */
  foreign: string[];
  /** Pixels that smoke, and the shadow of the object, still change at the end. */
  smoke: number;
  shadow: number;
}

/** Makes random mistakes, one at a time, and draws after each. */
export async function survive(seed: number, count: number): Promise<Survived> {
  const host = furnishedHost();
  const smoke = await smokeIn(host);
  const object = host.scene.children.find((child) => 'isMesh' in child && child.position.x < 0) as Mesh;
  object.material = new MeshStandardMaterial();
  const caster = smoke.cast(object);
  smoke.emitFrom(object, { rate: 0 });
  const next = random(seed);
  const pick = <Item>(items: readonly Item[]): Item => items[Math.floor(next() * items.length)];
  const seen: Survived = { thrown: [], unclear: [], renders: 0, foreign: [], smoke: 0, shadow: 0 };
  smoke.addEventListener('error', ({ error }) => {
    if (!(error instanceof SmokeError)) seen.foreign.push(String(error));
  });
  const attempt = (name: string, act: () => void) => {
    try {
      act();
    } catch (error) {
      seen.thrown.push(`${name}: ${(error as Error).stack}`);
    }
  };
  const render = (camera: Camera = host.camera) => host.renderer.render(host.scene, camera);
  for (let round = 0; round < count; round++) {
    const mistake = pick(MISTAKES);
    const undo = mistake(host, smoke, object, pick);
    const { visible } = smoke;
    smoke.visible = false;
    const isDrawn = survives(render);
    smoke.visible = visible;
    attempt(`update after ${String(mistake)}`, () => smoke.update(1 / 60));
    if (isDrawn) attempt(`render after ${String(mistake)}`, render);
    seen.renders += isDrawn ? 1 : 0;
    undo();
    object.updateMatrix();
    const call = pick(CALLS);
    const value = pick(WRONG_VALUES);
    try {
      call(smoke, value as never);
      seen.unclear.push(`${String(call)} took wrong value ${WRONG_VALUES.indexOf(value)}`);
    } catch (error) {
      if (!(error instanceof SmokeError))
        seen.unclear.push(`${String(call)} of wrong value ${WRONG_VALUES.indexOf(value)}: ${String(error)}`);
    }
  }
  smoke.update(0.1);
  const whole = draw(host);
  caster.enabled = false;
  smoke.update(0.1);
  seen.shadow = changedPixels(whole, draw(host));
  smoke.visible = false;
  seen.smoke = changedPixels(whole, draw(host));
  dispose(smoke, host.renderer);
  return seen;
}

function survives(act: () => void): boolean {
  try {
    act();
    return true;
  } catch {
    return false;
  }
}
