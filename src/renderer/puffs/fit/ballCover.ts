/** Incrementally updated overlap between a set of balls and voxels. */
import type { Lobe } from '../shapes.ts';
import { HALF_GRID, type Voxels } from './voxels.ts';

/** A set of balls over voxels. A ball covers the voxels whose centres are inside it. */
export class BallCover {
  private readonly voxels: Voxels;
  /** Number of balls that cover each voxel. */
  private readonly counts: Uint8Array;
  private readonly insideCount: number;
  private coveredInside = 0;
  private coveredOutside = 0;

  constructor(voxels: Voxels, balls: readonly Lobe[] = []) {
    this.voxels = voxels;
    this.counts = new Uint8Array(voxels.inside.length);
    this.insideCount = voxels.inside.reduce((sum, value) => sum + value, 0);
    for (const ball of balls) this.add(ball);
  }

  /** Intersection over union (Jaccard index) of the volumes of balls and voxels, 0 to 1. */
  get overlap(): number {
    return this.coveredInside / (this.insideCount + this.coveredOutside);
  }

  add(ball: Lobe): void {
    this.change(ball, 1);
  }

  remove(ball: Lobe): void {
    this.change(ball, -1);
  }

  /** The overlap after adding `ball`, without adding it. */
  overlapWith(ball: Lobe): number {
    const { inside } = this.voxels;
    let [more, outside] = [0, 0];
    this.visit(ball, (voxel) => {
      if (this.counts[voxel] > 0) return;
      if (inside[voxel] === 1) more += 1;
      else outside += 1;
    });
    return (this.coveredInside + more) / (this.insideCount + this.coveredOutside + outside);
  }

  private change(ball: Lobe, by: 1 | -1): void {
    const { inside } = this.voxels;
    this.visit(ball, (voxel) => {
      if (this.counts[voxel] === (by > 0 ? 0 : 1)) {
        if (inside[voxel] === 1) this.coveredInside += by;
        else this.coveredOutside += by;
      }
      this.counts[voxel] += by;
    });
  }

  private visit({ center, radius }: Lobe, act: (voxel: number) => void): void {
    const { size, width } = this.voxels;
    const place = center.map((at) => (at + HALF_GRID) / width - 0.5);
    const reach = radius / width;
    const first = place.map((at) => Math.max(0, Math.ceil(at - reach)));
    const last = place.map((at) => Math.min(size - 1, Math.floor(at + reach)));
    for (let k = first[2]; k <= last[2]; k++) {
      for (let j = first[1]; j <= last[1]; j++) {
        const rest = reach * reach - (k - place[2]) ** 2 - (j - place[1]) ** 2;
        if (rest < 0) continue;
        const half = Math.sqrt(rest);
        const end = Math.min(size - 1, Math.floor(place[0] + half));
        for (let i = Math.max(0, Math.ceil(place[0] - half)); i <= end; i++) act((k * size + j) * size + i);
      }
    }
  }
}
