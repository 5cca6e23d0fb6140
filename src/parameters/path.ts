/** Text format of paths: points `-.8:0:.1,.2:.35:0`, each x, y and z in metres. */

/** A point of a path in metres, below 100 in each direction, to the millimetre. */
export type PathPoint = readonly [x: number, y: number, z: number];

export const MIN_POINTS = 2;
/** The limit of the simulator. */
export const MAX_POINTS = 24;

const NUMBER = '-?(\\d{1,2}|\\d{0,2}\\.\\d{1,3})';
const POINT = `${NUMBER}(:${NUMBER}){2}`;

/** The grammar of paths, which may be empty. */
export const PATH = new RegExp(`^(${POINT}(,${POINT}){${MIN_POINTS - 1},${MAX_POINTS - 1}})?$`);

/** The points of a valid path. */
export function readPath(text: string): PathPoint[] {
  return text ? text.split(',').map((point) => point.split(':').map(Number) as unknown as PathPoint) : [];
}

/** Formats points to the millimetre, without leading zeros. */
export function writePath(points: readonly PathPoint[]): string {
  const short = (metres: number) => String(Number(metres.toFixed(3)) + 0).replace(/^(-?)0\./, '$1.');
  return points.map((point) => point.map(short).join(':')).join(',');
}
