/**
 * Exports of inner modules for the demo page. Not published: the package has no entry for it, and users must not import
 * it. No module of the library imports this file.
 */
export { keyOf, ORBIT_PER_KEY, ORBIT_PER_PIXEL, spread } from './page/gestures.ts';
export { linkCapacity, lookOf } from './page/moment.ts';
export { sizeOf, watchSize } from './page/size.ts';
export { pauseWhileHidden } from './page/visibility.ts';
export { FullScreen } from './device/fullScreen.ts';
export { LONGEST_LINK } from './preset/codec.ts';
export { MAX_STOPS, MIN_STOPS, readCurve, writeCurve, type Stop } from './preset/curve.ts';
export { LONGEST_LEAD, readEnvironment, type Environment } from './preset/environment.ts';
export { MAX_NAME, nameOf } from './preset/file.ts';
export { LIST_LIMIT, listNames } from './preset/lists.ts';
export { DEBUG_VIEWS } from './preset/quality.ts';
export { MAX_COLORS, MIN_COLORS, readRamp, writeRamp, type RampStop } from './preset/ramp.ts';
export { isAccepted } from './preset/values.ts';
export { itemLabel, listLabel, startValues } from './preset/words/lists.ts';
export { channelSheet, lobeSheet, type ChannelPicture } from './puffs/billboards/channelSheet.ts';
export { bakePuffs } from './puffs/billboards/layers.ts';
export { isOfLook } from './puff/ofLook.ts';
export { LOBE_SHAPES } from './puffs/lobeShapes.ts';
export { billboardShapes } from './puffs/shapes.ts';
export { inPieces, nextTask } from './work.ts';
export { STEP_SECONDS } from './sim/clock.ts';
export { ATTRIBUTE_BITS, ATTRIBUTE_WORDS, FIRST_PART, NO_END, PLACE_FLOATS } from './sim/layout.ts';
export { readBits, type Rows } from './sim/rows.ts';
export type { Arranged, Bounds } from './sim/arranged.ts';
export { ALL_PARTICLES as ALL_THAT_LIVES, type View } from './sim/view.ts';
export type { Arranger, FrameInput } from './smoke/frameInput.ts';
export type { Light } from './smoke/light.ts';
export { showsBillboards } from './smoke/livePuffs.ts';
export { automaticColors } from './smoke/style.ts';
export type { DrawnDepth } from './stage/picture.ts';
export { openScene } from './stage/openScene.ts';
export { encodePng } from './stage/presenter.ts';
