import { linkTo } from './address.ts';
import { create, textButton } from './dom.ts';
import type { Editor } from './editor.ts';
import type { Notices } from './notices.ts';
import { strings } from './strings.ts';

/**
 * Copies the link of what is shown and says so; where copying is refused, offers the link to copy by hand.
 * @param mesh name of a mesh that is shown, which no link can hold
 */
export async function share(editor: Editor, notices: Notices, mesh?: string): Promise<void> {
  if (mesh !== undefined) notices.tell(strings.ownShape.unshared(mesh));
  const link = await linkTo(editor);
  try {
    await navigator.clipboard.writeText(link);
    notices.mention(strings.share.copied);
  } catch {
    offer(link);
  }
}

function offer(link: string): void {
  const field = create('input', { type: 'text', readonly: true, value: link, 'aria-label': strings.share.link });
  const close = textButton('loud', strings.help.close, () => sheet.close());
  const sheet = create('dialog', { class: 'sheet card' }, create('p', {}, strings.share.byHand), field, close);
  sheet.addEventListener('close', () => sheet.remove());
  document.body.append(sheet);
  sheet.showModal();
  field.focus();
  field.select();
}
