/** The search of the panel. */
import { expect, test } from 'vitest';
import { hourParameter } from '../../../src/demo/panel/dial.ts';
import { rankOf, synonyms } from '../../../src/demo/panel/search.ts';
import { findParameter, groups, table } from '../../../src/preset.ts';

/** Keys of the matches in the order of the panel: the group with the best match first. */
function search(query: string): string[] {
  const found = groups.map(({ key, label }) => {
    const rows = table
      .filter(({ group }) => group === key)
      .map((row) => ({ key: row.key, rank: rankOf(query, row, label) }));
    return rows.filter(({ rank }) => rank !== undefined).sort((a, b) => a.rank! - b.rank!);
  });
  const ordered = found.filter((rows) => rows.length > 0).sort((a, b) => a[0].rank! - b[0].rank!);
  return ordered.flat().map(({ key }) => key);
}

test.each([
  ['ink', 'style.inkColor'],
  ['Ink', 'style.inkColor'],
  ['ink color', 'style.inkColor'],
  ['smoke colour', 'style.smokeColor'],
  ['smoke color', 'style.smokeColor'],
  ['background', 'style.backdrop'],
  ['background colour', 'style.backdrop'],
  ['sky', 'style.backdrop'],
  ['halftone', 'style.pattern'],
  ['hatching', 'style.pattern'],
  ['opacity', 'emission.density'],
  ['transparency', 'emission.density'],
  ['density', 'emission.density'],
  ['glow', 'emission.glow'],
  ['halo', 'style.rim'],
  ['thickness', 'emission.density'],
  ['line thickness', 'style.outlineWidth'],
  ['outline thickness', 'style.outlineWidth'],
  ['amount', 'emission.rate'],
  ['speed', 'turbulence.speed'],
  ['border', 'style.outlines'],
  ['outline', 'style.outlines'],
  ['stroke', 'style.strokes'],
  ['sun', 'light.kind'],
  ['shade', 'style.shading'],
  ['shadow', 'style.shadows'],
  ['wind', 'forces.wind.x'],
  ['winds', 'forces.wind.x'],
  ['size', 'puff.size'],
  ['line', 'style.outlineWidth'],
  ['rise', 'forces.buoyancy'],
  ['zoom', 'camera.distance'],
  ['duration', 'emission.lifetime'],
  ['tornado', 'forces.vortex'],
  ['fire', 'emission.glow'],
  ['fps', 'style.hold'],
  ['center', 'camera.target.x'],
  ['random', 'puff.variations'],
  ['particles', 'simulation.maxParticles'],
  ['wobble', 'style.boil'],
  ['keyframe', 'timeline'],
  ['animate', 'timeline'],
  ['timeline', 'timeline'],
  ['gradient', 'style.gradient'],
])('%s finds %s first', (query, key) => {
  expect(search(query)[0]).toBe(key);
});

test.each([
  ['color', 'colour'],
  ['colors', 'colours'],
  ['gray', 'grey'],
  ['center', 'centre'],
  ['meter', 'metre'],
  ['neighboring', 'neighbouring'],
  ['watercolor', 'watercolour'],
])('%s and %s find the same', (american, british) => {
  expect(search(american)).toEqual(search(british));
  expect(search(british).length).toBeGreaterThan(0);
});

test('a search finds nothing within words, except within labels', () => {
  expect(search('ink')).not.toContain('emission.dissolve');
  expect(search('width')).toContain('style.outlineWidth');
  expect(search('wind gust')).toEqual(['wind.gusts', 'wind.gustTime']);
  expect(search('no such thing')).toEqual([]);
  expect(search('')).toHaveLength(table.filter(({ group }) => groups.some(({ key }) => key === group)).length);
});

test('each synonym is of a parameter', () => {
  const isKnown = (key: string) => key === hourParameter.key || findParameter(key.replace('#', '0'));
  expect(Object.keys(synonyms).filter((key) => !isKnown(key))).toEqual([]);
});
