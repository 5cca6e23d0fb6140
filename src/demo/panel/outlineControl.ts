import { outlineOfPicture, readOutline, SIDE } from '../../internal.ts';
import { traceShape } from '../../index.ts';
import type { OutlineParameter } from '../../preset.ts';
import { strings } from '../strings.ts';
import { create, createSvg, textButton, uniqueId } from '../ui/dom.ts';
import type { Control, ControlListener } from './controlTypes.ts';

const { outline: words } = strings;

/** Outline editor: a preview, on which pictures can be dropped, a word to trace, and buttons for pictures. */
export function createOutline({ label }: OutlineParameter, describedBy: string, listener: ControlListener): Control {
  const id = uniqueId();
  const shape = createSvg('path', { class: 'outline-shape', 'fill-rule': 'evenodd' });
  const box = `0 0 ${SIDE} ${SIDE}`;
  const preview = createSvg('svg', { class: 'outline', viewBox: box, role: 'img', 'aria-label': label }, shape);
  const word = create('input', { id, type: 'text', maxlength: 40, 'aria-describedby': describedBy });
  word.placeholder = words.word;
  const fault = create('p', { class: 'outline-fault', role: 'alert' });
  const trace = async (making: () => Promise<string>): Promise<void> => {
    fault.textContent = '';
    try {
      listener.change(await making());
      listener.settle();
    } catch (error) {
      fault.textContent = (error as Error).message;
    }
  };
  const traceFile = (file: File): Promise<void> =>
    trace(async () => {
      const { pictureOfFile } = await import('../draw/import.ts');
      return outlineOfPicture(await pictureOfFile(file));
    });
  const traceWord = (): void => {
    if (word.value.trim() !== '') void trace(() => traceShape({ text: word.value }));
  };
  word.addEventListener('change', traceWord);
  const files = create('input', { type: 'file', accept: '.png,.svg', hidden: true, 'aria-label': words.picture });
  files.addEventListener('change', () => {
    const [file] = files.files!;
    if (file) void traceFile(file);
    files.value = '';
  });
  const picture = textButton('quiet', words.picture, () => files.click());
  const remove = textButton('quiet', words.remove, () => {
    word.value = '';
    listener.change('');
    listener.settle();
  });
  const tools = create('div', { class: 'outline-tools' }, word, picture, remove, files);
  const element = create('div', { class: 'outline-holder' }, tools, fault);
  element.prepend(preview);
  element.addEventListener('dragover', (event) => event.preventDefault());
  element.addEventListener('drop', (event) => {
    const file = event.dataTransfer?.files[0];
    if (!file) return;
    // The page itself opens other files that are dropped.
    event.preventDefault();
    event.stopPropagation();
    void traceFile(file);
  });
  return {
    elements: [element],
    id,
    show(text) {
      shape.setAttribute('d', pathOf(String(text)));
      remove.disabled = text === '';
    },
  };
}

/** The lines of all layers as the data of a path. */
function pathOf(text: string): string {
  const lines = readOutline(text).flat();
  return lines.map((line) => `M${line.map((point) => point.join()).join('L')}Z`).join('');
}
