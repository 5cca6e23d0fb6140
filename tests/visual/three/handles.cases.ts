/** What handles and bursts draw in a host's scene, and that they leave nothing behind. */
import {
  BoxGeometry,
  Mesh,
  MeshBasicMaterial,
  MeshStandardMaterial,
  Object3D,
  PlaneGeometry,
  SphereGeometry,
  Vector3,
} from 'three';
import type { CartoonSmoke } from '../../../src/three/cartoonSmoke.ts';
import type { Values } from '../../../src/parameters/parameter.ts';
import { changedPixels, dispose, draw, emptyHost, HEIGHT, smokeIn, smokePixels, WIDTH, type Host } from './scene.ts';

/** Smoke that stays where it is born for half a second, and none of the table. */
const SHORT: Values = {
  'emission.rate': 0,
  'emission.lifetime': 0.5,
  'emission.growthTime': 0,
  'buoyancy.acceleration': 0,
  'turbulence.speed': 0,
  'simulation.maxParticles': 400,
};
const CLUMP = { shape: 'ball', radius: 0.15, speed: 0, size: 0.2 } as const;

/** Where smoke is in the picture, in pixels. */
export interface PlacedSmoke {
  pixels: number;
  /** Distance of the centroid from the projected place. */
  off: number;
  /** Distance of the farthest pixel from it. */
  reach: number;
}

function smokeAt(host: Host, smoke: CartoonSmoke, place: Vector3): PlacedSmoke {
  // This also updates the key light, which is not in the scene that `smokePixels` draws.
  draw(host);
  const { x, y } = place.clone().project(host.camera);
  const [column, row] = [((x + 1) / 2) * WIDTH, ((y + 1) / 2) * HEIGHT];
  const found = smokePixels(host, smoke).flatMap((isSmoke, pixel) =>
    isSmoke ? [[(pixel % WIDTH) + 0.5 - column, Math.floor(pixel / WIDTH) + 0.5 - row]] : [],
  );
  const mean = (axis: number) => found.reduce((sum, offset) => sum + offset[axis], 0) / Math.max(1, found.length);
  return {
    pixels: found.length,
    off: Math.hypot(mean(0), mean(1)),
    reach: Math.max(0, ...found.map(([across, up]) => Math.hypot(across, up))),
  };
}

/** Before a burst, with it, and after its lifetime. */
export async function burst(): Promise<PlacedSmoke[]> {
  const host = emptyHost();
  const smoke = await smokeIn(host, SHORT);
  const place = new Vector3(0.8, 1.5, -0.2);
  const before = smokeAt(host, smoke, place);
  void smoke.burst({ ...CLUMP, position: place, count: 30, tint: 2 });
  smoke.step(8);
  const during = smokeAt(host, smoke, place);
  smoke.step(60);
  const after = smokeAt(host, smoke, place);
  dispose(smoke, host.renderer);
  return [before, during, after];
}

/** An emitter of a handle: at two places of its object, disabled, enabled again, out of the scene, back, and removed. */
export async function emitter(): Promise<PlacedSmoke[]> {
  const host = emptyHost();
  const smoke = await smokeIn(host, SHORT);
  const object = new Object3D();
  object.position.set(-0.9, 0.6, 0);
  host.scene.add(object);
  const handle = smoke.emitFrom(object, { ...CLUMP, rate: 90 });
  const seen: PlacedSmoke[] = [];
  const look = () => {
    // The first step brings the object to its place, the others outlast what was born on the way.
    smoke.step();
    smoke.step(50);
    seen.push(smokeAt(host, smoke, object.position));
  };
  look();
  object.position.set(0.9, 1.4, 0);
  look();
  handle.enabled = false;
  look();
  handle.enabled = true;
  look();
  host.scene.remove(object);
  look();
  host.scene.add(object);
  look();
  handle.remove();
  look();
  dispose(smoke, host.renderer);
  return seen;
}

/** Pixels that the shadow of a box changes: while it casts, disabled, enabled again and removed. */
export async function caster(): Promise<number[]> {
  const host = emptyHost();
  const floor = new Mesh(new PlaneGeometry(8, 8), new MeshStandardMaterial({ color: '#c08860' }));
  floor.rotation.x = -Math.PI / 2;
  const box = new Mesh(new BoxGeometry(0.6, 0.6, 0.6), new MeshBasicMaterial({ color: '#30a060' }));
  box.position.set(-0.3, 0.8, 0);
  host.scene.add(floor, box);
  const smoke = await smokeIn(host, SHORT);
  const plain = draw(host);
  const handle = smoke.cast(box);
  const changed = () => changedPixels(draw(host), plain);
  const seen = [changed()];
  handle.enabled = false;
  smoke.step();
  seen.push(changed());
  handle.enabled = true;
  smoke.step();
  seen.push(changed());
  handle.remove();
  seen.push(changed());
  dispose(smoke, host.renderer);
  return seen;
}

