/**
 * Exports of inner modules for the demo page. Not published: the package has no entry for it, and users must not import
 * it. No module of the library imports this file.
 */
export { keyOf, ORBIT_PER_KEY, ORBIT_PER_PIXEL, spread } from './page/gestures.ts';
export { linkCapacity, lookOf } from './page/element/moment.ts';
export { sizeOf, watchSize } from './page/size.ts';
export { pauseWhileHidden } from './page/visibility.ts';
export type { ClipFormat, ClipShape } from './page/clip/clipFile.ts';
export { encodesWebp } from './page/clip/encoder.ts';
export { ClipFiles } from './page/clip/files.ts';
export { LoopJoin, shootLoop } from './page/clip/loop.ts';
export { PixelReader } from './page/clip/pixelReader.ts';
export {
  chunk as pngChunk,
  deflated,
  filtered as pngRows,
  FILTERS as PNG_FILTERS,
  header as pngHeader,
  predicted,
  SIGNATURE as PNG_SIGNATURE,
} from './page/clip/pngChunks.ts';
export { record } from './page/clip/record.ts';
export { frameCount, openStudio, requireSize, shootClip, type Studio, type Task } from './page/clip/studio.ts';
export { FullScreen } from './renderer/gpu/fullScreen.ts';
export { readOutline } from './page/outline/outline.ts';
export { outlineOfPicture } from './page/outline/trace.ts';
export { areaOf, ringsOf, simplified } from './page/outline/rings.ts';
export { simplifyArc } from './page/outline/simplify.ts';
export { pictureOfSvg, type Picture } from './page/outline/svg.ts';
export { LONGEST_LINK } from './parameters/codec.ts';
export { MAX_STOPS, MIN_STOPS, readCurve, writeCurve, type Stop } from './parameters/curve.ts';
export { LONGEST_LEAD, readEnvironment, readTime, type Environment } from './parameters/environment.ts';
export { MAX_POINTS, MIN_POINTS, readPath, writePath, type PathPoint } from './parameters/path.ts';
export { MAX_NAME, nameOf } from './parameters/file.ts';
export { LIST_LIMIT, listNames } from './parameters/lists.ts';
export { notice } from './parameters/notice.ts';
export { DEBUG_VIEWS } from './parameters/quality.ts';
export { MAX_COLORS, MIN_COLORS, readRamp, writeRamp, type RampStop } from './parameters/ramp.ts';
export {
  CURVES as EASING_CURVES,
  eased,
  EMPTY_TIMELINE,
  MAX_BURSTS,
  MAX_KEYFRAMES,
  MAX_LANES,
  MAX_STEP,
  readTimeline,
  timeIn,
  valueAt,
  whyNotAnimated,
  writeTimeline,
  type Easing,
  type Keyframe,
  type Lane,
  type Timeline,
  type TimelineBurst,
} from './parameters/timeline.ts';
export { isAccepted } from './parameters/values.ts';
export { itemLabel, listLabel, startValues } from './parameters/words/lists.ts';
export { channelSheet, lobeSheet, type ChannelPicture } from './renderer/puffs/billboards/channelSheet.ts';
export { bakePuffs } from './renderer/puffs/billboards/layers.ts';
export { isOfLook, lookIn } from './page/puff/look.ts';
export { clearedAfter, makeWipe } from './page/puff/wipeSmoke.ts';
export { LOBE_SHAPES } from './renderer/puffs/lobeShapes.ts';
export {
  drawingText,
  readDrawings,
  SIDE,
  type DrawnArea,
  type Line,
  type Point,
  type PuffDrawing,
} from './renderer/puffs/drawing/drawing.ts';
export { painting } from './renderer/puffs/drawing/relief.ts';
export { DRAWING_LIMIT, MAX_DRAWINGS } from './base/drawingText.ts';
export { billboardShapes } from './renderer/puffs/billboards/sides.ts';
export { afterRunning } from './base/timeout.ts';
export { finished, inPieces, nextTask, unlessAborted, type Work } from './base/work.ts';
export { STEP_SECONDS } from './simulator/clock.ts';
export { FIRST_PART, PLACE_FLOATS } from './simulator/layout.ts';
export type { Rows } from './simulator/rows.ts';
export { ALL_PARTICLES as ALL_THAT_LIVES, type View } from './simulator/view.ts';
export type { Arranger, FrameInput } from './renderer/frameInput.ts';
export type { Light } from './renderer/light.ts';
export type { TriangleMesh } from './renderer/passes/extrusion.ts';
export { OUT_OF_SIGHT } from './renderer/sceneSurfaces.ts';
export { designOf, showsBillboards } from './renderer/livePuffs.ts';
export { fetchRareForces, hasPattern } from './renderer/extraPasses.ts';
export { formatColor, parseColor, rampOf } from './renderer/palette.ts';
export { encoded, linear, mixed, scaled, type Color } from './renderer/gpu/ramps.ts';
export { automaticColors, inkOf, styleOf, type Style } from './renderer/style.ts';
export type { DrawnDepth } from './stage/picture.ts';
export { openScene } from './stage/openScene.ts';
export { encodePng } from './stage/presenter.ts';
