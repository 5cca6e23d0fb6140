/**
 * Files of presets and takes: human-readable JSON with the schema `public/smoke-file.schema.json`.
 *
 * Values are parsed as in a link: invalid values produce notices and the rest applies. A file of another format is
 * rejected with an error that names the fault and its position.
 */
import { ownValues, readState, type State } from './codec.ts';
import { FileError } from '../base/errors.ts';
import { VERSION } from './migrations.ts';
import { notice, quoteKey, summarise, type Notice } from './notice.ts';
import { packBytes, unpackBytes } from './packing.ts';
import { defaultPreset } from './presets.ts';

export const FORMAT = 'cartoon-smoke';
export const MAX_NAME = 60;
/** Maximum decompressed size of a take in bytes: a saved state of a million particles and a full input log. */
const MAX_TAKE_BYTES = 128 * 1024 * 1024;
/** Maximum size of the file of a model in bytes. */
const MAX_MODEL_BYTES = 32 * 1024 * 1024;

/** A model in the scene. Links cannot contain it. */
export interface ModelFile {
  /** Name of its file, 1 to 60 characters. */
  readonly name: string;
  /** Content of its GLB file, at most 32 MB. Only a stage can validate it. */
  readonly bytes: Uint8Array<ArrayBuffer>;
  /** Its place and what it does, as `ModelOptions`. Only a stage can validate them. */
  readonly options: Readonly<Record<string, unknown>>;
}

/** Content of a file. */
export interface SmokeFile {
  /** Display name, 1 to 60 characters. */
  readonly name: string;
  readonly state: State;
  /** A recorded moment, in simulated seconds, and the take that leads to it. A file without it is a preset. */
  readonly moment?: { readonly take: Uint8Array<ArrayBuffer>; readonly seconds: number };
  readonly model?: ModelFile;
}

/** @param schema URL of the JSON schema, for validation in editors */
export async function writeFile({ name, state, moment, model }: SmokeFile, schema: string): Promise<string> {
  const content = {
    $schema: schema,
    format: FORMAT,
    version: Number(VERSION),
    name,
    preset: state.preset,
    values: Object.fromEntries(ownValues(state).map(([{ key }, value]) => [key, value])),
    ...(moment && { moment: { seconds: moment.seconds, take: await packBytes(moment.take) } }),
    ...(model && { model: { name: model.name, options: model.options, glb: await packBytes(model.bytes) } }),
  };
  return `${JSON.stringify(content, null, 2)}\n`;
}

/** @throws FileError with the fault and its position */
export async function readFile(text: string): Promise<SmokeFile & { notices: readonly Notice[] }> {
  const content = await parse(text);
  if (content.format !== FORMAT) {
    throw new FileError(`This is not a Cartoon Smoke file: "format" must be "${FORMAT}".`);
  }
  const notices: Notice[] = [];
  const state = readState(pairsOf(content, notices), notices, 'file');
  const moment = content.moment === undefined ? undefined : await readMoment(content.moment);
  const model = content.model === undefined ? undefined : await readModel(content.model);
  const parts = { ...(moment && { moment }), ...(model && { model }) };
  return { name: nameOf(content.name), state, ...parts, notices: summarise(notices) };
}

async function parse(text: string): Promise<Record<string, unknown>> {
  try {
    return recordOf(JSON.parse(text), 'The file');
  } catch (error) {
    if (error instanceof FileError) throw error;
    // Only invalid files need the parser.
    const fault = (await import('./jsonFault.ts')).jsonFault(text);
    const place = fault ? ` at line ${fault.line}, column ${fault.column}` : '';
    throw new FileError(`The file is not valid JSON${place}.`, { cause: error });
  }
}

function recordOf(value: unknown, what: string): Record<string, unknown> {
  if (typeof value === 'object' && value !== null && !Array.isArray(value)) return value as Record<string, unknown>;
  throw new FileError(`${what} must be an object, not ${describe(value)}.`);
}

/** Converts the values to text, as in a link. */
function pairsOf({ version, preset, values }: Record<string, unknown>, notices: Notice[]): Map<string, string> {
  if (typeof version !== 'number') throw new FileError(`"version" must be a number, not ${describe(version)}.`);
  const name = preset ?? defaultPreset.name;
  if (typeof name !== 'string') throw new FileError(`"preset" must be a string, not ${describe(name)}.`);
  const pairs = new Map([
    ['v', String(version)],
    ['preset', name],
  ]);
  for (const [key, value] of Object.entries(recordOf(values ?? {}, '"values"'))) {
    if (key === 'v' || key === 'preset' || key === 'take') notices.push(unknown(key, value));
    else if (typeof value === 'number' || typeof value === 'string') pairs.set(key, String(value));
    else notices.push(unusable(key, value));
  }
  return pairs;
}

function unknown(key: string, value: unknown): Notice {
  return notice('unknownKey', key, String(value), () => `There is no parameter ${quoteKey(key)}; it was ignored.`);
}

function unusable(key: string, value: unknown): Notice {
  const sentence = () => `${quoteKey(key)} cannot be ${describe(value)}; it was ignored.`;
  return notice('malformed', key, describe(value), sentence);
}

async function readMoment(value: unknown): Promise<NonNullable<SmokeFile['moment']>> {
  const { seconds, take } = recordOf(value, '"moment"');
  if (typeof seconds !== 'number' || seconds < 0) {
    throw new FileError(`"seconds" of "moment" must be a number from 0, not ${describe(seconds)}.`);
  }
  if (typeof take !== 'string') throw new FileError(`"take" of "moment" must be a string, not ${describe(take)}.`);
  const inflated = await unpackBytes(take, MAX_TAKE_BYTES).catch(() => undefined);
  if (!inflated || inflated.isCut) throw new FileError('"take" of "moment" is damaged or too large.');
  return { take: inflated.bytes, seconds };
}

async function readModel(value: unknown): Promise<ModelFile> {
  const { name, options, glb } = recordOf(value, '"model"');
  if (typeof glb !== 'string') throw new FileError(`"glb" of "model" must be a string, not ${describe(glb)}.`);
  const inflated = await unpackBytes(glb, MAX_MODEL_BYTES).catch(() => undefined);
  if (!inflated || inflated.isCut) throw new FileError('"glb" of "model" is damaged or too large.');
  return { name: nameOf(name), bytes: inflated.bytes, options: recordOf(options ?? {}, '"options" of "model"') };
}

/** Sanitises an untrusted name: at most 60 characters, 'Smoke' if it is empty or not a string. */
export function nameOf(value: unknown): string {
  const text = typeof value === 'string' ? value.replace(/\p{C}/gu, ' ').trim() : '';
  return text.slice(0, MAX_NAME) || 'Smoke';
}

function describe(value: unknown): string {
  if (value === undefined) return 'undefined';
  if (value === null) return 'null';
  if (Array.isArray(value)) return 'an array';
  return typeof value === 'object' ? 'an object' : `a ${typeof value}`;
}
