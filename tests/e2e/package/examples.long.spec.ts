/** The examples that are projects of their own, copied out of the repository and built on the packed tarball. */
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { bin, expect, expectTitle, test } from '../../support/freshProject.ts';
import { pixelsOf } from '../../support/pictures.ts';

const ROOT = fileURLToPath(new URL('../../..', import.meta.url));
/** What lit smoke of all examples has. */
const SMOKE = '#fff4e3';
const VITE = ['vite/bin/vite.js', 'dist'] as const;
/** The binary that builds an example and the folder that it writes, and the title of the page. */
const EXAMPLES = {
  game: [...VITE, 'Cartoon smoke in a small game'],
  lantern: [...VITE, 'Cartoon smoke lifts a lantern'],
  next: ['next/dist/bin/next', 'out', 'Cartoon smoke in Next.js'],
  product: [...VITE, 'Ember, a slow kettle'],
  react: [...VITE, 'Cartoon smoke in React Three Fiber'],
  'ring-game': [...VITE, 'A game of smoke rings'],
  scroll: [...VITE, 'The slow train: smoke by scrolling'],
  svelte: [...VITE, 'Cartoon smoke in Svelte'],
  three: [...VITE, 'Cartoon smoke in a three.js scene'],
  vite: [...VITE, 'Cartoon smoke with Vite'],
  vue: [...VITE, 'Cartoon smoke in Vue'],
} as const;
/** Versions by the names of packages. */
interface Dependencies {
  readonly dependencies: Record<string, string>;
  readonly devDependencies?: Record<string, string>;
}

const { version } = JSON.parse(readFileSync(join(ROOT, 'package.json'), 'utf8')) as { version: string };

test.use({ deviceScaleFactor: 1 });

/** The files of an example by their paths. */
function filesOf(name: string): Record<string, string> {
  const folder = join(ROOT, 'examples', name);
  const files = readdirSync(folder, { recursive: true, withFileTypes: true }).filter((entry) => entry.isFile());
  const paths = files.map(({ parentPath, name: file }) => join(parentPath, file));
  return Object.fromEntries(paths.map((path) => [path.slice(folder.length + 1), readFileSync(path, 'utf8')]));
}

test('all examples with a package.json are tested', () => {
  const folders = readdirSync(join(ROOT, 'examples'), { withFileTypes: true }).filter((entry) => entry.isDirectory());
  const projects = folders.filter(({ name }) => 'package.json' in filesOf(name)).map(({ name }) => name);
  expect(projects.sort()).toEqual(Object.keys(EXAMPLES));
});

for (const [name, [builder, folder, title]] of Object.entries(EXAMPLES)) {
  test(`${name}: a copy builds and draws smoke`, async ({ page, project }) => {
    const files = filesOf(name);
    const { dependencies, devDependencies = {} } = JSON.parse(files['package.json']) as Dependencies;
    expect(dependencies['cartoon-smoke']).toBe(version);
    delete dependencies['cartoon-smoke'];
    // The tarball takes the place of the published package.
    const packages = Object.entries({ ...dependencies, ...devDependencies }).map((each) => each.join('@'));
    const place = project(packages, { ...files, 'package.json': '{ "private": true, "type": "module" }' });
    bin(place, builder, 'build');
    await expectTitle(page, join(place, folder), title, async () => {
      await expect.poll(() => pixelsOf(page, SMOKE)).toBeGreaterThan(150);
    });
  });
}

test('cdn: a copy draws smoke', async ({ page, context, project }) => {
  const files = filesOf('cdn');
  const host = `https://unpkg.com/cartoon-smoke@${version}/`;
  expect(files['index.html']).toContain(host);
  const place = project([], files);
  await context.route(`${host}**`, (route) =>
    route.fulfill({
      path: join(place, 'node_modules/cartoon-smoke', route.request().url().slice(host.length)),
      headers: { 'access-control-allow-origin': '*' },
    }),
  );
  await expectTitle(page, place, 'Cartoon smoke without a bundler', async () => {
    await expect.poll(() => pixelsOf(page, SMOKE)).toBeGreaterThan(150);
  });
});
