/** How fast strokes fade: the opacity that their vertices have in consecutive frames. */
import { DrawnPoints } from '../../../../src/device/drawnPoints.ts';
import { ATTRIBUTE_WORDS, PLACE_FLOATS, type RowGeometry } from '../../../../src/device/drawnRows.ts';
import { pictureTarget } from '../../../../src/device/pictureTarget.ts';
import { SceneLab } from '../../sceneLab.ts';

interface Stroke {
  /** Variation, seed and lobe. */
  key: number;
  place: readonly number[];
  /** Greatest opacity of its vertices. */
  opacity: number;
}

const CHOICE = {
  width: 800,
  height: 450,
  values: { 'simulation.maxParticles': 3000, 'style.strokes': 1 },
} as const;
/** Farthest that a particle moves in a step, metres. */
const FARTHEST = 0.15;
const MAX_STROKES = 4096;

/**
 * The change of opacity between two frames of each stroke that one of them shows.
 * @param starts steps at which sequences begin
 */
export async function changesOfOpacity(preset: string, starts: readonly number[], frames: number): Promise<number[]> {
  const lab = await SceneLab.create(preset, CHOICE);
  lab.step(starts[0]);
  const watched = watch(lab);
  const changes: number[] = [];
  let [steps] = starts;
  for (const start of starts) {
    lab.step(start - steps);
    lab.draw();
    for (let frame = 0; frame < frames; frame++) {
      const before = watched.strokes;
      lab.step(1);
      lab.draw();
      changes.push(...changesBetween(before, watched.strokes));
    }
    steps = start + frames;
  }
  watched.points.dispose();
  lab.dispose();
  return changes;
}

interface Watched {
  strokes: Stroke[];
  readonly points: DrawnPoints;
}

/** Reads the strokes of each frame right after they are drawn, while the textures that they read are valid. */
function watch(lab: SceneLab): Watched {
  lab.draw();
  const pass = lab.passes.extras.strokes!;
  const { uniforms, vertexShader, defines } = pass.strips.material;
  const geometry = () => pass.strips.mesh.geometry;
  const { vertices } = geometry().layout;
  // The vertex shader of the strokes, with a point of the target for each of its vertices.
  const shader = `${vertexShader.replace('void main()', 'out float seen;\nvoid drawStroke()')}
    void main() {
      drawStroke();
      seen = gl_Position.z > 1.0 ? 0.0 : opacity;
      vec2 texel = vec2(gl_VertexID % ${vertices}, gl_VertexID / ${vertices}) + 0.5;
      gl_Position = vec4(texel / vec2(${vertices}, ${MAX_STROKES}) * 2.0 - 1.0, 0.0, 1.0);
      gl_PointSize = 1.0;
    }`;
  const fragment = 'precision highp float; in float seen; out vec4 pixel; void main() { pixel = vec4(seen); }';
  const points = new DrawnPoints(shader, fragment, uniforms, defines as Record<string, string>);
  const target = pictureTarget();
  target.setSize(vertices, MAX_STROKES);
  const watched: Watched = { strokes: [], points };
  const draw = pass.draw.bind(pass);
  pass.draw = (renderer, targets, ...others) => {
    draw(renderer, targets, ...others);
    renderer.setRenderTarget(target);
    points.draw(renderer, vertices * geometry().rows.count);
    watched.strokes = read(geometry(), (pixels, count) =>
      renderer.readRenderTargetPixels(target, 0, 0, vertices, count, pixels),
    );
    renderer.setRenderTarget(targets.renderTarget);
  };
  return watched;
}

function read({ rows, layout }: RowGeometry, readPixels: (pixels: Uint8Array, count: number) => void): Stroke[] {
  if (rows.count > MAX_STROKES) throw new Error(`${rows.count} strokes`);
  const pixels = new Uint8Array(4 * layout.vertices * rows.count);
  readPixels(pixels, rows.count);
  return Array.from({ length: rows.count }, (_, stroke) => ({
    key: rows.attributeWords[ATTRIBUTE_WORDS * stroke + 1] & 0xff00ffff,
    place: [...rows.placeArray.subarray(PLACE_FLOATS * stroke, PLACE_FLOATS * stroke + 3)],
    opacity: Math.max(...pixels.subarray(4 * layout.vertices * stroke, 4 * layout.vertices * (stroke + 1))) / 255,
  }));
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
