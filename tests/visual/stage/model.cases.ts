/** Models of GLB files on a stage. Runs inside a page. */
import type { ModelOptions } from '../../../src/stage/contract.ts';
import { createStage, type Stage } from '../../../src/stage/stage.ts';
import { bendingColumn, GlbFile, house, turningBox } from '../../support/files/glb.ts';
import { differing, pixelsOf } from './stage.cases.ts';

const [WIDTH, HEIGHT] = [320, 240];
const VALUES = { scene: 'campfire', 'emission.rate': 5, 'puff.variations': 1 } as const;
const PLACE: ModelOptions = { position: { x: 1.3, y: 0, z: 1.2 }, size: 1.6 };
const FILES = { turningBox, bendingColumn, sheet, fan };

export type FileName = keyof typeof FILES;

/** A square without thickness, seen from its back at first, which turns about y. */
function sheet(): GlbFile {
  const file = new GlbFile();
  file.json.materials = [{ pbrMetallicRoughness: { baseColorFactor: [1, 0, 0, 1] } }];
  const node = file.node({
    mesh: file.mesh(file.box([0.02, 0.8, 0.8], [0, 2, 3, 4, 5], 0)),
    rotation: [0, Math.SQRT1_2, 0, Math.SQRT1_2],
  });
  file.animate(
    'Turn',
    node,
    'rotation',
    [0, 2, 4],
    [0, Math.SQRT1_2, 0, Math.SQRT1_2, 0, Math.SQRT1_2, 0, -Math.SQRT1_2, 0, -Math.SQRT1_2, 0, -Math.SQRT1_2],
  );
  return file;
}

/** Three squares that share an edge, which enclose nothing. */
function fan(): GlbFile {
  const file = new GlbFile();
  const values = [0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 0, -0.5, 0, 0.8, -0.5, 1, 0.8, -0.5, 0, -0.8, -0.5, 1, -0.8];
  const indices = [0, 2, 3, 0, 3, 1, 0, 4, 5, 0, 5, 1, 0, 6, 7, 0, 7, 1];
  const primitive = {
    attributes: { POSITION: file.accessor({ values, type: 'VEC3' }) },
    indices: file.accessor({ values: indices, type: 'SCALAR', component: 5123 }),
  };
  file.node({ mesh: file.mesh(primitive) });
  return file;
}

async function begin(name?: FileName, options: ModelOptions = {}): Promise<Stage> {
  const stage = await createStage(new OffscreenCanvas(WIDTH, HEIGHT), { values: VALUES });
  if (name) await stage.setModel(FILES[name]().pack(), { ...PLACE, ...options });
  return stage;
}

async function picture(stage: Stage): Promise<Uint32Array> {
  return pixelsOf(await stage.picture());
}

/** A house among the trees of the campfire, with smoke from its chimney. */
export async function housePicture(): Promise<Blob> {
  const values = {
    scene: 'campfire',
    'camera.azimuth': 12,
    'camera.elevation': 16,
    'camera.distance': 9,
    'camera.target.y': 1.7,
    'puff.variations': 4,
    'style.outlineWidth': 1.4,
  } as const;
  const stage = await createStage(new OffscreenCanvas(720, 405), { values });
  const model = await stage.setModel(house().pack(), { position: { x: 1.1, y: 0, z: 1.1 }, size: 1.7, turn: -0.5 });
  const { rigid } = model!.nodes.find(({ name }) => name === 'Chimney')!;
  stage.set({
    'emitters.0.rigid': rigid,
    'emitters.0.position.x': 0,
    'emitters.0.position.y': 0.3,
    'emitters.0.position.z': 0,
  });
  stage.step(330);
  const blob = await stage.picture();
  stage.dispose();
  return blob;
}

/** Pixels that change by the model, by its shadow and by its outlines, and those that are red, before and after two seconds. */
export async function changes(name: FileName) {
  const found = { model: 0, shadow: 0, ink: 0, red: [0, 0] };
  const [empty, whole, shadeless, inkless] = await Promise.all([
    begin(),
    begin(name),
    begin(name, { casts: false }),
    begin(name, { inked: false }),
  ]);
  const first = await picture(whole);
  for (const stage of [empty, whole, shadeless, inkless]) stage.step(120);
  const [without, all, lit, plain] = [
    await picture(empty),
    await picture(whole),
    await picture(shadeless),
    await picture(inkless),
  ];
  for (const stage of [empty, whole, shadeless, inkless]) stage.dispose();
  found.model = differing(all, without);
  found.shadow = differing(all, lit);
  found.ink = differing(all, plain);
  found.red = [first, all].map(redOf);
  return found;
}

function redOf(drawn: Uint32Array): number {
  const pixels = new Uint8Array(drawn.buffer);
  let red = 0;
  for (let at = 0; at < pixels.length; at += 4)
    if (pixels[at] > 120 && pixels[at + 1] < 30 && pixels[at + 2] < 30) red++;
  return red;
}

