import { readFileSync, writeFileSync } from 'node:fs';
import { PNG } from 'pngjs';
import { expect, test } from '../../../support/fixtures.ts';
import { ask, expectSteps, LIGHT, open } from '../page.ts';

const CORNERS = [0, 1, 2, 3, 4, 5, 6, 7].map((corner) => [corner & 1, (corner >> 1) & 1, corner >> 2]);
/** Four corners each, counter-clockwise from outside. */
const SIDES = [
  [0, 2, 3, 1],
  [4, 5, 7, 6],
  [0, 1, 5, 4],
  [2, 6, 7, 3],
  [0, 4, 6, 2],
  [1, 3, 7, 5],
];

/** A cube as an OBJ file. @param sides number of its sides */
function cubeObject(name: string, sides = 6) {
  const lines = [
    ...CORNERS.map((corner) => `v ${corner.join(' ')}`),
    ...SIDES.slice(0, sides).map((side) => `f ${side.map((corner) => corner + 1).join(' ')}`),
  ];
  return { name, mimeType: 'model/obj', buffer: Buffer.from(lines.join('\n')) };
}

/** A glTF file of the cube in yellow with a magenta texture, whose product is red. */
function redCube(name: string) {
  const scene = JSON.parse(cubeScene(name).buffer.toString()) as Record<string, object[]>;
  const pixel = new PNG({ width: 1, height: 1 });
  pixel.data.set([255, 0, 255, 255]);
  const uvs = Buffer.from(new Float32Array(2 * CORNERS.length).buffer);
  scene.images = [{ uri: `data:image/png;base64,${PNG.sync.write(pixel).toString('base64')}` }];
  scene.textures = [{ source: 0 }];
  const pbrMetallicRoughness = { baseColorFactor: [1, 1, 0, 1], baseColorTexture: { index: 0 } };
  scene.materials = [{ pbrMetallicRoughness }];
  scene.buffers.push({ byteLength: uvs.length, uri: `data:application/octet-stream;base64,${uvs.toString('base64')}` });
  scene.bufferViews.push({ buffer: 1, byteOffset: 0, byteLength: uvs.length });
  scene.accessors.push({ bufferView: 2, componentType: 5126, count: CORNERS.length, type: 'VEC2' });
  const attributes = { POSITION: 0, TEXCOORD_0: 2 };
  scene.meshes = [{ primitives: [{ attributes, indices: 1, material: 0 }] }];
  return { name, mimeType: 'model/gltf+json', buffer: Buffer.from(JSON.stringify(scene)) };
}

/** The cube as a glTF file. @param address URL of its buffer; embedded where absent */
function cubeScene(name: string, address?: string) {
  const triangles = SIDES.flatMap(([a, b, c, d]) => [a, b, c, a, c, d]);
  const [places, corners] = [Float32Array.from(CORNERS.flat()), Uint16Array.from(triangles)];
  const bytes = Buffer.concat([Buffer.from(places.buffer), Buffer.from(corners.buffer)]);
  const scene = {
    asset: { version: '2.0' },
    scene: 0,
    scenes: [{ nodes: [0] }],
    // Mirrored and stretched: tests that node transforms are applied.
    nodes: [{ mesh: 0, scale: [-1, 1, 3] }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0 }, indices: 1 }] }],
    accessors: [
      { bufferView: 0, componentType: 5126, count: 8, type: 'VEC3', min: [0, 0, 0], max: [1, 1, 1] },
      { bufferView: 1, componentType: 5123, count: 36, type: 'SCALAR' },
    ],
    bufferViews: [
      { buffer: 0, byteOffset: 0, byteLength: places.byteLength },
      { buffer: 0, byteOffset: places.byteLength, byteLength: corners.byteLength },
    ],
    buffers: [
      { byteLength: bytes.length, uri: address ?? `data:application/octet-stream;base64,${bytes.toString('base64')}` },
    ],
  };
  return { name, mimeType: 'model/gltf+json', buffer: Buffer.from(JSON.stringify(scene)) };
}

