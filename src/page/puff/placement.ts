/** Where the canvas is on the page, and where places of the page are in the scene. */
import { placeOnPlane, rounded, type Box, type PlaneRectangle } from '../plane.ts';
import { sizeOf, type Size } from '../size.ts';
import type { Values } from '../../parameters/parameter.ts';
import type { ScenePlane } from '../../stage/sight.ts';
import type { Sheet } from './overlay.ts';

/** CSS pixels per metre of the scene `air`. */
export const PIXELS_PER_METRE = 150;
/** The camera can be this far from the middle of the scene, metres. */
const FARTHEST = 49;
/** Places of the scene are up to this far, metres. */
const FARTHEST_PLACE = 400;
/** The canvas moves when less than this fraction of its height is visible. */
const MIN_VISIBLE = 0.75;

/** The camera in front of the plane of the page. */
export class Placement {
  private readonly sheet: Sheet;
  private camera = { x: 0, y: 0 };
  private size: Size;

  constructor(sheet: Sheet, size: Size) {
    this.sheet = sheet;
    this.size = size;
  }

  /** Whether what is visible now is too far from the smoke for one camera. */
  get isFar(): boolean {
    const { left, top } = this.sheet.rectangle();
    const { x, y } = this.camera;
    const isFar = Math.max(Math.abs(x - left * this.metres), Math.abs(y + top * this.metres)) > FARTHEST;
    return this.sheet.followsWindow && isFar;
  }

  /** Whether too little of the canvas is visible. */
  get isOff(): boolean {
    const { top, height, left, width } = this.sheet.rectangle();
    const visible = (from: number, size: number, end: number) => Math.min(from + size, end) - Math.max(from, 0);
    const isOut =
      visible(top, height, innerHeight) < MIN_VISIBLE * height ||
      visible(left, width, innerWidth) < MIN_VISIBLE * width;
    return this.sheet.followsWindow && (isOut || this.sheet.hasOtherSize);
  }

  /** Metres for each client pixel. */
  private get metres(): number {
    return this.sheet.scale / PIXELS_PER_METRE;
  }

  /**
   * Moves the canvas to what is visible.
   * @param isEmpty whether the scene has no smoke whose place must stay
   * @param host element of the top layer that the canvas comes in front of
   */
  move(isEmpty: boolean, host?: Element): void {
    const before = middle(this.sheet.rectangle());
    this.sheet.place(host);
    const after = middle(this.sheet.rectangle());
    const { x, y } = this.camera;
    this.camera = isEmpty
      ? { x: 0, y: 0 }
      : { x: x + (after.x - before.x) * this.metres, y: y - (after.y - before.y) * this.metres };
    this.size = sizeOf(this.sheet.canvas);
  }

  /** The size of the canvas. */
  get canvasSize(): Size {
    return this.size;
  }

  /** Values of the camera. */
  get values(): Values {
    return { 'camera.target.x': rounded(this.camera.x), 'camera.target.y': rounded(this.camera.y) };
  }

  /** The part of a box on the canvas; all of it if it is beside the canvas. */
  clipped(box: Box): Box {
    const around = this.sheet.rectangle();
    const [right, bottom] = [around.left + around.width, around.top + around.height];
    const [left, top] = [Math.max(box.left, around.left), Math.max(box.top, around.top)];
    const width = Math.min(box.left + box.width, right) - left;
    const height = Math.min(box.top + box.height, bottom) - top;
    return width > 0 && height > 0 ? { left, top, width, height } : box;
  }

  /** Height of the upper edge of the canvas in the plane of the page. */
  get top(): number {
    return this.rectangleOf(this.sheet.rectangle()).top[1];
  }

  /** The plane of the page. */
  get plane(): ScenePlane {
    const metres = 1 / PIXELS_PER_METRE;
    return { middle: [this.camera.x, this.camera.y, 0], right: [metres, 0, 0], up: [0, metres, 0] };
  }

  /** A box in the plane of the page. */
  rectangleOf(box: Box): PlaneRectangle {
    const place = placeOnPlane(box, this.sheet.rectangle(), this.sheet.scale, this.plane);
    const [x, y, z] = place.middle;
    return {
      ...place,
      middle: [limited(x), limited(y), z],
      halfWidth: limited(place.halfWidth),
      halfHeight: limited(place.halfHeight),
    };
  }
}

function limited(metres: number): number {
  return Math.min(Math.max(metres, -FARTHEST_PLACE), FARTHEST_PLACE);
}

function middle({ left, top, width, height }: Box): { x: number; y: number } {
  return { x: left + width / 2, y: top + height / 2 };
}
