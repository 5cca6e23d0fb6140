/** Smoke in a host's three.js scene: what handles leave behind, bursts, smoke without particles, and targets. */
import {
  BoxGeometry,
  HalfFloatType,
  Mesh,
  MeshBasicMaterial,
  MeshStandardMaterial,
  PlaneGeometry,
  Vector2,
  Vector3,
  WebGLRenderTarget,
} from 'three';
import { CartoonSmoke } from '../../../src/three/cartoonSmoke.ts';
import type { SmokeHandle } from '../../../src/three/handle.ts';
import type { Simulator } from '../../../src/simulator/simulator.ts';
import { liveObjects } from '../../support/liveObjects.ts';
import { draw, emptyHost, makeRenderer, type Host } from '../../visual/three/scene.ts';
import { demand, figure, say, time, type Figure } from '../support/figures.ts';

const FRAME = 1 / 60;
const ROUNDS = 5;
/** Adds and removes of each kind of handle. */
const CYCLES = 1000;
/** Bursts in a second, and puffs of each. */
const BURSTS = 50;
const PUFFS = 12;
const FRAMES = 60;
const IDLE_FRAMES = 600;
/** Opaque objects, and frames of a round. */
const OBJECTS = 300;
const TARGET_FRAMES = 6;
const VALUES = { 'emission.rate': 0, 'emission.lifetime': 1, 'simulation.maxParticles': 2000 };

export async function measure(isQuick: boolean): Promise<Figure[]> {
  const rounds = isQuick ? 3 : ROUNDS;
  await say('handles');
  const handles = await measureHandles(isQuick ? CYCLES / 10 : CYCLES);
  await say('bursts');
  const bursts = await measureBursts(rounds);
  await say('no particles');
  const idle = await measureIdle(rounds);
  await say('targets');
  return [...handles, ...bursts, ...idle, ...(await measureTargets(rounds))];
}

async function smokeOf({ renderer, keyLight, scene }: Host, values = VALUES): Promise<CartoonSmoke> {
  const smoke = await CartoonSmoke.create({ renderer, keyLight, values });
  scene.add(smoke);
  return smoke;
}

/** Bytes of the simulator's state, which has all rigids, and of the heap; objects of the GPU. */
async function measureHandles(count: number): Promise<Figure[]> {
  const figures: Figure[] = [];
  for (const kind of ['emitFrom', 'collide', 'feelsSmoke', 'cast', 'attach'] as const) {
    const renderer = makeRenderer();
    const live = liveObjects(renderer);
    const host = emptyHost(renderer);
    const hashes: string[] = [];
    for (let run = 0; run < 2; run++) {
      const smoke = await smokeOf(host);
      const box = new Mesh(new BoxGeometry(0.3, 0.3, 0.3), new MeshBasicMaterial());
      host.scene.add(box);
      const add = (): SmokeHandle => {
        if (kind === 'emitFrom') return smoke.emitFrom(box, { rate: 60 });
        if (kind === 'feelsSmoke') return smoke.collide(box, { feelsSmoke: true });
        return kind === 'attach' ? smoke.attach('vortices.0', box) : smoke[kind](box);
      };
      const cycle = (from: number, to: number) => {
        for (let index = from; index < to; index++) {
          const handle = add();
          if (index % 20 === 0) smoke.step();
          handle.remove();
        }
        smoke.step();
        draw(host);
      };
      const state = () => {
        // All puffs are gone.
        smoke.step(3 * FRAMES);
        globalThis.gc!();
        const { usedJSHeapSize } = (performance as unknown as { memory: { usedJSHeapSize: number } }).memory;
        const simulator = Reflect.get(smoke, 'simulator') as Simulator;
        const objects = Object.values(live()).reduce((sum, each) => sum + each, 0);
        return { heap: usedJSHeapSize / 1000, state: simulator.save().length, objects };
      };
      cycle(0, 100);
      const before = state();
      cycle(100, 100 + count);
      const after = state();
      hashes.push(smoke.hash());
      if (run === 1) {
        const note = `more after ${count} adds and removes`;
        figures.push(figure(`host.${kind}.state`, 'B', [after.state - before.state], `${note}, with all rigids`));
        figures.push(figure(`host.${kind}.heap`, 'kB', [after.heap - before.heap], note));
        figures.push(figure(`host.${kind}.gpu`, '', [after.objects - before.objects], note));
      }
      smoke.dispose();
      host.scene.remove(box);
    }
    demand(hashes[0] === hashes[1], `the hashes of ${kind} are ${hashes.join(' and ')}`);
    renderer.forceContextLoss();
  }
  return figures;
}

