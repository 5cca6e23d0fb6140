/** Shortening of private names in the package's sources. */
import { join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { expect, it } from 'vitest';

interface NamePosition {
  readonly start: number;
  readonly end: number;
}
interface Members {
  privatePlaces(file: string, code: string): Map<string, NamePosition[]>[];
}
interface Shaders {
  shortNames(shaders: { file: string; text: string }[]): Map<string, string>;
}

const script = async <Module>(name: string) =>
  (await import(
    pathToFileURL(join(fileURLToPath(new URL('../../..', import.meta.url)), `scripts/package/${name}.mjs`)).href
  )) as Module;
const { privatePlaces } = await script<Members>('shortMembers');
const { shortNames } = await script<Shaders>('shortShaders');

/** The texts at the occurrences of each private name that can be shortened. */
function said(code: string): Record<string, string[]>[] {
  return privatePlaces('some.ts', code).map((places) =>
    Object.fromEntries([...places].map(([name, all]) => [name, all.map(({ start, end }) => code.slice(start, end))])),
  );
}

it('finds every use of a private name inside its class, and no other', () => {
  const code = `class Clock {
    private time = 0;
    readonly step = 1;
    private get late() { return this.time > 9; }
    advance() { const { time, step } = this; this.time = time + step; return () => this.late; }
  }`;
  expect(said(code)).toEqual([{ time: ['time', 'time', 'time', 'time'], late: ['late', 'late'] }]);
});

it('ignores names of other objects, of another this, and of classes that could have the short name', () => {
  expect(said('class A { private at = 1; isLike(other: A) { return this.at === other.at; } }')).toEqual([{}]);
  const foreign = 'class A { private at = 1; make() { return { at: 2, get() { return this.at; } }; } }';
  expect(said(foreign)).toEqual([{ at: ['at'] }]);
  expect(said('class B extends A { private yaw = 1; }')).toEqual([{}]);
  expect(said('class Point { x = 0; private yaw = 1; }')).toEqual([{}]);
});

it('shortens names declared in shaders, the most frequent first', () => {
  const text = 'float widthOf(float radius) { return 2.0 * radius; }\nvoid main() { pixel = widthOf(near); }';
  const names = shortNames([{ file: 'some.frag', text: `uniform float near;\nout vec4 pixel;\n${text}` }]);
  expect(Object.fromEntries(names)).toEqual({ pixel: 'e', radius: 't', widthOf: 'a' });
});

it('keeps names used by TypeScript, GLSL, structs and macros, and avoids collisions', () => {
  const vertex =
    'in vec2 corner;\nuniform highp sampler2D depths;\nout float shared1;\nvoid main() { float distance = 1.0; shared1 = distance; }';
  const fragment =
    'in float shared1;\nstruct Tones { vec3 lit; };\nvec4 litView(vec4 given) { vec3 lit; return given; }\n' +
    'void main() { float e = 1.0; gl_FragColor = VIEW(distance(e, e)); }';
  const names = shortNames([
    { file: 'one.vert', text: vertex },
    { file: 'one.frag', text: fragment },
  ]);
  expect(new Set(names.keys())).toEqual(new Set(['Tones', 'given', 'shared1']));
  expect([...names.values()]).not.toContain('e');
});
