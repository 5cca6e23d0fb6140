/** The recipes of docs/three.md as pictures. */
import {
  BoxGeometry,
  Color,
  ConeGeometry,
  CylinderGeometry,
  ExtrudeGeometry,
  Fog,
  HalfFloatType,
  HemisphereLight,
  Mesh,
  MeshBasicMaterial,
  MeshLambertMaterial,
  Object3D,
  Path,
  PlaneGeometry,
  Shape,
  SphereGeometry,
  Vector2,
  WebGLRenderTarget,
} from 'three';
import { Reflector } from 'three/examples/jsm/objects/Reflector.js';
import { EffectComposer } from 'three/examples/jsm/postprocessing/EffectComposer.js';
import { OutputPass } from 'three/examples/jsm/postprocessing/OutputPass.js';
import { RenderPass } from 'three/examples/jsm/postprocessing/RenderPass.js';
import { UnrealBloomPass } from 'three/examples/jsm/postprocessing/UnrealBloomPass.js';
import { traceShape } from '../../../src/page/outline/traceShape.ts';
import { driveByScroll } from '../../../src/page/drivers/scroll.ts';
import type { Values } from '../../../src/parameters/parameter.ts';
import { findPreset, presetValues } from '../../../src/parameters/presets.ts';
import { createStage } from '../../../src/stage/stage.ts';
import { CartoonSmoke } from '../../../src/three/cartoonSmoke.ts';
import { emptyHost, makeRenderer, type Host } from './scene.ts';

const [WIDTH, HEIGHT] = [400, 225];

const LOOK: Values = {
  'emission.rate': 0,
  'emission.lifetime': 4,
  'emission.growthTime': 0.8,
  'buoyancy.acceleration': 0.5,
  'style.smokeColor': '#fff4e0',
  'style.outlineWidth': 1.5,
};

export type Recipe = 'composer' | 'mirror' | 'fog' | 'looks' | 'bursts' | 'timeline' | 'drivers' | 'flows' | 'shapes';
/** Gap between the shots of a picture, pixels. */
const GAP = 2;

interface Setting extends Host {
  smoke: CartoonSmoke;
  chimney: Mesh;
}

/** A house with a smoking chimney on a lawn. */
async function houseWithSmoke(values: Values = {}): Promise<Setting> {
  const host = emptyHost(makeRenderer({ antialias: true }, [WIDTH, HEIGHT]));
  const { scene, camera, keyLight, renderer } = host;
  scene.background = new Color('#8fc7e8');
  scene.add(new HemisphereLight('#cfe8ff', '#6a8a50', 1.2));
  keyLight.position.set(-3, 4.5, 4);
  camera.aspect = WIDTH / HEIGHT;
  camera.position.set(0.9, 1.9, 5.4);
  camera.lookAt(0.45, 1.5, 0);
  camera.updateProjectionMatrix();
  const solid = (geometry: BoxGeometry | ConeGeometry | CylinderGeometry | PlaneGeometry, color: string) => {
    const mesh = new Mesh(geometry, new MeshLambertMaterial({ color }));
    scene.add(mesh);
    return mesh;
  };
  solid(new PlaneGeometry(60, 60), '#86b35e').rotation.x = -Math.PI / 2;
  const wall = solid(new BoxGeometry(1.7, 1, 1.2), '#f0d8b0');
  wall.position.set(-0.4, 0.5, 0);
  const roof = solid(new ConeGeometry(1.45, 0.8, 4, 1), '#c05a48');
  roof.rotation.y = Math.PI / 4;
  roof.scale.z = 0.85;
  roof.position.set(-0.4, 1.4, 0);
  const chimney = solid(new CylinderGeometry(0.12, 0.14, 0.6, 12), '#8a5a50');
  chimney.position.set(-0.05, 1.6, 0.1);
  for (const x of [1.6, 2.3]) solid(new ConeGeometry(0.42, 1.5, 12), '#3f7d5a').position.set(x, 0.75, -0.8);
  const smoke = await CartoonSmoke.create({ renderer, keyLight, values: { ...LOOK, ...values } });
  scene.add(smoke);
  return { ...host, smoke, chimney };
}

