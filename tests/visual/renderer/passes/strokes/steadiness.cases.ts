/** How fast strokes fade: the opacity that they have in consecutive frames. */
import { ATTRIBUTE_WORDS, PLACE_FLOATS } from '../../../../../src/renderer/gpu/drawnRows.ts';
import { SceneLab } from '../../../sceneLab.ts';

interface Stroke {
  /** Variation, seed and lobe. */
  key: number;
  place: readonly number[];
  /** Greatest opacity of its parts. */
  opacity: number;
}

const CHOICE = {
  width: 800,
  height: 450,
  values: { 'simulation.maxParticles': 3000, 'style.strokes': 1 },
} as const;
/** Farthest that a particle moves in a step, metres. */
const FARTHEST = 0.15;
/** Side of the tile of an arc, texels, and its samples. */
const TILE = 5;
const SAMPLES = 21;

/**
 * The change of opacity between two frames of each stroke that one of them shows.
 * @param starts steps at which sequences begin
 */
export async function changesOfOpacity(preset: string, starts: readonly number[], frames: number): Promise<number[]> {
  const lab = await SceneLab.create(preset, CHOICE);
  lab.step(starts[0]);
  const changes: number[] = [];
  let [steps] = starts;
  for (const start of starts) {
    lab.step(start - steps);
    lab.draw();
    let before = strokesOf(lab);
    for (let frame = 0; frame < frames; frame++) {
      lab.step(1);
      lab.draw();
      const after = strokesOf(lab);
      changes.push(...changesBetween(before, after));
      before = after;
    }
    steps = start + frames;
  }
  lab.dispose();
  return changes;
}

/** The arcs of the latest picture that have samples. */
function strokesOf({ context: gl, passes: { bodies, renderer, extras } }: SceneLab): Stroke[] {
  const { arcs, separations, ranges } = extras.strokes!;
  const { width, height } = ranges;
  const samples = new Uint8Array(4 * width * height);
  renderer.setRenderTarget(separations);
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, samples);
  const strokes = new Uint32Array(4 * width * height);
  renderer.setRenderTarget(ranges);
  gl.readPixels(0, 0, width, height, gl.RGBA_INTEGER, gl.UNSIGNED_INT, strokes);
  renderer.setRenderTarget(null);
  return [...arcs.words.subarray(0, arcs.count)].flatMap((word, arc) => {
    const texels = texelsOf(arc, width);
    if (samples[4 * texels.at(-1)!] === 0) return [];
    const row = word & 0xffffff;
    const look = bodies.attributeWords[ATTRIBUTE_WORDS * row + 1] & 0xffff;
    const place = [...bodies.places.subarray(PLACE_FLOATS * row, PLACE_FLOATS * row + 3)];
    const opacity = Math.max(...texels.slice(0, SAMPLES).map((texel) => strokes[4 * texel + 2])) / 65535;
    return [{ key: look | (word & 0xff000000), place, opacity }];
  });
}

/** The texels of the tile of an arc. */
function texelsOf(arc: number, width: number): number[] {
  const perLine = width / TILE;
  const first = TILE * (arc % perLine) + TILE * width * Math.floor(arc / perLine);
  return Array.from({ length: TILE ** 2 }, (_, at) => first + (at % TILE) + width * Math.floor(at / TILE));
}

function changesBetween(before: readonly Stroke[], after: readonly Stroke[]): number[] {
  return before.flatMap((stroke) => {
    const distanceTo = ({ place }: Stroke) => Math.hypot(...place.map((value, axis) => value - stroke.place[axis]));
    const same = after
      .filter(({ key }) => key === stroke.key)
      .toSorted((a, b) => distanceTo(a) - distanceTo(b))
      .find((each) => distanceTo(each) < FARTHEST);
    // A particle that dies between the frames must have no stroke before.
    const opacity = same?.opacity ?? 0;
    return Math.max(opacity, stroke.opacity) > 0 ? [Math.abs(opacity - stroke.opacity)] : [];
  });
}
