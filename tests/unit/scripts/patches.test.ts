/** The patches of three.js fail when it has changed. The patch of Rapier has its tests beside it. */
import { readFileSync } from 'node:fs';
import { expect, it } from 'vitest';
import { smallThree } from '../../../scripts/patches/three.mjs';

const sourceOf = (file: string) =>
  readFileSync(new URL(`../../../node_modules/three/build/three.${file}.js`, import.meta.url), 'utf8');
const SOURCES = { module: sourceOf('module'), core: sourceOf('core') };

interface Patch {
  readonly name: string;
  readonly transform: {
    readonly filter: { readonly id: RegExp };
    readonly handler: (code: string) => { code: string };
  };
}

const patches = smallThree() as unknown as readonly Patch[];

/** What changes in a three.js in which the names or the shape of the removed code differ. */
const CHANGES: Readonly<Record<string, (code: string) => string>> = {
  shaders: (code) => code.replace(/^(?:var|const) (?=[\w$]+ = ")/gm, 'let '),
  headsets: (code) => code.replaceAll('WebXRManager', 'XRManager'),
  extensions: (code) => code.replaceAll('getExtension', 'extensionNamed'),
  animation: (code) => code.replaceAll('KeyframeTrack.prototype', 'KeyframeTrack.base'),
  json: (code) => code.replaceAll('toJSON', 'serialize'),
};

it.each(patches.map((patch) => [patch.name.replace('without-', ''), patch] as const))(
  'removes %s from three.js, and fails if a release has it in another form',
  (name, { transform: { filter, handler } }) => {
    const source = filter.id.test('three/build/three.core.js') ? SOURCES.core : SOURCES.module;
    expect(handler(source).code.length).toBeLessThan(source.length);
    expect(() => handler(CHANGES[name](source))).toThrow(/update scripts\/patches\/three\.mjs/);
    expect(() => handler('')).toThrow(/^Only 0 pieces/);
  },
);
