import { expect, test } from 'vitest';
import { change } from '../../../../src/page/element/change.ts';
import type { RemoteStage } from '../../../../src/stage/remote/contract.ts';

test('a change is sent completely before another one, without unchanged values', async () => {
  const sent: unknown[] = [];
  const record = (name: string) => async (given: unknown) => void sent.push([name, given]);
  const stage = { unset: record('unset'), set: record('set') } as unknown as RemoteStage;
  const first = change(
    stage,
    { seed: 1, 'puff.size': 2, 'emission.rate': 3 },
    { 'puff.size': 2, 'emission.rate': 4, 'puff.turn': 5 },
  );
  const second = change(stage, { 'emission.rate': 4 }, { 'emission.rate': 6 });
  expect(sent).toEqual([
    ['unset', ['seed']],
    ['set', { 'emission.rate': 4, 'puff.turn': 5 }],
    ['set', { 'emission.rate': 6 }],
  ]);
  await Promise.all([first, second]);
  await change(stage, { 'puff.size': 2 }, { 'puff.size': 2 });
  expect(sent).toHaveLength(3);
});
