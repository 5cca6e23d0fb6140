/** `UPDATE_HASHES=1 npx vitest run tests/unit/presetHashes.test.ts` writes the list anew. */
import { readFileSync, writeFileSync } from 'node:fs';
import { expect, it } from 'vitest';
import { HASH_LIST, presetHashes, type HashList } from '../support/presetHashes.ts';
import { loadVariant } from './simWasm.ts';

it('every preset has the hashes of tests/engines/hashes.json in Node', async () => {
  const hashes = await presetHashes((physics) => loadVariant(physics ? 'physics' : 'core'));
  if (process.env.UPDATE_HASHES) writeFileSync(HASH_LIST, `${JSON.stringify(hashes, null, 2)}\n`);
  expect(hashes).toEqual(JSON.parse(readFileSync(HASH_LIST, 'utf8')) as HashList);
});
