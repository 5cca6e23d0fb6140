/** The smoke of a fire lifts a feather and a paper lantern. */
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
  Scene,
  Timer,
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
camera.position.set(0, 2.4, 6);
camera.lookAt(0, 1.4, 0);
const keyLight = new DirectionalLight('#fff1d6', 3);
keyLight.position.set(3, 6, 3.5);
scene.add(keyLight, new AmbientLight('#a9b7ff', 1.1));

const ground = add(new CircleGeometry(6, 64), '#b98a66');
ground.rotation.x = -Math.PI / 2;
const fire = add(new CylinderGeometry(0.5, 0.4, 0.3, 24), '#5d4037', [0, 0.15, 0]);
// Smoke starts above the fire, which smoke collides with.
const flame = new Group();
flame.position.y = 0.25;
fire.add(flame);
const lantern = add(new CylinderGeometry(0.22, 0.22, 0.4, 12), '#ffd27a', [-0.05, 1.4, 0]);
const feather = add(new BoxGeometry(0.5, 0.02, 0.14), '#fdfdf6', [0.15, 2.4, 0.1]);
feather.rotation.z = 0.3;

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
    'style.smokeColor': '#fff4e3',
  },
});
scene.add(smoke);
smoke.addEventListener('error', ({ error }) => console.warn(error.message));

for (const solid of [ground, fire]) smoke.collide(solid);
for (const caster of [fire, lantern]) smoke.cast(caster);
smoke.emitFrom(flame, { rate: 110, radius: 0.4, speed: 1, size: 0.24 });
smoke.attach('jets.0', flame);
for (const thing of [lantern, feather]) smoke.collide(thing, { feelsSmoke: 6, density: 0.4, friction: 0.2 });

/** A mesh of the scene. */
function add(geometry: BufferGeometry, color: string, place: [number, number, number] = [0, 0, 0]): Mesh {
  const mesh = new Mesh(geometry, new MeshToonMaterial({ color }));
  mesh.position.copy(new Vector3(...place));
  scene.add(mesh);
  return mesh;
}

const timer = new Timer();
timer.connect(document);
renderer.setAnimationLoop((now) => {
  timer.update(now);
  smoke.update(timer.getDelta());
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
