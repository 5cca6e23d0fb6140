/** Code that shows the current smoke in a three.js scene of its own. */
import { findParameter, type AnyValues, type Value, type Values } from '../../preset.ts';
import { readTimeline, writeTimeline, type Stage, type Timeline } from '../../index.ts';
import { readRamp } from '../../internal.ts';
import { styleOf, type EmbedOptions } from './embed.ts';

type Numbers = readonly [number, number, number];

/** What the code needs of the page's scene. */
export interface SceneOfCode {
  /** Values that differ from those of `CartoonSmoke.create` without values. */
  readonly values: Values;
  /** Position of the camera and the point that it looks at, in metres. */
  readonly eye: Numbers;
  readonly centre: Numbers;
  /** Vertical field of view in degrees. */
  readonly fieldOfView: number;
  /** Towards the light, at a distance that lights the scene evenly. */
  readonly light: Numbers;
  /** CSS of the backdrop. */
  readonly background: string;
}

/** Values of `CartoonSmoke` that differ from the table. */
const OWN: AnyValues = { 'emitters.0.shape': 'disc', 'emitters.0.share': 1 };
/** What a scene of three.js has of its own. */
const OF_SCENE =
  /^(scene$|light\.(kind|azimuth|elevation|distance|decay)$|camera\.|style\.(renderer|backdrop|volumes)$)|\.rigid$/;
const NEEDED = ['seed', 'simulation.maxParticles'];
/** The shape of emitters on meshes, as scenes write it. */
const SURFACE = 8;
const BACKGROUND = '#9ac4d6';
const LIGHT_DISTANCE = 10;

/** Reads what the code needs of a stage. */
export function sceneOf(stage: Stage): SceneOfCode {
  const all = placed(stage);
  const { plane, centre } = stage.sight;
  const canvas = stage.canvas as HTMLCanvasElement;
  const distance = all['camera.distance'] as number;
  const [right, up] = [unit(plane.right), unit(plane.up)];
  const halfHeight = (Math.hypot(...plane.up) * canvas.clientHeight) / 2;
  const back = cross(right, up);
  const timeline = timelineOf(all);
  const silent = silentEmitters(all, timeline);
  // The first emitter of a three.js scene emits by default.
  const isSilent = (key: string) => key !== 'emitters.0.share' && silent.has(emitterOf(key) ?? '');
  const carried = Object.entries(all).filter(([key, value]) => isCarried(key, value) && !isSilent(key));
  return {
    values: { ...Object.fromEntries(carried), ...(timeline.length > 0 && { timeline: writeTimeline(timeline) }) },
    eye: rounded(centre.map((at, axis) => at + distance * back[axis])),
    centre: rounded([...centre]),
    fieldOfView: Math.round((Math.atan(halfHeight / distance) * 3600) / Math.PI) / 10,
    light: lightOf(all),
    background: gradientOf(String(all['style.backdrop'] ?? '')),
  };
}

/**
 * All values; emitters and forces that move with an object of the page's scene are where it is now, and smoke of surfaces
 * comes from balls in the middle of the picture.
 */
function placed(stage: Stage): AnyValues {
  const all: Record<string, Value> = { ...stage.rig, ...stage.get() };
  for (const key of ridingKeys(stage)) {
    const axes = ['x', 'y', 'z'].map((axis) => `${key.replace(/rigid$/, 'position')}.${axis}`);
    if (!findParameter(axes[0])) continue;
    const [x, y, z] = axes.map((axis) => (all[axis] ?? findParameter(axis)!.default) as number);
    const place = rounded([...stage.sight.change([x, y, z], all[key] as number, -1)]);
    axes.forEach((axis, index) => (all[axis] = place[index]));
  }
  for (const [key, shape] of Object.entries(all)) {
    const emitter = /^(emitters\.\d)\.shape$/.exec(key)?.[1];
    if (!emitter || (shape !== 'surface' && shape !== SURFACE)) continue;
    const [x, y, z] = rounded([...stage.sight.centre]);
    const position = { [`${emitter}.position.x`]: x, [`${emitter}.position.y`]: y, [`${emitter}.position.z`]: z };
    Object.assign(all, { ...position, [key]: 'ball', [`${emitter}.radius`]: (all['camera.distance'] as number) / 8 });
    delete all[`${emitter}.surface`];
  }
  return all;
}

