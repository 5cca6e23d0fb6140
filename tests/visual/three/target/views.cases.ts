/** Cameras as other libraries set them: their picture is that of an ordinary camera with the same product of matrices. */
import {
  Camera,
  Group,
  Matrix4,
  Mesh,
  MeshStandardMaterial,
  OrthographicCamera,
  PlaneGeometry,
  type PerspectiveCamera,
} from 'three';
import {
  changedPixels,
  dispose,
  draw,
  emptyHost,
  HEIGHT,
  makeRenderer,
  smokeIn,
  WIDTH,
  type Host,
  type Pixels,
} from '../scene.ts';
import { keepPrograms } from '../../pageDevice.ts';

/** A camera with the view in the projection, as map layers have it. */
function ofProduct(camera: Camera, change: (clip: Matrix4) => Matrix4 = (clip) => clip): Camera {
  const plain = new Camera();
  plain.projectionMatrix.copy(change(camera.projectionMatrix.clone().multiply(camera.matrixWorldInverse)));
  plain.projectionMatrixInverse.copy(plain.projectionMatrix).invert();
  return plain;
}

/** In units of the width of the world from a corner of the map, y downwards, as maps have them. */
const METRES = 1 / 4e7;
const fromMercator = (clip: Matrix4) => {
  const mercator = new Matrix4().makeScale(METRES, -METRES, METRES).setPosition(0.53, 0.34, 0);
  return clip.multiply(mercator.clone().invert()).multiply(mercator);
};
const float32 = (clip: Matrix4) => clip.fromArray(Float32Array.from(clip.elements));
const scaled = (factor: number) => (clip: Matrix4) => clip.multiplyScalar(factor);

function orthographic(near = 0.1, far = 50): OrthographicCamera {
  const camera = new OrthographicCamera(-2.2, 2.2, 1.6, -1.6, near, far);
  camera.position.set(0.4, 2.2, 4.2);
  camera.lookAt(0, 0.8, 0);
  camera.updateMatrixWorld();
  return camera;
}

function offAxis(camera: PerspectiveCamera): PerspectiveCamera {
  camera.setViewOffset(WIDTH, HEIGHT, 25, -11, WIDTH, HEIGHT);
  return camera;
}

function inParent(camera: PerspectiveCamera, set: (parent: Group) => void): PerspectiveCamera {
  const parent = new Group();
  set(parent);
  parent.add(camera);
  parent.updateMatrixWorld();
  return camera;
}

/** Looks straight down, so that the axes of the view are those of the world. */
function above(camera: PerspectiveCamera): PerspectiveCamera {
  camera.position.set(0, 6, 0);
  camera.rotation.set(-Math.PI / 2, 0, 0);
  camera.updateMatrixWorld();
  return camera;
}

function endless(camera: PerspectiveCamera): PerspectiveCamera {
  camera.projectionMatrix.elements[10] = -1;
  camera.projectionMatrix.elements[14] = -2 * camera.near;
  return camera;
}

type Pair = readonly [Camera, Camera];

/** Cameras that show the same. */
export const CAMERAS: Readonly<Record<string, (camera: PerspectiveCamera) => Pair>> = {
  'perspective in the projection': (camera) => [camera, ofProduct(camera)],
  'single precision': (camera) => [camera, ofProduct(camera, float32)],
  mercator: (camera) => [camera, ofProduct(camera, fromMercator)],
  'mercator of single precision': (camera) => [camera, ofProduct(camera, (clip) => float32(fromMercator(clip)))],
  'large clip coordinates': (camera) => [camera, ofProduct(camera, scaled(1e3))],
  'small clip coordinates': (camera) => [camera, ofProduct(camera, scaled(1e-6))],
  'off-axis': (camera) => [offAxis(camera), ofProduct(camera)],
  'from above': (camera) => [above(camera), ofProduct(camera)],
  'infinite far plane': (camera) => [endless(camera), ofProduct(camera)],
  'infinite far plane of single precision': (camera) => [endless(camera), ofProduct(camera, float32)],
  orthographic: () => [orthographic(), ofProduct(orthographic())],
  'orthographic of single precision': () => [orthographic(), ofProduct(orthographic(), float32)],
  'orthographic from behind the scene': () => [orthographic(-46), ofProduct(orthographic(-46))],
  'orthographic with most before the eye': () => [orthographic(-60, 20), ofProduct(orthographic(-60, 20))],
  'parent that scales': (camera) => [ofProduct(inParent(camera, (parent) => parent.scale.setScalar(0.5))), camera],
  'parent that scales unevenly': (camera) => [
    ofProduct(inParent(camera, (parent) => parent.scale.set(1, 1, 0.5))),
    camera,
  ],
  'world scaled in the projection': (camera) => {
    const model = new Matrix4().makeScale(2, 2, 2);
    const plain = ofProduct(camera);
    plain.projectionMatrix.multiply(model.clone().invert());
    plain.matrixWorld.copy(model).invert();
    plain.matrixWorldInverse.copy(model);
    plain.matrixAutoUpdate = plain.matrixWorldAutoUpdate = false;
    plain.updateMatrixWorld = () => {};
    return [camera, plain];
  },
};

