import { beforeEach, expect, test, vi } from 'vitest';
import { completionOf } from '../../../src/renderer/completion.ts';
import type { PictureKind } from '../../../src/renderer/extraPasses.ts';

const { here, requests } = vi.hoisted(() => ({
  here: new Set<string>(),
  requests: [] as { what: string; come: () => void; fail: (error: Error) => void }[],
}));

vi.mock('../../../src/renderer/extraPasses.ts', () => ({
  hasExtras: ({ view }: PictureKind) => here.has(view!),
  fetchExtras: ({ view }: PictureKind) =>
    new Promise<void>((resolve, reject) => {
      const come = () => {
        here.add(view!);
        resolve();
      };
      requests.push({ what: view!, come, fail: reject });
    }),
}));

const settled = () => new Promise((resolve) => setTimeout(resolve));

/** A completion, its requested picture kind, and its notices. */
function begun() {
  const wanted: { view: PictureKind['view'] } = { view: 'ink' };
  const notified: string[] = [];
  const completion = completionOf(
    () => [
      {
        ...wanted,
        renderer: 'nailboards',
        form: 'lobes',
        isDeformed: true,
        volumes: 'receiver',
        simplify: 0,
        plumeForm: 0,
        outlines: true,
        strokes: 0,
        isEroded: false,
      },
    ],
    () => notified.push('shown'),
    ({ message }) => notified.push(message),
  );
  completion.begin();
  return { completion, wanted, notified };
}

beforeEach(() => {
  here.clear();
  requests.length = 0;
});

test('a failed load is reported once and retried by the next request', async () => {
  const { completion, notified } = begun();
  completion.begin();
  const waiting = expect(completion.wait()).rejects.toThrow('gone');
  requests[0].fail(new Error('gone'));
  await waiting;
  await settled();
  expect(requests).toHaveLength(1);
  expect(notified).toEqual(['gone']);
  completion.begin();
  requests[1].come();
  await completion.wait();
  expect(notified).toEqual(['gone', 'shown']);
});

test('code that becomes needed during a load is loaded before completion', async () => {
  const { completion, wanted, notified } = begun();
  const done = vi.fn<() => void>();
  const waiting = completion.wait().then(done);
  wanted.view = 'counts';
  completion.begin();
  requests[0].come();
  await settled();
  expect(requests.map(({ what }) => what)).toEqual(['ink', 'counts']);
  expect(done).not.toHaveBeenCalled();
  requests[1].come();
  await waiting;
  expect(notified).toEqual(['shown', 'shown']);
});

test('code that is no longer needed is not awaited, and loaded code is not requested again', async () => {
  const { completion, wanted, notified } = begun();
  here.add((wanted.view = 'lit'));
  requests[0].fail(new Error('gone'));
  await settled();
  completion.begin();
  await completion.wait();
  expect(requests).toHaveLength(1);
  expect(notified).toEqual([]);
});
