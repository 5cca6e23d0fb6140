/**
 * A small game: a runner whose steps raise dust, a jet with a trail, and twenty explosions a second. A click on the ground
 * adds another one.
 */
import {
  AmbientLight,
  BoxGeometry,
  Color,
  ConeGeometry,
  DirectionalLight,
  Group,
  Mesh,
  MeshToonMaterial,
  PerspectiveCamera,
  PlaneGeometry,
  Raycaster,
  Scene,
  Timer,
  Vector2,
  Vector3,
  WebGLRenderer,
  type BufferGeometry,
} from 'three';
import { CartoonSmoke } from 'cartoon-smoke';

const EXPLOSIONS_PER_SECOND = 20;
const STEPS_PER_SECOND = 5;

const renderer = new WebGLRenderer({ antialias: true, stencil: true });
document.body.append(renderer.domElement);
const scene = new Scene();
scene.background = new Color('#7fb2d9');
const camera = new PerspectiveCamera(40, 1, 0.1, 100);
camera.position.set(0, 5, 16);
camera.lookAt(0, 2.5, 0);
const keyLight = new DirectionalLight('#fff1d6', 3);
keyLight.position.set(4, 8, 6);
scene.add(keyLight, new AmbientLight('#a9b7ff', 1.2));

const ground = add(new PlaneGeometry(60, 30), '#8fbf6f');
ground.rotation.x = -Math.PI / 2;
const runner = add(new BoxGeometry(0.6, 1.2, 0.5), '#c0392b');
const jet = add(new ConeGeometry(0.35, 1.6, 16), '#e8e8f0');
jet.rotation.z = -Math.PI / 2;
// Puffs leave along the y axis, here backwards.
const nozzle = new Group();
nozzle.rotation.x = Math.PI;
nozzle.position.y = -0.9;
jet.add(nozzle);

const values = {
  'emission.rate': 0,
  'emission.lifetime': 1.2,
  'emission.growthTime': 0.3,
  'simulation.maxParticles': 3000,
  'style.smokeColor': '#fff4e3',
};
const smoke = await CartoonSmoke.create({ renderer, keyLight, values, physics: false });
scene.add(smoke);
smoke.emitFrom(nozzle, { rate: 70, size: 0.3, speed: 2, spread: 0.1 });

let time = 0;
let explosions = 0;
let steps = 0;
function animate(seconds: number): void {
  time += seconds;
  runner.position.set(((3 * time + 8) % 16) - 8, 0.6 + 0.2 * Math.abs(Math.sin(Math.PI * STEPS_PER_SECOND * time)), 2);
  jet.position.set(((9 * time + 12) % 24) - 12, 5 + Math.sin(2 * time), -2);
  for (; steps < STEPS_PER_SECOND * time; steps++) {
    const position = new Vector3(runner.position.x, 0.05, runner.position.z);
    void smoke.burst({ position, direction: new Vector3(-1, 1, 0), count: 4, size: 0.2, speed: 1.2, lifetime: 0.5 });
  }
  for (; explosions < EXPLOSIONS_PER_SECOND * time; explosions++) {
    const position = new Vector3(14 * Math.random() - 7, 0.4 + 2.5 * Math.random(), -4 * Math.random());
    void smoke.burst({ position, count: 12, size: 0.5, speed: 2.5, lifetime: 0.7 });
  }
}

const raycaster = new Raycaster();
addEventListener('pointerdown', ({ clientX, clientY }) => {
  raycaster.setFromCamera(new Vector2((2 * clientX) / innerWidth - 1, 1 - (2 * clientY) / innerHeight), camera);
  const [hit] = raycaster.intersectObject(ground);
  if (!hit) return;
  const direction = new Vector3(0, 1, 0);
  void smoke.burst({ position: hit.point, direction, count: 40, size: 0.5, speed: 4, spread: 1, lifetime: 0.8 });
});

/** A mesh of the scene. */
function add(geometry: BufferGeometry, color: string): Mesh {
  const mesh = new Mesh(geometry, new MeshToonMaterial({ color }));
  scene.add(mesh);
  return mesh;
}

function fit(): void {
  renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
  renderer.setSize(innerWidth, innerHeight);
  camera.aspect = innerWidth / innerHeight;
  // The camera zooms out in a narrow window.
  camera.zoom = Math.min(1, camera.aspect / 1.6);
  camera.updateProjectionMatrix();
}
addEventListener('resize', fit);
fit();

const timer = new Timer();
timer.connect(document);
renderer.setAnimationLoop((now) => {
  timer.update(now);
  const seconds = Math.min(timer.getDelta(), 1 / 15);
  animate(seconds);
  smoke.update(seconds);
  renderer.render(scene, camera);
});
