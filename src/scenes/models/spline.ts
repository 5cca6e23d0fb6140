/** A smooth curve for parameters 0 to 1, with the dimension of its control points. */
export type Curve = (parameter: number) => number[];

/**
 * A Catmull-Rom spline through control points that are evenly spaced in its parameter. It ends exactly at the first and
 * the last point, so that curves with a common end meet bit-exactly.
 */
export function spline(points: readonly (readonly number[])[]): Curve {
  const last = points.length - 1;
  const before = (i: number): readonly number[] => points[i - 1] ?? mirrored(points[0], points[1]);
  const after = (i: number): readonly number[] => points[i + 1] ?? mirrored(points[last], points[last - 1]);
  return (parameter) => {
    const at = Math.min(1, Math.max(0, parameter)) * last;
    const i = Math.min(last - 1, Math.floor(at));
    const t = at - i;
    if (t === 1) return [...points[i + 1]];
    const [a, b, c, d] = [before(i), points[i], points[i + 1], after(i + 1)];
    return b.map((from, axis) => {
      const slope = (c[axis] - a[axis]) / 2;
      const endSlope = (d[axis] - from) / 2;
      const rise = c[axis] - from;
      return from + t * (slope + t * (3 * rise - 2 * slope - endSlope + t * (slope + endSlope - 2 * rise)));
    });
  };
}

/** A virtual control point beyond an end, the neighbour mirrored about it. */
function mirrored(end: readonly number[], neighbour: readonly number[]): number[] {
  return end.map((value, axis) => 2 * value - neighbour[axis]);
}
