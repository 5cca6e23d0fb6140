/**
 * Recorded share links with the hash and the picture of their moment. `UPDATE_LINKS=all npx playwright test
 * --no-deps --project=modules tests/visual/links.spec.ts` records all of them and prints the changes;
 * `UPDATE_LINKS=lamp,dust` records only these.
 */
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import type { TestInfo } from '@playwright/test';
import { PNG } from 'pngjs';
import { presets } from '../../src/parameters/presets.ts';
import { sceneEntries } from '../../src/scenes/scenes.ts';
import { expect, test } from '../support/fixtures.ts';
import type { LoadModule } from '../support/modules.ts';
import { bytesOf, compare, expectSame } from '../support/goldens.ts';
import { HASH_LIST, type HashList } from '../support/sim/presetHashes.ts';

type Cases = typeof import('./links.cases.ts');

interface RecordedLink {
  /** Query and hash of the page's address. */
  link: string;
  hash: string;
  /** Code and key of each notice, separated by commas. */
  notices: string;
}

const FOLDER = fileURLToPath(new URL('links/', import.meta.url));
const FILE = `${FOLDER}links.json`;
const links = JSON.parse(readFileSync(FILE, 'utf8')) as Record<string, RecordedLink>;

/** There is no difference on one machine; another CPU may round differently. The hash is the same everywhere. */
const DIFFERENCE = { tolerance: 2, outliers: 7 };

const { UPDATE_LINKS } = process.env;
const chosen = UPDATE_LINKS && UPDATE_LINKS !== 'all' ? UPDATE_LINKS.split(',') : Object.keys(links);

/** Presets and their earlier versions, except the first preset of each scene. */
const isLook = (name: string) =>
  /^(plain|unformed)-/.test(name) || (!(name in sceneEntries) && presets.some((preset) => preset.name === name));

// One test for many links, because each failed test restarts the browser.
test('each link of a scene or a feature has the recorded hash and picture', async ({ load }, testInfo) => {
  await expectLinks(load, UPDATE_LINKS ? chosen : chosen.filter((name) => !isLook(name)), testInfo);
});

test('each link of another look has the recorded hash and picture @long', async ({ load }, testInfo) => {
  await expectLinks(load, chosen.filter(isLook), testInfo);
});

async function expectLinks(load: LoadModule, names: readonly string[], testInfo: TestInfo): Promise<void> {
  test.setTimeout(1_200_000);
  const cases = await load<Cases>('/tests/visual/links.cases.ts');
  for (const name of names) {
    const recorded = links[name];
    const opened = await cases.evaluateHandle((module, link) => module.openLink(link), recorded.link);
    const { hash, notices } = await opened.evaluate((it) => ({ hash: it.hash, notices: it.notices }));
    const notified = notices.map(({ code, key }) => `${code} ${key}`).join(', ');
    const picture = await bytesOf(await opened.evaluateHandle((it) => it.picture));
    const path = `${FOLDER}${name}.png`;
    if (UPDATE_LINKS) {
      console.log(`${name}: ${changeOf(recorded.hash, hash)}, ${pictureChange(path, picture)}`);
      writeFileSync(path, picture);
      links[name] = { ...recorded, hash, notices: notified };
      writeFileSync(FILE, `${JSON.stringify(links, null, 2)}\n`);
    } else {
      expect.soft({ hash, notices: notified }, name).toEqual({ hash: recorded.hash, notices: recorded.notices });
      await expectSame(picture, readFileSync(path), { name, ...DIFFERENCE }, testInfo);
    }
  }
}

test('every preset has a link, whose hash is that of the list', () => {
  expect(Object.keys(links).length).toBeGreaterThanOrEqual(50);
  const list = JSON.parse(readFileSync(HASH_LIST, 'utf8')) as HashList;
  const recorded = presets.map(({ name }) => [links[name].link, links[name].hash]);
  expect(recorded).toEqual(presets.map(({ name }) => [`?t=2#v=1&preset=${name}`, list[name]['2']]));
});

function changeOf(before: string, after: string): string {
  return before === after ? 'same hash' : `hash ${before || 'of nothing'} is now ${after}`;
}

function pictureChange(path: string, picture: Buffer): string {
  if (!existsSync(path)) return 'first picture';
  const [before, after] = [readFileSync(path), picture].map((bytes) => PNG.sync.read(bytes));
  const { outliers, largest } = compare(after, before, 0);
  const share = (100 * outliers) / (before.width * before.height);
  return `${share.toFixed(2)} % of the pixels changed, by at most ${largest} of 255`;
}
