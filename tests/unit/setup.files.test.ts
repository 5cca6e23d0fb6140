/** A test file that lies where no runner looks would pass for ever. */
import { readdirSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { expect, test } from 'vitest';

const ROOT = fileURLToPath(new URL('../..', import.meta.url));

test('every test file lies where a runner finds it', () => {
  const files = readdirSync(`${ROOT}/tests`, { recursive: true, encoding: 'utf8' }).map((path) =>
    path.replaceAll('\\', '/'),
  );
  const tests = files.filter((path) => /[.](test|spec)\.[cm]?[jt]sx?$/.test(path));
  const stray = tests.filter((path) => !/^unit\/.+\.test\.ts$|^(support|visual|e2e)\/.+\.(spec|test)\.ts$/.test(path));
  expect(stray).toEqual([]);
  expect(tests.length).toBeGreaterThan(0);
});
