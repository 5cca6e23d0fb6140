import { iconButton } from '../ui/dom.ts';
import { icon } from '../ui/icons.ts';
import { strings } from '../strings.ts';

/** Lets the page fill the screen, or gives the screen back. Nothing happens where the browser does not allow it. */
export async function toggleFullScreen(): Promise<void> {
  if (document.fullscreenElement) await document.exitFullscreen();
  else if (document.fullscreenEnabled) await document.documentElement.requestFullscreen();
}

/** Its button, hidden where a page cannot fill the screen, as on some phones and in some frames. */
export function createFullScreenButton(): HTMLButtonElement {
  const { fullScreen } = strings.transport;
  const button = iconButton('icon-button', fullScreen, icon('fullScreen'), () => void toggleFullScreen());
  button.hidden = !document.fullscreenEnabled;
  document.addEventListener('fullscreenchange', () => {
    button.setAttribute('aria-pressed', String(document.fullscreenElement !== null));
  });
  button.setAttribute('aria-pressed', 'false');
  return button;
}