/** Objects of the GPU before and after `count` adds and removes of each handle, drawn now and then. */
export async function census(count: number): Promise<Record<string, number>[]> {
  const host = emptyHost();
  const smoke = await smokeIn(host, SHORT, { physics: true });
  const box = new Mesh(new BoxGeometry(0.3, 0.3, 0.3), new MeshBasicMaterial());
  const sheet = new Mesh(new PlaneGeometry(1, 1), new MeshBasicMaterial());
  const ball = new Mesh(new SphereGeometry(0.2), new MeshBasicMaterial());
  host.scene.add(box, sheet, ball);
  const proxies = [{ follows: sheet, radius: 0.4 }];
  const seen: Record<string, number>[] = [];
  for (let round = 0; round <= count; round++) {
    const handles = [
      smoke.cast(box),
      smoke.cast(sheet, { proxies }),
      smoke.collide(box),
      smoke.collide(ball),
      smoke.emitFrom(ball, { rate: 60 }),
      smoke.attach('vortices.0', ball),
    ];
    if (round % 100 === 0) {
      smoke.step();
      draw(host);
    }
    for (const handle of handles) handle.remove();
    if (round === 100 || round === count) {
      draw(host);
      const { geometries, textures } = host.renderer.info.memory;
      seen.push({ geometries, textures, programs: host.renderer.info.programs!.length });
    }
  }
  dispose(smoke, host.renderer);
  return seen;
}

/** Hashes of two runs with the same calls, and of one without handles. */
export async function hashes(): Promise<string[]> {
  const run = async (hasHandles: boolean) => {
    const host = emptyHost();
    const smoke = await smokeIn(host, { ...SHORT, 'emission.rate': 40, 'vortices.0.circulation': 2 });
    const object = new Object3D();
    host.scene.add(object);
    const handle = hasHandles ? smoke.emitFrom(object, { rate: 50, inherit: 0.5 }) : undefined;
    if (hasHandles) smoke.attach('vortices.0', object);
    for (let frame = 0; frame < 30; frame++) {
      object.position.x = frame / 30;
      if (hasHandles && frame % 4 === 0) void smoke.burst({ position: object.position, count: 3 });
      if (frame === 20) handle?.remove();
      smoke.update(1 / 30);
    }
    const hash = smoke.hash();
    dispose(smoke, host.renderer);
    return hash;
  };
  return [await run(true), await run(true), await run(false)];
}

/** Error events of frames in which something is wrong, and the particles after them. */
export async function mistakes(): Promise<{ said: string[]; alive: number; pixels: number }> {
  const host = emptyHost();
  const smoke = await smokeIn(host, SHORT, { physics: true });
  const said: string[] = [];
  smoke.addEventListener('error', ({ error }) => said.push(`${error.name}: ${error.message}`));
  const object = new Mesh(new SphereGeometry(0.1), new MeshBasicMaterial());
  object.position.set(0, 1, 0);
  host.scene.add(object);
  smoke.emitFrom(object, { ...CLUMP, rate: 90 });
  smoke.collide(object);
  const box = new Mesh(new BoxGeometry(0.2, 0.2, 0.2), new MeshBasicMaterial());
  host.scene.add(box);
  smoke.cast(box);
  const frames = () => {
    for (let frame = 0; frame < 4; frame++) {
      smoke.update(1 / 60);
      draw(host);
    }
  };
  frames();
  object.position.y = NaN;
  box.position.x = NaN;
  frames();
  box.position.x = 0;
  object.position.y = 1;
  smoke.update(NaN);
  smoke.update(NaN);
  smoke.step(50);
  const { pixels } = smokeAt(host, smoke, object.position);
  const { alive } = smoke.stats;
  dispose(smoke, host.renderer);
  return { said, alive, pixels };
}

/** Draw calls of a frame, and whether its picture differs from that without smoke: empty, in a burst, after it, casting. */
export async function idle(): Promise<Record<string, { calls: number; changed: number; bodies: number }>> {
  const host = emptyHost();
  const floor = new Mesh(new PlaneGeometry(6, 6), new MeshStandardMaterial({ color: '#c08860' }));
  floor.rotation.x = -Math.PI / 2;
  const box = new Mesh(new BoxGeometry(0.5, 0.5, 0.5), new MeshStandardMaterial());
  box.position.y = 0.8;
  host.scene.add(floor, box);
  const bare = draw(host);
  const calls = drawCalls(host);
  draw(host);
  const seen: Record<string, { calls: number; changed: number; bodies: number }> = {};
  const without = calls();
  const smoke = await smokeIn(host, SHORT);
  const look = (name: string) => {
    smoke.step();
    const before = calls();
    const changed = changedPixels(draw(host), bare);
    seen[name] = { calls: calls() - before - without, changed, bodies: smoke.stats.bodiesDrawn };
  };
  look('first');
  look('empty');
  void smoke.burst({ ...CLUMP, position: new Vector3(0.4, 1.4, 0.3), count: 20 });
  look('burst');
  smoke.step(60);
  look('after');
  const handle = smoke.cast(box);
  draw(host);
  look('casting');
  handle.remove();
  look('removed');
  dispose(smoke, host.renderer);
  return seen;
}

/** Counts the draw calls of a host. */
function drawCalls({ renderer }: Host): () => number {
  const gl = renderer.getContext() as unknown as Record<string, (...given: unknown[]) => unknown>;
  let count = 0;
  for (const name of ['drawArrays', 'drawElements', 'drawArraysInstanced', 'drawElementsInstanced', 'clear']) {
    const native = gl[name].bind(gl);
    gl[name] = (...given) => {
      count++;
      return native(...given);
    };
  }
  return () => count;
}
