/** What calls without an object of options, with an unknown option or without an argument throw. */
import { expect, it } from 'vitest';
import {
  capsule,
  CartoonSmoke,
  connectFrame,
  createDevice,
  createStage,
  driveByAudio,
  driveByMidi,
  driveByPointer,
  driveByScroll,
  fitPuff,
  openStage,
  presetValues,
  readPuffSheet,
  setAssetUrls,
  writePuffSheet,
} from '../../../src/index.ts';
import { SmokeError } from '../../../src/base/errors.ts';
import { validate } from '../../../src/parameters/values.ts';
import { puff } from '../../../src/page/puff/puff.ts';
import { requireCollideOptions } from '../../../src/three/colliders.ts';
import { burstNumbers, emitterNumbers } from '../../../src/simulator/emitterOptions.ts';

type Call = (given: never) => unknown;
const canvas = { width: 1, height: 1, getContext: () => null } as unknown as OffscreenCanvas;
const iframe = { localName: 'iframe' } as HTMLIFrameElement;
const mesh = { positions: [0, 0, 0] };

/** Calls by name: with options, of which some are required, and with a first argument. */
const OPTIONS: Record<string, [call: Call, isRequired?: true]> = {
  'CartoonSmoke.create': [(options) => CartoonSmoke.create(options), true],
  'CartoonSmoke.create, values': [(values) => CartoonSmoke.create({ values } as never)],
  createStage: [(options) => createStage(canvas, options)],
  'createStage, values': [(values) => createStage(canvas, { values })],
  openStage: [(options) => openStage(() => canvas as never, options)],
  connectFrame: [(options) => connectFrame(iframe, options)],
  createDevice: [(options) => createDevice(canvas, options)],
  fitPuff: [(options) => fitPuff(mesh, options)],
  readPuffSheet: [(options) => readPuffSheet({} as never, options)],
  writePuffSheet: [(options) => writePuffSheet([], options)],
  puff: [(options) => puff(null, options)],
  driveByAudio: [(options) => driveByAudio({} as never, options), true],
  driveByMidi: [(options) => driveByMidi({} as never, options), true],
  driveByPointer: [(options) => driveByPointer({} as never, options), true],
  driveByScroll: [(options) => driveByScroll({} as never, options), true],
  setAssetUrls: [(urls) => setAssetUrls(urls), true],
  validate: [(values) => validate(values), true],
  emitFrom: [(options) => emitterNumbers('emitFrom', options), true],
  burst: [(options) => burstNumbers(options), true],
  collide: [(options) => requireCollideOptions(options), true],
};
const ARGUMENTS: Record<string, Call> = {
  'new CartoonSmoke': (options) => new (CartoonSmoke as unknown as new (options: unknown) => unknown)(options),
  'CartoonSmoke.create, renderer': (renderer) => CartoonSmoke.create({ renderer } as never),
  createStage: (given) => createStage(given),
  openStage: (given) => openStage(given),
  connectFrame: (given) => connectFrame(given),
  createDevice: (given) => createDevice(given),
  fitPuff: (given) => fitPuff(given),
  readPuffSheet: (given) => readPuffSheet(given),
  writePuffSheet: (given) => writePuffSheet(given),
  'puff.create': (given) => puff.create(given),
  capsule: (given) => capsule(given),
  presetValues: (given) => presetValues(given),
};
const WRONG: readonly unknown[] = [null, 3, 'text', true];

async function thrownBy(call: Call, given: unknown): Promise<unknown> {
  try {
    await call(given as never);
    return undefined;
  } catch (error) {
    return error;
  }
}

it.each(Object.entries(OPTIONS))('%s names options that it cannot use', async (_name, [call, isRequired]) => {
  for (const given of [...WRONG, { unknownOption: 1 }, ...(isRequired ? [undefined] : [])]) {
    const error = await thrownBy(call, given);
    expect(error, JSON.stringify(given)).toBeInstanceOf(SmokeError);
    expect(String(error)).toMatch(typeof given === 'object' && given ? /unknownOption.*no (value|such)/ : /it takes /);
  }
});

it.each(Object.entries(ARGUMENTS))('%s names an argument that is missing or wrong', async (_name, call) => {
  for (const given of [...WRONG, {}, undefined]) {
    expect(await thrownBy(call, given), JSON.stringify(given)).toBeInstanceOf(SmokeError);
  }
});
