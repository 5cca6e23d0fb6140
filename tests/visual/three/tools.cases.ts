/** Tools of three.js that walk a scene with smoke: what they find is what they find with an empty group in its place. */
import {
  Box3,
  EdgesGeometry,
  Group,
  Mesh,
  MeshStandardMaterial,
  ObjectLoader,
  Raycaster,
  Scene,
  SphereGeometry,
  Vector3,
  WebGLRenderTarget,
  WireframeGeometry,
  type BufferGeometry,
  type Object3D,
} from 'three';
import { GLTFExporter } from 'three/examples/jsm/exporters/GLTFExporter.js';
import { OBJExporter } from 'three/examples/jsm/exporters/OBJExporter.js';
import { PLYExporter } from 'three/examples/jsm/exporters/PLYExporter.js';
import { STLExporter } from 'three/examples/jsm/exporters/STLExporter.js';
import { USDZExporter } from 'three/examples/jsm/exporters/USDZExporter.js';
import { unzipSync } from 'three/examples/jsm/libs/fflate.module.js';
import { mergeGeometries } from 'three/examples/jsm/utils/BufferGeometryUtils.js';
import type { CartoonSmoke } from '../../../src/three/cartoonSmoke.ts';
import { keepPrograms } from '../pageDevice.ts';
import { changedPixels, dispose, draw, emptyHost, HEIGHT, makeRenderer, smokeIn, WIDTH } from './scene.ts';

type Drawn = Object3D & { geometry?: BufferGeometry };

const partsOf = (scene: Object3D): Drawn[] => {
  const parts: Drawn[] = [];
  scene.traverse((part) => void parts.push(part));
  return parts;
};
const geometriesOf = (scene: Object3D) => partsOf(scene).flatMap(({ geometry }) => geometry ?? []);
const sum = (numbers: readonly number[]) => numbers.reduce((all, number) => all + number, 0);
const text = (bytes: DataView | Uint8Array | ArrayBuffer) => new TextDecoder('latin1').decode(bytes);

/** What each tool finds, as text or numbers. */
export const TOOLS: Readonly<Record<string, (scene: Scene) => unknown>> = {
  stl: (scene) => new STLExporter().parse(scene),
  'binary stl': (scene) => text(new STLExporter().parse(scene, { binary: true })),
  obj: (scene) => new OBJExporter().parse(scene),
  ply: (scene) => new PLYExporter().parse(scene, () => {}, {}),
  'binary ply': (scene) => text(new PLYExporter().parse(scene, () => {}, { binary: true })!),
  gltf: async (scene) => JSON.stringify(await new GLTFExporter().parseAsync(scene)),
  'gltf with what is hidden': async (scene) =>
    JSON.stringify(await new GLTFExporter().parseAsync(scene, { onlyVisible: false })),
  glb: async (scene) => text((await new GLTFExporter().parseAsync(scene, { binary: true })) as ArrayBuffer),
  usdz: async (scene) => Object.values(unzipSync(await new USDZExporter().parseAsync(scene))).map(text),
  json: (scene) => {
    const { object, geometries, materials } = scene.toJSON() as unknown as Record<string, Object3D[]> & {
      object: Object3D;
    };
    const loaded = new ObjectLoader().parse(scene.toJSON());
    return [object.children.length, geometries.length, materials.length, partsOf(loaded).map(({ type }) => type)];
  },
  vertices: (scene) => sum(geometriesOf(scene).map(({ attributes }) => attributes.position.count)),
  'computed bounds': (scene) =>
    sum(
      geometriesOf(scene).map((geometry) => {
        geometry.computeBoundingBox();
        geometry.computeBoundingSphere();
        geometry.computeVertexNormals();
        return geometry.boundingSphere!.radius;
      }),
    ),
  box: (scene) => new Box3().setFromObject(scene),
  'precise box': (scene) => new Box3().setFromObject(scene, true),
  edges: (scene) =>
    sum(
      geometriesOf(scene).map(
        (geometry) =>
          new EdgesGeometry(geometry).attributes.position.count +
          new WireframeGeometry(geometry).attributes.position.count,
      ),
    ),
  merged: (scene) =>
    mergeGeometries(partsOf(scene).flatMap((part) => ('isMesh' in part ? (part as Mesh).geometry : []))).attributes
      .position.count,
  raycast: (scene) =>
    new Raycaster(new Vector3(0, 0, 9), new Vector3(0, 0, -1))
      .intersectObjects(scene.children, true)
      .map(({ distance }) => distance),
};

