import { expect, test } from 'vitest';
import type { AnyValues } from '../../../src/parameters/parameter.ts';
import { ParameterError } from '../../../src/base/errors.ts';
import { findPreset } from '../../../src/parameters/presets.ts';
import { loadPreset, startValues } from '../../../src/three/options.ts';

test('the values of a preset are above the defaults and below those of the caller', async () => {
  await loadPreset('lamp');
  const preset = findPreset('lamp')!.values;
  const others = Object.entries(preset).filter(([key]) => key !== 'emission.rate');
  const values = startValues({ preset: 'lamp', values: { 'emission.rate': 3 } });
  expect(values).toMatchObject({ ...preset, 'emission.rate': 3 });
  const plain = startValues({}) as AnyValues;
  expect(others.filter(([key, value]) => plain[key] !== value).length).toBeGreaterThan(5);
});

test('an unknown preset is an error that says what is accepted', async () => {
  await expect(loadPreset('lampp' as never)).rejects.toThrow(ParameterError);
  await expect(loadPreset('lampp' as never)).rejects.toThrow(
    /^preset cannot be “lampp”: it takes the name of a preset/,
  );
  await expect(loadPreset(undefined)).resolves.toBeUndefined();
});
