/** The list of hashes that every engine must reach is what Node and the native build compute. */
import { readFileSync, writeFileSync } from 'node:fs';
import { expect, test } from 'vitest';
import { nativeHashes } from '../support/sim/nativeTakes.ts';
import { HASH_LIST, motionOf, presetHashes, type HashList } from '../support/sim/presetHashes.ts';
import { RecordedCalls } from '../support/sim/recordedCalls.ts';
import { loadVariant } from '../support/sim/simWasm.ts';

// With UPDATE_HASHES=1 it writes the list.
test('every preset has the hashes of the list in Node and, with the same calls, natively', async () => {
  const calls = new RecordedCalls();
  const hashes = await presetHashes(async (variant) => calls.record(await loadVariant(variant)));
  if (process.env.UPDATE_HASHES) writeFileSync(HASH_LIST, `${JSON.stringify(hashes, null, 2)}\n`);
  const list = JSON.parse(readFileSync(HASH_LIST, 'utf8')) as HashList;
  expect(hashes).toEqual(list);
  const simulated = new Map(Object.keys(list).map((name) => [motionOf(name), list[name]]));
  expect(simulated.size).toBeGreaterThan(10);
  expect(await nativeHashes(calls.bytes())).toEqual([...simulated.values()].flatMap(Object.values));
});
