import { expect, test } from 'vitest';
import { change } from '../../../src/element/change.ts';
import type { RemoteStage } from '../../../src/remote/contract.ts';

test('a change is sent completely before another one, without unchanged values', async () => {
  const sent: unknown[] = [];
  const record = (name: string) => async (given: unknown) => void sent.push([name, given]);
  const stage = { unset: record('unset'), set: record('set') } as unknown as RemoteStage;
  const first = change(stage, { gone: 1, same: 2, other: 3 }, { same: 2, other: 4, added: 5 });
  const second = change(stage, { other: 4 }, { other: 6 });
  expect(sent).toEqual([
    ['unset', ['gone']],
    ['set', { other: 4, added: 5 }],
    ['set', { other: 6 }],
  ]);
  await Promise.all([first, second]);
  await change(stage, { same: 2 }, { same: 2 });
  expect(sent).toHaveLength(3);
});