/** What `setModel` keeps, and what it gives back. */
export async function life() {
  const stage = await begin('turningBox');
  const names = [...stage.partNames];
  stage.step(30);
  const [played, hash] = [stage.model, stage.hash()];
  const shown = await picture(stage);
  await stage.seek(2);
  await stage.seek(0.5);
  const sought = stage.hash();
  const point = stage.sight.project([1.3, 0.4, 1.2])!;
  const picked = stage.pickModel(point.x, point.y);
  const missed = stage.pickModel(1, 1);
  const twin = await stage.copy(new OffscreenCanvas(WIDTH, HEIGHT));
  const copied = { hash: twin.hash(), differing: differing(await picture(twin), shown) };
  twin.dispose();
  await stage.enter({ ...VALUES, scene: 'wisp' });
  const elsewhere = stage.model?.triangles;
  await stage.setModel(null);
  const removed = stage.model;
  stage.dispose();
  return { names, played, hash, sought, picked, missed, copied, elsewhere, removed };
}

/** The names of errors, whether the picture stays, and whether the stage still runs. */
export async function refused(files: readonly number[][]) {
  const stage = await begin('turningBox');
  stage.step(10);
  const before = await picture(stage);
  const errors: string[] = [];
  for (const bytes of files) {
    await stage
      .setModel(Uint8Array.from(bytes))
      .catch((error: Error) => errors.push(`${error.name}: ${error.message}`));
  }
  await stage
    .setModel(turningBox().pack(), { size: -1 })
    .catch((error: Error) => errors.push(`${error.name}: ${error.message}`));
  const after = await picture(stage);
  stage.step(10);
  const { steps } = stage.stats;
  stage.dispose();
  return { errors, differing: differing(before, after), steps };
}

/** Bytes of a file that refers to other files. */
export function referring(): number[] {
  const file = turningBox();
  file.json.images = [{ uri: 'https://example.org/secret.png' }, { uri: 'other.png' }];
  file.json.textures = [{ source: 0 }, { source: 1 }];
  file.json.materials[0].pbrMetallicRoughness.baseColorTexture = { index: 0 };
  file.json.materials[1].pbrMetallicRoughness.baseColorTexture = { index: 1 };
  return [...file.pack()];
}

/** The notices of a file. */
export async function noticesOf(bytes: readonly number[]): Promise<readonly string[]> {
  const stage = await begin();
  const model = await stage.setModel(Uint8Array.from(bytes));
  stage.dispose();
  return model!.notices;
}

/** Pixels that a lost and restored context changes. */
export async function lostContext(): Promise<number> {
  const canvas = new OffscreenCanvas(WIDTH, HEIGHT);
  const stage = await createStage(canvas, { values: VALUES });
  await stage.setModel(bendingColumn().pack(), PLACE);
  stage.step(50);
  const before = await picture(stage);
  const extension = canvas.getContext('webgl2')!.getExtension('WEBGL_lose_context')!;
  const happens = (event: string) => new Promise((resolve) => canvas.addEventListener(event, resolve, { once: true }));
  const lost = happens('webglcontextlost');
  extension.loseContext();
  await lost;
  await new Promise((resolve) => setTimeout(resolve));
  const restored = happens('webglcontextrestored');
  extension.restoreContext();
  await restored;
  const after = await picture(stage);
  stage.dispose();
  return differing(before, after);
}

/** The colour of a primitive with a texture of half red and half blue, of which it uses the red half. */
export async function textureColor(): Promise<number[]> {
  const canvas = new OffscreenCanvas(64, 64);
  const context = canvas.getContext('2d')!;
  context.fillStyle = '#d02010';
  context.fillRect(0, 0, 32, 64);
  context.fillStyle = '#0000ff';
  context.fillRect(32, 0, 32, 64);
  const image = new Uint8Array(await (await canvas.convertToBlob()).arrayBuffer());
  const file = new GlbFile();
  const primitive = file.box([0.5, 0.5, 0.5], [], 0);
  const corners = Array.from({ length: 48 }, (_, at) => (at % 2 === 0 ? [0.1, 0.4][(at >> 1) % 2] : 0.5));
  primitive.attributes.TEXCOORD_0 = file.accessor({ values: corners, type: 'VEC2' });
  file.json.images = [{ bufferView: file.view(image), mimeType: 'image/png' }];
  file.json.textures = [{ source: 0 }];
  file.json.materials = [{ pbrMetallicRoughness: { baseColorTexture: { index: 0 } } }];
  file.node({ mesh: file.mesh(primitive) });
  const stage = await createStage(new OffscreenCanvas(WIDTH, HEIGHT), { values: VALUES });
  await stage.setModel(file.pack(), PLACE);
  const [...color] = stage.running.opened.scene.surfaces.find(({ name }) => name === 'model 0')!.color;
  stage.dispose();
  return color;
}