/** Keys of the emitters and forces that move with an object of the page's scene, which the code does not have. */
export function ridingKeys(stage: Stage): string[] {
  const all: AnyValues = { ...stage.rig, ...stage.get() };
  return Object.keys(all).filter((key) => key.endsWith('.rigid') && (all[key] as number) >= 0);
}

function isCarried(key: string, value: Value): boolean {
  return isOfSmoke(key) && value !== (OWN[key] ?? findParameter(key)!.default);
}

/** Whether a parameter is one of the smoke, and not of the scene. */
function isOfSmoke(key: string): boolean {
  const parameter = findParameter(key);
  if (!parameter || OF_SCENE.test(key)) return false;
  return NEEDED.includes(key) || ['simulator', 'style', 'light'].includes(parameter.reader);
}

/** The timeline, with the lanes that the code carries. Without any, its length is 0. */
function timelineOf(values: AnyValues): Timeline {
  const { timeline } = readTimeline(String(values.timeline ?? ''));
  const lanes = timeline.lanes.filter(({ key }) => isOfSmoke(key));
  const isEmpty = lanes.length === 0 && timeline.bursts.length === 0;
  return { ...timeline, lanes, length: isEmpty ? 0 : timeline.length };
}

/** The emitters that emit nothing, such as `emitters.3.`. */
function silentEmitters(values: AnyValues, { bursts, lanes }: Timeline): Set<string> {
  const led = new Set([
    ...bursts.map(({ emitter }) => `emitters.${emitter}.`),
    ...lanes.map(({ key }) => emitterOf(key)),
  ]);
  const all = new Set(Object.keys(values).flatMap((key) => emitterOf(key) ?? []));
  const emits = (emitter: string) =>
    values[`${emitter}share`] !== 0 || values[`${emitter}burst.count`] || values[`${emitter}perMetre`];
  return new Set([...all].filter((emitter) => !led.has(emitter) && !emits(emitter)));
}

/** Start of the keys of its emitter. */
function emitterOf(key: string): string | undefined {
  return /^emitters\.\d\./.exec(key)?.[0];
}

/** A backdrop as CSS, which blends its colours as the page does. */
function gradientOf(ramp: string): string {
  const stops = (readRamp(ramp) ?? []).map(({ at, color }) => `${color} ${Number((100 * at).toFixed(1))}%`);
  return stops.length > 0 ? `linear-gradient(to top, ${stops.join(', ')})` : BACKGROUND;
}

function lightOf(values: Values): Numbers {
  const [azimuth, elevation] = (['azimuth', 'elevation'] as const).map(
    (key) => (values[`light.${key}`]! * Math.PI) / 180,
  );
  const across = LIGHT_DISTANCE * Math.cos(elevation);
  return rounded([across * Math.sin(azimuth), LIGHT_DISTANCE * Math.sin(elevation), across * Math.cos(azimuth)]);
}

/** A page with three.js. */
export function threeCode(scene: SceneOfCode, options: EmbedOptions): string {
  const { isTransparent, isInteractive, alt } = options;
  const [across, up] = options.ratio;
  const lines = [
    isInteractive && `import { OrbitControls } from 'three/addons/controls/OrbitControls.js';`,
    `import { CartoonSmoke } from 'cartoon-smoke';`,
    `import { DirectionalLight, PerspectiveCamera, Scene, Timer, WebGLRenderer } from 'three';`,
    '',
    `const renderer = new WebGLRenderer({ antialias: true, alpha: true, stencil: true });`,
    `const canvas = renderer.domElement;`,
    alt ? `canvas.role = 'img';\ncanvas.ariaLabel = ${text(alt)};` : `canvas.ariaHidden = 'true';`,
    `canvas.style.cssText = ${text(isTransparent ? styleOf(options) : `${styleOf(options)}; background: ${scene.background}`)};`,
    `document.body.append(canvas);`,
    `renderer.setPixelRatio(Math.min(devicePixelRatio, 2));`,
    '',
    `const scene = new Scene();`,
    `const camera = new PerspectiveCamera(${scene.fieldOfView}, ${across} / ${up}, 0.1, 200);`,
    `camera.position.set(${scene.eye.join(', ')});`,
    isInteractive
      ? `const controls = new OrbitControls(camera, canvas);\ncontrols.target.set(${scene.centre.join(', ')});\ncontrols.update();`
      : `camera.lookAt(${scene.centre.join(', ')});`,
    `const keyLight = new DirectionalLight('white', 3);`,
    `keyLight.position.set(${scene.light.join(', ')});`,
    `const smoke = await CartoonSmoke.create({ renderer, keyLight, values: ${literal(scene.values, '')} });`,
    `scene.add(keyLight, smoke);`,
    '',
    `const timer = new Timer();`,
    `renderer.setAnimationLoop((now) => {`,
    `  renderer.setSize(canvas.clientWidth, canvas.clientHeight, false);`,
    `  timer.update(now);`,
    `  smoke.update(timer.getDelta());`,
    `  renderer.render(scene, camera);`,
    `});`,
  ];
  return lines.filter((line) => line !== false).join('\n');
}

