import { BackdropPass } from './passes/backdrop.ts';
import { memoizedCreases, memoizedRibbons, memoizedSeams, meetingBehind } from './passes/creases.ts';
import { MaskPass } from './passes/mask.ts';
import { memoizedExtrusion } from './passes/meshVolumes.ts';
import { RESOLVE_SHADERS } from './passes/resolve.ts';
import { memoizedHullNormals, memoizedVertices } from './passes/surfaceGeometry.ts';
import type { SurfaceDescription } from './passes/surface.ts';
import { inPieces, nextTask, PIECE_MS, type Work } from '../base/work.ts';
import type { Device } from './gpu/device.ts';
import { SELF_TEST_SHADERS } from './gpu/selfTest.ts';
import { FrameView } from './gpu/frameView.ts';
import { RampTexture } from './gpu/ramps.ts';
import { shadersOf, type Shaders } from './gpu/programsAhead.ts';
import { lobeBodyShaders } from './passes/bodies.ts';
import { volumeShaders } from './passes/volumes.ts';
import type { Values } from '../parameters/parameter.ts';
import { coarserSurfaces, SceneSurfaces } from './sceneSurfaces.ts';
import { codeOf, fetchExtras, hasPattern, hasStrokes, isSimplified } from './extraPasses.ts';
import { LivePuffs } from './livePuffs.ts';
import { formOf, styleOf, styleUniforms } from './style.ts';

/**
 * Computes everything that passes derive from surfaces. Results are memoized for the passes that draw them later.
 * @param deviation of the triangles from the finest ones, metres
 */
export function* preparingSurfaces(finest: readonly SurfaceDescription[], deviation = 0): Work<void> {
  const surfaces = coarserSurfaces(finest, deviation);
  for (const [index, { mesh, casts, inked, skin }] of surfaces.entries()) {
    memoizedHullNormals(finest[index].mesh);
    yield;
    if (casts) yield* memoizedExtrusion.pieces(mesh);
    yield;
    if (!inked || skin) continue;
    yield* memoizedCreases.pieces(mesh);
    yield;
    for (const other of meetingBehind(surfaces, index)) {
      yield* memoizedSeams(mesh).pieces(other.mesh);
      yield;
    }
  }
  memoizedVertices(finest);
  yield;
  memoizedRibbons(surfaces);
}

/** Like {@link preparingSurfaces}, but keeps the page responsive. */
export function prepareSurfaces(surfaces: readonly SurfaceDescription[], deviation: number): Promise<void> {
  return inPieces(preparingSurfaces(surfaces, deviation));
}

/**
 * Compiles the programs of a picture while other resources load, and resolves when they are ready. Those of rarely used
 * passes are compiled when they first draw.
 */
export async function compileAhead(device: Device, values: Values): Promise<void> {
  const { programs, renderer } = device;
  if (!device.isUsable || formOf(values) !== 'lobes') return;
  const lobes = values['puff.lobes'] as number;
  const style = styleOf(values);
  const { isDeformed, lampLight, hasAdditionalLights } = style;
  const isPrinted = hasPattern(style);
  if (lampLight || hasAdditionalLights || isPrinted) await fetchExtras(style);
  const added: readonly ((shaders: Shaders) => Shaders)[] = [
    ...(lampLight ? [codeOf('falloff').withFalloff] : []),
    ...(hasAdditionalLights ? [codeOf('additionalLights').withAdditionalLights] : []),
    ...(isPrinted ? [(shaders: Shaders) => codeOf('patterns').withPattern(shaders, style.pattern)] : []),
  ];
  const isShaded = isSimplified(style);
  const bodies = (isFlat: boolean) => lobeBodyShaders(lobes, { isFlat, isShaded, isDeformed });
  const compile = async (...all: Shaders[]) => {
    for (const shaders of all) {
      if (!device.isUsable) return;
      programs.compile(
        renderer,
        added.reduce((code, add) => add(code), shaders),
      );
      await nextTask();
    }
  };
  await compile(bodies(false), SELF_TEST_SHADERS, volumeShaders(lobes, isDeformed));
  const [eye, ramps] = [new FrameView(styleUniforms()), new RampTexture(1)];
  const { surfaces, creases, volumes } = new SceneSurfaces(eye, ramps, 0, []);
  const passes: object[] = [new BackdropPass(eye), surfaces, creases, volumes, new MaskPass()];
  await compile(...passes.flatMap(shadersOf), ...RESOLVE_SHADERS);
  await fetchExtras(style);
  if (isShaded) {
    const { SimplifyPass } = codeOf('simplify');
    await compile(...shadersOf(new SimplifyPass(eye, ramps).meshes(style.plumeForm > 0)));
  }
  if (isPrinted) {
    const pass = new (codeOf('patterns').PatternPass)(eye);
    pass.setStyle(style, 1);
    await compile(...shadersOf(pass.meshes()));
  }
  if (hasStrokes(style)) await compile(...shadersOf(codeOf('strokes').strokeMaterials(eye, isDeformed)));
  await programs.finished(renderer);
  await device.testDepth();
  await nextTask();
  if (device.writesDepth) return;
  await compile(bodies(true));
  await programs.finished(renderer);
}

/**
 * Bakes the puffs that values describe while the scene and its simulator load. The puffs are cached for later requests.
 */
export async function bakeAhead(values: Values): Promise<void> {
  const puffs = new LivePuffs(values);
  while (!puffs.workFor(PIECE_MS)) await nextTask();
}
