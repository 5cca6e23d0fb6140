/** Situations in which a mistake has no visible effect, and correct programs. */
import { Group, type Scene } from 'three';
import { createElement } from 'react';
import type * as Fiber from '../../../src/fiber.ts';
import type * as Index from '../../../src/index.ts';
import type { Puff } from '../../../src/puff.ts';
import type { CartoonSmoke, CartoonSmokeOptions } from '../../../src/index.ts';
import { Tree } from '../three/fiber/tree.ts';
import { emptyHost, makeRenderer } from '../three/scene.ts';

/** More frames than a warning waits for. */
const MANY = 310;
const VALUES = { 'simulation.maxParticles': 16, 'emission.rate': 0 };

interface Given extends ReturnType<typeof emptyHost> {
  index: typeof Index;
  fiber: typeof Fiber;
  puff: Puff;
  options: CartoonSmokeOptions;
  smoke: CartoonSmoke;
}

const frame = () => new Promise((resolve) => requestAnimationFrame(resolve));
/** Stands for a render, which does the same for each object of a scene. */
const renders = (scene: Scene | Group, count: number, before: () => void = () => undefined) => {
  for (let at = 0; at < count; ++at) {
    before();
    scene.updateMatrixWorld();
  }
};

function element(style: string): HTMLElement {
  const made = document.createElement('div');
  made.style.cssText = style;
  document.body.append(made);
  return made;
}

/** Calls `act` while the system prefers reduced motion, as pages see it. */
async function calmly(act: () => Promise<void>): Promise<void> {
  const { matchMedia: real } = globalThis;
  globalThis.matchMedia = (query) =>
    Object.defineProperty(real(query), 'matches', { value: /reduced-motion: reduce/.test(query) });
  await act();
  globalThis.matchMedia = real;
}

export const situations: Record<string, (given: Given) => unknown> = {
  'update is never called': ({ scene, smoke }) => renders(scene.add(smoke), MANY),
  'smoke in no scene': ({ smoke }) => {
    for (let at = 0; at < MANY; ++at) smoke.update(1 / 60);
  },
  'smoke in a group that is in no scene': ({ smoke }) => {
    new Group().add(smoke);
    for (let at = 0; at < MANY; ++at) smoke.update(1 / 60);
  },
  'update(16.7)': ({ scene, smoke }) => renders(scene.add(smoke), 20, () => smoke.update(16.7)),
  'update(performance.now())': async ({ scene, smoke }) => {
    scene.add(smoke);
    for (let at = 0; at < 20; ++at) {
      await frame();
      smoke.update(performance.now());
    }
  },
  'update(clock.getElapsedTime())': ({ scene, smoke }) => {
    let elapsed = 3;
    renders(scene.add(smoke), 20, () => smoke.update((elapsed += 1 / 60)));
  },
  'two updates in each frame': ({ scene, smoke }) =>
    renders(scene.add(smoke), MANY, () => {
      smoke.update(0.5);
      smoke.update(0.5);
    }),
  'update(NaN)': ({ scene, smoke }) => renders(scene.add(smoke), 2, () => smoke.update(NaN)),
  'update() without a number': ({ scene, smoke }) => renders(scene.add(smoke), 2, () => (smoke.update as () => void)()),
  'an object at NaN': ({ scene, smoke }) => {
    const box = new Group();
    scene.add(smoke, box);
    smoke.emitFrom(box, { rate: 10 });
    box.position.x = NaN;
    renders(scene, 2, () => smoke.update(1 / 60));
    smoke.update(1 / 60);
  },
  'update after dispose': ({ smoke }) => {
    smoke.dispose();
    smoke.update(1 / 60);
  },
  'update(NaN) of <Smoke>': async ({ fiber, keyLight, smoke: other }) => {
    other.dispose();
    const tree = await Tree.open();
    const smoke = await new Promise<CartoonSmoke>((onReady) => {
      void tree.show(createElement(fiber.Smoke, { keyLight, values: VALUES, onReady }));
    });
    tree.frames(2);
    smoke.update(NaN);
    await tree.end();
  },
  'scene.add(promise)': async ({ index, options, scene }) => {
    const promise = index.CartoonSmoke.create(options);
    const { error } = console;
    // three.js reports it as well.
    console.error = () => undefined;
    scene.add(promise as never);
    console.error = error;
    (await promise).dispose();
  },
  'promise.update()': async ({ index, options }) => {
    const promise = index.CartoonSmoke.create(options);
    for (const act of [
      () => (promise as never as CartoonSmoke).update(0),
      () => (promise as never as CartoonSmoke).emitFrom,
    ]) {
      try {
        act();
      } catch {
        // Not a function.
      }
    }
    (await promise).dispose();
  },
  'promise.visible = false': async ({ index, options }) => {
    const promise = index.CartoonSmoke.create(options);
    (promise as never as CartoonSmoke).visible = false;
    if ((promise as never as CartoonSmoke).visible) throw new Error('not set');
    (await promise).dispose();
  },
  'createStage(canvas).play': async ({ index }) => {
    const promise = index.createStage(document.createElement('canvas'), {
      values: { scene: 'air' },
      width: 8,
      height: 8,
    });
    void (promise as never as Index.Stage).play;
    (await promise).dispose();
  },
  'smokes that nobody disposes': async ({ index, options }) => {
    const made: CartoonSmoke[] = [];
    for (let count = 0; count < 17; ++count) made.push(await index.CartoonSmoke.create(options));
    for (const smoke of made) smoke.dispose();
  },
  "puff(document.querySelector('.none'))": async ({ puff }) => {
    const done = puff(document.querySelector('.none'), { count: 1 });
    puff.clear();
    await done;
  },
  'puff of a hidden element': ({ puff }) => puff(element('display: none')),
  'puff of an element without a size': ({ puff }) => puff(element('width: 0')),
  'puff of an element outside of the document': ({ puff }) => puff(document.createElement('p')),
  'puff with reduced motion': ({ puff }) => calmly(() => puff()),
  'puff of an unknown effect': ({ puff }) => puff(undefined, { effect: 'poofs' as never }).catch(() => undefined),
  'puff of a selector': ({ puff }) => puff('.none' as never).catch(() => undefined),
  'puff of an unknown preset': ({ puff }) => puff(undefined, { preset: 'lampp' as never }).catch(() => undefined),
};

