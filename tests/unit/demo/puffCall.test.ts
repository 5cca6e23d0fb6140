import { expect, it } from 'vitest';
import { puffCode, puffCall } from '../../../src/demo/effects/code.ts';
import { decode, findPreset, presetValues } from '../../../src/preset.ts';

const IMPORT = "import { puff } from 'cartoon-smoke/puff';\n";

it('writes the options that are given', () => {
  expect(puffCode('button', {})).toBe('puff(button);');
  expect(puffCode('event', { effect: 'boom', size: 2, color: undefined })).toBe(
    "puff(event, { effect: 'boom', size: 2 });",
  );
});

it('writes texts that cannot end the text', () => {
  expect(puffCode('x', { preset: "a'\\b#" })).toBe("puff(x, { preset: 'a\\'\\\\b#' });");
});

it('names the preset of an unchanged look', async () => {
  const values = { ...presetValues(findPreset('lamp-noir')!), 'emission.rate': 3 };
  expect(await puffCall({ preset: 'lamp-noir', values })).toBe(`${IMPORT}puff(button, { preset: 'lamp-noir' });`);
});

it('has a link with a changed look, without what is motion', async () => {
  const changes = { 'style.outlineWidth': 5, 'emission.rate': 3 };
  const code = await puffCall({ preset: 'lamp', values: { ...presetValues(findPreset('lamp')!), ...changes } });
  const link = /preset: '(#[^']+)'/.exec(code)![1];
  const { state, notices } = await decode(link);
  expect(notices).toEqual([]);
  expect(state.values['style.outlineWidth']).toBe(5);
  expect(state.values['emission.rate']).toBe(presetValues(findPreset('lamp')!)['emission.rate']);
});
