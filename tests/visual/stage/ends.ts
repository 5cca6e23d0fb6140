import type { CDPSession, Page } from '@playwright/test';
import { expect } from '../../support/fixtures.ts';
import type { LoadModule } from '../../support/modules.ts';

type Devices = typeof import('./devices.cases.ts');

/** Stages to create first, so that modules fill their caches and most functions are compiled. */
const WARM_UP = 2;
/** Limit for the growth of arrays and objects together, bytes per stage. */
const MAX_BYTES = 500;

/**
 * Creates and disposes stages one by one between two heap snapshots. Expects their contexts to be lost, and no class to
 * grow by one instance per stage. One small object leaked by each stage fails.
 */
export async function expectGone(load: LoadModule, page: Page, stages: number): Promise<void> {
  const cases = await load<Devices>('/tests/visual/stage/devices.cases.ts');
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

/** V8's format: consecutive numbers for each node and each edge. */
interface HeapSnapshot {
  snapshot: { meta: { node_fields: string[]; node_types: [string[]]; edge_fields: string[] } };
  nodes: number[];
  edges: number[];
  strings: string[];
}

interface Heap {
  /** Live objects, functions and WebGL resources, by class name. */
  objects: Map<string, number>;
  /** Size of the objects and their arrays, bytes. */
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
    // The engine copies literals from allocation sites.
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