function smokeRises({ smoke, chimney }: Setting): void {
  smoke.emitFrom(chimney, { rate: 13, size: 0.55, speed: 0.8, spread: 0.5 });
  smoke.set({ 'forces.wind.x': 0.45 });
  smoke.step(200);
}

/** The chimney's smoke by an emitter of the table, in a tall shot. */
async function chimneySmoke(values: Values): Promise<Setting> {
  const setting = await houseWithSmoke(values);
  const { camera, smoke, chimney } = setting;
  chimney.updateWorldMatrix(true, false);
  smoke.set({ 'emitters.0.position.x': chimney.position.x, 'emitters.0.position.y': 1.9, 'emitters.0.size': 0.5 });
  camera.position.set(0.25, 2, 5.6);
  camera.lookAt(0.2, 1.75, 0);
  return setting;
}

/** Draws shots side by side. @param shots what happens before each one */
async function drawShots({ renderer, scene, camera }: Setting, shots: readonly (() => unknown)[]): Promise<void> {
  const width = (WIDTH - GAP * (shots.length - 1)) / shots.length;
  camera.aspect = width / HEIGHT;
  camera.updateProjectionMatrix();
  renderer.setScissorTest(true);
  for (const [index, prepare] of shots.entries()) {
    await prepare();
    renderer.setViewport(index * (width + GAP), 0, width, HEIGHT);
    renderer.setScissor(index * (width + GAP), 0, width, HEIGHT);
    renderer.render(scene, camera);
  }
}

