import { Color as ThreeColor } from 'three';
import { writeColor, type Color } from '../device/ramps.ts';

/** Style of the outlines. */
export interface InkLine {
  color: Color;
  /** Width in pixels of the target; 0 draws no lines. */
  pixels: number;
  /** 0..1: at 1 a line is twice as wide on the side away from the light and half as wide on the lit side. */
  swell: number;
}

/** Uniforms of the outlines; see shaders/lib/ink.glsl. */
export class InkUniforms {
  readonly uniforms = { inkColor: { value: new ThreeColor() }, inkPixels: { value: 2 }, inkSwell: { value: 0 } };

  set({ color, pixels, swell }: InkLine): void {
    const { inkColor, inkPixels, inkSwell } = this.uniforms;
    writeColor(color, inkColor);
    inkPixels.value = pixels;
    inkSwell.value = swell;
  }
}

/** Largest width of a line, pixels of the target. */
export function widestLine(pixels: number, swell: number): number {
  return pixels * 2 ** swell;
}
