/** A scene of the demo with its simulator, drawn for any camera, by default without the edge filter: colours are flat. */
import { PerspectiveCamera, Vector3, type Box3, type Camera } from 'three';
import type { Values } from '../../src/parameters/parameter.ts';
import type { DebugView } from '../../src/parameters/quality.ts';
import { findPreset, presetValues } from '../../src/parameters/presets.ts';
import type { CameraPose, MovingPart, Scene } from '../../src/scenes/scene.ts';
import { sceneNamed } from '../../src/scenes/scenes.ts';
import { loadSimulators } from '../../src/simulator/load.ts';
import { PLACE_FLOATS } from '../../src/simulator/layout.ts';
import type { Simulator } from '../../src/simulator/simulator.ts';
import { deviationFor, drawnSurfaces } from '../../src/renderer/sceneSurfaces.ts';
import { fetchExtras, fetchTimelineText } from '../../src/renderer/extraPasses.ts';
import { drawFrame } from '../../src/renderer/frame.ts';
import type { Arranger, FrameInput, FrameReport } from '../../src/renderer/frameInput.ts';
import { lightOf, type AdditionalLight } from '../../src/renderer/light.ts';
import { LivePuffs } from '../../src/renderer/livePuffs.ts';
import { SmokeRenderer } from '../../src/renderer/smoke.ts';
import type { SmokePasses } from '../../src/renderer/smokePasses.ts';
import { styleOf, widestLineOf, type Style } from '../../src/renderer/style.ts';
import { MESHES } from '../../src/simulator/meshes.ts';
import { hasRareForces } from '../../src/simulator/rareForces.ts';
import { Simulation } from '../../src/stage/simulation.ts';
import { fitDevice, keepPrograms, pageDevice } from './pageDevice.ts';
import { countsOf, rowsOf, type LabPicture } from './lab.ts';
import { PLAIN_LOOK } from '../support/plainLook.ts';

/** Few enough particles for a software renderer, drawn plainly. */
const SMALL: Values = { 'simulation.maxParticles': 800, ...PLAIN_LOOK };

export interface SceneChoice {
  width: number;
  height: number;
  /** Override the scene's values. */
  values?: Values;
  /** Replaces the surfaces of the scene. */
  surfaces?: (own: Scene['surfaces']) => Scene['surfaces'];
  /** Stops self-rotating parts at their initial angle. */
  holdsRotations?: boolean;
  /** Whether the preset draws as on the page. The default is a plain drawing with few particles. */
  ownLook?: boolean;
  /** Whether the puffs are those of the values. The default is the built-in ones. */
  ownPuffs?: boolean;
  /** Draws with the edge filter. */
  smoothEdges?: boolean;
  /** Lights besides the key light. */
  lights?: readonly AdditionalLight[];
}

export interface FrameOptions {
  camera?: Camera;
  /** Culls hidden particles. */
  cull?: boolean;
  /** Also counts the shadow volumes at each pixel. */
  readCounts?: boolean;
  /** Draws no smoke. */
  isBare?: boolean;
  /** Whether smoke that glows lights surfaces and other smoke. */
  hasLamps?: boolean;
  /** Between the previous step (0) and the current one (1). */
  blend?: number;
  /** How far models may deviate from their finest triangles, metres. */
  deviation?: number;
  /** Debug view to draw instead of the picture. */
  view?: DebugView;
}

const NO_SMOKE: Arranger = {
  arrange: () => ({
    rows: rowsOf([]),
    bounds: { min: [0, 0, 0], max: [0, 0, 0], greatestRadius: 0 },
    grid: undefined,
  }),
  moves: () => new Float32Array(),
};

export class SceneLab {
  readonly scene: Scene;
  readonly width: number;
  readonly height: number;
  report: FrameReport | undefined;
  private readonly values: Values;
  private readonly simulation: Simulation;
  private readonly device = pageDevice();
  private readonly smoke: SmokeRenderer;
  readonly style: Style;
  private readonly lights: SceneChoice['lights'];

  private constructor(scene: Scene, simulation: Simulation, values: Values, choice: SceneChoice) {
    const { width, height, smoothEdges = false, lights = [] } = choice;
    this.scene = scene;
    this.simulation = simulation;
    this.values = values;
    const style = styleOf(values);
    this.style = { ...style, hasAdditionalLights: style.hasAdditionalLights || lights.length > 0 };
    this.lights = lights;
    [this.width, this.height] = [width, height];
    const capacity = values['simulation.maxParticles'] as number;
    const surfaces = drawnSurfaces(scene.surfaces);
    const puffs = choice.ownPuffs ? new LivePuffs(values).finish() : undefined;
    this.smoke = new SmokeRenderer(this.device, { capacity, backdrop: scene.backdrop, surfaces, puffs });
    this.smoke.passes.resolve.smoothEdges = smoothEdges;
  }

