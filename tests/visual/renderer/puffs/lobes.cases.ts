/** Smoke that changes its puff form between frames. */
import { Lab, type LabScene } from '../../lab.ts';

const SCENE: LabScene = {
  width: 200,
  height: 200,
  puffs: [
    { place: [-0.3, 0.1, 0.2], radius: 0.6, variation: 1, seed: 20, roll: 1 },
    { place: [0.4, -0.2, -0.1], radius: 0.5, variation: 2, seed: 130, roll: 4, tint: 1 },
  ],
};

/** Pixels that change on a switch from lobes to billboards, and pixels that differ after the switch back. */
export function switchForms(): { there: number; back: number } {
  const lab = new Lab(SCENE);
  const [first, second, third] = (['lobes', 'billboards', 'lobes'] as const).map(
    (form) => new Uint32Array(lab.draw({ ...SCENE, style: { form } }).pixels.buffer),
  );
  lab.dispose();
  const unlike = (a: Uint32Array, b: Uint32Array): number => a.filter((pixel, index) => pixel !== b[index]).length;
  return { there: unlike(first, second), back: unlike(first, third) };
}