test('a mesh replaces the puffs, the link reports that it cannot contain it, and the default puffs can be restored', async ({
  page,
}) => {
  await open(page, `?paused=1&t=2${LIGHT}`);
  await expectSteps(page, 120);
  await page.keyboard.press('p');
  await page.locator('summary', { hasText: 'Shape of the puffs' }).click();
  const chooser = page.getByLabel('Use your own mesh');
  const hash = await ask(page, (stage) => stage.hash());
  await chooser.last().setInputFiles(cubeObject('cube.obj'));
  const name = page.locator('.own-shape-name');
  await expect(name).toHaveText(/^cube\.obj, [89]\d % match$/);
  expect(await ask(page, (stage) => stage.hash())).toBe(hash);
  await page.getByRole('button', { name: 'Share' }).click();
  await expect(
    page.getByText('A link cannot contain a mesh. It shows the default puffs instead of cube.obj.'),
  ).toBeVisible();
  await page.keyboard.press('Escape');
  await page.getByRole('button', { name: 'Use the default puffs' }).click();
  await expect(name).toBeHidden();
  await chooser.last().setInputFiles(cubeScene('bar.gltf'));
  await expect(name).toHaveText(/^bar\.gltf, [789]\d % match$/);
});

test('billboards have the colours and the texture of a mesh @long', async ({ page }) => {
  await open(page, `?paused=1&t=2${LIGHT}&puff.form=billboards`);
  await page.keyboard.press('p');
  await page.locator('summary', { hasText: 'Shape of the puffs' }).click();
  const redPixels = () =>
    ask(page, async (stage) => {
      const bitmap = await createImageBitmap(await stage.picture());
      const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d')!;
      context.drawImage(bitmap, 0, 0);
      const { data } = context.getImageData(0, 0, bitmap.width, bitmap.height);
      let count = 0;
      for (let at = 0; at < data.length; at += 4) if (data[at] > 60 && data[at + 1] + data[at + 2] < 8) count++;
      return count;
    });
  expect(await redPixels()).toBe(0);
  await page.getByLabel('Use your own mesh').last().setInputFiles(redCube('red.gltf'));
  await expect(page.locator('.own-shape-name')).toHaveText(/^red\.gltf/);
  expect(await redPixels()).toBeGreaterThan(30);
});

/** A PNG. @param pixelAt for places from -1 to 1, x to the right and y up */
function picture(name: string, size: number, pixelAt: (x: number, y: number) => readonly number[]) {
  const png = new PNG({ width: size, height: size });
  for (let at = 0; at < size * size; at++) {
    const [x, y] = [at % size, Math.floor(at / size)].map((pixel) => (2 * (pixel + 0.5)) / size - 1);
    png.data.set(pixelAt(x, -y), 4 * at);
  }
  return { name, mimeType: 'image/png', buffer: PNG.sync.write(png) };
}

const BALL = 0.7;
const heightOf = (x: number, y: number) => Math.sqrt(Math.max(0, BALL * BALL - x * x - y * y));
/** A red ball of a puff sheet, whose colours are black, and whose normals are those of its middle, where it ends. */
const BALL_NORMALS = picture('ball-n.png', 64, (x, y) => {
  const z = heightOf(x, y);
  return [...(z > 0 ? [x, y, z] : [0, 0, BALL]).map((axis) => 127.5 * (axis / BALL + 1)), 127.5 + (255 * z) / 2];
});
const BALL_COLORS = picture('ball-c.png', 64, (x, y) => (heightOf(x, y) > 0 ? [255, 0, 0, 255] : [0, 0, 0, 0]));