  /** @param preset name of a preset; a scene has the name of its first preset */
  static async create(preset: string, choice: SceneChoice): Promise<SceneLab> {
    const values = { ...presetValues(findPreset(preset)!), ...(choice.ownLook ? {} : SMALL), ...choice.values };
    const { load, hasRigids } = sceneNamed(values.scene as string);
    const [loaded, factory] = await Promise.all([
      load(),
      loadSimulators({ physics: hasRigids || (hasRareForces(values) && MESHES) }),
      choice.ownPuffs && fetchExtras(styleOf(values)),
      fetchTimelineText(values),
    ]);
    const held = choice.holdsRotations ? withHeldRotations(loaded) : loaded;
    const scene = choice.surfaces ? { ...held, surfaces: choice.surfaces(held.surfaces) } : held;
    return new SceneLab(scene, new Simulation(factory, scene, values, 0), values, choice);
  }

  get simulator(): Simulator {
    return this.simulation.simulator;
  }

  get passes(): SmokePasses {
    return this.smoke.passes;
  }

  /** The colour of lines in pictures. */
  get ink(): number {
    const [red, green, blue] = this.style.inkColor;
    return (255 << 24) | (blue << 16) | (green << 8) | red;
  }

  /** Largest line width, pixels. */
  get widestLine(): number {
    return widestLineOf(this.style, 1);
  }

  /** The bodies of the latest picture, metres. */
  bodies(): { place: Vector3; radius: number }[] {
    const { count, places } = this.smoke.passes.bodies;
    return Array.from({ length: count }, (_, row) => ({
      place: new Vector3().fromArray(places, PLACE_FLOATS * row),
      radius: places[PLACE_FLOATS * row + 3],
    }));
  }

  step(steps: number): void {
    this.simulation.advance(steps);
  }

  /** Draws as a stage of this size, without reading the picture. */
  redraw(options: FrameOptions = {}): void {
    const deviation = deviationFor(1 / this.pixelsPerMetre(this.scene.camera.distance));
    this.render(this.frame({ deviation, ...options }));
  }

  draw(options: FrameOptions = {}): LabPicture {
    const { width, height } = this;
    const input = this.frame(options);
    this.render(input);
    const pixels = new Uint8Array(4 * width * height);
    const gl = this.context;
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    const counts = options.readCounts ? countsOf(this.device, this.smoke, input) : new Uint8Array(0);
    return { width, height, pixels, counts };
  }

  private render(input: FrameInput): void {
    fitDevice(this.device, this.width, this.height);
    this.report = drawFrame(this.smoke, input);
    keepPrograms(this.device.renderer);
  }

  get context(): WebGL2RenderingContext {
    return this.device.renderer.getContext() as WebGL2RenderingContext;
  }

  /** Draw calls and triangles of the latest picture. */
  drawn(): { calls: number; triangles: number } {
    const { calls, triangles } = this.device.renderer.info.render;
    return { calls, triangles };
  }

  /** What a picture is drawn from. */
  frame({
    camera = this.camera(),
    cull = true,
    isBare = false,
    hasLamps = true,
    blend = 1,
    view,
    deviation = 0,
  }: FrameOptions = {}): FrameInput {
    const { width, height, values, style, lights, scene } = this;
    const rigids = this.simulation.rigids(blend);
    return {
      simulator: isBare ? NO_SMOKE : hasLamps ? this.simulator : withoutLamps(this.simulator),
      camera,
      light: lightOf(values, new Vector3(...(scene.lightCentre ?? scene.camera.target))),
      lights,
      style,
      blend,
      width,
      height,
      pixelRatio: 1,
      rigids,
      parts: this.simulation.parts(blend, rigids),
      cull,
      view,
      deviation,
      output: null,
    };
  }

  /** The scene's camera, with optional changes: angles in radians, lengths in metres. */
  camera(changed: Partial<CameraPose> = {}): PerspectiveCamera {
    const { target, azimuth, elevation, distance, fieldOfView } = { ...this.scene.camera, ...changed };
    const camera = new PerspectiveCamera((fieldOfView * 180) / Math.PI, this.width / this.height, 0.1, 100);
    camera.position.setFromSphericalCoords(distance, Math.PI / 2 - elevation, azimuth).add(new Vector3(...target));
    camera.lookAt(...target);
    camera.updateMatrixWorld();
    return camera;
  }

  /** Bounding boxes of the surfaces after the latest step, world space. */
  surfaceBoxes(): Box3[] {
    const { rigids, parts = [] } = this.frame();
    const { scene } = this.smoke.passes;
    scene!.place(rigids, parts, 0);
    return scene!.surfaces.worldBoxes();
  }

  /** Pixels per metre at the distance `nearest` from the eye, metres. */
  pixelsPerMetre(nearest: number): number {
    return this.height / (2 * Math.tan(this.scene.camera.fieldOfView / 2) * nearest);
  }

  dispose(): void {
    this.smoke.dispose();
    this.simulation.dispose();
  }
}

function withoutLamps(simulator: Simulator): Arranger {
  return { arrange: (view) => simulator.arrange(view), moves: () => simulator.moves() };
}

function withHeldRotations(scene: Scene): Scene {
  const held = ({ pose, ...part }: MovingPart): MovingPart => {
    const { rotation } = pose(0);
    return { ...part, pose: (seconds) => ({ position: pose(seconds).position, rotation }) };
  };
  return { ...scene, parts: scene.parts?.map(held) };
}
