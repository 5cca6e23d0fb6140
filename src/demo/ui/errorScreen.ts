import { ContextError, LoadError, UnsupportedError } from '../../index.ts';
import { create, textButton } from './dom.ts';
import { strings } from '../strings.ts';

/** Error page: what happened, advice, and a reload button. */
export function createErrorScreen(error: unknown): HTMLElement {
  const { title, advice } = adviceFor(error);
  const reason = error instanceof Error ? error.message : String(error);
  const items = advice.map((text) => create('li', {}, text));
  const reload = textButton('loud', strings.error.reload, () => location.reload());
  const parts = [create('h1', {}, title), create('p', {}, reason), create('ul', {}, ...items), reload];
  return create('div', { class: 'error-screen', role: 'alert' }, create('div', { class: 'card' }, ...parts));
}

function adviceFor(error: unknown): { title: string; advice: readonly string[] } {
  if (error instanceof UnsupportedError) return strings.error.unsupported;
  if (error instanceof LoadError) return strings.error.load;
  if (error instanceof ContextError) return strings.error.context;
  return strings.error.other;
}