test('puff sheets are opened as one or two PNGs, and saved without loss @long', async ({ page }, testInfo) => {
  await open(page, `?paused=1&t=2${LIGHT}`);
  await page.keyboard.press('p');
  await page.locator('summary', { hasText: 'Shape of the puffs' }).click();
  const chooser = page.getByLabel('Use your own mesh or puff sheet').last();
  const name = page.locator('.own-shape-name');
  const hash = await ask(page, (stage) => stage.hash());

  // In any order.
  await chooser.setInputFiles([BALL_COLORS, BALL_NORMALS]);
  await expect(name).toHaveText('ball-c.png, one puff');
  expect(await ask(page, (stage) => [stage.get()['puff.form'], stage.hash()])).toEqual(['billboards', hash]);

  const saved = new Map<string, string>();
  page.on('download', (download) => {
    const file = testInfo.outputPath(download.suggestedFilename());
    void download.saveAs(file).then(() => saved.set(download.suggestedFilename(), file));
  });
  await page.getByRole('button', { name: 'Save puff sheet' }).click();
  await expect.poll(() => saved.size).toBe(2);
  const files = ['puffs-normal-depth.png', 'puffs-color-coverage.png'].map((file) => saved.get(file)!);
  const [normals, colors] = files.map((file) => PNG.sync.read(readFileSync(file)));
  expect([normals.width, colors.height]).toEqual([256, 256]);
  // The upper right of the ball, and the corner, which has colours in spite of its alpha of 0.
  const [shown, corner] = [4 * (88 * 256 + 168), 0];
  const [x, y] = [40.5 / 128, 39.5 / 128];
  const expected = [x / BALL, y / BALL, heightOf(x, y) / BALL].map((axis) => 127.5 * (axis + 1));
  expected.forEach((byte, at) => expect(Math.abs(normals.data[shown + at] - byte)).toBeLessThan(3));
  expect(Math.abs(normals.data[shown + 3] - 127.5 - 127.5 * heightOf(x, y))).toBeLessThan(3);
  expect([...colors.data.subarray(shown, shown + 4)]).toEqual([255, 0, 0, 255]);
  expect([...colors.data.subarray(corner, corner + 4)]).toEqual([255, 0, 0, 0]);

  await page.getByRole('button', { name: 'Share' }).click();
  await expect(page.getByText('A link cannot contain a puff sheet.')).toBeVisible();
  await page.keyboard.press('Escape');
  await chooser.setInputFiles(files);
  await expect(name).toHaveText('puffs-normal-depth.png, one puff');

  const packed = picture('packed.png', 64, (right, up) => {
    const z = heightOf(right, up);
    return [0, 255, (255 * z) / BALL, z > 0 ? 255 : 0];
  });
  await page.evaluate(
    ([base64, file]) => {
      const dataTransfer = new DataTransfer();
      dataTransfer.items.add(new File([Uint8Array.from(atob(base64), (byte) => byte.charCodeAt(0))], file));
      document
        .querySelector('canvas')!
        .dispatchEvent(new DragEvent('drop', { dataTransfer, bubbles: true, cancelable: true }));
    },
    [packed.buffer.toString('base64'), packed.name],
  );
  await page
    .getByRole('dialog')
    .getByRole('button', { name: /^Puff sheet/ })
    .click();
  await expect(name).toHaveText('packed.png, one puff');

  for (const [wrong, words] of [
    [[BALL_NORMALS], /ball-n\.png has normals and depths\. Open it together/],
    [[BALL_COLORS, BALL_COLORS], /Neither of the two images has normals/],
    [[BALL_COLORS, BALL_NORMALS, packed], /one or two images, not 3/],
    [[{ ...packed, name: 'text.png', buffer: Buffer.from('text') }], /text\.png is not a PNG/],
    [[picture('none.png', 64, () => [9, 9, 9, 0])], /The puff sheet is empty/],
  ] as const) {
    await chooser.setInputFiles([...wrong]);
    await expect(page.getByText(words)).toBeVisible();
    await expect(name).toHaveText('packed.png, one puff');
  }
  await page.getByRole('button', { name: 'Use the default puffs' }).click();
  await expect(name).toBeHidden();
});

test('an open or invalid mesh is rejected with a message and the puffs stay, until a mesh is dropped on the page @long', async ({
  page,
}, testInfo) => {
  await open(page, `?paused=1${LIGHT}`);
  await page.keyboard.press('p');
  await page.locator('summary', { hasText: 'Shape of the puffs' }).click();
  const chooser = page.getByLabel('Use your own mesh').last();
  const rejected = async (file: string | ReturnType<typeof cubeObject>, words: RegExp) => {
    await chooser.setInputFiles(file);
    await expect(page.getByText(words)).toBeVisible();
  };
  await rejected(cubeObject('lid.obj', 5), /The mesh is open: 4 of its 17 edges/);
  await rejected(cubeObject('empty.obj', 0), /empty/);
  await rejected({ ...cubeObject('cube.stl'), name: 'cube.stl' }, /cube\.stl is not a supported mesh\./);
  await rejected(
    { name: 'torn.glb', mimeType: 'model/gltf-binary', buffer: Buffer.from('glTF') },
    /torn\.glb could not be read/,
  );
  await rejected(cubeScene('parts.gltf', 'https://example.org/cube.bin'), /refers to other files/);
  // Passed by its path, because Playwright encodes a buffer in base64.
  const huge = testInfo.outputPath('huge.obj');
  writeFileSync(huge, Buffer.alloc(17 * 1024 * 1024, ' '));
  await rejected(huge, /huge\.obj has 17 MB\. The limit is 16 MB\./);
  await expect(page.locator('.own-shape-name')).toBeHidden();
  await page.evaluate((text) => {
    const dataTransfer = new DataTransfer();
    dataTransfer.items.add(new File([text], 'dropped.obj'));
    document
      .querySelector('canvas')!
      .dispatchEvent(new DragEvent('drop', { dataTransfer, bubbles: true, cancelable: true }));
  }, cubeObject('dropped.obj').buffer.toString());
  await expect(page.locator('.own-shape-name')).toHaveText(/^dropped\.obj/);
});
