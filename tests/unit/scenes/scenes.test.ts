/** Every scene fits the list of scenes, can be built, and is deterministic. */
import { Triangle, Vector3 } from 'three';
import { beforeAll, describe, expect, test } from 'vitest';
import { strings } from '../../../src/demo/strings.ts';
import { findPreset, presets, presetValues } from '../../../src/parameters/presets.ts';
import { findParameter } from '../../../src/parameters/table.ts';
import { extrude, type TriangleMesh } from '../../../src/renderer/passes/extrusion.ts';
import type { Scene } from '../../../src/scenes/scene.ts';
import { sceneEntries, sceneNamed } from '../../../src/scenes/scenes.ts';
import type { SimulatorFactory } from '../../../src/simulator/load.ts';
import { fetchTimelineText } from '../../../src/renderer/extraPasses.ts';
import { coarserSurfaces } from '../../../src/renderer/sceneSurfaces.ts';
import { Drag } from '../../../src/stage/drag.ts';
import { Simulation } from '../../../src/stage/simulation.ts';
import { finished } from '../../../src/base/work.ts';
import { variantOf } from '../../support/sim/presetHashes.ts';
import { loadVariant } from '../../support/sim/simWasm.ts';

const NAMES = Object.keys(sceneEntries);

test('the table has all scenes in the same order', () => {
  const parameter = findParameter('scene')!;
  expect(parameter.kind === 'choice' && parameter.options.map(({ value }) => value)).toEqual(NAMES);
});

test('an unknown scene is rejected by name, also a name of the object prototype', () => {
  for (const name of ['', 'moon', 'constructor', '__proto__']) expect(() => sceneNamed(name)).toThrow('scene');
});

test('presets of a scene are adjacent, and the first one has its name', () => {
  const scenes = presets.map((preset) => String(presetValues(preset).scene));
  expect([...new Set(scenes)]).toEqual(NAMES);
  for (const [index, scene] of scenes.entries()) {
    if (scene !== scenes[index - 1]) expect(presets[index].name).toBe(scene);
  }
  expect(scenes).toEqual(scenes.toSorted((a, b) => NAMES.indexOf(a) - NAMES.indexOf(b)));
});

