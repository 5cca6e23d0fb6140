/** Models of GLB files: dropped on the page, clicked for smoke, undone, saved and opened. */
import { readFileSync, writeFileSync } from 'node:fs';
import type { Page } from '@playwright/test';
import { expect, test } from '../../../support/fixtures.ts';
import { bendingColumn, turningBox, type GlbFile } from '../../../support/files/glb.ts';
import { ask, drop, expectValue, messagesOf, open, valueOf } from '../page.ts';

const BARE = '#v=1&preset=air&emission.rate=60&puff.variations=1&simulation.maxParticles=500';
const FIRST_PART = 4096;

/** Opens a paused page with its parameters. */
async function openBare(page: Page): Promise<void> {
  await open(page, `?paused=1${BARE}`);
  await page.keyboard.press('p');
}

/** The section of the panel. */
function section(page: Page) {
  return page.locator('details', { has: page.locator('summary', { hasText: /^Model$/ }) });
}

function caption(page: Page) {
  return section(page).locator('[role=status]');
}

/** Names of the parts of the model in the scene; undefined without one. */
function nodeNames(page: Page): Promise<string[] | undefined> {
  return ask(page, ({ model }) => model?.nodes.map(({ name }) => name));
}

/** Drops the box that turns and waits until it is shown. */
async function dropBox(page: Page, bytes = turningBox().pack()): Promise<void> {
  await drop(page, 'box.glb', bytes);
  await expect(caption(page)).toHaveText(/^box\.glb: 22 triangles, 2 materials/);
  // The last of all changes.
  await expect(section(page)).toHaveAttribute('open');
}

/** Where the picture shows a place of a node, in CSS pixels of the page. @param place in shares of the longest side of the model */
function placeOf(
  page: Page,
  name: string,
  place: readonly [number, number, number],
): Promise<{ x: number; y: number }> {
  return page.evaluate(
    ([wanted, shares]) => {
      const { model, sight } = window.cartoonSmoke!;
      const { rigid } = model!.nodes.find((node) => node.name === wanted)!;
      const longest = Math.max(...model!.box);
      const [x, y, z] = shares.map((share) => share * longest);
      const { left, top } = document.querySelector('canvas')!.getBoundingClientRect();
      const point = sight.project([x, y, z], rigid)!;
      return { x: left + point.x, y: top + point.y };
    },
    [name, place] as const,
  );
}

test('a dropped model is added to the scene, smokes from the surface that is clicked, and is undone', async ({
  page,
}) => {
  const requests: string[] = [];
  await openBare(page);
  page.on('request', (request) => requests.push(request.url()));
  await dropBox(page);
  expect(await nodeNames(page)).toEqual(expect.arrayContaining(['Top', 'Base']));
  await expect(section(page)).toHaveAttribute('open');

  // In the middle of the part that turns, and at its edge. The buttons cover the other part.
  for (const [index, [name, share]] of (
    [
      ['Top', [0, 0, 0.142]],
      ['Top', [0.28, 0.01, 0.142]],
    ] as const
  ).entries()) {
    const place = await placeOf(page, name, share);
    await page.mouse.click(place.x, place.y);
    const node = await page.evaluate(
      (wanted) => window.cartoonSmoke!.model!.nodes.find((each) => each.name === wanted)!,
      name,
    );
    const key = `emitters.${index + 1}`;
    await expectValue(page, `${key}.rigid`, node.rigid);
    expect(node.rigid).toBeGreaterThanOrEqual(FIRST_PART);
    // The emitter is where the pointer is.
    const seen = await page.evaluate((emitter) => {
      const stage = window.cartoonSmoke!;
      const values = stage.get() as Record<string, number>;
      const [x, y, z] = ['x', 'y', 'z'].map((axis) => values[`${emitter}.position.${axis}`]);
      const { left, top } = document.querySelector('canvas')!.getBoundingClientRect();
      const point = stage.sight.project([x, y, z], values[`${emitter}.rigid`])!;
      return { x: left + point.x, y: top + point.y };
    }, key);
    expect(Math.hypot(seen.x - place.x, seen.y - place.y)).toBeLessThan(2);
  }

  await ask(page, (stage) => stage.advance(0.5));
  expect(await ask(page, (stage) => stage.stats.alive)).toBeGreaterThan(10);

  // A drag turns the view, and does not add an emitter.
  const { x, y } = await placeOf(page, 'Top', [0, 0, 0.142]);
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 60, y, { steps: 3 });
  await page.mouse.up();
  expect(await valueOf(page, 'emitters.3.rigid')).toBeUndefined();

  const undo = page.getByRole('button', { name: 'Undo' });
  for (let times = 0; times < 3; times++) await undo.click();
  await expectValue(page, 'emitters.1.rigid', undefined);
  expect(await nodeNames(page)).toBeDefined();
  await undo.click();
  await expect.poll(() => nodeNames(page)).toBeUndefined();
  await expect(caption(page)).toHaveText('Drop a GLB file on the page to add it to the scene.');
  await page.getByRole('button', { name: 'Redo' }).click();
  await expect(caption(page)).toHaveText(/^box\.glb/);
  await page.getByRole('button', { name: 'Remove the model' }).click();
  await expect.poll(() => nodeNames(page)).toBeUndefined();
  expect(
    requests.filter((url) => new URL(url).origin !== new URL(page.url()).origin && !/^(data|blob):/.test(url)),
  ).toEqual([]);
});

