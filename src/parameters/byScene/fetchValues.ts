/** Loads the values of presets and links for calls. Apart from fetchPreset.ts, since the element needs none of it. */
import { ParameterError } from '../../base/errors.ts';
import type { Values } from '../parameter.ts';
import { fetched } from '../../base/timeout.ts';
import { presetValues } from '../values.ts';
import { fetchPreset } from './fetchPreset.ts';

/**
 * Loads the values of a preset or of a share link.
 * @param preset name of a preset, a share link, or its hash
 * @throws ParameterError for an unknown preset or a link with an invalid part, LoadError when it cannot be fetched
 */
export async function fetchValues(preset: unknown): Promise<Values> {
  const name = String(preset);
  if (name.includes('#')) {
    const { decode } = await fetched('The link', import('../codec.ts'));
    const { state, notices } = await decode(name.slice(name.indexOf('#')));
    if (notices.length > 0) throw new ParameterError('preset', preset, `a share link: ${notices[0].message}`);
    return state.values;
  }
  const found = await fetchPreset(name);
  if (!found) throw new ParameterError('preset', preset, 'the name of a preset, such as lamp-noir, or a share link');
  return presetValues(found);
}
