/** `emitFrom` without options, and `clear`, `restart`, `save` and `restore` of smoke with handles. */
import { BoxGeometry, Mesh, MeshBasicMaterial, Object3D } from 'three';
import type { AnyValues, Values } from '../../../../src/parameters/parameter.ts';
import type { CartoonSmoke } from '../../../../src/three/cartoonSmoke.ts';
import type { EmitterHandle } from '../../../../src/three/emitters.ts';
import { ALL_PARTICLES } from '../../../../src/simulator/view.ts';
import type { Simulator } from '../../../../src/simulator/simulator.ts';
import { dispose, draw, emptyHost, smokeIn, type Host } from '../scene.ts';

/** Smoke that stays where it is born. */
export const STILL: Values = {
  'emission.rate': 60,
  'emission.lifetime': 60,
  'emission.growthTime': 0,
  'buoyancy.acceleration': 0,
  'turbulence.speed': 0,
  'emitters.0.speed': 0,
  'emitters.0.shape': 'point',
};

export function at(host: Host, x: number): Object3D {
  const object = new Object3D();
  object.position.x = x;
  host.scene.add(object);
  return object;
}

/** The number of puffs at each place along x. */
export function countsOf(smoke: CartoonSmoke): Record<string, number> {
  const { simulator } = smoke as unknown as { simulator: Simulator };
  const { count, place } = simulator.arrange({ ...ALL_PARTICLES, blend: 1 }).rows;
  const counts: Record<string, number> = {};
  for (let row = 0; row < count; row++) {
    const x = Math.round(place[4 * row]);
    counts[x] = (counts[x] ?? 0) + 1;
  }
  return counts;
}

async function withSmoke<Result>(
  run: (smoke: CartoonSmoke, host: Host) => Result | Promise<Result>,
  values: Values = {},
  physics = false,
): Promise<Result> {
  const host = emptyHost();
  const smoke = await smokeIn(host, { ...STILL, ...values }, { physics });
  smoke.restart();
  const result = await run(smoke, host);
  dispose(smoke, host.renderer);
  return result;
}

/** One second of smoke after each change. */
export async function emitFromObjects(): Promise<Record<string, Record<string, number>>> {
  const seen: Record<string, Record<string, number>> = {};
  const second = (what: string, smoke: CartoonSmoke) => {
    smoke.clear();
    smoke.step(60);
    // What is born at the end of the second is drawn later.
    smoke.step(1);
    seen[what] = countsOf(smoke);
  };
  await withSmoke((smoke, host) => {
    second('none', smoke);
    const [a, b] = [3, 6].map((x) => smoke.emitFrom(at(host, x)));
    second('two', smoke);
    smoke.set({ 'emission.rate': 120 });
    second('twice the rate', smoke);
    b.set({ rate: 30 });
    smoke.set({ 'emission.rate': 240 });
    second('one with a rate of its own', smoke);
    a.enabled = false;
    second('one disabled', smoke);
    const table = smoke.emitFrom(at(host, 9), 0);
    second('and the emitter of the table', smoke);
    table.remove();
    const ridden = smoke.attach('emitters.0', at(host, 12));
    second('and attached', smoke);
    ridden.remove();
    b.remove();
    second('all removed', smoke);
    a.enabled = true;
    second('enabled', smoke);
    a.remove();
    second('nothing', smoke);
  });
  await withSmoke(
    (smoke, host) => {
      smoke.emitFrom(at(host, 3));
      second('a quarter of the rate', smoke);
    },
    { 'emitters.1.share': 3, 'emitters.1.position.x': -5, 'emitters.1.shape': 'point', 'emitters.1.speed': 0 },
  );
  await withSmoke(
    (smoke, host) => {
      smoke.emitFrom(at(host, 3));
      second('bursts of the table', smoke);
    },
    {
      'emission.rate': 0,
      'emitters.0.burst.count': 5,
      'emitters.0.envelope.period': 0.5,
      'emitters.0.envelope.duration': 0.1,
    },
  );
  await withSmoke(
    (smoke, host) => {
      smoke.emitFrom(at(host, 3));
      second('a high rate', smoke);
    },
    { 'emission.rate': 6000, 'simulation.maxParticles': 10_000 },
  );
  return seen;
}

/** What `clear` of smoke removes and keeps, and the hash of the same run without and with it. */
export async function clear() {
  return withSmoke(async (smoke, host) => {
    const child = new Object3D();
    smoke.add(child);
    const handle = smoke.emitFrom(at(host, 3));
    smoke.step(60);
    const before = smoke.stats.alive;
    const isItself = smoke.clear() === smoke;
    const { alive } = smoke.stats;
    const values = smoke.get();
    smoke.step(61);
    const after = countsOf(smoke);
    handle.set({ rate: 10 });
    return { before, isItself, alive, after, rate: values['emission.rate'], children: smoke.children.includes(child) };
  });
}

