/**
 * The profiles of the magic oil lamp: lathed parts (foot, belly, collar, lid, gem) and parts swept along a curve
 * (spout, handle, curl). Metres; positions along a curve are fractions of its length.
 */
import { cos } from '../../simulator/exact/sine.ts';
import { planarAxis, uprightAxis, type Stretch, type SurfaceOfRevolution, spline } from './revolve.ts';

/** Points [x, y]: out of the belly, low, up in a long curve, and outwards at the opening. */
export const SPOUT_PATH = spline([
  [0.22, 0.3],
  [0.37, 0.28],
  [0.53, 0.262],
  [0.68, 0.295],
  [0.785, 0.395],
  [0.855, 0.515],
  [0.95, 0.62],
]);

/** Radius of the opening, and the depth of its bottom as a fraction of the path. */
export const OPENING = 0.05;
const BOTTOM_OF_MOUTH = 0.88;

const HANDLE_PATH = spline([
  [-0.3, 0.36],
  [-0.42, 0.43],
  [-0.57, 0.535],
  [-0.73, 0.53],
  [-0.8, 0.4],
  [-0.73, 0.265],
  [-0.57, 0.2],
  [-0.44, 0.215],
  [-0.34, 0.25],
]);

/** A thumb rest on the handle that curls back. */
const CURL_PATH = spline([
  [-0.58, 0.535],
  [-0.67, 0.585],
  [-0.765, 0.632],
  [-0.855, 0.628],
  [-0.905, 0.57],
  [-0.885, 0.505],
]);

function stretch(bands: number, ...points: readonly (readonly number[])[]): Stretch {
  return { bands, curve: spline(points) };
}

/** The belly bulges towards the spout. */
function swell(angle: number): number {
  const towards = Math.max(0, cos(angle));
  return 1 + 0.1 * towards * towards;
}

export const FOOT: SurfaceOfRevolution = {
  axis: uprightAxis,
  segments: 32,
  profile: [
    stretch(1, [0, 0], [0.27, 0]),
    stretch(3, [0.27, 0], [0.285, 0.02], [0.27, 0.042]),
    stretch(8, [0.27, 0.042], [0.2, 0.062], [0.14, 0.1], [0.125, 0.14]),
    stretch(4, [0.125, 0.14], [0.152, 0.157], [0.125, 0.174]),
    stretch(1, [0.125, 0.174], [0, 0.174]),
  ],
};

export const BELLY: SurfaceOfRevolution = {
  axis: uprightAxis,
  segments: 40,
  swell,
  profile: [
    stretch(
      16,
      [0, 0.165],
      [0.13, 0.168],
      [0.3, 0.195],
      [0.415, 0.25],
      [0.45, 0.31],
      [0.42, 0.37],
      [0.33, 0.42],
      [0.225, 0.45],
    ),
    stretch(1, [0.225, 0.45], [0, 0.45]),
  ],
};

export const COLLAR: SurfaceOfRevolution = {
  axis: uprightAxis,
  segments: 32,
  swell,
  profile: [
    stretch(1, [0, 0.435], [0.228, 0.435]),
    stretch(4, [0.228, 0.435], [0.25, 0.455], [0.228, 0.477]),
    stretch(1, [0.228, 0.477], [0, 0.477]),
  ],
};

export const LID: SurfaceOfRevolution = {
  axis: uprightAxis,
  segments: 32,
  profile: [
    stretch(1, [0, 0.465], [0.205, 0.465]),
    stretch(10, [0.205, 0.465], [0.2, 0.5], [0.165, 0.545], [0.105, 0.575], [0.055, 0.6], [0.034, 0.64]),
    stretch(1, [0.034, 0.64], [0, 0.64]),
  ],
};

export const GEM: SurfaceOfRevolution = {
  axis: uprightAxis,
  segments: 20,
  profile: [stretch(10, [0, 0.625], [0.045, 0.633], [0.067, 0.67], [0.053, 0.715], [0.022, 0.755], [0, 0.785])],
};

export const SPOUT: SurfaceOfRevolution = {
  axis: planarAxis(SPOUT_PATH),
  segments: 20,
  profile: [
    stretch(1, [0, 0], [0.1, 0]),
    stretch(
      20,
      [0.1, 0],
      [0.128, 0.14],
      [0.112, 0.28],
      [0.085, 0.42],
      [0.064, 0.56],
      [0.052, 0.7],
      [0.05, 0.84],
      [0.092, 0.98],
    ),
    stretch(4, [0.092, 0.98], [0.09, 0.995], [0.076, 1], [0.06, 0.988], [OPENING, 0.965]),
    stretch(2, [OPENING, 0.965], [0.04, BOTTOM_OF_MOUTH]),
    stretch(1, [0.04, BOTTOM_OF_MOUTH], [0, BOTTOM_OF_MOUTH]),
  ],
};

export const HANDLE: SurfaceOfRevolution = {
  axis: planarAxis(HANDLE_PATH),
  segments: 12,
  profile: [
    stretch(1, [0, 0], [0.05, 0]),
    stretch(32, [0.05, 0], [0.04, 0.25], [0.034, 0.5], [0.036, 0.75], [0.045, 1]),
    stretch(1, [0.045, 1], [0, 1]),
  ],
};

export const CURL: SurfaceOfRevolution = {
  axis: planarAxis(CURL_PATH),
  segments: 10,
  profile: [
    stretch(1, [0, 0], [0.024, 0]),
    stretch(16, [0.024, 0], [0.032, 0.32], [0.026, 0.64], [0.018, 0.96]),
    stretch(3, [0.018, 0.96], [0.013, 0.985], [0, 1]),
  ],
};
