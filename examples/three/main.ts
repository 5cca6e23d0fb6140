/**
 * Smoke in a regular three.js scene. This file contains all code for smoke; the scene in scene.ts is independent of it.
 */
import { ACESFilmicToneMapping, PCFShadowMap, PerspectiveCamera, Timer, WebGLRenderer } from 'three';
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';
import { CartoonSmoke } from 'cartoon-smoke';
import { makeScene } from './scene.ts';

// Smoke counts its shadows in the stencil buffer, which three.js does not allocate by default.
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

// Move all objects to their initial positions before smoke reads them.
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
    'style.smokeColor': '#fff4e3',
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
  // A slow machine shows everything in slow motion, as smoke does itself.
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
  // The camera zooms out in a narrow window.
  camera.zoom = Math.min(1, camera.aspect / 1.1);
  camera.updateProjectionMatrix();
}
addEventListener('resize', fit);
fit();
