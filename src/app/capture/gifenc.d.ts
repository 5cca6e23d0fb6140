/** What we use of gifenc, which comes without types. */
declare module 'gifenc' {
  export interface FrameOptions {
    palette: number[][];
    /** Milliseconds. */
    delay: number;
    /** How often all is played again; 0 is forever. Counts in the first frame. */
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
