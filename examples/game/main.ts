/**
 * Smoke in a game: puffs where you click, a cart with dust behind its wheels, and a feather and a paper lantern over a fire
 * that its smoke lifts.
 */
import {
  AmbientLight,
  BoxGeometry,
  CircleGeometry,
  Color,
  CylinderGeometry,
  DirectionalLight,
  Group,
  Mesh,
  MeshToonMaterial,
  PerspectiveCamera,
  Raycaster,
  Scene,
  Timer,
  Vector2,
  Vector3,
  WebGLRenderer,
  type BufferGeometry,
} from 'three';
import { CartoonSmoke } from 'cartoon-smoke';

const renderer = new WebGLRenderer({ antialias: true, stencil: true });
document.body.append(renderer.domElement);
const scene = new Scene();
scene.background = new Color('#7f9ab8');
const camera = new PerspectiveCamera(40, 1, 0.1, 60);
camera.position.set(0, 2.6, 7.5);
camera.lookAt(0, 1.2, 0);
const keyLight = new DirectionalLight('#fff1d6', 3);
keyLight.position.set(3, 6, 3.5);
scene.add(keyLight, new AmbientLight('#a9b7ff', 1.1));

const ground = add(new CircleGeometry(6, 64), '#b98a66');
ground.rotation.x = -Math.PI / 2;
const fire = add(new CylinderGeometry(0.5, 0.4, 0.3, 24), '#5d4037', [-1.2, 0.15, 0]);
// Smoke starts above the fire, which smoke collides with.
const flame = new Group();
flame.position.y = 0.25;
fire.add(flame);
const lantern = add(new CylinderGeometry(0.22, 0.22, 0.4, 12), '#ffd27a', [-1.25, 1.4, 0]);
const feather = add(new BoxGeometry(0.5, 0.02, 0.14), '#fdfdf6', [-1.05, 2.4, 0.1]);
feather.rotation.z = 0.3;
const cart = new Group();
cart.add(add(new BoxGeometry(0.7, 0.35, 0.45), '#c0392b', [0, 0.3, 0]));
const exhaust = new Group();
exhaust.position.set(-0.4, 0.15, 0);
exhaust.rotation.z = 1.2;
scene.add(cart.add(exhaust));

const smoke = await CartoonSmoke.create({
  renderer,
  keyLight,
  values: {
    'emission.rate': 0,
    'emission.lifetime': 1.6,
    'emission.growthTime': 0.5,
    'jets.0.speed': 2.2,
    'jets.0.radius': 0.8,
    'jets.0.reach': 2,
    'jets.0.direction.x': 0,
    'jets.0.direction.y': 1,
  },
});
scene.add(smoke);
smoke.addEventListener('error', ({ error }) => console.warn(error.message));

for (const solid of [ground, fire, cart]) smoke.collide(solid);
for (const caster of [fire, lantern, cart]) smoke.cast(caster);
smoke.emitFrom(flame, { rate: 110, radius: 0.4, speed: 1, size: 0.24 });
const dust = smoke.emitFrom(exhaust, { rate: 30, size: 0.22, lifetime: 0.5, speed: 1, inherit: 0.2 });
smoke.attach('jets.0', flame);
for (const thing of [lantern, feather]) smoke.collide(thing, { feelsSmoke: 6, density: 0.4, friction: 0.2 });

const raycaster = new Raycaster();
addEventListener('pointerdown', ({ clientX, clientY }) => {
  raycaster.setFromCamera(new Vector2((2 * clientX) / innerWidth - 1, 1 - (2 * clientY) / innerHeight), camera);
  const [hit] = raycaster.intersectObjects([ground, fire, cart]);
  if (!hit) return;
  const direction = hit.face!.normal.clone().transformDirection(hit.object.matrixWorld);
  smoke.burst({ position: hit.point, direction, count: 30, speed: 2.2, spread: 1, size: 0.3, lifetime: 0.5 });
});

let time = 0;
function animate(seconds: number): void {
  time += seconds;
  const isDriving = time % 6 < 4;
  dust.enabled = isDriving;
  if (isDriving) cart.position.set(-1 + 1.2 * (time % 6), 0, 1.6);
}

/** A mesh of the scene. */
function add(geometry: BufferGeometry, color: string, place: [number, number, number] = [0, 0, 0]): Mesh {
  const mesh = new Mesh(geometry, new MeshToonMaterial({ color }));
  mesh.position.copy(new Vector3(...place));
  scene.add(mesh);
  return mesh;
}

for (let frame = 0; frame < 60 * Number(new URLSearchParams(location.search).get('t') ?? 0); frame++) {
  animate(1 / 60);
  smoke.step();
}

const timer = new Timer();
timer.connect(document);
renderer.setAnimationLoop((now) => {
  timer.update(now);
  const seconds = Math.min(timer.getDelta(), 1 / 15);
  animate(seconds);
  smoke.update(seconds);
  renderer.render(scene, camera);
});

function fit(): void {
  renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
  renderer.setSize(innerWidth, innerHeight);
  camera.aspect = innerWidth / innerHeight;
  camera.updateProjectionMatrix();
}
addEventListener('resize', fit);
fit();
