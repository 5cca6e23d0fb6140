import { Vector3, type Box3, type DepthTexture, type WebGLRenderer } from 'three';
import type { PuffExtents } from '../../renderer/gpu/formTextures.ts';
import { ATTRIBUTE_WORDS, END_STEPS, ONE_QUAD, PLACE_FLOATS } from '../../renderer/gpu/drawnRows.ts';
import type { FrameView } from '../../renderer/gpu/frameView.ts';
import { BeamSpan, hasFullSize, latestStart } from '../../renderer/passes/shadowVolume.ts';
import { PuffRows } from '../../renderer/gpu/puffRows.ts';
import { NO_END } from '../../simulator/layout.ts';
import type { Rows } from '../../simulator/rows.ts';
import type { SmokePasses } from '../../renderer/smokePasses.ts';

/** Boxes that are tested one by one. One box contains all others. */
const MAX_BOXES = 64;
/** End of a shadow that leaves all receivers, in steps. */
const ENDLESS = NO_END >>> 16;

/**
 * The shadow volumes of particles on the objects of the host's scene. Under a directional light, a volume begins where it
 * may meet the first object and ends behind the last, and particles whose shadow meets none have no volume.
 */
export class HostVolumes {
  private readonly rows: PuffRows;
  private readonly place: Float32Array;
  private readonly attributes: Uint32Array;

  /** @param capacity maximum number of particles */
  constructor(capacity: number) {
    this.rows = new PuffRows(capacity, ONE_QUAD);
    this.place = new Float32Array(PLACE_FLOATS * capacity);
    this.attributes = new Uint32Array(ATTRIBUTE_WORDS * capacity);
  }

  get isEmpty(): boolean {
    return this.rows.count === 0;
  }

  /**
   * @param casters all casters
   * @param boxes boxes of the objects, in the space of the smoke
   * @param minCap least distance behind a puff's centre at which volumes start, in radii
   */
  fill(casters: Rows, boxes: readonly Box3[], eye: FrameView, extents: PuffExtents, minCap: number): void {
    this.rows.fill(eye.lamp ? casters : this.shortened(casters, boxes, eye, extents, minCap));
  }

  private shortened(casters: Rows, boxes: readonly Box3[], eye: FrameView, extents: PuffExtents, minCap: number): Rows {
    const { place, attributes } = this;
    const travel = eye.travelAt(new Vector3());
    const spans = new Spans(boxes, travel);
    const latest = latestStart(eye, travel, extents, minCap);
    let whole = 0;
    let count = 0;
    for (let row = 0; row < casters.count; row++) {
      const [from, word] = [PLACE_FLOATS * row, ATTRIBUTE_WORDS * row];
      const radius = casters.place[from + 3];
      spans.find(casters.place, from, extents.reach * radius);
      const steps = END_STEPS / radius;
      const wanted = Math.max(0, spans.enter - latest * radius);
      const reached = Math.max(1, extents.reach) * radius;
      // The shader finds the size near the camera by the place of the row, so that both places need the full size.
      const isFull = (along: number): boolean =>
        hasFullSize(eye, new Vector3().fromArray(casters.place, from).addScaledVector(travel, along), reached);
      const shift = wanted > 0 && isFull(0) && isFull(wanted) ? wanted : 0;
      const first = casters.attributes[word];
      const covered = first >>> 16 === ENDLESS ? Infinity : (first >>> 16) / steps;
      const end = Math.min(spans.exit, covered) - shift;
      if (!(end > 0)) continue;
      const to = PLACE_FLOATS * count;
      place[to] = casters.place[from] + shift * travel.x;
      place[to + 1] = casters.place[from + 1] + shift * travel.y;
      place[to + 2] = casters.place[from + 2] + shift * travel.z;
      place[to + 3] = radius;
      const at = ATTRIBUTE_WORDS * count++;
      if (row < casters.whole) whole = count;
      attributes[at] = (Math.min(ENDLESS, Math.ceil(end * steps)) << 16) | (first & 0xffff);
      for (let next = 1; next < ATTRIBUTE_WORDS; next++) attributes[at + next] = casters.attributes[word + next];
    }
    return { count, whole, place, attributes };
  }

  /**
   * Counts the volumes in the bound framebuffer.
   * @param depth the depth of its pixels, if they have one each
   * @param limit count at which a pixel is dark enough, 1..255
   */
  draw(
    renderer: WebGLRenderer,
    { volumes, extras }: SmokePasses,
    depth: DepthTexture | undefined,
    limit: number,
  ): void {
    const { geometry } = this.rows;
    if (depth) volumes.draw(renderer, geometry, depth, limit);
    else extras.countedVolumes!.draw(renderer, geometry);
  }

  /** Frees the GPU resources. The next draw recreates them. */
  dispose(): void {
    this.rows.dispose();
  }
}

/** Where parallel beams of light meet boxes. */
class Spans {
  /** Distances at which the beam meets the first box and leaves the last; infinite if it meets none. */
  enter = Infinity;
  exit = -Infinity;
  private readonly boxes: readonly (readonly number[])[];
  private readonly travel: readonly number[];
  private readonly span: BeamSpan;

  constructor(boxes: readonly Box3[], travel: Vector3) {
    const rest = boxes.slice(MAX_BOXES - 1);
    const last = rest.length > 1 ? [rest.reduce((all, box) => all.union(box), rest[0].clone())] : rest;
    this.boxes = [...boxes.slice(0, MAX_BOXES - 1), ...last].map(({ min, max }) => [...min, ...max]);
    this.travel = travel.toArray();
    // A beam is a disc across the light.
    this.span = new BeamSpan(this.travel.map((along) => Math.sqrt(Math.max(0, 1 - along * along))));
  }

  /** @param radius of the beam from a place */
  find(places: Float32Array, from: number, radius: number): void {
    this.enter = Infinity;
    this.exit = -Infinity;
    for (const box of this.boxes) {
      this.span.find(box, places, from, this.travel, radius, 0);
      const enter = Math.max(0, this.span.enter);
      if (!(enter <= this.span.exit)) continue;
      this.enter = Math.min(this.enter, enter);
      this.exit = Math.max(this.exit, this.span.exit);
    }
  }
}
