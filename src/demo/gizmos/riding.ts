import type { Stage } from '../../index.ts';
import type { Values } from '../../preset.ts';
import { areSame, carrierChoices, type CarrierChoice } from '../panel/carriers.ts';
import { create } from '../ui/dom.ts';
import type { Editor } from '../editor/editor.ts';
import type { PlaceGizmo } from './placeGizmo.ts';
import { strings } from '../strings.ts';

/**
 * Attaches the emitter or vortex that was dragged last to an object of the scene. It keeps its position and then
 * follows the object.
 */
export class Riding {
  readonly element: HTMLElement;
  private readonly stage: Stage;
  private readonly valuesNow: () => Values;
  private readonly name = create('span');
  private readonly select = create('select');
  private chosen: PlaceGizmo | undefined;
  private offered: readonly CarrierChoice[] = [];

  constructor(editor: Editor, stage: Stage, valuesNow: () => Values) {
    this.stage = stage;
    this.valuesNow = valuesNow;
    this.element = create('label', { class: 'riding', hidden: true }, this.name, this.select);
    this.select.addEventListener('change', () => {
      if (this.chosen) editor.changeAll(this.chosen.ride(this.valuesNow(), Number(this.select.value)));
    });
  }

  choose(gizmo: PlaceGizmo): void {
    this.chosen = gizmo;
    this.show();
  }

  show(): void {
    const choices = carrierChoices(this.stage);
    this.element.hidden = !this.chosen || choices.length === 1;
    if (!this.chosen) return;
    if (!areSame(this.offered, choices)) {
      this.select.replaceChildren(...choices.map(({ value, label }) => create('option', { value: `${value}` }, label)));
      this.offered = choices;
    }
    this.name.textContent = strings.gizmos.attachTo(this.chosen.describe());
    this.select.value = `${this.chosen.carrierIn(this.valuesNow())}`;
  }
}