const RECIPES: Record<Recipe, () => Promise<[Setting, () => unknown]>> = {
  async composer() {
    const setting = await houseWithSmoke();
    const { renderer, scene, camera } = setting;
    scene.background = new Color('#2c3a66');
    const lamp = new Mesh(new SphereGeometry(0.16), new MeshBasicMaterial({ color: new Color(9, 6, 2.5) }));
    lamp.position.set(1.3, 1.4, 0.7);
    scene.add(lamp);
    smokeRises(setting);
    const target = new WebGLRenderTarget(WIDTH, HEIGHT, { type: HalfFloatType, samples: 4 });
    const composer = new EffectComposer(renderer, target);
    const bloom = new UnrealBloomPass(new Vector2(WIDTH, HEIGHT), 0.7, 0.5, 1);
    for (const pass of [new RenderPass(scene, camera), bloom, new OutputPass()]) composer.addPass(pass);
    return [setting, () => composer.render(0)];
  },

  async mirror() {
    const setting = await houseWithSmoke();
    const { renderer, scene, camera } = setting;
    const pond = new Reflector(new PlaneGeometry(9, 5.4), { textureWidth: 800, textureHeight: 450, color: 0xa8c8d8 });
    pond.rotation.x = -Math.PI / 2;
    pond.position.set(0.4, 0.01, 3.5);
    scene.add(pond);
    camera.position.set(0.8, 1.3, 7.4);
    camera.lookAt(0.4, 0.75, 0);
    smokeRises(setting);
    return [setting, () => renderer.render(scene, camera)];
  },

  async fog() {
    const setting = await houseWithSmoke();
    const { renderer, scene, camera, smoke, keyLight } = setting;
    scene.background = new Color('#d8e2ea');
    scene.fog = new Fog('#d8e2ea', 4, 15);
    for (const z of [-3, -6, -9]) {
      const from = new Mesh(new CylinderGeometry(0.14, 0.16, 1.4, 12), new MeshLambertMaterial({ color: '#8a5a50' }));
      from.position.set(1.3 - z / 2.2, 0.7, z);
      scene.add(from);
      smoke.emitFrom(from, { rate: 9, size: 0.6, speed: 1 });
    }
    keyLight.position.set(-3, 4.5, 4);
    smokeRises(setting);
    return [setting, () => renderer.render(scene, camera)];
  },

  async looks() {
    const setting = await houseWithSmoke();
    const { renderer, scene, camera, smoke } = setting;
    const at = (x: number, y: number, z: number) => {
      const object = new Object3D();
      object.position.set(x, y, z);
      scene.add(object);
      return object;
    };
    const fire = { rate: 40, size: 0.4, speed: 0.7, spread: 0.35, radius: 0.12 };
    smoke.emitFrom(at(1.25, 0.1, 1.1), {
      ...fire,
      look: {
        colors: '0:a02818,.3:ff8030,.7:ffd060',
        lifetime: 1.1,
        sizeCurve: '0:.5,.3:1,1:.1',
        dissolve: 'shrink',
        inkWeight: 0.7,
      },
    });
    smoke.emitFrom(at(2.15, 0.1, 0.5), {
      rate: 16,
      size: 0.42,
      speed: 0.7,
      spread: 0.3,
      look: { ageColors: '0:7ad0a0,.3:4a90c8,.6:5a4a98', lifetime: 2.4, inkWeight: 1.6 },
    });
    smokeRises(setting);
    return [setting, () => renderer.render(scene, camera)];
  },

  async timeline() {
    const setting = await chimneySmoke({
      'forces.wind.x': 0.3,
      timeline:
        '240;style.smokeColor/60*fff4e0/130*f0a070/200*7a5a90;emitters.0.speed/0*.8;emission.rate/0*4/120*4/121*40;burst/40*0*8',
    });
    const { smoke } = setting;
    const shots = [60, 130, 200].map((step) => () => smoke.step(step - smoke.stats.steps));
    return [setting, () => (smoke.restart(), drawShots(setting, shots))];
  },

  async shapes() {
    const heart = 'M0 -25C-15 -75 -90 -65 -85 -5C-80 45 -25 65 0 95C25 65 80 45 85 -5C90 -65 15 -75 0 -25Z';
    const setting = await chimneySmoke({
      'emission.rate': 260,
      'emission.lifetime': 6,
      'emission.growthTime': 0.4,
      'emission.density': '0:1,.9:.95,1:0',
      'simulation.maxParticles': 1600,
      'emitters.0.envelope.duration': 2.4,
      'emitters.0.lifetimeVariation': 0.1,
      'shapes.0.outline': await traceShape({ path: heart }),
      'shapes.0.speed': 2,
      'shapes.0.size': 1.5,
      'shapes.0.depth': 0.2,
      'shapes.0.position.x': 0.15,
      'shapes.0.position.y': 2.95,
      'shapes.0.envelope.duration': 4.6,
      'shapes.0.envelope.fade': 0.4,
      'style.simplify': 3,
    });
    const { smoke, camera } = setting;
    smoke.set({ 'emitters.0.size': 0.13 });
    camera.position.set(0.25, 2.2, 6.6);
    camera.lookAt(0.15, 2.1, 0);
    const shots = [70, 255, 330].map((step) => () => smoke.step(step - smoke.stats.steps));
    return [setting, () => (smoke.restart(), drawShots(setting, shots))];
  },

  async drivers() {
    const setting = await chimneySmoke({ 'emitters.0.speed': 0.8 });
    const { smoke } = setting;
    const scroller = document.createElement('div');
    scroller.style.cssText = 'height: 100px; overflow: auto';
    scroller.innerHTML = '<div style="height: 600px"></div>';
    document.body.append(scroller);
    driveByScroll(smoke, {
      scroller,
      drives: {
        'emission.rate': [5, 45],
        'style.smokeColor': ['#fff4e0', '#ee8a5c'],
        'forces.wind.x': [0, 1],
      },
    });
    const shots = [0, 0.5, 1].map((position) => async () => {
      smoke.restart();
      scroller.scrollTop = 500 * position;
      const rate = 5 + 40 * position;
      // The driver sets values once a step.
      for (let steps = 0; Math.abs(Number(smoke.get()['emission.rate']) - rate) > 0.1; ++steps) {
        if (steps > 60) throw new Error(`The driver did not set the rate ${rate}.`);
        await new Promise(requestAnimationFrame);
        smoke.step();
      }
      smoke.restart();
      smoke.step(110);
    });
    return [setting, () => drawShots(setting, shots)];
  },

  async flows() {
    const host = emptyHost(makeRenderer({ antialias: true }, [WIDTH, HEIGHT]));
    const { scene, camera, keyLight, renderer } = host;
    scene.background = new Color('#f0c890');
    scene.add(new HemisphereLight('#fff0d8', '#7a5a48', 1.3));
    keyLight.position.set(-3, 4.5, 4);
    camera.aspect = WIDTH / HEIGHT;
    camera.position.set(1.25, 1.5, 3);
    camera.lookAt(0.35, 1.4, 0);
    camera.updateProjectionMatrix();
    const door = new Mesh(doorWithKeyhole(), new MeshLambertMaterial({ color: '#8a4a3a' }));
    scene.add(door);
    const values: Values = {
      ...LOOK,
      'emission.rate': 70,
      'emission.lifetime': 4,
      'buoyancy.acceleration': 0,
      'emitters.0.position.y': 1.2,
      'emitters.0.position.z': -1,
      'emitters.0.radius': 0.1,
      'emitters.0.size': 0.17,
      'flows.0.points': '0:1.2:-1,0:1.35:-.3,0:1.35:.25,.5:1.15:.9,1.15:1.3:.8,1.3:1.85:.4,.85:2.2:.2',
      'flows.0.speed': 1.2,
      'flows.0.inflow': 1.2,
      'flows.0.radius': 0.4,
    };
    const smoke = await CartoonSmoke.create({ renderer, keyLight, values });
    scene.add(smoke);
    smoke.step(200);
    return [{ ...host, smoke, chimney: door }, () => renderer.render(scene, camera)];
  },

  async bursts() {
    const setting = await houseWithSmoke({
      'emission.lifetime': 1.6,
      'emission.growthTime': 0.2,
      'buoyancy.acceleration': 0.2,
    });
    const { renderer, scene, camera, smoke } = setting;
    const steps: [number, number, number, number][] = [
      [-0.9, 0.15, 1.6, 22],
      [0.1, 0.15, 1.8, 20],
      [1.1, 0.15, 1.9, 16],
      [2.1, 0.15, 2, 10],
    ];
    for (const [x, y, z, age] of steps) {
      void smoke.burst({
        position: { x, y, z },
        direction: { x: 0, y: 1, z: 0 },
        count: 18,
        speed: 1.3,
        size: 0.42,
        spread: 0.9,
      });
      smoke.step(age);
    }
    return [setting, () => renderer.render(scene, camera)];
  },
};

