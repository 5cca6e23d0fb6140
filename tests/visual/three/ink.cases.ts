/** Ink of smoke in the host's scene: along surfaces, and over time. */
import { Mesh, MeshBasicMaterial, PlaneGeometry, Vector2 } from 'three';
import {
  changedPixels,
  differences,
  dispose,
  draw,
  emptyHost,
  HANGING,
  HEIGHT,
  makeRenderer,
  smokeIn,
  WIDTH,
  type Pixels,
} from './scene.ts';
import type { Values } from '../../../src/parameters/parameter.ts';

/** There is ink within this distance of the border, pixels. */
const REACH = 2;
const RED = {
  'style.inkColor': '#ff0000',
  'style.smokeColor': '#ffffff',
  'style.tones': 1,
  'style.outlineWidth': 3,
} as const;

/**
 * Puffs that are half inside a floor: smoke pixels next to the floor, and those of them with ink nearby.
 * @param origin origin of the viewport on the canvas, pixels
 */
export async function contactLine(antialias: boolean, origin: number): Promise<{ border: number; inked: number }> {
  const host = emptyHost(makeRenderer({ antialias }, [WIDTH + origin, HEIGHT + origin]));
  const floor = new Mesh(new PlaneGeometry(20, 20), new MeshBasicMaterial({ color: '#4477aa' }));
  floor.rotation.x = -Math.PI / 2;
  host.scene.add(floor);
  host.renderer.setViewport(origin, origin, WIDTH, HEIGHT);
  const before = draw(host);
  const values: Values = {
    ...HANGING,
    ...RED,
    'emitters.0.position.y': 0.05,
    'emitters.0.radius': 0.4,
    'style.shadows': 0,
  };
  const smoke = await smokeIn(host, values);
  const picture = draw(host);
  const size = host.renderer.getDrawingBufferSize(new Vector2());
  dispose(smoke, host.renderer);
  return borderOf(picture, before, size.x);
}

function borderOf(picture: Pixels, before: Pixels, width: number): { border: number; inked: number } {
  const isSmoke = differences(picture, before).map((difference) => difference > 0);
  const isInk = isSmoke.map((_, pixel) => picture[4 * pixel] > 200 && picture[4 * pixel + 1] < 60);
  const result = { border: 0, inked: 0 };
  isSmoke.forEach((smoke, pixel) => {
    if (!smoke || [1, -1, width, -width].every((step) => isSmoke[pixel + step])) return;
    ++result.border;
    if (around(pixel, width).some((near) => isInk[near])) ++result.inked;
  });
  return result;
}

function around(pixel: number, width: number): number[] {
  const steps = Array.from({ length: 2 * REACH + 1 }, (_, step) => step - REACH);
  return steps.flatMap((x) => steps.map((y) => pixel + x + y * width));
}

/**
 * Pixels that change within two steps, between which a new drawing begins (a drawing lasts five steps): with boiling
 * lines, and without.
 */
export async function boiling(): Promise<{ boiling: number; steady: number }> {
  const changes: number[] = [];
  for (const boil of [1, 0]) {
    const host = emptyHost();
    const smoke = await smokeIn(host, { ...HANGING, 'style.boil': boil });
    smoke.step(6);
    const before = draw(host);
    smoke.step(2);
    changes.push(changedPixels(draw(host), before));
    dispose(smoke, host.renderer);
  }
  return { boiling: changes[0], steady: changes[1] };
}
