/** render.host: the scene of `examples/three` with smoke, compared with the same scene without, in turns. */
import { ACESFilmicToneMapping, PCFShadowMap, PerspectiveCamera, WebGLRenderer } from 'three';
import { makeScene, type ExampleScene } from '../../../examples/three/scene.ts';
import { CartoonSmoke } from '../../../src/three/cartoonSmoke.ts';
import { demand, figure, say, time, type Figure } from '../support/figures.ts';
import { HEIGHT, WIDTH } from './bench.ts';

const STEPS = 360;

export async function measureHost(quick: boolean): Promise<Figure[]> {
  return [...(await measureAt(true, quick ? 5 : 9, '')), ...(await measureAt(false, quick ? 5 : 9, '.single'))];
}

async function measureAt(antialias: boolean, rounds: number, suffix: string): Promise<Figure[]> {
  const host = await ExampleHost.create(antialias);
  demand(host.smoke.stats.castersDrawn > 50, `smoke has ${host.smoke.stats.castersDrawn} casters`);
  const [withSmoke, without]: number[][] = [[], []];
  for (let round = 0; round < rounds; round++) {
    await say(`render.host${suffix}, round ${round + 1} of ${rounds}`);
    const runs = [() => withSmoke.push(host.draw(true)), () => without.push(host.draw(false))];
    for (const run of round % 2 === 0 ? runs : runs.toReversed()) run();
  }
  const note = `${host.smoke.stats.bodiesDrawn} bodies, ${host.smoke.stats.castersDrawn} casters, ${WIDTH} x ${HEIGHT}`;
  host.dispose();
  return [
    figure(
      `render.host${suffix}`,
      'x',
      withSmoke.map((milliseconds, round) => milliseconds / without[round]),
      `the example scene with smoke / without, ${antialias ? '4 samples' : '1 sample'} a pixel; ${note}`,
    ),
  ];
}

/** The example with its smoke after six seconds. */
export class ExampleHost {
  readonly renderer: WebGLRenderer;
  readonly smoke: CartoonSmoke;
  private readonly example: ExampleScene;
  private readonly camera = new PerspectiveCamera(40, WIDTH / HEIGHT, 0.1, 60);

  private constructor(renderer: WebGLRenderer, example: ExampleScene, smoke: CartoonSmoke) {
    this.renderer = renderer;
    this.example = example;
    this.smoke = smoke;
    this.camera.position.set(3.2, 2.4, 6.4);
    this.camera.lookAt(0, 1.1, 0);
  }

  static async create(antialias: boolean): Promise<ExampleHost> {
    const canvas = new OffscreenCanvas(WIDTH, HEIGHT);
    const renderer = new WebGLRenderer({ canvas, antialias, stencil: true });
    renderer.setSize(WIDTH, HEIGHT, false);
    renderer.toneMapping = ACESFilmicToneMapping;
    renderer.shadowMap.enabled = true;
    renderer.shadowMap.type = PCFShadowMap;
    const example = await makeScene();
    example.animate(0);
    const { keyLight, setInShadow, chimney, obstacles, casters } = example;
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
    example.scene.add(smoke);
    smoke.emitFrom(chimney);
    for (const obstacle of obstacles) smoke.collide(obstacle);
    for (const caster of casters) smoke.cast(caster);
    smoke.step(STEPS);
    const host = new ExampleHost(renderer, example, smoke);
    for (const isThere of [false, true]) host.draw(isThere);
    return host;
  }

  /** Milliseconds of a frame until all draw calls are complete. */
  draw(isThere: boolean): number {
    const {
      example: { scene },
      smoke,
      renderer,
      camera,
    } = this;
    const gl = renderer.getContext();
    if (isThere) scene.add(smoke);
    else smoke.removeFromParent();
    const pixel = new Uint8Array(4);
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
    return time(() => {
      renderer.render(scene, camera);
      gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
    });
  }

  dispose(): void {
    this.smoke.dispose();
    this.renderer.forceContextLoss();
  }
}
