/**
 * A game: blow smoke rings through hoops. A ring is a burst of puffs that fly straight; the promise of the burst says when
 * its last puff has ended, and so when the game is over.
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
  Plane,
  PlaneGeometry,
  Raycaster,
  Scene,
  SphereGeometry,
  Timer,
  TorusGeometry,
  Vector2,
  Vector3,
  WebGLRenderer,
  type BufferGeometry,
  type Object3D,
} from 'three';
import { CartoonSmoke } from 'cartoon-smoke';
import { crossing, hoopAround, type Ring } from './rules.ts';

const BREATHS = 12;
/** Metres, metres per second and seconds. */
const RING = { radius: 0.36, speed: 8, lifetime: 1.5, pause: 0.35 };
/** The hoops are in this plane. Aims stay in a box of it. */
const DEPTH = -5;
const [LOW, HIGH] = [new Vector3(-3.2, 0.7, DEPTH), new Vector3(3.2, 4.2, DEPTH)];
/** Metres per second at which arrow keys aim. */
const KEY_SPEED = 4;
const INK = '#2a1c3a';
const KEYS: Readonly<Record<string, readonly [x: number, y: number]>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};

const renderer = new WebGLRenderer({ antialias: true, stencil: true });
document.body.prepend(renderer.domElement);
const scene = new Scene();
scene.background = new Color('#8cc8ea');
const camera = new PerspectiveCamera(42, 1, 0.1, 60);
camera.position.set(0, 3, 9);
camera.lookAt(0, 1.75, 0);
const keyLight = new DirectionalLight('#fff1d6', 3);
keyLight.position.set(-4, 8, 6);
scene.add(keyLight, new AmbientLight('#b4c0ff', 1.3));

const ground = add(new PlaneGeometry(80, 40), '#98cb78', scene);
ground.rotation.x = -Math.PI / 2;
const mouth = player();
const aim = new Vector3(0, 2.2, DEPTH);
const sight = add(new TorusGeometry(RING.radius, 0.035, 8, 40), INK, scene);

const hoops = [
  { radius: 0.85, points: 1, color: '#ff7a5c', swing: 0.7, pace: 0.5, home: new Vector3(-1.9, 1.7, DEPTH) },
  { radius: 0.68, points: 2, color: '#ffb52e', swing: 1, pace: 0.8, home: new Vector3(1.7, 2.1, DEPTH) },
  { radius: 0.54, points: 3, color: '#9a6cf0', swing: 1.7, pace: 1.1, home: new Vector3(0, 3.5, DEPTH) },
].map((hoop) => {
  const mesh = add(new TorusGeometry(hoop.radius, 0.11, 16, 48), hoop.color, scene);
  const look = { lifetime: 0.9, colors: `0:${shaded(hoop.color)},.4:${hoop.color}`.replaceAll('#', '') };
  return { ...hoop, mesh, look, back: 0 };
});

const smoke = await CartoonSmoke.create({
  renderer,
  keyLight,
  physics: false,
  values: {
    'emission.rate': 0,
    'emission.growthTime': 0.15,
    'emission.company': 0,
    'forces.turbulence': 0,
    'simulation.maxParticles': 1200,
    'style.smokeColor': '#fff4e3',
    'style.inkColor': INK,
    'puff.stretch': 1.4,
  },
});
scene.add(smoke);
smoke.addEventListener('error', ({ error }) => console.warn(error.message));
smoke.cast(mouth.parent!);

const keys = new Set<string>();
let time = 0;
let rings: Ring[] = [];
let score = 0;
let breaths = 0;
let flying = 0;
/** Simulated seconds before which no ring can be blown. */
let ready = 0;
let isPlaying = false;

const element = (id: string) => document.querySelector<HTMLElement>(`#${id}`)!;

function start(): void {
  [score, breaths, isPlaying, rings] = [0, BREATHS, true, []];
  element('panel').hidden = true;
  showState();
}

function showState(): void {
  element('score').textContent = isPlaying ? `Score ${score}` : '';
  element('breaths').textContent = isPlaying ? `${breaths} ${breaths === 1 ? 'ring' : 'rings'} left` : '';
}

/** Blows a ring at the aim. */
async function blow(): Promise<void> {
  if (time < ready || (isPlaying && breaths === 0)) return;
  ready = time + RING.pause;
  const isCounted = isPlaying;
  const from = mouth.getWorldPosition(new Vector3());
  const direction = aim.clone().sub(from).normalize();
  if (isCounted) {
    --breaths;
    ++flying;
    rings.push({ from, velocity: direction.clone().multiplyScalar(RING.speed), start: time });
    showState();
  }
  await smoke.burst({
    position: from,
    direction,
    count: 30,
    shape: 'ring',
    radius: RING.radius,
    inner: 0.95,
    speed: RING.speed,
    speedVariation: 0,
    spread: 0,
    size: 0.17,
    temperature: 0,
    lifetimeVariation: 0.1,
    look: { lifetime: RING.lifetime, drag: 0, gravity: 0, densityCurve: '0:1,.7:1,1:0' },
  });
  if (isCounted && --flying === 0 && breaths === 0) finish();
}

