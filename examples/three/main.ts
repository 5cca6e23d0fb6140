/** Smoke in an ordinary three.js scene. What smoke needs is in this file; the scene is in scene.ts and knows nothing of it. */
import { ACESFilmicToneMapping, PCFShadowMap, PerspectiveCamera, Timer, WebGLRenderer } from 'three';
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';
import { CartoonSmoke } from '../../src/index.ts';
import { makeScene } from './scene.ts';

// Smoke counts its shadows in the stencil buffer, which three.js leaves out unless it is asked for.
const renderer = new WebGLRenderer({ antialias: true, stencil: true });
renderer.toneMapping = ACESFilmicToneMapping;
renderer.shadowMap.enabled = true;
renderer.shadowMap.type = PCFShadowMap;
document.body.append(renderer.domElement);

const camera = new PerspectiveCamera(40, 1, 0.1, 60);
camera.position.set(3.2, 2.4, 6.4);
const controls = new OrbitControls(camera, renderer.domElement);
controls.target.set(0, 1.1, 0);

const { scene, keyLight, chimney, obstacles, casters, setInShadow, animate } = await makeScene();

// Everything stands where it is going to, before smoke sees it for the first time.
animate(0);

const smoke = await CartoonSmoke.create({
  renderer,
  keyLight,
  onRelight: setInShadow,
  values: {
    'emission.rate': 45,
    'emission.lifetime': 6,
    'emitters.0.radius': 0.16,
    'emitters.0.speed': 0.7,
    'emitters.0.size': 0.34,
    'forces.wind.x': 0.12,
    'style.outlineWidth': 2,
  },
});
scene.add(smoke);
smoke.emitFrom(chimney);
for (const obstacle of obstacles) smoke.collide(obstacle);
for (const caster of casters) smoke.cast(caster);
smoke.step(Math.round(60 * Number(new URLSearchParams(location.search).get('t') ?? 0)));

const timer = new Timer();
timer.connect(document);
let time = 0;
renderer.setAnimationLoop((now) => {
  timer.update(now);
  // A machine that cannot keep up sees everything in slow motion, as smoke does by itself.
  const seconds = Math.min(timer.getDelta(), 1 / 15);
  animate((time += seconds));
  controls.update();
  smoke.update(seconds);
  renderer.render(scene, camera);
});

function fit(): void {
  renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
  renderer.setSize(innerWidth, innerHeight);
  camera.aspect = innerWidth / innerHeight;
  // A narrow window looks from farther away.
  camera.zoom = Math.min(1, camera.aspect / 1.1);
  camera.updateProjectionMatrix();
}
addEventListener('resize', fit);
fit();
