/** When calls begin and end, on a stage whose time the test sets. */
import { afterEach, beforeEach, expect, it, vi } from 'vitest';
import { Engine, type PuffCall } from '../../../../src/page/puff/engine.ts';
import type { Sheet } from '../../../../src/page/puff/overlay.ts';
import { Placement } from '../../../../src/page/puff/placement.ts';
import type { RemoteStage } from '../../../../src/stage/remote/contract.ts';

const BOX = { left: 0, top: 0, width: 300, height: 200 };

beforeEach(() => {
  vi.useFakeTimers();
  vi.stubGlobal('addEventListener', () => undefined);
  vi.stubGlobal('document', { addEventListener: () => undefined });
  vi.stubGlobal('devicePixelRatio', 1);
  vi.stubGlobal('innerWidth', BOX.width);
  vi.stubGlobal('innerHeight', BOX.height);
});
afterEach(() => {
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

/** An engine, the names of the calls of its stage in their order, and the time of the stage. */
function opened(): { engine: Engine; calls: string[]; at: { time: number } } {
  const calls: string[] = [];
  const at = { time: 0 };
  const call = (name: string, result?: () => unknown) => async () => {
    calls.push(name);
    return result?.();
  };
  const stage = {
    on: () => () => undefined,
    stats: async () => ({ time: at.time, waiting: 0 }),
    emit: call('emit', () => calls.length),
    ...Object.fromEntries(['set', 'play', 'pause', 'restart', 'resize', 'dispose'].map((name) => [name, call(name)])),
  } as unknown as RemoteStage;
  const canvas = { clientWidth: BOX.width, clientHeight: BOX.height, currentCSSZoom: 1 };
  const sheet = {
    canvas,
    scale: 1,
    place: () => undefined,
    rectangle: () => BOX,
    style: () => undefined,
    remove: () => undefined,
  };
  const size = { ...BOX, pixelRatio: 1 };
  const placement = new Placement(sheet as unknown as Sheet, size);
  const engine = new Engine(stage, sheet as unknown as Sheet, placement, { seed: 0 }, {}, () => undefined);
  return { engine, calls, at };
}

function callOf(begun: PuffCall[]): PuffCall {
  const made: PuffCall = {
    effect: 'pop',
    source: { box: () => BOX } as unknown as PuffCall['source'],
    signal: new AbortController().signal,
    onBegin: () => begun.push(made),
  };
  return made;
}

it('plays after the first emissions, and later calls need no other message than theirs', async () => {
  const { engine, calls } = opened();
  const begun: PuffCall[] = [];
  const all = [engine.play(callOf(begun)), engine.play(callOf(begun))];
  await vi.advanceTimersByTimeAsync(1);
  expect(calls.filter((name) => name !== 'resize')).toEqual(['set', 'emit', 'emit', 'play']);
  calls.length = 0;
  all.push(engine.play(callOf(begun)));
  await vi.advanceTimersByTimeAsync(1);
  expect(calls).toEqual(['emit']);
  expect(begun).toHaveLength(3);
  engine.clear();
  await Promise.all(all);
});

it('lets calls wait until others end when the stage has no emission left', async () => {
  const { engine, calls, at } = opened();
  const begun: PuffCall[] = [];
  const ended: number[] = [];
  for (let index = 0; index < 390; index++) void engine.play(callOf(begun)).then(() => ended.push(index));
  await vi.advanceTimersByTimeAsync(500);
  expect([begun.length, calls.filter((name) => name === 'emit').length]).toEqual([384, 384]);
  at.time = 5;
  await vi.advanceTimersByTimeAsync(1000);
  expect([begun.length, ended.length]).toEqual([390, 384]);
  at.time = 10;
  await vi.advanceTimersByTimeAsync(1000);
  expect(ended).toHaveLength(390);
  engine.dispose();
});
