/** Runs the code of the share sheet. */
import * as fiber from '@react-three/fiber';
import * as react from 'react';
import { createRoot } from 'react-dom/client';
import * as three from 'three';
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';
import { elementCode, type EmbedOptions } from '../../../src/demo/share/embed.ts';
import { puffCall } from '../../../src/demo/effects/code.ts';
import { fiberCode, sceneOf, threeCode } from '../../../src/demo/share/sceneCode.ts';
import * as smokeInReact from '../../../src/fiber.ts';
import * as library from '../../../src/index.ts';
import { encode, findPreset, presetValues, type PresetName, type Values } from '../../../src/preset.ts';
import * as puffs from '../../../src/puff.ts';
import { threadDevice } from '../../../src/stage/remote/openHere.ts';
import { createStage } from '../../../src/stage/stage.ts';
import { keepPrograms } from '../pageDevice.ts';

/** The ring of `air-ring` is 2.2 m wide, at 150 pixels per metre. */
const [WIDTH, HEIGHT] = [320, 180];
const OPTIONS: EmbedOptions = {
  width: WIDTH,
  ratio: [16, 9],
  isTransparent: false,
  isInteractive: false,
  alt: '',
  hasPoster: false,
};

export type Kind = 'three' | 'fiber' | 'element' | 'puff';

/** What the code shows. */
export interface Shown {
  /** Computed background of the box of the smoke. */
  background?: string;
  /** Pixels that are covered after four seconds, and living particles. */
  covered?: number;
  alive?: number;
  values?: Values;
  /** What was written to the console. */
  said: string[];
}

/** The code of each kind for a preset. */
export async function codesFor(
  name: PresetName,
  changed: Values = {},
  options: Partial<EmbedOptions> = {},
): Promise<Record<Kind, string>> {
  const values = { ...presetValues(findPreset(name)!), ...changed };
  const chosen = { ...OPTIONS, ...options };
  const canvas = document.createElement('canvas');
  canvas.style.cssText = `width: ${WIDTH}px; height: ${HEIGHT}px`;
  document.body.replaceChildren(canvas);
  const device = threadDevice.acquire();
  const stage = await createStage(canvas, { values, width: WIDTH, height: HEIGHT, device, visible: false });
  const scene = sceneOf(stage);
  stage.dispose();
  return {
    three: threeCode(scene, chosen),
    fiber: fiberCode(scene, chosen),
    element: elementCode(`https://example.org/${await encode({ preset: name, values })}`, chosen),
    puff: await puffCall({ preset: name, values }),
  };
}

const AsyncFunction = (async () => {}).constructor as new (
  ...parts: string[]
) => (...values: unknown[]) => Promise<unknown>;

/** Runs a module's code with these modules. @param result expression of its result */
function execute(code: string, modules: Record<string, unknown>, result: string): Promise<unknown> {
  const body = code
    .replaceAll(/^import (\{[^}]*\}) from ["']([^"']+)["'];$/gm, `const $1 = modules['$2'];`)
    .replaceAll(/^export /gm, '');
  if (/^import /m.test(body)) throw new Error(`This import was not replaced: ${body}`);
  return new AsyncFunction('modules', 'React', 'button', `${body}\nreturn ${result};`)(modules, react, document.body);
}

/** @param code plain JavaScript, for React without JSX */
export async function run(kind: Kind, code: string): Promise<Shown> {
  const said: string[] = [];
  const { warn, error } = console;
  console.warn = console.error = (...parts: unknown[]) => {
    // React Three Fiber uses it.
    if (!String(parts[0]).startsWith('THREE.Clock')) said.push(parts.map(String).join(' '));
  };
  document.body.replaceChildren();
  try {
    return { ...(await RUNS[kind](code)), said };
  } finally {
    Object.assign(console, { warn, error });
  }
}

interface SceneOfPage {
  renderer: three.WebGLRenderer;
  scene: three.Scene;
  camera: three.Camera;
  smoke: library.CartoonSmoke;
}

