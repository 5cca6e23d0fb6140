import type { Stage } from '../../stage/stage.ts';
import type { CaptureDialog } from './dialog.ts';
import { iconButton } from '../dom.ts';
import { icon } from '../icons.ts';
import type { Notices } from '../notices.ts';
import { strings } from '../strings.ts';

/** Opens the sheet of captures, which comes with its code when it is first asked for. */
export class CaptureButton {
  readonly element = iconButton('icon-button', strings.capture.button, icon('camera'), () => this.press());
  private readonly stage: Stage;
  private readonly host: HTMLElement;
  private readonly notices: Notices;
  private dialog: Promise<CaptureDialog> | undefined;

  /** @param host where the sheet is put */
  constructor(stage: Stage, host: HTMLElement, notices: Notices) {
    this.stage = stage;
    this.host = host;
    this.notices = notices;
  }

  press(): void {
    this.dialog ??= this.load();
    this.dialog.then(
      (dialog) => dialog.open(),
      (error: unknown) => {
        // Asked for again, it may come.
        this.dialog = undefined;
        this.notices.tell(strings.capture.failed((error as Error).message));
      },
    );
  }

  private async load(): Promise<CaptureDialog> {
    const { CaptureDialog } = await import('./dialog.ts');
    const dialog = new CaptureDialog(this.stage);
    this.host.append(dialog.element);
    return dialog;
  }
}
