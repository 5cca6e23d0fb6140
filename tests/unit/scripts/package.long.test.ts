/** The types of the npm package, as compilers find them. */
import { execFileSync } from 'node:child_process';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { expect, it } from 'vitest';
import { script } from '../../support/server.ts';

const ROOT = fileURLToPath(new URL('../../..', import.meta.url));

interface PackageScript {
  /** The tarball's name. */
  ARCHIVE: string;
  isFresh(): boolean;
  bring(say: () => void): Promise<void>;
}

it('has types for each way of resolving modules', async () => {
  const { ARCHIVE, isFresh, bring } = await script<PackageScript>('setup/package.mjs');
  if (!isFresh()) await bring(() => undefined);
  const checker = join(ROOT, 'node_modules/@arethetypeswrong/cli/dist/index.js');
  const words = [checker, join(ROOT, ARCHIVE), '--profile', 'esm-only', '--quiet'];
  expect(() => execFileSync(process.execPath, words)).not.toThrow();
});
