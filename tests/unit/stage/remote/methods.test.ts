/** Every method of the list works on each kind of stage: of this thread, in a worker, in an element and in a frame. */
import { expect, test } from 'vitest';
import { CartoonSmokeElement } from '../../../../src/page/element/cartoonSmokeElement.ts';
import { elementStage } from '../../../../src/page/iframe/answerPage.ts';
import type { Model } from '../../../../src/stage/contract.ts';
import type { RemoteStage } from '../../../../src/stage/remote/contract.ts';
import type { CrowdTurns } from '../../../../src/stage/remote/crowd.ts';
import { localStage } from '../../../../src/stage/remote/openHere.ts';
import type { MethodName, RemoteMethods } from '../../../../src/stage/remote/calls.ts';
import { methodNames } from '../../../../src/stage/remote/methods.ts';
import { PortStage } from '../../../../src/stage/remote/portStage.ts';
import { serveStage } from '../../../../src/stage/remote/serveStage.ts';
import type { Stage } from '../../../../src/stage/stage.ts';
import type { StageStats } from '../../../../src/stage/contract.ts';
import { EXAMPLE_TAKE } from '../../../support/exampleTake.ts';

/** Arguments of a method, and a result of it. */
type Call<Name extends MethodName> =
  Awaited<ReturnType<RemoteMethods[Name]>> extends infer Result
    ? { readonly given: Parameters<RemoteMethods[Name]>; readonly result?: Result }
    : never;

const BYTES = Uint8Array.of(1, 2, 3);

const MODEL: Model = {
  triangles: 12,
  materials: 1,
  box: [1, 2, 1],
  nodes: [{ name: 'Head', rigid: 4096, surface: -1 }],
  animations: [{ name: 'Walk', seconds: 1.5 }],
  notices: ['Its morph targets are not shown.'],
};

/** A method without a line here does not compile. */
const calls: { readonly [Name in MethodName]: Call<Name> } = {
  play: { given: [] },
  pause: { given: [] },
  step: { given: [2] },
  seek: { given: [2] },
  advance: { given: [0.5] },
  clear: { given: [] },
  restart: { given: [] },
  enter: { given: [{ scene: 'wisp' }] },
  set: { given: [{ 'emission.rate': 3 }] },
  unset: { given: [['camera.azimuth']] },
  get: { given: [], result: { 'emission.rate': 3 } },
  picture: { given: [], result: new Blob(['png']) },
  save: { given: [], result: BYTES },
  restore: { given: [BYTES] },
  take: { given: [], result: EXAMPLE_TAKE },
  readTake: { given: [BYTES], result: EXAMPLE_TAKE },
  playTake: { given: [EXAMPLE_TAKE] },
  hash: { given: [], result: '0123456789abcdef' },
  stats: { given: [{ gpu: true }], result: { steps: 3, writesDepth: true } as StageStats },
  resize: { given: [30, 20, 2] },
  pointer: { given: [{ type: 'down', id: 1, x: 3, y: 4 }], result: 'rigid' },
  blow: { given: [{ x: 3, y: 4 }] },
  steer: { given: [1, 0.5] },
  drop: { given: [3, 4], result: true },
  emit: { given: [{ position: { x: 0, y: 1, z: 0 }, count: 3 }], result: 7 },
  changeEmission: { given: [7, { rate: 3, direction: { x: 0, y: 1, z: 0 } }] },
  setModel: {
    given: [BYTES.slice(), { size: 2, animation: 'Walk', casts: false, position: { x: 1, y: 0, z: 2 } }],
    result: MODEL,
  },
  pickModel: { given: [3, 4], result: { node: MODEL.nodes[0], position: [1, 2, 3], direction: [0, 1, 0] } },
  nudge: { given: [{ dx: 1 }] },
  orbit: { given: [0.1, 0.2] },
  zoom: { given: [1.1] },
  pan: { given: [3, 4] },
  resetView: { given: [] },
  plane: { given: [], result: { middle: [0, 0, 0], right: [1, 0, 0], up: [0, 1, 0] } },
  setBackground: { given: [false] },
  setVisible: { given: [false] },
};
/** What the element decides itself: it has attributes, a place and a size for these. */
const NOT_OF_ELEMENT: readonly MethodName[] = ['resize', 'setBackground', 'setVisible'];

/** A stage whose members give `result`, and what was called or set of it. */
function fakeStage(result: unknown, used: string[]): Stage {
  const members: Readonly<Record<string, unknown>> = {
    stats: result,
    sight: { plane: result },
    complete: async () => {},
  };
  const get = (_: object, name: string): unknown => {
    if (name === 'camera') return fakeStage(result, used);
    if (name in members) return members[name];
    return (...args: unknown[]) => {
      used.push(`${name} ${args.length}`);
      // A port takes the bytes away.
      return result instanceof Uint8Array ? result.slice() : result;
    };
  };
  return new Proxy({}, { get, set: (_, name: string) => used.push(name) > 0 }) as Stage;
}

function overPort(stage: RemoteStage): RemoteStage {
  const { port1, port2 } = new MessageChannel();
  serveStage(port2, stage);
  return new PortStage(port1, 'worker').stage;
}

/** The stage of a frame, whose element has the methods of the real one. */
function inFrame(stage: RemoteStage): RemoteStage {
  const own = methodNames.filter((name) => name in CartoonSmokeElement.prototype);
  const element = { isConnected: true, ...Object.fromEntries(own.map((name) => [name, stage[name]])) };
  return elementStage(element as unknown as CartoonSmokeElement);
}

const kinds: Readonly<Record<string, (stage: RemoteStage) => RemoteStage>> = {
  'on this thread': (stage) => stage,
  'in a worker': overPort,
  'in a frame': (stage) => overPort(inFrame(stage)),
};

for (const [kind, make] of Object.entries(kinds)) {
  test.each(methodNames)(`%s works ${kind}`, async (name) => {
    const { given, result } = calls[name] as { given: unknown[]; result?: unknown };
    const used: string[] = [];
    const stage = make(localStage(fakeStage(result, used)));
    const called = await (stage[name] as (...given: unknown[]) => Promise<unknown>)(...given);
    if (result instanceof Blob) expect(called).toBeInstanceOf(Blob);
    else expect(JSON.stringify(called)).toBe(JSON.stringify(result));
    if (kind !== 'in a frame' || !NOT_OF_ELEMENT.includes(name))
      expect(used.length + (result ? 1 : 0)).toBeGreaterThan(0);
    await stage.dispose();
  });
}

test('only inputs of the user let a stage of a crowd draw in every frame', async () => {
  const inputs: MethodName[] = [];
  for (const name of methodNames) {
    const turns = { touch: () => inputs.push(name) } as unknown as CrowdTurns;
    const stage = localStage(fakeStage(calls[name].result, []), 'main', undefined, turns);
    await (stage[name] as (...given: unknown[]) => Promise<unknown>)(...calls[name].given);
  }
  expect(inputs.join(' ')).toBe('pointer blow steer emit changeEmission drop nudge orbit zoom pan resetView');
});

test('the element has each method that is not an attribute or its place on the page', () => {
  const missing = methodNames.filter((name) => !(name in CartoonSmokeElement.prototype));
  expect(missing).toEqual(NOT_OF_ELEMENT);
});
