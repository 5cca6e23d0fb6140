/**
 * three.quarks with the same puffs, drawn as particle libraries do: soft textured quads that face the camera, blended,
 * unsorted.
 */
import {
  BufferAttribute,
  BufferGeometry,
  CustomBlending,
  DataTexture,
  FloatType,
  Mesh,
  MeshBasicMaterial,
  NearestFilter,
  OneFactor,
  Scene,
  WebGLRenderTarget,
  type Material,
  type Matrix4,
  type PerspectiveCamera,
  type WebGLRenderer,
} from 'three';
import { BatchedRenderer, ConstantValue, ParticleSystem, PointEmitter, RenderMode } from 'three.quarks';
import type { SurfaceDescription } from '../../../src/renderer/passes/surface.ts';

/** Side of the soft disc, texels. */
const SOFT_DISC = 64;

export class QuarksScene {
  private readonly scene = new Scene();
  private readonly batches = new BatchedRenderer();
  private readonly system: ParticleSystem;
  private readonly softDisc = softDisc();

  /**
   * @param places x, y, z and radius of each puff, metres: the width of a quad is the diameter of its puff
   * @param transforms of the surfaces, if they have any
   */
  constructor(places: Float32Array, surfaces: readonly SurfaceDescription[], transforms: readonly Matrix4[] = []) {
    this.system = new ParticleSystem({
      looping: false,
      duration: 1e6,
      startLife: new ConstantValue(1e6),
      startSpeed: new ConstantValue(0),
      worldSpace: true,
      emissionOverTime: new ConstantValue(0),
      emissionBursts: [{ time: 0, count: new ConstantValue(places.length / 4), cycle: 1, interval: 0, probability: 1 }],
      shape: new PointEmitter(),
      renderMode: RenderMode.BillBoard,
      material: new MeshBasicMaterial({ map: this.softDisc, transparent: true, depthWrite: false }),
    });
    this.batches.addSystem(this.system);
    this.scene.add(
      this.system.emitter,
      this.batches,
      ...surfaces.map((surface, at) => plainMesh(surface, transforms[at])),
    );
    this.batches.update(1);
    this.system.particles.forEach(({ position, velocity, size }, i) => {
      position.set(places[4 * i], places[4 * i + 1], places[4 * i + 2]);
      velocity.set(0, 0, 0);
      size.setScalar(2 * places[4 * i + 3]);
    });
  }

  get alive(): number {
    return this.system.particleNum;
  }

  /** A frame of an application: fills the buffers for moved particles, then draws everything to the canvas. */
  draw(renderer: WebGLRenderer, camera: PerspectiveCamera): void {
    this.batches.update(0);
    renderer.setRenderTarget(null);
    renderer.setClearColor(0x2b2d5c, 1);
    renderer.clear(true, true, true);
    renderer.render(this.scene, camera);
  }

  /** Number of fragments of its quads, counted with additive blending. */
  countFragments(renderer: WebGLRenderer, camera: PerspectiveCamera, width: number, height: number): number {
    const target = new WebGLRenderTarget(width, height, {
      type: FloatType,
      minFilter: NearestFilter,
      magFilter: NearestFilter,
      depthBuffer: false,
    });
    const [{ material }] = this.batches.batches as unknown as { material: Material }[];
    const { blending } = material;
    const soft = [...(this.softDisc.image.data as Uint8Array)];
    this.paint(soft.map(() => 255));
    this.batches.update(0);
    Object.assign(material, { blending: CustomBlending, blendSrc: OneFactor, blendDst: OneFactor });
    renderer.setRenderTarget(target);
    renderer.setClearColor(0x000000, 0);
    renderer.clear(true, false, false);
    renderer.render(this.batches, camera);
    const pixels = new Float32Array(4 * width * height);
    renderer.readRenderTargetPixels(target, 0, 0, width, height, pixels);
    renderer.setRenderTarget(null);
    target.dispose();
    material.blending = blending;
    this.paint(soft);
    return pixels.reduce((sum, value, index) => (index % 4 === 0 ? sum + value : sum), 0);
  }

  dispose(): void {
    this.system.dispose();
    this.softDisc.dispose();
  }

  private paint(texels: ArrayLike<number>): void {
    (this.softDisc.image.data as Uint8Array).set(texels);
    this.softDisc.needsUpdate = true;
  }
}

/** White, with an alpha that decreases smoothly from the centre. */
function softDisc(): DataTexture {
  const texels = new Uint8Array(4 * SOFT_DISC * SOFT_DISC).fill(255);
  for (let i = 0; i < SOFT_DISC * SOFT_DISC; i++) {
    const [x, y] = [i % SOFT_DISC, Math.floor(i / SOFT_DISC)].map((at) => (2 * (at + 0.5)) / SOFT_DISC - 1);
    texels[4 * i + 3] = Math.round(64 * Math.max(0, 1 - Math.hypot(x, y)) ** 2);
  }
  const texture = new DataTexture(texels, SOFT_DISC, SOFT_DISC);
  texture.needsUpdate = true;
  return texture;
}

function plainMesh({ mesh, color }: SurfaceDescription, transform?: Matrix4): Mesh {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(mesh.positions, 3));
  geometry.setIndex(new BufferAttribute(mesh.indices, 1));
  const [red, green, blue] = color;
  const plain = new Mesh(geometry, new MeshBasicMaterial({ color: (red << 16) | (green << 8) | blue }));
  if (transform) plain.applyMatrix4(transform);
  return plain;
}
