/** Lights of a host's scene at the glowing parts of smoke. */
import { Group, Mesh, MeshStandardMaterial, PlaneGeometry, PointLight, Vector3 } from 'three';
import type { Values } from '../../../../src/parameters/parameter.ts';
import type { CartoonSmoke } from '../../../../src/three/cartoonSmoke.ts';
import { dispose, draw, emptyHost, smokeIn, type Host } from '../scene.ts';

/** A fire without other light. */
const FIRE: Values = {
  'emission.rate': 70,
  'emission.lifetime': 2,
  'emission.growthTime': 0.3,
  'buoyancy.coolingTime': 0.85,
  'emitters.0.radius': 0.3,
  'emitters.0.size': 0.34,
  'emitters.0.temperature': 1,
  'style.heatRamp': '0:7a7494,.3:ea7a38,.8:ffe38c',
  'emission.glow': '.2:0,.4:1',
  'simulation.maxParticles': 300,
};

/** What a light does: its place in the world, colour and intensity. */
type Shown = number[];

/** A dark scene with fire and its lights. */
async function fire(values: Values = {}, options: object = {}): Promise<Host & { smoke: CartoonSmoke }> {
  const host = emptyHost();
  host.scene.traverse((object) => Object.assign(object, 'intensity' in object ? { intensity: 0 } : {}));
  const smoke = await smokeIn(host, { ...FIRE, ...values }, options);
  smoke.add(...smoke.glowLights);
  return { ...host, smoke };
}

function shown({ smoke }: { smoke: CartoonSmoke }): Shown[] {
  return smoke.glowLights.map((light) => [
    ...light.getWorldPosition(new Vector3()).toArray(),
    ...light.color.toArray(),
    light.intensity,
  ]);
}

/** The lights while a camera orbits, and the colour of the ground below the fire and away from it. */
export async function orbiting(): Promise<{ lights: Shown[][]; near: number[]; far: number[] }> {
  const host = await fire();
  host.smoke.step(120);
  const ground = new Mesh(new PlaneGeometry(30, 30), new MeshStandardMaterial({ color: '#ffffff' }));
  ground.rotation.x = -Math.PI / 2;
  host.scene.add(ground);
  const lights = [0, 1, 2, 3].map((quarter) => {
    host.camera.position.set(5 * Math.sin(quarter), 2, 5 * Math.cos(quarter));
    host.camera.lookAt(0, 0.8, 0);
    draw(host);
    return shown(host);
  });
  host.scene.remove(host.smoke);
  host.scene.add(...host.smoke.glowLights);
  host.camera.position.set(0, 12, 0.01);
  host.camera.lookAt(0, 0, 0);
  const pixels = draw(host);
  const { width, height } = host.renderer.domElement;
  const at = (right: number) => [...pixels.subarray(4 * ((height / 2) * width + width / 2 + right)).subarray(0, 3)];
  const result = { lights, near: at(8), far: at(80) };
  dispose(host.smoke, host.renderer);
  return result;
}

/** The lights after steps, after the same steps at once, and after a restored state. */
export async function repeated(): Promise<{ stepped: Shown[]; atOnce: Shown[]; restored: Shown[]; hashes: string[] }> {
  const [one, other] = [await fire(), await fire()];
  for (let step = 0; step < 90; ++step) one.smoke.step();
  const state = one.smoke.save();
  const stepped = shown(one);
  // Another smoke, which nobody asks for lights.
  const silent = await fire({ 'emission.glow': '0:0,1:0' });
  silent.smoke.step(90);
  other.smoke.step(90);
  const atOnce = shown(other);
  other.smoke.step(30);
  other.smoke.restore(state);
  const restored = shown(other);
  const hashes = [one, silent].map(({ smoke }) => smoke.hash());
  for (const { smoke, renderer } of [one, other, silent]) dispose(smoke, renderer);
  return { stepped, atOnce, restored, hashes };
}

/** Lights of smoke that is moved, turned and enlarged, of local smoke, and of smoke at the origin. */
export async function placed(): Promise<Record<'plain' | 'world' | 'local', Shown[]>> {
  const result: Partial<Record<'plain' | 'world' | 'local', Shown[]>> = {};
  for (const space of ['plain', 'world', 'local'] as const) {
    const host = await fire({ 'forces.turbulence': 0 }, space === 'plain' ? {} : { space });
    if (space !== 'plain') {
      const parent = new Group();
      parent.position.set(3, 1, -2);
      parent.rotation.y = 0.5;
      host.scene.add(parent);
      parent.add(host.smoke);
      host.smoke.scale.setScalar(2);
    }
    // The first steps were elsewhere.
    host.smoke.restart();
    host.smoke.step(60);
    result[space] = shown(host);
    dispose(host.smoke, host.renderer);
  }
  return result as Record<'plain' | 'world' | 'local', Shown[]>;
}

/** The lights before smoke, without glow, with glow, after a clear, and after disposal, and whether they are the same. */
export async function life() {
  const host = await fire({ 'emission.glow': '0:0,1:0' });
  const { smoke } = host;
  const first = smoke.glowLights;
  const intensity = () => first.reduce((sum, light) => sum + light.intensity, 0);
  const before = intensity();
  smoke.step(60);
  const withoutGlow = intensity();
  smoke.set({ 'emission.glow': '0:1,1:1' });
  const withGlow = intensity();
  const between = [0, 0.01].map((seconds) => {
    smoke.update(seconds);
    return first[0].position.y;
  });
  smoke.clear();
  const cleared = intensity();
  smoke.step(30);
  const isSame = first === smoke.glowLights && first.every((light) => light instanceof PointLight);
  smoke.dispose();
  const disposed = intensity();
  dispose(host.smoke, host.renderer);
  return { before, withoutGlow, withGlow, cleared, isSame, disposed, moved: between[1] !== between[0] };
}
