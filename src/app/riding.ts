import type { Values } from '../preset/parameter.ts';
import type { Stage } from '../stage/stage.ts';
import { create } from './dom.ts';
import type { Editor } from './editor.ts';
import type { PlaceGizmo } from './placeGizmo.ts';
import { strings } from './strings.ts';

/** Attaches what was taken last by its handle to an object of the scene; it stays where it is and then rides along. */
export class Riding {
  readonly element: HTMLElement;
  private readonly stage: Stage;
  private readonly valuesNow: () => Values;
  private readonly name = create('span');
  private readonly select = create('select');
  private chosen: PlaceGizmo | undefined;
  private offered: readonly string[] | undefined;

  constructor(editor: Editor, stage: Stage, valuesNow: () => Values) {
    this.stage = stage;
    this.valuesNow = valuesNow;
    this.element = create('label', { class: 'riding', hidden: true }, this.name, this.select);
    this.select.addEventListener('change', () => {
      if (this.chosen) editor.changeAll(this.chosen.ride(this.valuesNow(), this.select.selectedIndex - 1));
    });
  }

  choose(gizmo: PlaceGizmo): void {
    this.chosen = gizmo;
    this.show();
  }

  show(): void {
    const { rigidNames } = this.stage;
    this.element.hidden = !this.chosen || rigidNames.length === 0;
    if (!this.chosen) return;
    if (this.offered !== rigidNames) {
      const names = [strings.items.world, ...rigidNames];
      this.select.replaceChildren(...names.map((name) => create('option', {}, name)));
      this.offered = rigidNames;
    }
    this.name.textContent = strings.gizmos.ridesOn(this.chosen.describe());
    this.select.selectedIndex = 1 + this.chosen.rigidIn(this.valuesNow());
  }
}
