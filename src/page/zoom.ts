/** Client pixels of elements, also where CSS `zoom` applies. */

/** The element around another one, across shadow trees and the frames of this window. */
export function parentOf(element: Element): Element | undefined {
  return (
    element.assignedSlot ??
    element.parentElement ??
    (element.getRootNode() as Partial<ShadowRoot>).host ??
    (isForeign(element) ? (element.ownerDocument.defaultView?.frameElement ?? undefined) : undefined)
  );
}

function isForeign({ ownerDocument }: Element): boolean {
  return ownerDocument !== document;
}

interface Zoomed {
  readonly currentCSSZoom: number;
}

/** Client pixels for each CSS pixel of an element that has no transform. */
export function zoomOf(element: Element): number {
  const { currentCSSZoom } = element as Partial<Zoomed>;
  if (currentCSSZoom !== undefined) return currentCSSZoom;
  let zoom = 1;
  for (let each: Element | undefined = element; each; each = parentOf(each)) {
    zoom *= Number.parseFloat(getComputedStyle(each).zoom) || 1;
  }
  return zoom;
}

/** The box of an element in client pixels. Browsers without `currentCSSZoom` divide its place on the page by the zoom. */
export function clientBox(element: Element): DOMRect {
  const box = element.getBoundingClientRect();
  if ((element as Partial<Zoomed>).currentCSSZoom !== undefined) return box;
  const zoom = zoomOf(element);
  const { scrollX: x = 0, scrollY: y = 0 } = element.ownerDocument.defaultView ?? {};
  return new DOMRect((box.x + x) * zoom - x, (box.y + y) * zoom - y, box.width * zoom, box.height * zoom);
}