describe.each(NAMES)('%s', (name) => {
  const { load, hasRigids } = sceneEntries[name];
  let scene: Scene;
  let factory: SimulatorFactory;
  const begin = () => new Simulation(factory, scene, presetValues(findPreset(name)!), 1e8);

  beforeAll(async () => {
    await fetchTimelineText(presetValues(findPreset(name)!));
    [scene, factory] = await Promise.all([load(), loadVariant(variantOf(hasRigids, presetValues(findPreset(name)!)))]);
  });

  test('matches its entry of the list', () => {
    expect(scene.name).toBe(name);
    expect(scene.rigids.length > 0).toBe(hasRigids);
    expect(scene.rigidNames).toHaveLength(scene.rigids.length);
    expect(strings.scenes[name].hand !== undefined, 'the page says what to drag').toBe(scene.handle !== undefined);
  });

  test.each([0.004, 0.02, 0.1])('has closed surfaces with fewer triangles, at most about %f m away', (deviation) => {
    const coarser = coarserSurfaces(scene.surfaces, deviation);
    const triangles = (surfaces: typeof coarser) => surfaces.reduce((sum, { mesh }) => sum + mesh.indices.length, 0);
    if (scene.surfaces.length > 0) expect(triangles(coarser)).toBeLessThan(triangles(scene.surfaces));
    coarser.forEach(({ name: surface, mesh, casts }, index) => {
      const finest = scene.surfaces[index].mesh;
      if (casts) expect(() => finished(extrude(mesh)), surface).not.toThrow();
      expect(mesh.positions).toBe(finest.positions);
      expect(volume(mesh), surface).toBeGreaterThan(0);
      // A vertex is off by the chords around a mesh, and by those along it.
      expect(farthestVertex(finest, mesh), surface).toBeLessThan(2 * deviation);
    });
  });

  test('has closed surfaces, wound outwards, on existing rigids and parts', () => {
    for (const { name: surface, mesh, rigid, part, casts } of scene.surfaces) {
      if (casts) expect(() => finished(extrude(mesh)), surface).not.toThrow();
      expect(volume(mesh), surface).toBeGreaterThan(1e-6);
      expect(mesh.indices.length % 3, surface).toBe(0);
      if (rigid !== undefined) expect(scene.rigids[rigid], surface).toBeDefined();
      if (part !== undefined) expect(scene.parts![part], surface).toBeDefined();
      expect(
        mesh.normals.every((coordinate) => Math.abs(coordinate) < 1.001),
        surface,
      ).toBe(true);
    }
    for (const { rigid } of scene.parts ?? []) if (rigid !== undefined) expect(scene.rigids[rigid]).toBeDefined();
  });

  test('has unique names for its parts, and at most as many as can be followed', () => {
    const names = [...scene.rigidNames, ...(scene.parts ?? []).map(({ name: part }) => part)];
    expect(names.every(Boolean)).toBe(true);
    expect(new Set(names).size).toBe(names.length);
    expect(scene.parts?.length ?? 0).toBeLessThanOrEqual(64);
  });

  test('smokes within the capacity of its preset', () => {
    const simulation = begin();
    simulation.advance(240);
    expect(simulation.simulator.alive).toBeGreaterThan(20);
    expect(simulation.simulator.variationsAlive).toBe(presetValues(findPreset(name)!)['puff.variations']);
    expect(simulation.simulator.alive).toBeLessThanOrEqual(3000);
    expect(simulation.simulator.waiting).toBe(0);
    simulation.dispose();
  });

  test('repeats itself exactly, also with steering and after seeking back', () => {
    const [first, second] = [begin(), begin()];
    for (const simulation of [first, second]) {
      simulation.advance(40);
      if (scene.handle) {
        new Drag(simulation, scene.handle).moveTo(new Vector3(...scene.handle.max));
      }
      simulation.advance(70);
    }
    expect(second.simulator.hash()).toBe(first.simulator.hash());
    const hash = first.simulator.hash();
    first.approach(75);
    expect(first.simulator.steps).toBeLessThanOrEqual(75);
    first.advance(110 - first.simulator.steps);
    expect(first.simulator.hash()).toBe(hash);
    first.dispose();
    second.dispose();
  });

  test('moves its camera and its parts as continuous functions of time', () => {
    for (const seconds of [0, 1, 2.5, 9]) {
      for (const { pose } of scene.parts ?? []) {
        expect(pose(seconds)).toEqual(pose(seconds));
        expect(Math.hypot(...pose(seconds).rotation)).toBeCloseTo(1, 6);
      }
      const [here, next] = [seconds, seconds + 1 / 60].map((at) => scene.cameraMove?.(at) ?? {});
      expect(Math.abs((next.azimuth ?? 0) - (here.azimuth ?? 0))).toBeLessThan(0.01);
      expect(Math.abs((next.distance ?? 1) - (here.distance ?? 1))).toBeLessThan(0.01);
    }
  });
});

/** The largest distance of some vertices of a mesh from the triangles of another, metres. */
function farthestVertex({ positions }: TriangleMesh, { indices }: TriangleMesh): number {
  const at = (vertex: number) => new Vector3().fromArray(positions, 3 * vertex);
  const triangles = Array.from({ length: indices.length / 3 }, (_, face) => {
    const [a, b, c] = [0, 1, 2].map((corner) => at(indices[3 * face + corner]));
    return new Triangle(a, b, c);
  });
  const vertices = positions.length / 3;
  const closest = new Vector3();
  let farthest = 0;
  for (let vertex = 0; vertex < vertices; vertex += Math.ceil(vertices / 40)) {
    const point = at(vertex);
    const distances = triangles.map((triangle) => triangle.closestPointToPoint(point, closest).distanceTo(point));
    farthest = Math.max(
      farthest,
      distances.reduce((least, distance) => Math.min(least, distance)),
    );
  }
  return farthest;
}

/** Six times the signed volume of tetrahedra from the origin: positive where faces point outwards. */
function volume({ positions, indices }: TriangleMesh): number {
  let sum = 0;
  for (let from = 0; from < indices.length; from += 3) {
    const [a, b, c] = [0, 1, 2].map((corner) => [
      ...positions.subarray(3 * indices[from + corner], 3 * indices[from + corner] + 3),
    ]);
    sum += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
  }
  return sum;
}
