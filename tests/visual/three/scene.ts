/** The host's scene for the tests of src/three: meshes of every type, a renderer, and its pixels as bytes. */
import {
  AmbientLight,
  Bone,
  BoxGeometry,
  Color,
  CylinderGeometry,
  DirectionalLight,
  Float32BufferAttribute,
  InstancedMesh,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  MeshStandardMaterial,
  MeshToonMaterial,
  PerspectiveCamera,
  PlaneGeometry,
  Scene,
  ShaderMaterial,
  Skeleton,
  SkinnedMesh,
  SphereGeometry,
  Uint16BufferAttribute,
  WebGLRenderer,
  type ToneMapping,
  type WebGLRendererParameters,
} from 'three';
import { CartoonSmoke } from '../../../src/three/cartoonSmoke.ts';
import type { CartoonSmokeOptions } from '../../../src/three/options.ts';
import type { Values } from '../../../src/parameters/parameter.ts';

export const WIDTH = 200;
export const HEIGHT = 140;

/** About twenty puffs that stay at one position. */
export const HANGING: Values = {
  'emission.rate': 240,
  'emission.growthTime': 0,
  'buoyancy.acceleration': 0,
  'turbulence.speed': 0,
  'emitters.0.speed': 0,
  'emitters.0.shape': 'ball',
  'emitters.0.radius': 0.3,
  'emitters.0.size': 0.4,
  'emitters.0.position.y': 1.2,
  'simulation.maxParticles': 24,
};

export interface Host {
  renderer: WebGLRenderer;
  scene: Scene;
  camera: PerspectiveCamera;
  keyLight: DirectionalLight;
}

/** RGBA bytes, the bottom row first. */
export type Pixels = Uint8Array;

export function makeRenderer(
  parameters: WebGLRendererParameters = {},
  [width, height] = [WIDTH, HEIGHT],
  toneMapping?: ToneMapping,
): WebGLRenderer {
  const canvas = new OffscreenCanvas(width, height);
  const renderer = new WebGLRenderer({ canvas, stencil: true, antialias: false, ...parameters });
  renderer.setSize(width, height, false);
  if (toneMapping !== undefined) renderer.toneMapping = toneMapping;
  return renderer;
}

/** An empty scene with a key light from the upper right. */
export function emptyHost(renderer = makeRenderer()): Host {
  const scene = new Scene();
  scene.background = new Color('#4477aa');
  const keyLight = new DirectionalLight('#fff0d0', 2.5);
  keyLight.position.set(2, 5, 3);
  scene.add(keyLight, new AmbientLight('#8899ff', 0.8));
  const camera = new PerspectiveCamera(45, WIDTH / HEIGHT, 0.1, 50);
  camera.position.set(0.4, 1.8, 4.2);
  camera.lookAt(0, 0.8, 0);
  return { renderer, scene, camera, keyLight };
}

/** Meshes of every type on a floor. */
export function furnishedHost(renderer?: WebGLRenderer): Host {
  const host = emptyHost(renderer);
  const floor = new Mesh(new PlaneGeometry(8, 8), new MeshStandardMaterial({ color: '#c08860' }));
  floor.rotation.x = -Math.PI / 2;
  const ball = new Mesh(new SphereGeometry(0.3, 32, 24), new MeshToonMaterial({ color: '#f0b030' }));
  ball.position.set(-0.9, 0.3, 0.3);
  const box = new Mesh(new BoxGeometry(0.4, 0.4, 0.4), new MeshBasicMaterial({ color: '#30a060' }));
  box.position.set(0.9, 0.2, 0.6);
  const { mesh: skinned } = makeSkinned(new MeshStandardMaterial({ color: '#a050c0' }));
  skinned.position.set(0.3, 0, -0.2);
  const instanced = makeInstanced(new MeshStandardMaterial({ color: '#8090a0' }));
  const striped = new Mesh(new SphereGeometry(0.25, 32, 24), stripes());
  striped.position.set(-0.2, 0.25, 1);
  host.scene.add(floor, ball, box, skinned, instanced, striped);
  return host;
}