export const correct: typeof situations = {
  'a loop that starts late, and pauses': ({ scene, smoke, renderer, camera }) => {
    scene.add(smoke);
    renders(scene, MANY / 2);
    renders(scene, MANY, () => smoke.update(1 / 60));
    renders(scene, MANY);
    renderer.render(scene, camera);
  },
  'two halves of a frame, and several views of it': ({ scene, smoke }) => {
    const { now } = performance;
    let time = now.call(performance);
    performance.now = () => time;
    renders(scene.add(smoke), MANY, () => {
      time += 1000 / 60;
      smoke.update(1 / 120);
      smoke.update(1 / 120);
    });
    performance.now = now;
    renders(scene, 3, () => smoke.update(1 / 60));
    renders(scene, 3);
  },
  'a tab that was hidden for a minute': ({ scene, smoke }) => renders(scene.add(smoke), 3, () => smoke.update(60)),
  'steps instead of updates': ({ scene, smoke }) => {
    smoke.step();
    renders(scene.add(smoke), MANY);
  },
  'an object of no scene as an anchor': ({ scene, smoke }) => {
    scene.add(smoke);
    smoke.emitFrom(new Group(), { rate: 5 });
    renders(scene, 5, () => smoke.update(1 / 60));
  },
  'smoke that waits for its scene': ({ scene, smoke }) => {
    for (let at = 0; at < 20; ++at) smoke.update(1 / 60);
    renders(scene.add(smoke), 5, () => smoke.update(1 / 60));
  },
  'promises that are awaited together': async ({ index, options }) => {
    const made = [index.CartoonSmoke.create(options), index.CartoonSmoke.create(options)];
    structuredClone({ count: Object.keys(made[0]).length });
    for (const smoke of await Promise.all(made)) smoke.dispose();
  },
  'puff of a point, an element and nothing': async ({ puff }) => {
    const options = { count: 1, effect: 'pop' } as const;
    const done = [
      puff({ x: 5, y: 5 }, options),
      puff(element('width: 9px; height: 9px'), options),
      puff(undefined, options),
    ];
    puff.clear();
    await Promise.all(done);
  },
};

/** Imports a build and does each of these twice. @returns what each wrote to the console */
export async function written(build: 'development' | 'production', names: readonly string[]) {
  const ending = build === 'development' ? '.development.ts' : '.ts';
  const index = (await import(/* @vite-ignore */ `/src/index${ending}`)) as typeof Index;
  const fiber = (await import(/* @vite-ignore */ `/src/fiber${ending}`)) as typeof Fiber;
  const { puff } = (await import(/* @vite-ignore */ `/src/puff${ending}`)) as { puff: Puff };
  const renderer = makeRenderer({}, [8, 8]);
  const lines: Record<string, string[]> = {};
  const { warn } = console;
  for (const name of names) {
    const list: string[] = (lines[name] = []);
    // Fiber uses what three.js calls deprecated.
    console.warn = (...said: unknown[]) => void (String(said[0]).startsWith('THREE.') || list.push(said.join(' ')));
    for (let time = 0; time < 2; ++time) {
      const host = emptyHost(renderer);
      const options = { renderer, keyLight: host.keyLight, values: VALUES };
      const smoke = await index.CartoonSmoke.create(options);
      await { ...situations, ...correct }[name]({ ...host, index, fiber, puff, options, smoke });
      smoke.dispose();
    }
  }
  console.warn = warn;
  return lines;
}
