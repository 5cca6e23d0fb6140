import { Color as ThreeColor } from 'three';
import { writeColor, type Color } from '../device/ramps.ts';

/** The line around what is outlined. */
export interface InkLine {
  color: Color;
  /** Width in pixels of the target; 0 draws none. */
  pixels: number;
  /** 0..1: at 1 a line is twice as wide away from the light and half as wide towards it. */
  swell: number;
}

/** What the shaders know of the line; see shaders/lib/ink.glsl. */
export class InkUniforms {
  readonly uniforms = { inkColor: { value: new ThreeColor() }, inkPixels: { value: 2 }, inkSwell: { value: 0 } };

  set({ color, pixels, swell }: InkLine): void {
    const { inkColor, inkPixels, inkSwell } = this.uniforms;
    writeColor(color, inkColor);
    inkPixels.value = pixels;
    inkSwell.value = swell;
  }
}

/** Width in pixels of the target where a line is widest. */
export function widestLine(pixels: number, swell: number): number {
  return pixels * 2 ** swell;
}
