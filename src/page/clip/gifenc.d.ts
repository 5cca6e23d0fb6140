/** Types for the used parts of gifenc, which has no type declarations. */
declare module 'gifenc' {
  export interface FrameOptions {
    palette: number[][];
    /** Milliseconds. */
    delay: number;
    /** Number of repetitions; 0 loops forever. Only the first frame's value counts. */
    repeat: number;
    transparent: boolean;
    transparentIndex: number;
    dispose: number;
  }
  export interface Encoder {
    writeFrame(indices: Uint8Array, width: number, height: number, options: FrameOptions): void;
    finish(): void;
    bytes(): Uint8Array<ArrayBuffer>;
  }
  export function GIFEncoder(): Encoder;
  /** @param pixels RGBA */
  export function quantize(pixels: Uint8Array, colors: number): number[][];
}