function finish(): void {
  const best = Math.max(score, Number(localStorage.getItem('best') ?? 0));
  localStorage.setItem('best', String(best));
  isPlaying = false;
  showState();
  element('result').textContent =
    score === 0 ? 'No ring went through. Aim at where a hoop will be.' : `Score: ${score}. Your best: ${best}.`;
  element('start').textContent = 'Play again';
  element('panel').hidden = false;
  element('start').focus();
}

/** Scores rings that have reached the plane of the hoops. */
function pass(): void {
  const places = rings.map((ring) => crossing(ring, DEPTH, time));
  rings = rings.filter((_, index) => !places[index]);
  for (const place of places) {
    const hoop = place && hoopAround(place, hoops);
    if (hoop) hit(hoop);
  }
}

/** Counts a hit. The hoop turns into smoke and comes back later. */
function hit(hoop: (typeof hoops)[number]): void {
  const { radius, look, mesh } = hoop;
  score += hoop.points;
  mesh.visible = false;
  hoop.back = time + 1.2;
  showState();
  void smoke.burst({
    position: mesh.position,
    count: 26,
    shape: 'ring',
    radius,
    speed: 1.8,
    spread: 3,
    size: 0.3,
    look,
  });
}

function animate(seconds: number): void {
  time += seconds;
  for (const key of keys) {
    const [x, y] = KEYS[key];
    aim.add(new Vector3(x, y, 0).multiplyScalar(KEY_SPEED * seconds));
  }
  aim.clamp(LOW, HIGH);
  sight.position.copy(aim);
  mouth.parent!.lookAt(aim);
  for (const { mesh, home, swing, pace, back } of hoops) {
    mesh.position.copy(home).add(new Vector3(swing * Math.sin(pace * time), 0.25 * Math.sin(1.7 * pace * time), 0));
    mesh.visible ||= time >= back;
  }
  pass();
  // Before a game, rings show what the smoke does.
  if (!isPlaying && time > ready + 1.6) {
    aim.copy(hoops[Math.floor(time) % hoops.length].mesh.position);
    void blow();
  }
}

/** Aims at what is under the pointer. */
const raycaster = new Raycaster();
function point({ clientX, clientY }: PointerEvent): void {
  raycaster.setFromCamera(new Vector2((2 * clientX) / innerWidth - 1, 1 - (2 * clientY) / innerHeight), camera);
  raycaster.ray.intersectPlane(new Plane(new Vector3(0, 0, 1), -DEPTH), aim);
}

element('start').addEventListener('click', start);
renderer.domElement.addEventListener('pointermove', (event) => isPlaying && point(event));
renderer.domElement.addEventListener('pointerdown', (event) => {
  if (!isPlaying) return;
  point(event);
  // A finger aims first and blows when it is lifted.
  if (event.pointerType === 'mouse') void blow();
});
renderer.domElement.addEventListener('pointerup', ({ pointerType }) => {
  if (isPlaying && pointerType !== 'mouse') void blow();
});
addEventListener('keydown', (event) => {
  if (!isPlaying || !(event.key === ' ' || event.key in KEYS)) return;
  event.preventDefault();
  if (event.key in KEYS) keys.add(event.key);
  else if (!event.repeat) void blow();
});
addEventListener('keyup', ({ key }) => keys.delete(key));
addEventListener('blur', () => keys.clear());

/** A round fellow who looks at the aim. Rings leave at his mouth. */
function player(): Object3D {
  const head = new Group();
  head.position.set(0, 0.95, 3);
  scene.add(head);
  add(new SphereGeometry(0.55, 96, 64), '#f4d35e', head);
  for (const side of [-1, 1]) add(new SphereGeometry(0.09, 16, 12), INK, head).position.set(0.2 * side, 0.22, 0.48);
  const hat = add(new ConeGeometry(0.34, 0.6, 24), '#e2504a', head);
  hat.position.set(0, 0.66, -0.1);
  hat.rotation.x = -0.15;
  add(new BoxGeometry(0.5, 0.9, 0.4), '#e2504a', scene).position.set(0, 0.3, 3);
  const lips = add(new TorusGeometry(0.13, 0.05, 12, 24), '#c0566a', head);
  lips.position.set(0, -0.08, 0.55);
  return lips;
}

/** A mesh on a parent. */
function add(geometry: BufferGeometry, color: string, parent: Object3D): Mesh {
  const mesh = new Mesh(geometry, new MeshToonMaterial({ color }));
  parent.add(mesh);
  return mesh;
}

/** The colour of a shadow on a colour. */
function shaded(color: string): string {
  return `#${new Color(color).multiplyScalar(0.5).getHexString()}`;
}

function fit(): void {
  renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
  renderer.setSize(innerWidth, innerHeight);
  camera.aspect = innerWidth / innerHeight;
  // The camera zooms out in a narrow window.
  camera.zoom = Math.min(1, camera.aspect / 0.95);
  camera.updateProjectionMatrix();
}
addEventListener('resize', fit);
fit();
showState();

const timer = new Timer();
timer.connect(document);
renderer.setAnimationLoop((now) => {
  timer.update(now);
  const seconds = Math.min(timer.getDelta(), 1 / 15);
  animate(seconds);
  smoke.update(seconds);
  renderer.render(scene, camera);
});