test('place, animation and smoke of a model are changed by keys alone', async ({ page }) => {
  await openBare(page);
  await section(page).locator('summary').click();
  await section(page)
    .getByLabel('Choose a GLB file')
    .last()
    .setInputFiles({ name: 'column.glb', mimeType: 'model/gltf-binary', buffer: Buffer.from(bendingColumn().pack()) });
  await expect(caption(page)).toHaveText(/^column\.glb/);
  const boxOf = () => ask(page, ({ model }) => model?.box.map((side) => Number(side.toFixed(2))));

  const size = section(page).getByLabel('Size, exact value');
  await size.fill('1.5');
  await size.press('Enter');
  await expect.poll(async () => Math.max(...((await boxOf()) ?? []))).toBe(1.5);
  await expect(section(page).getByRole('slider', { name: 'Size' })).toHaveAttribute('aria-valuetext', '1.5 m');

  const heightNow = () => ask(page, ({ model, sight }) => sight.project([0, 0, 0], model!.nodes[0].rigid)!.y);
  const before = await heightNow();
  const height = section(page).getByLabel('Position y, exact value');
  await height.fill('2');
  await height.press('Enter');
  await expect.poll(heightNow).not.toBeCloseTo(before, 0);

  const animation = section(page).getByLabel('Animation', { exact: true });
  await expect(animation).toHaveValue('Bend');
  await animation.focus();
  await page.keyboard.press('ArrowDown');
  await expect(animation).toHaveValue('');
  await expect.poll(() => page.evaluate(() => document.activeElement?.tagName)).toBe('SELECT');

  const node = section(page).getByLabel('Part that smokes');
  const names = (await nodeNames(page))!;
  await node.selectOption(names.at(-1)!);
  await section(page).getByRole('button', { name: 'Add smoke' }).focus();
  await page.keyboard.press('Enter');
  const rigid = await ask(page, ({ model }) => model!.nodes.at(-1)!.rigid);
  await expectValue(page, 'emitters.1.rigid', rigid);
});

test('a smoke file holds the model and restores it; a link names it as what it cannot hold', async ({
  page,
}, testInfo) => {
  await openBare(page);
  const bytes = turningBox().pack();
  await dropBox(page, bytes);
  const { x, y } = await placeOf(page, 'Top', [0, 0, 0.142]);
  await page.mouse.click(x, y);
  await expect.poll(() => valueOf(page, 'emitters.1.rigid')).toBeGreaterThanOrEqual(FIRST_PART);
  const state = () => ask(page, (stage) => ({ model: stage.model, values: stage.get() }));
  const before = await state();

  await page.getByRole('button', { name: 'Share' }).click();
  const dialog = page.getByRole('dialog');
  await expect(
    dialog.getByText('A link cannot contain the model box.glb. Save it as a file instead, which contains the model.'),
  ).toBeVisible();
  const downloading = page.waitForEvent('download');
  await dialog.getByRole('button', { name: 'Save as file' }).click();
  const file = testInfo.outputPath('saved.json');
  await (await downloading).saveAs(file);
  await page.keyboard.press('Escape');

  await openBare(page);
  expect(await nodeNames(page)).toBeUndefined();
  await drop(page, 'saved.json', readFileSync(file));
  await expect(caption(page)).toHaveText(/^box\.glb: 22 triangles/);
  await expect.poll(state).toEqual(before);

  // Another preset keeps it, a file without a model removes it.
  await ask(page, (stage) => stage.stats);
  const { model: _model, ...bare } = JSON.parse(readFileSync(file, 'utf8')) as Record<string, unknown>;
  await drop(page, 'bare.json', JSON.stringify(bare));
  await expect.poll(() => nodeNames(page)).toBeUndefined();
  await drop(page, 'torn.json', JSON.stringify({ ...bare, model: { name: 'box.glb', glb: 'AwA', options: {} } }));
  await expect(page.getByText(/torn\.json could not be opened\. The model cannot be used/)).toBeVisible();
  await drop(
    page,
    'size.json',
    JSON.stringify({
      ...(JSON.parse(readFileSync(file, 'utf8')) as object),
      model: { ...(_model as object), options: { size: 1e9 } },
    }),
  );
  await expect(page.getByText(/size\.json could not be opened\. .*size/)).toBeVisible();
  expect(await nodeNames(page)).toBeUndefined();
});