/** A door, 2 m wide, with its keyhole at a height of 1.35 m. */
function doorWithKeyhole(): ExtrudeGeometry {
  const door = new Shape().moveTo(-1, 0).lineTo(1, 0).lineTo(1, 2.6).lineTo(-1, 2.6).lineTo(-1, 0);
  const hole = new Path()
    .absarc(0, 1.35, 0.26, -1.2, Math.PI + 1.2, false)
    .lineTo(-0.2, 0.75)
    .lineTo(0.2, 0.75);
  door.holes.push(hole.closePath());
  return new ExtrudeGeometry(door, { depth: 0.14, bevelEnabled: false });
}

/** A recipe as a PNG. */
export async function pictureOf(recipe: Recipe): Promise<Blob> {
  const [{ renderer, smoke }, render] = await RECIPES[recipe]();
  await render();
  await smoke.complete();
  await render();
  const blob = await (renderer.domElement as unknown as OffscreenCanvas).convertToBlob({ type: 'image/png' });
  smoke.dispose();
  renderer.dispose();
  renderer.forceContextLoss();
  return blob;
}

/** Moments of a preset side by side, as a PNG. @param seconds their times */
export async function momentsOf(preset: string, seconds: readonly number[]): Promise<Blob> {
  const [width, height] = [208, 156];
  const values = presetValues(findPreset(preset)!);
  const stage = await createStage(new OffscreenCanvas(width, height), { values, width, height, pixelRatio: 1 });
  const canvas = new OffscreenCanvas(seconds.length * (width + GAP) - GAP, height);
  const context = canvas.getContext('2d')!;
  for (const [index, time] of seconds.entries()) {
    await stage.seek(time);
    const picture = await createImageBitmap(await stage.picture());
    context.drawImage(picture, index * (width + GAP), 0);
  }
  stage.dispose();
  return canvas.convertToBlob({ type: 'image/png' });
}
