import { Vector3 } from 'three';
import { encoded, linear as linearOf, rampOf, type FrameInput, type Style } from '../../internal.ts';
import { linear } from './pixels.ts';
import type { LightLayout } from './settings.ts';

/** Directions of light in view space: +x is right, +y is up, +z is towards the viewer. */
const DIRECTIONS = {
  right: [1, 0, 0],
  left: [-1, 0, 0],
  top: [0, 1, 0],
  bottom: [0, -1, 0],
  front: [0, 0, 1],
  back: [0, 0, -1],
} as const;
type Direction = keyof typeof DIRECTIONS;

/** Content of the red, green and blue channels of the two maps. */
export const LIGHT_LAYOUTS = {
  unity: [
    ['right', 'top', 'back'],
    ['left', 'bottom', 'front'],
  ],
  unreal: [
    ['right', 'left', 'top'],
    ['bottom', 'back', 'front'],
  ],
} as const satisfies Record<LightLayout, readonly (readonly Direction[])[]>;

export const LIGHT_FILES = ['lightA.png', 'lightB.png'] as const;

/** The part of `flipbook.json` that describes the light maps. */
export interface LightMapInfo {
  readonly layout: LightLayout;
  /** Files, and what their red, green, blue and alpha channels contain. */
  readonly files: readonly string[];
  readonly channels: readonly (readonly string[])[];
}

export function describeLightMaps(layout: LightLayout): LightMapInfo {
  const [a, b] = LIGHT_LAYOUTS[layout];
  return {
    layout,
    files: LIGHT_FILES,
    channels: [
      [...a, 'coverage'],
      [...b, 'emission'],
    ],
  };
}

/** Shows a frame in another light and returns its straight-alpha pixels. */
export type Relit = (change: (input: FrameInput) => FrameInput) => ImageData;

/**
 * Draws a frame of two six-way light maps: linear light from one side in each colour channel, without ambient light, 0 to
 * 255 from the darkest tone of the style to its lightest. Alpha is coverage in the first map, and in the second one the
 * brightest channel of what glows.
 * @param color the picture of the frame, whose alpha is coverage
 */
export function shootLightMaps(layout: LightLayout, color: ImageData, relit: Relit): [ImageData, ImageData] {
  const { width, height } = color;
  const maps: [ImageData, ImageData] = [new ImageData(width, height), new ImageData(width, height)];
  LIGHT_LAYOUTS[layout].forEach((directions, map) => {
    directions.forEach((direction, channel) => {
      const { data } = relit((input) => litFrom(DIRECTIONS[direction], input));
      for (let at = 0; at < data.length; at += 4) maps[map].data[at + channel] = 255 * linear(data[at + 1]);
    });
  });
  const { data: glow } = relit((input) => ({
    ...input,
    lights: [],
    style: { ...withoutLines(input.style), illumination: DARKNESS },
  }));
  for (let at = 0; at < glow.length; at += 4) {
    maps[0].data[at + 3] = color.data[at + 3];
    const brightest = Math.max(glow[at], glow[at + 1], glow[at + 2]);
    maps[1].data[at + 3] = 255 * linear(brightest) * (glow[at + 3] / 255);
  }
  return maps;
}

const BLACK = [0, 0, 0] as const;
const WHITE = [255, 255, 255] as const;
const UNCHANGED = { direct: [1, 1, 1], ambient: [1, 1, 1] } as const;
const DARKNESS = { direct: BLACK, ambient: BLACK };

/** @param direction view space */
function litFrom(direction: readonly [number, number, number], input: FrameInput): FrameInput {
  const towards = new Vector3(...direction).transformDirection(input.camera.matrixWorld);
  return { ...input, light: { kind: 'sun', towards }, lights: [], style: styleOfLight(input.style) };
}

/** A style of white smoke that shows only direct light: its tones from black to white, at the borders of the given ones. */
function styleOfLight(style: Style): Style {
  const { lit } = rampOf(WHITE, { ...style, fill: 0 });
  const lights = lit.map(({ color }) => linearOf(color)[1]);
  const [least, most] = [lights[0], lights[lights.length - 1]];
  const stops = lit.map(({ from }, tone) => {
    const light = most > least ? Math.max(0, (lights[tone] - least) / (most - least)) : 1;
    return { from, color: encoded([light, light, light]) };
  });
  return {
    ...withoutLines(style),
    stops,
    illumination: UNCHANGED,
    smokeColor: WHITE,
    ageColors: [],
    heatColors: [],
    tints: [WHITE, WHITE, WHITE],
    glow: [],
    hasAdditionalLights: false,
    hasLooks: false,
    looks: undefined,
    fill: 0,
    gradient: 'none',
  };
}

function withoutLines(style: Style): Style {
  return { ...style, outlines: false, rim: 0, patternCoverage: 0, patternBackdrop: 0, lampLight: undefined };
}
