/** Many stages on one page. */
import { goesOn, open, sightIsNotified, type Opened } from './stage.cases.ts';

const TINY = { width: 32, height: 24 };

/** Counts the WebGL contexts that this thread creates, from now on. */
export function countContexts(): { webgl: number } {
  const count = { webgl: 0 };
  for (const { prototype } of [HTMLCanvasElement, OffscreenCanvas]) {
    const getContext = prototype.getContext as (this: unknown, ...given: unknown[]) => unknown;
    const counting = function (this: unknown, ...given: unknown[]) {
      if (given[0] === 'webgl2') count.webgl += 1;
      return getContext.apply(this, given);
    };
    Object.assign(prototype, { getContext: counting });
  }
  return count;
}

/** Stages of the same smoke, some out of view, each advanced by 60 steps. */
export async function openMany(count: number, inView: number, thread: 'main' | 'worker'): Promise<Opened[]> {
  document.body.style.cssText = 'display: flow-root; height: 5000px; position: relative';
  const opened = await Promise.all(Array.from({ length: count }, () => open({ ...TINY, thread })));
  opened.forEach(({ canvas }, index) => {
    canvas.style.cssText = `position: absolute; width: 32px; height: 24px; left: ${34 * (index % 10)}px`;
    canvas.style.top = `${26 * Math.floor(index / 10) + (index < inView ? 0 : 4000)}px`;
  });
  for (const { stage } of opened) await stage.step(60);
  return opened;
}

/** Plays all stages until those in view have advanced. @returns which of them advanced */
export async function whichGoOn(opened: readonly Opened[], inView: number): Promise<boolean[]> {
  await Promise.all(opened.map(({ stage }) => stage.play()));
  await sightIsNotified();
  const before = await stepsOf(opened);
  await Promise.all(opened.slice(0, inView).map(({ stage }) => goesOn(stage, 2)));
  const after = await stepsOf(opened);
  return after.map((steps, index) => steps > before[index]);
}

function stepsOf(opened: readonly Opened[]): Promise<number[]> {
  return Promise.all(opened.map(async ({ stage }) => (await stage.stats()).steps));
}

/** Creates and disposes stages one by one. */
export async function comeAndGo(rounds: number, thread: 'main' | 'worker'): Promise<void> {
  for (let round = 0; round < rounds; ++round) {
    const { stage, canvas } = await open({ ...TINY, thread });
    await stage.step(2);
    await stage.play();
    await stage.dispose();
    canvas.remove();
  }
}