/** A post with two bones, bent at the middle. */
export function makeSkinned(material: MeshStandardMaterial | MeshBasicMaterial): { mesh: SkinnedMesh; bones: Bone[] } {
  const geometry = new CylinderGeometry(0.12, 0.12, 1.6, 24, 12).translate(0, 0.8, 0);
  const { position } = geometry.attributes;
  const heights = Array.from({ length: position.count }, (_, vertex) => position.getY(vertex) / 1.6);
  geometry.setAttribute(
    'skinIndex',
    new Uint16BufferAttribute(
      heights.flatMap(() => [0, 1, 0, 0]),
      4,
    ),
  );
  geometry.setAttribute(
    'skinWeight',
    new Float32BufferAttribute(
      heights.flatMap((h) => [1 - h, h, 0, 0]),
      4,
    ),
  );
  const bones = [new Bone(), new Bone()];
  bones[0].add(bones[1]);
  bones[1].position.y = 0.8;
  const mesh = new SkinnedMesh(geometry, material);
  mesh.add(bones[0]);
  mesh.bind(new Skeleton(bones));
  bones[1].rotation.z = 0.7;
  return { mesh, bones };
}

export function makeInstanced(material: MeshStandardMaterial | MeshBasicMaterial): InstancedMesh {
  const mesh = new InstancedMesh(new BoxGeometry(0.2, 0.5, 0.2), material, 6);
  for (let index = 0; index < mesh.count; ++index)
    mesh.setMatrixAt(index, new Matrix4().makeRotationY(index).setPosition(-1 + 0.4 * index, 0.8 + 0.1 * index, 0.1));
  return mesh;
}

/** A custom shader without lights. */
function stripes(): ShaderMaterial {
  return new ShaderMaterial({
    vertexShader: `
      varying float height;
      void main() {
        height = position.y;
        gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
      }`,
    fragmentShader: `
      varying float height;
      void main() { gl_FragColor = vec4(step(0.0, sin(60.0 * height)), 0.3, 0.4, 1.0); }`,
  });
}

export async function smokeIn(host: Host, values: Values = HANGING, more: Partial<CartoonSmokeOptions> = {}) {
  const { renderer, keyLight } = host;
  const smoke = await CartoonSmoke.create({ renderer, keyLight, values, physics: false, ...more });
  host.scene.add(smoke);
  smoke.step(8);
  return smoke;
}

/** Draws the host's frame and reads its pixels from the canvas. */
export function draw({ renderer, scene, camera }: Host): Pixels {
  renderer.render(scene, camera);
  return readCanvas(renderer);
}

export function readCanvas(renderer: WebGLRenderer): Pixels {
  const gl = renderer.getContext();
  const { drawingBufferWidth: width, drawingBufferHeight: height } = gl;
  const pixels = new Uint8Array(4 * width * height);
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  return pixels;
}

/** Pixels of the smoke, drawn alone in front of a uniform colour. */
export function smokePixels(host: Host, smoke: CartoonSmoke): boolean[] {
  const scene = new Scene();
  scene.background = new Color('#ff00ff');
  scene.add(smoke);
  const pixels = draw({ ...host, scene });
  host.scene.add(smoke);
  return Array.from({ length: WIDTH * HEIGHT }, (_, pixel) => pixels[4 * pixel + 1] !== 0);
}

/** The picture without the key light. */
export function drawUnlit(host: Host): Pixels {
  const { intensity } = host.keyLight;
  host.keyLight.intensity = 0;
  const pixels = draw(host);
  host.keyLight.intensity = intensity;
  return pixels;
}

/** The largest difference of a channel, by pixel. */
export function differences(a: Pixels, b: Pixels): number[] {
  return Array.from({ length: a.length / 4 }, (_, pixel) =>
    Math.max(...[0, 1, 2, 3].map((channel) => Math.abs(a[4 * pixel + channel] - b[4 * pixel + channel]))),
  );
}

export function changedPixels(a: Pixels, b: Pixels, tolerance = 0): number {
  return differences(a, b).filter((difference) => difference > tolerance).length;
}

export function dispose(...parts: { dispose(): void; forceContextLoss?: () => void }[]): void {
  for (const part of parts) {
    part.dispose();
    part.forceContextLoss?.();
  }
}
