import { fitPuff, type Stage, ShapeError, type PlainMesh, type PuffShape } from '../../index.ts';
import type { Editor } from '../editor/editor.ts';
import { create, textButton } from '../ui/dom.ts';
import type { Notices } from '../ui/notices.ts';
import { Progress } from '../ui/progress.ts';
import { strings } from '../strings.ts';
import {
  Color,
  LoadingManager,
  Mesh,
  type BufferGeometry,
  type MeshBasicMaterial,
  type Object3D,
  type Texture,
} from 'three';

/**
 * A mesh or a puff sheet from the user as puff shapes: chosen in the panel or dropped onto the page, and removable. The
 * panel also saves the present puffs as a sheet.
 */
export class OwnShape {
  /** Element for the panel. */
  readonly element: HTMLElement;
  private readonly editor: Editor;
  private readonly stage: Stage;
  private readonly notices: Notices;
  private readonly container: HTMLElement;
  private readonly caption = create('p', { class: 'own-shape-name', role: 'status' });
  private readonly back = textButton('quiet', strings.ownShape.back, () => this.remove());
  private working: AbortController | undefined;
  private shown: string | undefined;
  private shapes: readonly PuffShape[] | undefined;

  /** @param container parent of the progress bar */
  constructor(editor: Editor, stage: Stage, notices: Notices, container: HTMLElement) {
    this.editor = editor;
    this.stage = stage;
    this.notices = notices;
    this.container = container;
    const chooser = create('input', {
      type: 'file',
      accept: `${MESH_TYPES},.png`,
      multiple: true,
      hidden: true,
      'aria-label': strings.ownShape.choose,
    });
    chooser.addEventListener('change', () => {
      const files = [...(chooser.files ?? [])];
      if (files.length > 0) void this.open(files);
      chooser.value = '';
    });
    const choose = textButton('quiet', strings.ownShape.choose, () => chooser.click());
    const save = textButton('quiet', strings.ownShape.save, () => void this.save());
    const buttons = create('div', { class: 'own-shape-buttons' }, choose, this.back, save);
    this.element = create('div', { 'data-text': strings.ownShape.text }, this.caption, buttons, chooser);
    this.caption.hidden = this.back.hidden = true;
  }

  /** Name of the file whose shape is shown. */
  get name(): string | undefined {
    return this.shown;
  }

  /** Shows the default puffs, or drawn ones. */
  remove(): void {
    this.show();
  }

  /** Shows a mesh or a puff sheet, or reports why it cannot. Opening other files cancels work in progress. */
  async open(files: readonly File[]): Promise<void> {
    const [{ name }] = files;
    const isSheet = files.every((file) => /\.png$/i.test(file.name));
    await this.work(isSheet ? strings.ownShape.reading : strings.ownShape.fitting(name), async (signal) => {
      if (isSheet) {
        const { openSheet } = await import('./puffSheet.ts');
        const shapes = await openSheet(files, signal);
        this.show(name, shapes, strings.ownShape.sheet(name, shapes.length));
        this.showBillboards();
      } else {
        const { shape, overlap } = await fitPuff(await readMesh(files[0]), { name, signal });
        this.show(name, [shape], strings.ownShape.shown(name, overlap));
      }
    });
  }

  /** Lobes would only show the silhouettes of a sheet. */
  private showBillboards(): void {
    if (this.editor.state.values['puff.form'] === 'billboards') return;
    this.editor.change('puff.form', 'billboards');
    this.notices.mention(strings.ownShape.billboards);
  }

  private async save(): Promise<void> {
    await this.work(strings.ownShape.saving, async (signal) => {
      const { saveSheet } = await import('./puffSheet.ts');
      const { saved, all } = await saveSheet(this.stage, this.shapes, signal);
      this.notices.mention(strings.ownShape.saved(saved, all));
    });
  }

  /** Shows progress, and what failed. */
  private async work(message: string, task: (signal: AbortSignal) => Promise<void>): Promise<void> {
    this.working?.abort();
    const controller = (this.working = new AbortController());
    const progress = new Progress(message, () => controller.abort());
    this.container.append(progress.element);
    try {
      await task(controller.signal);
    } catch (error) {
      if (!controller.signal.aborted) this.notices.notify((error as Error).message);
    } finally {
      progress.element.remove();
    }
  }

  private show(name?: string, shapes?: readonly PuffShape[], caption = ''): void {
    this.stage.setPuffs(shapes);
    this.shown = name;
    this.shapes = shapes;
    this.caption.textContent = caption;
    this.caption.hidden = this.back.hidden = name === undefined;
  }
}

/** Loads mesh files as plain triangles. The loaders are fetched with the first file. */