/** Names of the tools that find something else, with what they find, and pixels of smoke after all of them. */
export async function found(): Promise<{ different: string[]; drawn: number }> {
  const host = emptyHost();
  const smoke = await smokeIn(host);
  const scene = new Scene();
  const mesh = new Mesh(new SphereGeometry(1, 8, 6), new MeshStandardMaterial());
  scene.add(mesh, smoke);
  // Everything that the first frame adds is there.
  host.renderer.render(scene, host.camera);
  const group = new Group();
  const different: string[] = [];
  for (const [name, tool] of Object.entries(TOOLS)) {
    try {
      scene.add(smoke);
      const result = JSON.stringify(await tool(scene));
      scene.remove(smoke);
      scene.add(Object.assign(group, { name: smoke.name }));
      if (result !== JSON.stringify(await tool(scene))) different.push(`${name}: ${result.slice(0, 300)}`);
    } catch (error) {
      different.push(`${name}: ${String(error)}`);
    }
    scene.remove(group, smoke);
  }
  host.scene.add(smoke);
  const drawn = pixelsOf(host, smoke);
  dispose(smoke, host.renderer);
  return { different, drawn };
}

function pixelsOf(host: ReturnType<typeof emptyHost>, smoke: CartoonSmoke): number {
  const whole = draw(host);
  smoke.removeFromParent();
  const without = draw(host);
  host.scene.add(smoke);
  return changedPixels(whole, without);
}

/** State of the smoke object, as applications set it, and whether smoke is drawn with it. */
export const STATES: Readonly<
  Record<string, readonly [(smoke: CartoonSmoke, host: ReturnType<typeof emptyHost>) => void, boolean]>
> = {
  plain: [() => {}, true],
  'layers.set': [(smoke) => smoke.layers.set(1), false],
  'layers.set of both': [(smoke, { camera }) => (smoke.layers.set(1), camera.layers.set(1)), true],
  'layers.enable': [(smoke, { camera }) => (smoke.layers.enable(1), camera.layers.set(1)), true],
  'layers.disable': [(smoke) => smoke.layers.disable(0), false],
  'layers.toggle': [(smoke) => smoke.layers.toggle(0), false],
  'layers.enableAll': [(smoke, { camera }) => (smoke.layers.enableAll(), camera.layers.set(5)), true],
  'layers.mask': [(smoke) => (smoke.layers.mask = 4), false],
  'layers of the camera': [(_smoke, { camera }) => camera.layers.set(1), false],
  'layers of all': [(smoke) => smoke.traverse(({ layers }) => layers.set(1)), false],
  'layers of a parent, which do not inherit': [
    (smoke, { scene }) => {
      const parent = new Group();
      parent.layers.set(1);
      scene.add(parent.add(smoke));
    },
    true,
  ],
  visible: [(smoke) => (smoke.visible = false), false],
  frustumCulled: [
    (smoke) => smoke.position.set(90, 0, 0) && smoke.traverse((part) => (part.frustumCulled = true)),
    true,
  ],
  renderOrder: [(smoke) => (smoke.renderOrder = 7), true],
  'renderOrder of a parent': [
    (smoke, { scene }) => scene.add(Object.assign(new Group(), { renderOrder: 3 }).add(smoke)),
    true,
  ],
  matrixAutoUpdate: [(smoke) => (smoke.matrixAutoUpdate = false), true],
  shadows: [(smoke) => smoke.traverse((part) => (part.castShadow = part.receiveShadow = true)), true],
  'no children': [(smoke) => smoke.remove(...smoke.children), true],
  userData: [(smoke) => (smoke.userData = { own: 1 }), true],
};

