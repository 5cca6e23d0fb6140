/** Which programs a stage compiles, and when. */
import type { Values } from '../../../src/parameters/parameter.ts';
import { findPreset, presetValues } from '../../../src/parameters/presets.ts';
import { createStage } from '../../../src/stage/stage.ts';
import { PLAIN_LOOK } from '../../support/plainLook.ts';

/** The shaders of programs in link order. */
export interface LinkedPrograms {
  /** Linked before the first visible picture. */
  readonly ahead: string[];
  /** Linked with the first pictures. */
  readonly drawing: string[];
}

/** The programs of a plain wisp. */
export function programsOfWisp(lobes: number, failsSelfTest: boolean): Promise<LinkedPrograms> {
  const values = { ...presetValues(findPreset('wisp')!), ...PLAIN_LOOK, 'puff.lobes': lobes };
  return programsOf(values, [64, 48], failsSelfTest);
}

/** The programs of a preset, in a picture that is large enough for strokes. */
export function programsOfPreset(name: string): Promise<LinkedPrograms> {
  return programsOf(presetValues(findPreset(name)!), [480, 270]);
}

/** The programs of a picture that is hidden until it is ready. */
async function programsOf(
  values: Values,
  [width, height]: readonly [number, number],
  failsSelfTest = false,
): Promise<LinkedPrograms> {
  const linked: string[] = [];
  const stop = listenToLinks((shaders) => linked.push(shaders));
  const stage = await createStage(new OffscreenCanvas(width, height), {
    values: { ...values, 'simulation.maxParticles': 100 },
    visible: false,
    failsSelfTest,
  });
  const ahead = linked.splice(0);
  stage.visible = true;
  stage.step(120);
  stage.dispose();
  stop();
  return { ahead, drawing: linked };
}

/** @returns the function that stops listening */
function listenToLinks(listener: (shaders: string) => void): () => void {
  const { prototype } = WebGL2RenderingContext;
  const { linkProgram } = prototype;
  prototype.linkProgram = function (program) {
    const shaders = this.getAttachedShaders(program) ?? [];
    listener(shaders.map((shader) => this.getShaderSource(shader)).join('\n'));
    linkProgram.call(this, program);
  };
  return () => (prototype.linkProgram = linkProgram);
}
