/** Creates elements without parsing markup, so that untrusted text cannot become HTML. */
type Children = readonly (Node | string)[];
type Attributes = Readonly<Record<string, string | number | boolean | undefined>>;

/** Creates an element with attributes and children. `true` sets an empty attribute; `false` and undefined set none. */
export function create<Tag extends keyof HTMLElementTagNameMap>(
  tag: Tag,
  attributes: Attributes = {},
  ...children: Children
): HTMLElementTagNameMap[Tag] {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (value !== undefined && value !== false) element.setAttribute(name, value === true ? '' : String(value));
  }
  element.append(...children);
  return element;
}

/** Sets attributes. */
export function setAttributes(element: Element, attributes: Readonly<Record<string, string | number | boolean>>): void {
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, String(value));
}

/** Creates an SVG element. */
export function createSvg<Tag extends keyof SVGElementTagNameMap>(
  tag: Tag,
  attributes: Readonly<Record<string, string | number>> = {},
  ...children: Children
): SVGElementTagNameMap[Tag] {
  const element = document.createElementNS('http://www.w3.org/2000/svg', tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, String(value));
  element.append(...children);
  return element;
}

/** A button with an icon. The name is its accessible name and its tooltip. */
export function iconButton(className: string, name: string, icon: Node, press: () => void): HTMLButtonElement {
  const button = create('button', { type: 'button', class: className, 'aria-label': name, title: name }, icon);
  button.addEventListener('click', press);
  return button;
}

/** A button with visible text. */
export function textButton(className: string, name: string, press: () => void): HTMLButtonElement {
  const button = create('button', { type: 'button', class: className }, name);
  button.addEventListener('click', press);
  return button;
}

let count = 0;

/** An id that is unique in the page. */
export function uniqueId(): string {
  return `id-${++count}`;
}

/** Downloads a file. @param content a string is saved as JSON */
export function download(name: string, content: string | Blob): void {
  const file = typeof content === 'string' ? new Blob([content], { type: 'application/json' }) : content;
  const address = URL.createObjectURL(file);
  const link = create('a', { href: address, download: name });
  link.click();
  // The browser reads the URL after this task.
  setTimeout(() => URL.revokeObjectURL(address), 60_000);
}

/** Copies text. @returns whether the browser allowed it */
export async function copyText(text: string): Promise<boolean> {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    return false;
  }
}
