/** Models of GLB files on a stage. Runs inside a page. */
import type { ModelOptions } from '../../../src/stage/contract.ts';
import type { Values } from '../../../src/parameters/parameter.ts';
import { createStage, type Stage } from '../../../src/stage/stage.ts';
import { bendingColumn, turningBox } from '../../support/glb.ts';

const [WIDTH, HEIGHT] = [480, 320];
const FILES = { turningBox, bendingColumn };

export type FileName = keyof typeof FILES;

/** A scene with a model, after some seconds. */
export async function modelStage(name: FileName, options: ModelOptions, values: Values, seconds: number): Promise<Stage> {
  const stage = await createStage(new OffscreenCanvas(WIDTH, HEIGHT), { values });
  await stage.setModel(FILES[name]().pack(), options);
  await stage.seek(seconds);
  return stage;
}

export async function modelPicture(name: FileName, options: ModelOptions, values: Values, seconds: number): Promise<Blob> {
  const stage = await modelStage(name, options, values, seconds);
  const picture = await stage.picture();
  stage.dispose();
  return picture;
}