/** File types for the file picker. */
const MESH_TYPES = '.glb,.gltf,.obj';
/** Maximum file size in bytes. A puff keeps little detail, so larger files bring no benefit. */
const MAX_BYTES = 16 * 1024 * 1024;
/** Maximum width and height of a texture; larger ones are scaled down. */
const MAX_PIXELS = 512;
const WHITE = new Color(1, 1, 1);

/** @throws ShapeError when the file is too large, has an unsupported type, or cannot be read */
async function readMesh(file: File): Promise<PlainMesh> {
  if (file.size > MAX_BYTES) {
    const size = (file.size / 1024 / 1024).toFixed(0);
    throw new ShapeError(
      `${file.name} has ${size} MB. The limit is ${MAX_BYTES / 1024 / 1024} MB. Simplify the mesh first.`,
    );
  }
  return trianglesOf(await objectIn(file));
}

async function objectIn(file: File): Promise<Object3D> {
  const kind = file.name.toLowerCase().split('.').at(-1);
  try {
    if (kind === 'obj') {
      const { OBJLoader } = await import('three/examples/jsm/loaders/OBJLoader.js');
      return new OBJLoader().parse(await file.text());
    }
    if (kind === 'glb' || kind === 'gltf') {
      const { GLTFLoader } = await import('three/examples/jsm/loaders/GLTFLoader.js');
      const { scene } = await new GLTFLoader(embeddedOnly()).parseAsync(await file.arrayBuffer(), '');
      return scene;
    }
  } catch (error) {
    throw new ShapeError(`${file.name} could not be read: ${(error as Error).message}`, { cause: error });
  }
  throw new ShapeError(`${file.name} is not a supported mesh. Use .glb, .gltf with embedded data, or .obj.`);
}

/** Rejects references to other files, local or on the web. */
function embeddedOnly(): LoadingManager {
  const manager = new LoadingManager();
  manager.setURLModifier((address) => {
    if (/^(data|blob):/.test(address)) return address;
    throw new Error('it refers to other files. Save it with embedded data, as .glb.');
  });
  return manager;
}

/** The triangles of all meshes in world space with their colours; with their texture, if all have the same. */
function trianglesOf(root: Object3D): PlainMesh {
  root.updateMatrixWorld(true);
  const meshes: Drawn[] = [];
  root.traverse((object) => {
    if (object instanceof Mesh) meshes.push(object as Drawn);
  });
  const all = { positions: [] as number[], indices: [] as number[], colors: [] as number[], uvs: [] as number[] };
  for (const mesh of meshes) addTriangles(mesh, all);
  const [map] = meshes.map(({ material }) => material.map);
  const hasTexture =
    map && meshes.every(({ material, geometry }) => material.map === map && geometry.hasAttribute('uv'));
  return { ...all, uvs: hasTexture ? all.uvs : undefined, texture: hasTexture ? pixelsOf(map) : undefined };
}

type Drawn = Mesh<BufferGeometry, MeshBasicMaterial>;

interface Triangles {
  readonly positions: number[];
  readonly indices: number[];
  readonly colors: number[];
  readonly uvs: number[];
}

function addTriangles({ geometry, material, matrixWorld: world }: Drawn, all: Triangles): void {
  const first = all.positions.length / 3;
  const { position, color, uv } = geometry.attributes;
  const places = position.clone().applyMatrix4(world);
  const paint = new Color();
  for (let vertex = 0; vertex < places.count; vertex++) {
    all.positions.push(places.getX(vertex), places.getY(vertex), places.getZ(vertex));
    paint.copy(material.color ?? WHITE);
    if (color) paint.multiply(new Color(color.getX(vertex), color.getY(vertex), color.getZ(vertex)));
    const { r, g, b } = paint.convertLinearToSRGB();
    all.colors.push(r, g, b);
    const down = uv?.getY(vertex) ?? 0;
    all.uvs.push(uv?.getX(vertex) ?? 0, material.map?.flipY ? 1 - down : down);
  }
  const corners = geometry.index?.array ?? Uint32Array.from({ length: places.count }, (_, vertex) => vertex);
  // A mirroring transform reverses the winding.
  const [second, third] = world.determinant() < 0 ? [2, 1] : [1, 2];
  for (let at = 0; at + 2 < corners.length; at += 3) {
    all.indices.push(first + corners[at], first + corners[at + second], first + corners[at + third]);
  }
}

/** The pixels of a texture, at most `MAX_PIXELS` along each side: a puff shows no more. */
function pixelsOf({ image }: Texture): ImageData {
  const { width, height } = image as ImageBitmap;
  const scale = Math.min(1, MAX_PIXELS / Math.max(width, height));
  const [columns, rows] = [width, height].map((length) => Math.max(1, Math.round(scale * length)));
  const copy = create('canvas', {});
  [copy.width, copy.height] = [columns, rows];
  const context = copy.getContext('2d')!;
  context.drawImage(image as ImageBitmap, 0, 0, columns, rows);
  return context.getImageData(0, 0, columns, rows);
}
