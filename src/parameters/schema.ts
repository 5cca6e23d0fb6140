/** JSON Schema (2020-12) of the files that `file.ts` reads and writes, generated from the parameter table. */
import { MIN_STOPS, MAX_STOPS } from './curve.ts';
import { DRAWING_LIMIT, MAX_DRAWINGS } from '../base/drawingText.ts';
import { OUTLINE_LIMIT } from '../base/outlineText.ts';
import { FORMAT, MAX_NAME } from './file.ts';
import { LIST_LIMIT } from './lists.ts';
import { VERSION } from './migrations.ts';
import { presets } from './presets.ts';
import { TIMELINE_LIMIT } from './parameter.ts';
import { PATH } from './path.ts';
import { MIN_COLORS, MAX_COLORS } from './ramp.ts';
import { TIMELINE } from './timeline.ts';
import { table } from './words/table.ts';
import type { Parameter } from './words/words.ts';

type Schema = Readonly<Record<string, unknown>>;

/** The complete schema as plain data. */
export function fileSchema(): Schema {
  return {
    $schema: 'https://json-schema.org/draft/2020-12/schema',
    title: 'A preset or a take of cartoon smoke',
    type: 'object',
    required: ['format', 'version', 'values'],
    properties: {
      $schema: { type: 'string' },
      format: { const: FORMAT },
      version: { type: 'integer', minimum: 1, maximum: Number(VERSION) },
      name: { type: 'string', minLength: 1, maxLength: MAX_NAME, description: 'The display name.' },
      preset: { enum: presets.map(({ name }) => name), description: 'The base preset. The values override it.' },
      values: valuesSchema(),
      moment: MOMENT,
      model: MODEL,
    },
    additionalProperties: false,
  };
}

const MOMENT: Schema = {
  type: 'object',
  description: 'A recorded moment. A file without it is a preset.',
  required: ['seconds', 'take'],
  properties: {
    seconds: { type: 'number', minimum: 0, description: 'Simulated seconds.' },
    take: { type: 'string', pattern: '^[\\w-]+$', description: 'Recorded input by step: base64url of deflate-raw.' },
  },
  additionalProperties: false,
};

const MODEL: Schema = {
  type: 'object',
  description: 'A model in the scene.',
  required: ['glb'],
  properties: {
    name: { type: 'string', minLength: 1, maxLength: MAX_NAME, description: 'The name of its file.' },
    options: { type: 'object', description: 'Its place and what it does: the options of setModel.' },
    glb: { type: 'string', pattern: '^[\\w-]+$', description: 'Its GLB file: base64url of deflate-raw.' },
  },
  additionalProperties: false,
};

/** One pattern covers all items of a list, because they have the same fields. */
function valuesSchema(): Schema {
  const single = table.filter(({ key }) => !/^\w+\.\d\./.test(key));
  const first = table.filter(({ key }) => /^\w+\.0\./.test(key));
  const pattern = (key: string) => `^${key.replace('.0.', `.[0-${LIST_LIMIT - 1}].`).replaceAll('.', '\\.')}$`;
  return {
    type: 'object',
    description: 'Values that differ from the preset, by the keys of links.',
    properties: Object.fromEntries(single.map((row) => [row.key, schemaOf(row)])),
    patternProperties: Object.fromEntries(first.map((row) => [pattern(row.key), schemaOf(row)])),
    additionalProperties: false,
  };
}

function schemaOf(parameter: Parameter): Schema {
  return { title: parameter.label, description: parameter.text, ...valueSchema(parameter) };
}

function valueSchema(parameter: Parameter): Schema {
  switch (parameter.kind) {
    case 'toggle':
      return { enum: [0, 1] };
    case 'choice':
      return { enum: parameter.options.map(({ value }) => value) };
    case 'color':
      return { type: 'string', pattern: '^#[0-9a-fA-F]{6}$' };
    case 'curve':
      return parameter.default
        ? { type: 'string', pattern: stops('[0-9.]+', MIN_STOPS, MAX_STOPS), examples: [parameter.default] }
        : { type: 'string', pattern: `^$|${stops('[0-9.]+', MIN_STOPS, MAX_STOPS)}` };
    case 'ramp':
      return { type: 'string', pattern: `^$|${stops('[0-9a-fA-F]{6}', MIN_COLORS, MAX_COLORS)}` };
    case 'path':
      return { type: 'string', pattern: PATH.source };
    case 'drawing':
      return { type: 'string', maxLength: MAX_DRAWINGS * (DRAWING_LIMIT + 1) - 1, pattern: '^[-;,*.\\w]*$' };
    case 'outline':
      return { type: 'string', maxLength: OUTLINE_LIMIT, pattern: '^[-;.\\w]*$' };
    case 'timeline':
      return { type: 'string', maxLength: TIMELINE_LIMIT, pattern: TIMELINE.source };
    default:
      return { type: parameter.kind, minimum: parameter.min, maximum: parameter.max };
  }
}

/** Pattern for stops such as `0:1,.5:.8`. A schema cannot express that positions increase. */
function stops(value: string, min: number, max: number): string {
  const stop = `[0-9.]+:${value}`;
  return `^${stop}(,${stop}){${min - 1},${max - 1}}$`;
}