/** Names of the states with which smoke is drawn, or not, against the table. */
export async function states(): Promise<string[]> {
  const wrong: string[] = [];
  const renderer = makeRenderer();
  renderer.shadowMap.enabled = true;
  for (const [name, [set, isDrawn]] of Object.entries(STATES)) {
    const host = emptyHost(renderer);
    const smoke = await smokeIn(host);
    host.keyLight.castShadow = true;
    set(smoke, host);
    const whole = draw(host);
    smoke.removeFromParent();
    if (changedPixels(whole, draw(host)) > 500 !== isDrawn) wrong.push(name);
    keepPrograms(renderer);
    dispose(smoke);
  }
  dispose(renderer);
  return wrong;
}

/** How often the callbacks of the smoke object are called in a frame with smoke, and in one of another layer. */
export async function callbacks(): Promise<number[]> {
  const host = emptyHost();
  const smoke = await smokeIn(host);
  const calls = [0, 0, 0];
  smoke.onBeforeRender = () => void calls[0]++;
  smoke.onAfterRender = () => void calls[1]++;
  calls[2] = pixelsOf(host, smoke);
  smoke.layers.set(3);
  draw(host);
  dispose(smoke, host.renderer);
  return calls;
}

/** Views that show nothing. */
const EMPTY_VIEWS: Readonly<Record<string, (host: ReturnType<typeof emptyHost>) => void>> = {
  'size of 0': ({ renderer }) => renderer.setSize(0, 0, false),
  'width of 0': ({ renderer }) => renderer.setSize(0, HEIGHT, false),
  'viewport of 0': ({ renderer }) => renderer.setViewport(0, 0, 0, 0),
  'less than a pixel': ({ renderer }) => renderer.setViewport(0, 0, 0.2, 0.2),
  'pixel ratio of 0': ({ renderer }) => renderer.setPixelRatio(0),
  'scissor of 0': ({ renderer }) => (renderer.setScissorTest(true), renderer.setScissor(0, 0, 0, 0)),
  'target of 0': ({ renderer }) => {
    const target = new WebGLRenderTarget(0, 0, { stencilBuffer: true });
    renderer.setRenderTarget(target);
  },
  'aspect of 0/0': ({ camera }) => (camera.aspect = NaN),
  'aspect of 0': ({ camera }) => (camera.aspect = 0),
  'aspect of 1/0': ({ camera }) => (camera.aspect = Infinity),
  'angle of 0': ({ camera }) => (camera.fov = 0),
  'angle of NaN': ({ camera }) => (camera.fov = NaN),
  'near equals far': ({ camera }) => (camera.far = camera.near),
  'near of 0': ({ camera }) => (camera.near = 0),
  'zoom of 0': ({ camera }) => (camera.zoom = 0),
  'scale of 0': ({ camera }) => camera.scale.setScalar(0),
  'position of NaN': ({ camera }) => (camera.position.x = NaN),
  'everything during a resize': ({ renderer, camera }) => (renderer.setSize(0, 0, false), (camera.aspect = NaN)),
};

/** Errors and changed pixels by the view that shows nothing, and pixels of smoke after it. */
export async function emptyViews(): Promise<string[]> {
  const wrong: string[] = [];
  const renderer = makeRenderer();
  for (const [name, set] of Object.entries(EMPTY_VIEWS)) {
    const host = emptyHost(renderer);
    const smoke = await smokeIn(host, undefined, {});
    smoke.addEventListener('error', ({ error }) => wrong.push(`${name}: ${error.message}`));
    set(host);
    host.camera.updateProjectionMatrix();
    host.renderer.render(host.scene, host.camera);
    smoke.update(0);
    host.renderer.setRenderTarget(null);
    host.renderer.setScissorTest(false);
    host.renderer.setPixelRatio(1);
    host.renderer.setSize(WIDTH, HEIGHT, false);
    host.camera = emptyHost(host.renderer).camera;
    if (!(pixelsOf(host, smoke) > 1000)) wrong.push(`${name}: no smoke afterwards`);
    smoke.update(0);
    keepPrograms(renderer);
    dispose(smoke);
  }
  dispose(renderer);
  return wrong;
}