/** A component for React Three Fiber. */
export function fiberCode(scene: SceneOfCode, options: EmbedOptions): string {
  const { isTransparent, isInteractive, alt, width, ratio } = options;
  const sides = width === undefined ? `width: '100%'` : `width: ${width}, maxWidth: '100%'`;
  const background = isTransparent ? '' : `, background: '${scene.background}'`;
  const name = alt ? ` role="img" aria-label={${text(alt)}}` : ' aria-hidden';
  const camera = `{ position: [${scene.eye.join(', ')}], fov: ${scene.fieldOfView} }`;
  const [target, light] = [scene.centre, scene.light].map((place) => `[${place.join(', ')}]`);
  const lines = [
    isInteractive && `import { OrbitControls } from '@react-three/drei';`,
    `import { Canvas } from '@react-three/fiber';`,
    `import { Smoke } from 'cartoon-smoke/fiber';`,
    `import { useRef } from 'react';`,
    '',
    `const VALUES = ${literal(scene.values, '')};`,
    '',
    `function Scene() {`,
    `  const keyLight = useRef(null);`,
    `  return (`,
    `    <Smoke keyLight={keyLight} values={VALUES}>`,
    `      <directionalLight ref={keyLight} position={${light}} intensity={3} />`,
    isInteractive && `      <OrbitControls target={${target}} />`,
    `    </Smoke>`,
    `  );`,
    `}`,
    '',
    `export function SmokeScene() {`,
    `  return (`,
    `    <div style={{ ${sides}, aspectRatio: '${ratio.join(' / ')}'${background} }}${name}>`,
    `      <Canvas flat gl={{ stencil: true }} camera={${camera}} onCreated={({ camera }) => camera.lookAt(${scene.centre.join(', ')})}>`,
    `        <Scene />`,
    `      </Canvas>`,
    `    </div>`,
    `  );`,
    `}`,
  ];
  return lines.filter((line) => line !== false).join('\n');
}

/** An object of values as code. */
function literal(values: Values, indent: string): string {
  const entries = Object.entries(values);
  if (entries.length === 0) return '{}';
  const lines = entries.map(([key, value]) => {
    const name = /^\w+$/.test(key) ? key : text(key);
    return `${indent}  ${name}: ${typeof value === 'string' ? text(value) : value},`;
  });
  return `{\n${lines.join('\n')}\n${indent}}`;
}

/** A string as code, also inside a script element. */
function text(value: string): string {
  const escaped = JSON.stringify(value).slice(1, -1).replaceAll('\\"', '"').replaceAll('<', '\\x3C');
  return `'${escaped.replaceAll("'", "\\'")}'`;
}

function rounded(numbers: readonly number[]): Numbers {
  return numbers.map((value) => Math.round(value * 1000) / 1000 + 0) as unknown as Numbers;
}

function unit(vector: Numbers): Numbers {
  const length = Math.hypot(...vector);
  return vector.map((value) => value / length) as unknown as Numbers;
}

function cross([a, b, c]: Numbers, [x, y, z]: Numbers): Numbers {
  return [b * z - c * y, c * x - a * z, a * y - b * x];
}
