import { missingContext, requireCanvas, type DeviceCanvas } from '../renderer/gpu/device.ts';
import type { Fault } from '../renderer/gpu/faults.ts';
import { requireOptions } from '../base/errors.ts';
import type { Values } from '../parameters/parameter.ts';
import type { GivenValues } from '../parameters/timeline.ts';
import { defaults, validate } from '../parameters/values.ts';
import { fetchExtras, fetchTimelineText, loaded } from '../renderer/extraPasses.ts';
import { bakeAhead, compileAhead } from '../renderer/prepare.ts';
import { styleOf } from '../renderer/style.ts';
import { hasRareForces } from '../simulator/rareForces.ts';
import { STAGE_OPTIONS, type EnterOptions, type StageOptions } from './contract.ts';
import { openScene, type OpenedScene } from './openScene.ts';
import { firstDeviation, pixelsOf, type Picture } from './picture.ts';
import { createPresenter, type Presenter } from './presenter.ts';
import { RunningScene } from './runningScene.ts';

/** Opens a scene on a canvas. See `createStage`, also for errors. */
export async function openStage(canvas: DeviceCanvas, options: StageOptions): Promise<RunningScene> {
  requireCanvas(canvas);
  requireOptions('createStage', options, [...STAGE_OPTIONS, 'device', 'failsSelfTest', 'onStep', 'turns']);
  const values = await read(options.values);
  // Before the programs compile: a resize of the drawing buffer waits for the GPU.
  const { width, height, pixelRatio = 1, view } = options;
  if (width && height) [canvas.width, canvas.height] = pixelsOf(width, height, pixelRatio);
  const size: [number, number] = [width ?? canvas.width, height ?? canvas.height];
  const presenting = createPresenter(canvas, options.device, { failsSelfTest: options.failsSelfTest });
  try {
    const opened = await openFor(values, { size, pixelRatio, view }, options, presenting);
    const presenter = await presenting;
    if (import.meta.env.DEV && options.fault) await provoke(options.fault, presenter, opened);
    if (!presenter.device.isRecoverable) throw missingContext();
    const running = new RunningScene(presenter, opened, values, options);
    running.isSeen = options.visible ?? true;
    running.resize(...size, pixelRatio);
    return running;
  } catch (error) {
    (await presenting.catch(() => undefined))?.dispose();
    throw error;
  }
}

/**
 * Opens the scene that values name, and prepares what its first picture needs.
 * @param presenting whose device compiles the programs of the picture
 * @throws the errors of `openScene`, LoadError when code of the picture cannot be fetched
 */
export async function openFor(
  values: Values,
  { size, pixelRatio, view }: Pick<Picture, 'size' | 'pixelRatio' | 'view'>,
  { onProgress }: EnterOptions,
  presenting?: Promise<Presenter>,
): Promise<OpenedScene> {
  const [opened] = await Promise.all([
    openScene(values.scene as string, {
      onProgress,
      hasRareForces: hasRareForces(values),
      deviationIn: (scene) => firstDeviation(scene, values, ...size, pixelRatio),
    }),
    presenting?.then(({ device }) => compileAhead(device, values)),
    bakeAhead(values),
    // What the loaded code bakes.
    fetchExtras({ ...styleOf(values), view }).then(() => bakeAhead(values)),
    fetchExtras(styleOf({ ...values, ...loaded.animation?.demandsIn(values.timeline!) })),
  ]);
  return opened;
}

/**
 * All values, with the timeline as text. Loads the code of a timeline.
 * @throws ParameterError for an invalid value, LoadError when the code cannot be fetched
 */
export async function read(given: GivenValues = {}): Promise<Values> {
  const values = await fetchTimelineText(given);
  validate(values);
  return { ...defaults(), ...values };
}

/** @see Fault */
async function provoke(fault: Fault, { device }: Presenter, { factory }: OpenedScene): Promise<void> {
  const { fill, loseContext } = await import('../renderer/gpu/faults.ts');
  if (fault === 'outOfMemory') fill(factory.module.memory);
  if (fault === 'contextLostInStart') loseContext(device);
}
