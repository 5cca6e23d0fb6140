import type { Stage } from '../../index.ts';
import type { CaptureDialog } from './dialog.ts';
import { iconButton } from '../ui/dom.ts';
import { icon } from '../ui/icons.ts';
import type { Notices } from '../ui/notices.ts';
import { strings } from '../strings.ts';

/** Opens the capture dialog, whose code is fetched on first use. */
export class CaptureButton {
  readonly element = iconButton('icon-button', strings.capture.button, icon('camera'), () => this.press());
  private readonly stage: Stage;
  private readonly container: HTMLElement;
  private readonly notices: Notices;
  private dialog: Promise<CaptureDialog> | undefined;

  /** @param container parent of the dialog */
  constructor(stage: Stage, container: HTMLElement, notices: Notices) {
    this.stage = stage;
    this.container = container;
    this.notices = notices;
  }

  press(): void {
    this.dialog ??= this.load();
    this.dialog.then(
      (dialog) => dialog.open(),
      (error: unknown) => {
        // Allow a retry after a failed fetch.
        this.dialog = undefined;
        this.notices.notify(strings.capture.failed((error as Error).message));
      },
    );
  }

  private async load(): Promise<CaptureDialog> {
    const { CaptureDialog } = await import('./dialog.ts');
    const dialog = new CaptureDialog(this.stage);
    this.container.append(dialog.element);
    return dialog;
  }
}