/** One renderer for the code of all presets, created with the options of the first, so that programs compile once. */
function sharedRenderer(): (options?: three.WebGLRendererParameters) => three.WebGLRenderer {
  let renderer: three.WebGLRenderer | undefined;
  return (options) => {
    renderer ??= new three.WebGLRenderer(options);
    renderer.forceContextLoss = () => undefined;
    return renderer;
  };
}

const rendererOfThree = sharedRenderer();
const rendererOfFiber = sharedRenderer();

const RUNS: Readonly<Record<Kind, (code: string) => Promise<Omit<Shown, 'said'>>>> = {
  async three(code) {
    const WebGLRenderer = function (options: three.WebGLRendererParameters) {
      return rendererOfThree(options);
    };
    const modules = {
      three: { ...three, WebGLRenderer },
      'three/addons/controls/OrbitControls.js': { OrbitControls },
      'cartoon-smoke': library,
    };
    const result = (await execute(code, modules, '{ renderer, scene, camera, smoke }')) as SceneOfPage;
    const { renderer, smoke } = result;
    await nextFrame();
    const shown = drawn(result);
    renderer.setAnimationLoop(null);
    smoke.dispose();
    return { ...shown, background: backgroundOf(document.querySelector('canvas')!) };
  },
  async fiber(code) {
    const found: { state?: fiber.RootState; smoke?: library.CartoonSmoke } = {};
    const Canvas = ({ onCreated, ...props }: fiber.CanvasProps) =>
      react.createElement(fiber.Canvas, {
        ...props,
        gl: (defaults) => rendererOfFiber({ ...defaults, ...(props.gl as three.WebGLRendererParameters) }),
        onCreated: (state) => {
          found.state = state;
          onCreated?.(state);
        },
      });
    const ref = (smoke: library.CartoonSmoke | null) => void (found.smoke ??= smoke ?? undefined);
    const Smoke = (props: smokeInReact.SmokeProps) => react.createElement(smokeInReact.Smoke, { ...props, ref });
    const modules = {
      react,
      '@react-three/fiber': { ...fiber, Canvas },
      // Not installed: its controls are those of three.js.
      '@react-three/drei': { OrbitControls: () => null },
      'cartoon-smoke/fiber': { ...smokeInReact, Smoke },
    };
    const SmokeScene = (await execute(code, modules, 'SmokeScene')) as react.FunctionComponent;
    const box = document.createElement('div');
    document.body.append(box);
    const root = createRoot(box);
    root.render(react.createElement(SmokeScene));
    while (!found.smoke || !found.state) await nextFrame();
    const { gl: renderer, scene, camera } = found.state;
    const shown = drawn({ renderer, scene, camera, smoke: found.smoke });
    const background = backgroundOf(box.firstElementChild!);
    root.unmount();
    return { ...shown, background };
  },
  async element(code) {
    await import('../../../src/element.ts');
    document.body.innerHTML = code;
    const element = document.querySelector('cartoon-smoke') as library.CartoonSmokeElement;
    await element.ready;
    const values = await element.get();
    element.remove();
    return { values };
  },
  async puff(code) {
    await execute(code, { 'cartoon-smoke/puff': puffs }, 'undefined');
    await puffs.puff.preload();
    return { covered: document.querySelectorAll('canvas').length };
  },
};

function nextFrame(): Promise<unknown> {
  return new Promise((resolve) => requestAnimationFrame(resolve));
}

/** Draws the smoke after four seconds: some scenes begin late or outside of the view. */
function drawn({ renderer, scene, camera, smoke }: SceneOfPage): Pick<Shown, 'covered' | 'alive'> {
  smoke.step(240);
  renderer.render(scene, camera);
  keepPrograms(renderer);
  const { width, height } = renderer.domElement;
  const pixels = new Uint8Array(4 * width * height);
  const gl = renderer.getContext();
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  return { covered: pixels.filter((value, at) => at % 4 === 3 && value > 128).length, alive: smoke.stats.alive };
}

function backgroundOf(box: Element): string {
  const { backgroundImage, backgroundColor } = getComputedStyle(box);
  return backgroundImage === 'none' ? backgroundColor : backgroundImage;
}