/** Hashes of a run, after `restart`, and after `restore` in the middle; with handles of each kind. */
export async function again(physics: boolean) {
  return withSmoke(
    (smoke, host) => {
      const box = new Mesh(new BoxGeometry(0.5, 0.5, 0.5), new MeshBasicMaterial());
      box.position.set(3, 1, 0);
      host.scene.add(box);
      smoke.collide(box);
      smoke.cast(box);
      smoke.emitFrom(at(host, 3));
      smoke.emitFrom(at(host, 6), { rate: 40, inherit: 1 });
      smoke.emitFrom(at(host, 9), 1);
      smoke.attach('vortices.0', box);
      const run = () => {
        smoke.step(30);
        const half = smoke.hash();
        void smoke.burst({ position: { x: 0, y: 1, z: 0 }, count: 20 });
        smoke.step(30);
        return [half, smoke.hash()];
      };
      smoke.restart();
      const first = run();
      smoke.restart();
      const steps = smoke.stats.steps;
      smoke.step(30);
      const state = smoke.save();
      const untouched = smoke.hash();
      void smoke.burst({ position: { x: 0, y: 1, z: 0 }, count: 20 });
      smoke.step(30);
      const end = smoke.hash();
      smoke.restore(state);
      const restored = smoke.hash();
      void smoke.burst({ position: { x: 0, y: 1, z: 0 }, count: 20 });
      smoke.step(30);
      return { steps, first, second: [untouched, end], third: [restored, smoke.hash()] };
    },
    { 'vortices.0.circulation': 1, 'emitters.1.share': 1, 'turbulence.speed': 1, 'emitters.0.speed': 1 },
    physics,
  );
}

/** A state outlives handles, and handles outlive a state. Values come from the state, without what handles do to them. */
export async function otherHandles() {
  return withSmoke(
    async (smoke, host) => {
      const box = new Mesh(new BoxGeometry(0.5, 0.5, 0.5), new MeshBasicMaterial());
      host.scene.add(box);
      const early: { remove(): void }[] = [
        smoke.emitFrom(at(host, 3), { rate: 30, speed: 0, shape: 'point' }),
        smoke.collide(box),
        smoke.emitFrom(at(host, 4), 0),
      ];
      const before: AnyValues = smoke.get();
      smoke.step(60);
      const state = smoke.save();
      for (const handle of early) handle.remove();
      const late: EmitterHandle = smoke.emitFrom(at(host, 8));
      smoke.set({ 'emission.rate': 120, 'style.tones': 3 });
      smoke.step(10);
      smoke.restore(state);
      const after: AnyValues = smoke.get();
      smoke.clear();
      smoke.step(61);
      const counts = countsOf(smoke);
      const { simulator } = smoke as unknown as { simulator: Simulator };
      late.remove();
      const damaged = state.slice();
      damaged[100] ^= 1;
      const hash = smoke.hash();
      let message = '';
      try {
        smoke.restore(damaged);
      } catch (error) {
        message = (error as Error).name;
      }
      draw(host);
      const isUnchanged = hash === smoke.hash();
      const changed = Object.keys({ ...before, ...after }).filter((key) => before[key] !== after[key]);
      return { counts, changed, rigids: simulator.rigidCount, message, isUnchanged };
    },
    {},
    true,
  );
}

/** The message for a state that does not fit. */
export async function tooSmall(): Promise<string> {
  const state = await withSmoke((smoke) => {
    smoke.step(120);
    return smoke.save();
  });
  return withSmoke(
    (smoke) => {
      try {
        smoke.restore(state);
        return 'restored';
      } catch (error) {
        return String(error);
      }
    },
    { 'simulation.maxParticles': 50 },
  );
}

/** Pictures of a smoking chimney, by `emitFrom(chimney)` and by the emitter of the table. */
export async function chimneys(): Promise<Record<'own' | 'table', number[]>> {
  const look = async (emitter?: number) => {
    const host = emptyHost();
    const smoke = await smokeIn(host, { 'emission.rate': 28 });
    smoke.restart();
    smoke.emitFrom(at(host, 0.5), emitter);
    smoke.step(150);
    const pixels = Array.from(draw(host));
    dispose(smoke, host.renderer);
    return pixels;
  };
  return { own: await look(), table: await look(0) };
}

/** What each call says about an object or a position at 4,999 m and at 5,001 m. */
export async function reach(): Promise<string[]> {
  return withSmoke(
    (smoke, host) => {
      const said: string[] = [];
      smoke.addEventListener('error', ({ error }) => said.push(error.message));
      for (const [call, place] of [
        ['emitFrom', (x: number) => smoke.emitFrom(at(host, x), { rate: 1 })],
        ['emitFrom 0', (x: number) => smoke.emitFrom(at(host, x), 0)],
        ['emitFrom', (x: number) => smoke.emitFrom(at(host, x))],
        ['burst', (x: number) => void smoke.burst({ position: { x, y: 0, z: 0 }, count: 1 })],
        ['attach', (x: number) => smoke.attach('vortices.0', at(host, x)).remove()],
        ['collide', (x: number) => smoke.collide(boxAt(host, x))],
        ['pushed', (x: number) => smoke.collide(boxAt(host, x), { feelsSmoke: true })],
        ['cast', (x: number) => smoke.cast(boxAt(host, x))],
      ] as const)
        for (const x of [4999, 5001]) {
          try {
            const handle = place(x) as { remove(): void } | undefined;
            smoke.step(2);
            handle?.remove();
            said.push(`${call} ${x}`);
          } catch (error) {
            said.push(`${call} ${(error as Error).message}`);
          }
        }
      return said;
    },
    {},
    true,
  );
}

function boxAt(host: Host, x: number): Mesh {
  const box = new Mesh(new BoxGeometry(0.5, 0.5, 0.5), new MeshBasicMaterial());
  box.position.x = x;
  host.scene.add(box);
  return box;
}