function floored(renderer = makeRenderer()): Host {
  const host = emptyHost(renderer);
  const floor = new Mesh(new PlaneGeometry(8, 8), new MeshStandardMaterial({ color: '#c08860', side: 2 }));
  floor.rotation.x = -Math.PI / 2;
  host.scene.add(floor);
  host.camera.updateMatrixWorld();
  return host;
}

export interface View {
  name: string;
  /** Pixels that differ between the cameras, with smoke and without. */
  changed: number;
  /** Those that smoke and its shadow change. */
  smoke: number;
  errors: string[];
}

/** All views share a renderer, so that programs compile once. */
const shared = makeRenderer();

/** @param isMirrored compares with the picture of the first camera from right to left */
async function compare(name: string, pairOf: (camera: PerspectiveCamera) => Pair, isMirrored = false): Promise<View> {
  // three.js shades the other side of objects in a mirrored view.
  const host = isMirrored ? emptyHost(shared) : floored(shared);
  host.camera.updateMatrixWorld();
  const smoke = await smokeIn(host);
  const errors: string[] = [];
  smoke.addEventListener('error', ({ error }) => errors.push(error.message));
  const cameras = pairOf(host.camera) as unknown as readonly PerspectiveCamera[];
  const [first, second] = cameras.map((camera) => draw({ ...host, camera }));
  smoke.update(0);
  smoke.visible = false;
  const without = draw({ ...host, camera: cameras[0] });
  keepPrograms(shared);
  dispose(smoke);
  const shown = isMirrored ? mirrored(second) : second;
  return { name, changed: changedPixels(first, shown, 8), smoke: changedPixels(first, without), errors };
}

function mirrored(pixels: Pixels): Pixels {
  return pixels.map((_, at) => {
    const pixel = Math.floor(at / 4);
    const column = pixel % WIDTH;
    return pixels[at + 4 * (WIDTH - 1 - 2 * column)];
  });
}

export async function views(): Promise<View[]> {
  const seen: View[] = [];
  for (const [name, pairOf] of Object.entries(CAMERAS)) seen.push(await compare(name, pairOf));
  return seen;
}

const flip = new Matrix4().makeScale(-1, 1, 1);

/** Cameras that show everything from right to left, compared with the mirrored picture of the camera. */
export async function mirrors(): Promise<View[]> {
  return [
    await compare('projection', (camera) => [camera, ofProduct(camera, (clip) => flip.clone().multiply(clip))], true),
    await compare(
      'off-axis projection',
      (camera) => [offAxis(camera), ofProduct(camera, (clip) => flip.clone().multiply(clip))],
      true,
    ),
    await compare(
      'orthographic',
      () => {
        const camera = orthographic();
        return [camera, ofProduct(camera, (clip) => flip.clone().multiply(clip))];
      },
      true,
    ),
  ];
}

/** A picture of a view, to look at. */
export async function picture(name: string): Promise<number[]> {
  const host = floored();
  const smoke = await smokeIn(host);
  const camera =
    name === 'mirrored' ? ofProduct(host.camera, (clip) => flip.clone().multiply(clip)) : CAMERAS[name](host.camera)[1];
  const pixels = draw({ ...host, camera: camera as PerspectiveCamera });
  dispose(smoke, host.renderer);
  return [...pixels];
}
