/**
 * A link contains only the differences from its preset, so presets and defaults are part of the meaning of links.
 * `UPDATE_LINK_MEANING=1 npx vitest run tests/unit/parameters/linkMeaning.test.ts` records new keys, new presets and a new
 * version; recorded values can only change with a new version.
 */
import { readFileSync, writeFileSync } from 'node:fs';
import { beforeAll, expect, it } from 'vitest';
import { decode } from '../../../src/parameters/codec.ts';
import { VERSION } from '../../../src/parameters/migrations.ts';
import type { AnyValues, Value, Values } from '../../../src/parameters/parameter.ts';
import { presets } from '../../../src/parameters/presets.ts';
import { findParameter, table } from '../../../src/parameters/table.ts';

interface Meaning {
  /** All released versions, the current one last. */
  versions: string[];
  /** Defaults by parameter; keys of list items have `#` instead of the index. */
  defaults: AnyValues;
  /** Differences from the defaults, by preset name. */
  presets: Record<string, AnyValues>;
}

const FILE = new URL('linkMeaning.json', import.meta.url);
const read = () => JSON.parse(readFileSync(FILE, 'utf8')) as Meaning;
const present = presentMeaning(read());

beforeAll(() => {
  if (!process.env.UPDATE_LINK_MEANING || changesOf(read()).length > 0) return;
  writeFileSync(FILE, `${JSON.stringify(present, null, 2)}\n`);
});

it('is unchanged while the version of links is the same', () => {
  expect(changesOf(read()), 'needs a new VERSION and a migration in src/parameters/migrations.ts').toEqual([]);
});

it('is recorded', () => {
  expect(read(), 'see UPDATE_LINK_MEANING').toEqual(present);
});

it('is preserved for links of all versions by migrations', async () => {
  for (const version of read().versions) {
    const { notices } = await decode(`#v=${version}&preset=lamp`);
    expect(notices, `of version ${version}`).toEqual([]);
  }
});

function presentMeaning({ versions }: Meaning): Meaning {
  const defaults: Record<string, Value> = {};
  for (const row of table) {
    const key = row.key.replace(/\.\d\./, '.#.');
    expect(defaults[key] ?? row.default, row.key).toBe(row.default);
    defaults[key] = row.default;
  }
  const ownOf = (values: Values) => Object.entries(values).filter(([key, value]) => value !== usual(defaults, key));
  return {
    versions: versions.at(-1) === VERSION ? versions : [...versions, VERSION],
    defaults,
    presets: Object.fromEntries(presets.map(({ name, values }) => [name, Object.fromEntries(ownOf(values))])),
  };
}

/** The value of a key without a value in the preset; an optional parameter then has the scene's value. */
function usual(defaults: AnyValues, key: string): Value | undefined {
  return findParameter(key)?.isOptional ? undefined : defaults[key];
}

/** Recorded values that have changed although the version of links has not. */
function changesOf(recorded: Meaning): string[] {
  if (recorded.versions.at(-1) !== VERSION) return [];
  const ofDefaults = Object.keys(recorded.defaults).map((key) => ['', key]);
  const ofPresets = Object.entries(recorded.presets).flatMap(([name, values]) =>
    Object.keys({ ...values, ...present.presets[name] }).map((key) => [name, key]),
  );
  return [...ofDefaults, ...ofPresets].flatMap(([preset, key]) => {
    const [before, after] = [recorded, present].map((meaning) => valueIn(meaning, preset, key));
    return before === after ? [] : [`${preset} ${key}: ${before} is now ${after}`.trim()];
  });
}

function valueIn({ defaults, presets: named }: Meaning, preset: string, key: string): Value | undefined {
  return preset === '' ? defaults[key] : (named[preset]?.[key] ?? usual(defaults, key));
}
