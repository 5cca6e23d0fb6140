/** A typical scene: an imported model, and a mesh of every type that three.js draws. */
import {
  AmbientLight,
  BoxGeometry,
  CanvasTexture,
  CircleGeometry,
  Color,
  CylinderGeometry,
  DirectionalLight,
  InstancedMesh,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  MeshStandardMaterial,
  MeshToonMaterial,
  Scene,
  ShaderMaterial,
  SphereGeometry,
  Sprite,
  SpriteMaterial,
  TorusGeometry,
  Vector3,
  type Object3D,
} from 'three';
import { DRACOLoader } from 'three/examples/jsm/loaders/DRACOLoader.js';
import { GLTFLoader } from 'three/examples/jsm/loaders/GLTFLoader.js';
import { makeTentacle } from './tentacle.ts';

export interface ExampleScene {
  scene: Scene;
  keyLight: DirectionalLight;
  chimney: Object3D;
  /** Objects that collide with the smoke, and objects that cast shadow. */
  obstacles: Object3D[];
  casters: Object3D[];
  /** For the custom shader, which computes its own lighting. */
  setInShadow: (isInShadow: boolean) => void;
  animate: (seconds: number) => void;
}

const KEY = new Vector3(3, 6, 3.5);

export async function makeScene(): Promise<ExampleScene> {
  const scene = new Scene();
  scene.background = new Color('#6f86a6');
  const keyLight = makeKeyLight();
  scene.add(keyLight, new AmbientLight('#a9b7ff', 1.1));

  const floor = new Mesh(new CircleGeometry(4, 64), new MeshStandardMaterial({ color: '#c58f6a', roughness: 0.9 }));
  floor.rotation.x = -Math.PI / 2;
  const chimney = new Mesh(new CylinderGeometry(0.2, 0.26, 0.5, 32), new MeshStandardMaterial({ color: '#7d5447' }));
  chimney.position.set(-1.1, 0.25, 0.2);
  const monkey = await loadMonkey();
  const ring = new Mesh(new TorusGeometry(0.8, 0.12, 24, 64), new MeshToonMaterial({ color: '#f2b632' }));
  ring.position.set(-1, 1.75, 0.15);
  const globe = makeGlobe();
  const tentacle = makeTentacle();
  const stones = makeStones();
  const lamp = new Mesh(new SphereGeometry(0.09, 24, 16), new MeshBasicMaterial({ color: '#fff3b0' }));
  lamp.position.set(-2, 1.1, 0.9);
  const pane = makePane();
  const solid = [floor, chimney, monkey, ring, globe, tentacle.mesh, stones, lamp];
  scene.add(...solid, pane, ...makeSparks());
  for (const object of solid)
    object.traverse((part) => ((part.receiveShadow = true), (part.castShadow = part !== floor)));

  return {
    scene,
    keyLight,
    chimney,
    obstacles: [floor, monkey, ring, globe, tentacle.mesh],
    casters: [ring, globe, tentacle.mesh],
    setInShadow: (isInShadow) => (globe.material.uniforms.keyLight.value = isInShadow ? 0 : 1),
    animate: (seconds) => {
      ring.rotation.set(1.57 + 0.35 * Math.sin(seconds), 0.3 * Math.cos(seconds), 0);
      tentacle.animate(seconds);
    },
  };
}

function makeKeyLight(): DirectionalLight {
  const light = new DirectionalLight('#fff1d6', 3.2);
  light.position.copy(KEY);
  light.castShadow = true;
  light.shadow.mapSize.set(2048, 2048);
  light.shadow.normalBias = 0.02;
  Object.assign(light.shadow.camera, { left: -4.5, right: 4.5, top: 4.5, bottom: -4.5, far: 16 });
  return light;
}

/** Blender's Suzanne from the package @pmndrs/assets (CC0). */
async function loadMonkey(): Promise<Object3D> {
  const { default: address } = await import('@pmndrs/assets/models/suzi.glb');
  const { scene } = await new GLTFLoader().setDRACOLoader(new DRACOLoader()).loadAsync(address);
  const material = new MeshStandardMaterial({ color: '#5b8c5a', roughness: 0.6 });
  scene.traverse((part) => (part instanceof Mesh ? (part.material = material) : undefined));
  scene.scale.setScalar(0.85);
  scene.position.set(0.35, 0.62, 0.3);
  scene.rotation.y = -0.35;
  return scene;
}

/** A custom shader that computes its own lighting. */
function makeGlobe(): Mesh<SphereGeometry, ShaderMaterial> {
  const material = new ShaderMaterial({
    uniforms: { keyLight: { value: 1 }, towardsLight: { value: KEY.clone().normalize() } },
    vertexShader: `
      varying vec3 normalInWorld;
      void main() {
        normalInWorld = mat3(modelMatrix) * normal;
        gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
      }`,
    fragmentShader: `
      uniform float keyLight;
      uniform vec3 towardsLight;
      varying vec3 normalInWorld;
      void main() {
        float stripe = step(0.0, sin(24.0 * normalInWorld.y));
        float light = 0.35 + 0.65 * keyLight * smoothstep(-0.05, 0.05, dot(normalize(normalInWorld), towardsLight));
        gl_FragColor = vec4(mix(vec3(0.75, 0.12, 0.2), vec3(0.95, 0.9, 0.85), stripe) * light, 1.0);
        #include <colorspace_fragment>
      }`,
  });
  const globe = new Mesh(new SphereGeometry(0.36, 48, 32), material);
  globe.position.set(1.75, 0.36, 1.1);
  return globe;
}

function makeStones(): InstancedMesh {
  const count = 24;
  const stones = new InstancedMesh(
    new BoxGeometry(0.3, 0.22, 0.3),
    new MeshStandardMaterial({ color: '#8b8f9c' }),
    count,
  );
  const place = new Matrix4();
  for (let index = 0; index < count; ++index) {
    const angle = (2 * Math.PI * index) / count;
    place.makeRotationY(3 * angle).setPosition(3.4 * Math.cos(angle), 0.11, 3.4 * Math.sin(angle));
    stones.setMatrixAt(index, place);
  }
  return stones;
}

function makePane(): Mesh {
  const material = new MeshStandardMaterial({ color: '#9fe3ff', transparent: true, opacity: 0.35, roughness: 0.1 });
  const pane = new Mesh(new BoxGeometry(1.1, 1.6, 0.04), material);
  pane.position.set(-1.2, 0.85, 1.2);
  pane.rotation.y = 0.5;
  return pane;
}

function makeSparks(): Sprite[] {
  const material = new SpriteMaterial({ color: '#ffe08a', map: drawStar(), depthWrite: false });
  return [0, 1, 2, 3].map((index) => {
    const spark = new Sprite(material);
    spark.scale.setScalar(0.3 - 0.04 * index);
    spark.position.set(-1.4 + 0.35 * index, 1.2 + 0.45 * index, 0.5 - 0.35 * index);
    return spark;
  });
}

/** A four-pointed cartoon star. */
function drawStar(): CanvasTexture {
  const size = 128;
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = size;
  const context = canvas.getContext('2d')!;
  context.translate(size / 2, size / 2);
  context.fillStyle = '#fff';
  context.moveTo(0, -60);
  for (let point = 0; point < 4; point++) {
    context.rotate(Math.PI / 2);
    context.quadraticCurveTo(-6, -6, 0, -60);
  }
  context.fill();
  return new CanvasTexture(canvas);
}
