/** The background, drawn without anything before it. */
import { parseStops } from '../../../src/renderer/palette.ts';
import { Lab, type LabScene } from '../lab.ts';

const [WIDTH, HEIGHT] = [4, 200];
const OWN = { top: [10, 20, 30], bottom: [200, 100, 50] } as const;

/** Channels of each row, from the bottom up, with a value of `style.backdrop`. */
export function rowsOf(ramp: string): number[][] {
  const style = { backdropColors: parseStops(ramp) };
  const scene: LabScene = { width: WIDTH, height: HEIGHT, puffs: [], backdrop: OWN, style };
  const lab = new Lab(scene);
  const { pixels } = lab.draw(scene);
  lab.dispose();
  return Array.from({ length: HEIGHT }, (_, row) => [...pixels.subarray(4 * WIDTH * row, 4 * WIDTH * row + 4)]);
}
