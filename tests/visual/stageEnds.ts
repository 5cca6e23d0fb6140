import type { CDPSession, Page } from '@playwright/test';
import { expect } from '../support/fixtures.ts';
import type { LoadModule } from '../support/modules.ts';

type Devices = typeof import('./cases/stageDevices.ts');

/** Stages after which the modules hold what they keep for all stages, and most functions are compiled. */
const WARM_UP = 2;
/** By so many bytes for each stage may arrays and objects grow together. */
const MAX_BYTES = 500;

/**
 * Makes and ends stages, one after the other, between two snapshots of the heap: their contexts are gone, and of no class
 * live as many more as there were stages. One small object left by each stage fails.
 */
export async function expectGone(load: LoadModule, page: Page, stages: number): Promise<void> {
  const cases = await load<Devices>('/tests/visual/cases/stageDevices.ts');
  const devTools = await page.context().newCDPSession(page);
  const comeAndGo = (rounds: number) => cases.evaluate((module, count) => module.comeAndGo(count), rounds);
  const witness = await page.evaluateHandle(() => {
    class LeftOnPurpose {
      number = 1;
    }
    return { LeftOnPurpose, left: [new LeftOnPurpose()] };
  });
  const first = await comeAndGo(WARM_UP);
  const before = await takeSnapshot(devTools);
  await witness.evaluate(({ LeftOnPurpose, left }) => void left.push(new LeftOnPurpose()));
  const later = await comeAndGo(stages);
  const after = await takeSnapshot(devTools);

  expect([first.lost, later.lost]).toEqual([WARM_UP, stages]);
  expect(later.wasmBytes).toBe(first.wasmBytes);
  const grown = [...after.objects].map(([name, count]) => ({ name, more: count - (before.objects.get(name) ?? 0) }));
  expect(grown).toContainEqual({ name: 'LeftOnPurpose', more: 1 });
  expect(grown.filter(({ more }) => more >= stages)).toEqual([]);
  expect(after.bytes - before.bytes).toBeLessThan(stages * MAX_BYTES);
}

/** As V8 writes it: numbers one after the other for each node and each edge. */
interface HeapSnapshot {
  snapshot: { meta: { node_fields: string[]; node_types: [string[]]; edge_fields: string[] } };
  nodes: number[];
  edges: number[];
  strings: string[];
}

interface Heap {
  /** How many objects, functions and resources of WebGL live, by the names of their classes. */
  objects: Map<string, number>;
  /** That these and their arrays take. */
  bytes: number;
}

const RESOURCES = /^(WebGL|OffscreenCanvas|HTMLCanvas|ImageBitmap|EventListener|system \/ JSArrayBuffer)/;

async function takeSnapshot(devTools: CDPSession): Promise<Heap> {
  const parts: string[] = [];
  const add = ({ chunk }: { chunk: string }): void => void parts.push(chunk);
  devTools.on('HeapProfiler.addHeapSnapshotChunk', add);
  await devTools.send('HeapProfiler.collectGarbage');
  await devTools.send('HeapProfiler.takeHeapSnapshot');
  devTools.off('HeapProfiler.addHeapSnapshotChunk', add);
  return heapOf(JSON.parse(parts.join('')) as HeapSnapshot);
}

function heapOf({ snapshot: { meta }, nodes, edges, strings }: HeapSnapshot): Heap {
  const [width, edgeWidth] = [meta.node_fields.length, meta.edge_fields.length];
  const [selfSize, edgeCount] = ['self_size', 'edge_count'].map((field) => meta.node_fields.indexOf(field));
  const toNode = meta.edge_fields.indexOf('to_node');
  const heap: Heap = { objects: new Map(), bytes: 0 };
  const patterns = new Set<number>();
  for (let at = 0, edge = 0; at < nodes.length; at += width) {
    const end = edge + edgeWidth * nodes[at + edgeCount];
    // What the engine copies literals from.
    if (strings[nodes[at + 1]] === 'system / AllocationSite') {
      for (; edge < end; edge += edgeWidth) patterns.add(edges[edge + toNode]);
    }
    edge = end;
  }
  for (let at = 0; at < nodes.length; at += width) {
    if (patterns.has(at)) continue;
    const name = strings[nodes[at + 1]];
    const type = meta.node_types[0][nodes[at]];
    const isObject = ['object', 'closure'].includes(type) || (type === 'native' && RESOURCES.test(name));
    if (isObject) heap.objects.set(name, (heap.objects.get(name) ?? 0) + 1);
    if (isObject || type === 'array') heap.bytes += nodes[at + selfSize];
  }
  return heap;
}
