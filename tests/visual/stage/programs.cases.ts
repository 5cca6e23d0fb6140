/** Which programs a stage compiles, and when. */
import { findPreset, presetValues } from '../../../src/preset/presets.ts';
import { createStage } from '../../../src/stage/stage.ts';
import { PLAIN_LOOK } from '../../support/plainLook.ts';

/** The shaders of programs in link order. */
export interface LinkedPrograms {
  /** Linked before the first visible picture. */
  readonly ahead: string[];
  /** Linked with the first pictures. */
  readonly drawing: string[];
}

/** The programs of a wisp that is hidden until it is ready. */
export async function programsOfWisp(lobes: number): Promise<LinkedPrograms> {
  const linked: string[] = [];
  const stop = listenToLinks((shaders) => linked.push(shaders));
  const values = {
    ...presetValues(findPreset('wisp')!),
    ...PLAIN_LOOK,
    'simulation.maxParticles': 100,
    'puff.lobes': lobes,
  };
  const stage = await createStage(new OffscreenCanvas(64, 48), { values, visible: false });
  const ahead = linked.splice(0);
  stage.visible = true;
  stage.step(60);
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