/** A box with changes to its JSON. */
function boxWith(change: (json: GlbFile['json']) => void): Uint8Array {
  const file = turningBox();
  change(file.json);
  return file.pack();
}

/** A box whose upper part has this many triangles, with 10 below it. The file does not contain their indices, so it is small. */
function denseBox(triangles: number): Uint8Array {
  return boxWith((json) => {
    const count = 3 * triangles;
    const indices = json.accessors.push({ componentType: 5125, count, type: 'SCALAR' }) - 1;
    Object.assign(json.meshes[0].primitives[0], { indices });
  });
}

const HOSTILE: readonly (readonly [name: string, bytes: () => Uint8Array, words: RegExp])[] = [
  ['text.glb', () => new TextEncoder().encode('solid, but no model at all'), /not a GLB file/],
  ['empty.glb', () => new Uint8Array(), /not a GLB file/],
  ['cut.glb', () => turningBox().pack().slice(0, 400), /cut off/],
  [
    'away.glb',
    () => boxWith((json) => (json.buffers = [{ uri: 'https://example.org/box.bin', byteLength: 9 }])),
    /in another file/,
  ],
  ['draco.glb', () => boxWith((json) => (json.extensionsRequired = ['KHR_draco_mesh_compression'])), /Draco/],
  ['meshopt.glb', () => boxWith((json) => (json.extensionsRequired = ['EXT_meshopt_compression'])), /meshopt/],
  [
    'paint.glb',
    () => boxWith((json) => (json.materials = Array.from({ length: 65 }, () => ({})))),
    /65 materials\. At most 64/,
  ],
  ['dense.glb', () => denseBox(199_991), /200001 triangles or more\. At most 200,000/],
  ['crowd.glb', () => boxWith((json) => json.nodes.push(...Array.from({ length: 4_000 }, () => ({})))), /At most 4000/],
  ['none.glb', () => boxWith((json) => (json.nodes = [{ name: 'Nothing' }, { name: 'Nobody' }])), /no triangles/],
  ['loop.glb', () => boxWith((json) => (json.nodes[1].children = [0])), /has a parent/],
];

test('files that cannot be used are refused with the reason, without a request, and the model before stays', async ({
  page,
}, testInfo) => {
  await openBare(page);
  await dropBox(page);
  const requests: string[] = [];
  page.on('request', (request) => requests.push(request.url()));
  for (const [name, bytes, words] of HOSTILE) {
    const messages = await messagesOf(page);
    await drop(page, name, bytes());
    await expect.poll(async () => (await messages()).join('\n'), { message: name }).toMatch(words);
    expect((await messages()).join('\n')).toContain(`${name} could not be opened.`);
  }
  // Passed by its path, because Playwright encodes a buffer in base64.
  const huge = testInfo.outputPath('huge.glb');
  writeFileSync(huge, Buffer.alloc(33 * 1024 * 1024));
  await section(page).getByLabel('Choose a GLB file').last().setInputFiles(huge);
  await expect(page.getByText('huge.glb could not be opened. It has 33 MB. The limit is 32 MB.')).toBeVisible();
  await expect(caption(page)).toHaveText(/^box\.glb/);
  expect(await nodeNames(page)).toEqual(expect.arrayContaining(['Top', 'Base']));
  expect(requests.filter((url) => !/^(data|blob):/.test(url))).toEqual([]);
  // The page still runs.
  const before = await ask(page, (stage) => stage.hash());
  await ask(page, (stage) => stage.advance(0.5));
  expect(await ask(page, (stage) => stage.hash())).not.toBe(before);
});
