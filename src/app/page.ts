import type { Stage } from '../stage/stage.ts';
import { create, iconButton } from './dom.ts';
import type { Editor } from './editor.ts';
import { createHelp, toggleHelp } from './help.ts';
import { icon } from './icons.ts';
import type { Notices } from './notices.ts';
import { OwnShape } from './ownShape.ts';
import { createPanel, PANEL_ID } from './panel.ts';
import { share } from './share.ts';
import { createStatistics } from './statistics.ts';
import { strings } from './strings.ts';
import { createTransport } from './transport.ts';
import { Views } from './views.ts';

/** What the keys need of the page's controls. */
export interface Page {
  share(): void;
  help(): void;
  togglePanel(): void;
  nextView(): void;
}

/** On a phone the panel covers half of the smoke, so it starts closed there. */
const ROOMY = '(min-width: 701px) and (min-height: 501px)';

/** Puts the controls over the canvas. @param host the element that holds them */
export function buildPage(
  host: HTMLElement,
  editor: Editor,
  stage: Stage,
  notices: Notices,
  hasStatistics: boolean,
): Page {
  const help = createHelp();
  const views = new Views(stage);
  const toggle = iconButton('icon-button', strings.panel.open, icon('sliders'), () => page.togglePanel());
  toggle.setAttribute('aria-controls', PANEL_ID);
  const ownShape = new OwnShape(stage, notices, host);
  ownShape.acceptDrops(document.body);
  const panel = createPanel(editor, stage, { puff: ownShape.element }, () => {
    page.togglePanel();
    toggle.focus();
  });
  const showPanel = (isOpen: boolean) => {
    panel.hidden = !isOpen;
    toggle.setAttribute('aria-expanded', String(isOpen));
    document.body.classList.toggle('has-panel', isOpen);
  };
  const page: Page = {
    share: () => void share(editor, notices, ownShape.name),
    help: () => toggleHelp(help),
    nextView: () => views.next(),
    togglePanel: () => showPanel(panel.hidden !== false),
  };
  host.append(createHeader(page, toggle), createTransport(stage), panel, help, views.element);
  if (hasStatistics) host.append(createStatistics(stage));
  showPanel(matchMedia(ROOMY).matches);
  return page;
}

function createHeader(page: Page, toggle: HTMLElement): HTMLElement {
  const shareButton = create('button', { type: 'button', class: 'loud' }, icon('share'), strings.share.button);
  shareButton.addEventListener('click', () => page.share());
  const helpButton = iconButton('icon-button', strings.help.button, icon('help'), () => page.help());
  const actions = create('div', { class: 'actions card' }, shareButton, helpButton, toggle);
  return create('header', { class: 'top' }, createWordmark(), actions);
}

function createWordmark(): HTMLElement {
  const words = strings.title.split(' ').map((word) => create('span', {}, word));
  return create('h1', { class: 'wordmark', 'aria-label': strings.title }, ...words);
}