/** A second with bursts, beside a second in which an emitter emits as many puffs. */
async function measureBursts(rounds: number): Promise<Figure[]> {
  const host = emptyHost();
  const smoke = await smokeOf(host);
  const emitter = smoke.emitFrom(host.keyLight, { rate: BURSTS * PUFFS, size: 0.15 });
  const options = { position: new Vector3(2, 5, 3), count: PUFFS, size: 0.15, speed: 0.5 };
  const second = (hasBursts: boolean) => {
    emitter.enabled = !hasBursts;
    let done = 0;
    let callMs = 0;
    const ms = time(() => {
      for (let frame = 1; frame <= FRAMES; frame++) {
        const due = hasBursts ? Math.floor((frame * BURSTS) / FRAMES) : 0;
        callMs += time(() => {
          for (; done < due; done++) void smoke.burst(options);
        });
        smoke.update(FRAME);
        draw(host);
      }
    });
    return { ms: ms / FRAMES, callMs: callMs / FRAMES, alive: smoke.stats.alive };
  };
  second(false);
  const [share, calls, frames]: number[][] = [[], [], []];
  for (let round = 0; round < rounds; round++) {
    const even = second(false);
    const bursts = second(true);
    demand(Math.abs(bursts.alive / even.alive - 1) < 0.1, `${bursts.alive} and ${even.alive} puffs`);
    share.push(100 * (bursts.ms / even.ms - 1));
    calls.push((100 * bursts.callMs) / even.ms);
    frames.push(even.ms);
  }
  host.renderer.forceContextLoss();
  return [
    figure(
      'host.bursts.frame',
      '%',
      share,
      `${BURSTS} bursts of ${PUFFS} puffs in a second, beside an emitter; at most 10`,
    ),
    figure('host.bursts.calls', '%', calls, 'of a frame, the calls alone'),
    figure('host.frame', 'ms', frames, 'of the frame with the emitter, on this machine'),
  ];
}

/** Frames of a scene with many objects in a target with a stencil and in one without, where the objects are drawn again. */
async function measureTargets(rounds: number): Promise<Figure[]> {
  const host = emptyHost();
  const { renderer, scene, camera } = host;
  const [geometry, material] = [new BoxGeometry(0.2, 0.2, 0.2), new MeshStandardMaterial()];
  for (let index = 0; index < OBJECTS; index++) {
    const box = new Mesh(geometry, material);
    box.position.set((index % 20) / 5 - 2, 0.2 * Math.floor(index / 60), (Math.floor(index / 20) % 3) - 2);
    scene.add(box);
  }
  const smoke = await smokeOf(host, { ...VALUES, 'emission.rate': 60 });
  smoke.step(FRAMES);
  const [size, pixel] = [renderer.getSize(new Vector2()), new Uint16Array(4)];
  const frameIn = (target: WebGLRenderTarget) => {
    renderer.setRenderTarget(target);
    const ms = time(() => {
      for (let frame = 0; frame < TARGET_FRAMES; frame++) renderer.render(scene, camera);
      renderer.readRenderTargetPixels(target, 0, 0, 1, 1, pixel);
    });
    return { ms, calls: renderer.info.render.calls };
  };
  const [counted, bare] = [true, false].map(
    (stencilBuffer) => new WebGLRenderTarget(size.x, size.y, { type: HalfFloatType, stencilBuffer }),
  );
  frameIn(bare);
  await smoke.complete();
  const calls = [bare, counted].map((target) => frameIn(target).calls);
  const ratios: number[] = [];
  for (let round = 0; round < rounds; round++) ratios.push(frameIn(bare).ms / frameIn(counted).ms);
  renderer.forceContextLoss();
  const note = `a frame without stencil in the target, in frames with one; ${OBJECTS} objects`;
  return [
    figure('host.target.frame', 'x', ratios, note),
    figure('host.target.calls', '', [calls[0] - calls[1]], 'more draw calls of it'),
  ];
}

/** Frames of a scene with and without smoke that has no particles. */
async function measureIdle(rounds: number): Promise<Figure[]> {
  const host = emptyHost();
  const floor = new Mesh(new PlaneGeometry(6, 6), new MeshStandardMaterial());
  host.scene.add(floor);
  const smoke = await smokeOf(host);
  const calls = () => host.renderer.info.render.calls;
  const frames = (isThere: boolean) => {
    if (isThere) host.scene.add(smoke);
    else host.scene.remove(smoke);
    return time(() => {
      for (let frame = 0; frame < IDLE_FRAMES; frame++) {
        if (isThere) smoke.update(FRAME);
        host.renderer.render(host.scene, host.camera);
      }
    });
  };
  frames(true);
  const without = (frames(false), calls());
  const drawn = (frames(true), calls()) - without;
  const cost: number[] = [];
  for (let round = 0; round < 4 * rounds; round++) cost.push((frames(true) - frames(false)) / IDLE_FRAMES);
  host.renderer.forceContextLoss();
  return [
    figure('host.idle.ms', 'ms', cost, 'JavaScript of a frame without particles; at most 0.1'),
    figure('host.idle.calls', '', [drawn], 'draw calls of it'),
  ];
}
