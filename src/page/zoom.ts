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

/** Client pixels for each CSS pixel of an element that has no transform. */
export function zoomOf(element: Element): number {
  const { currentCSSZoom } = element as { currentCSSZoom?: number };
  if (currentCSSZoom !== undefined) return currentCSSZoom;
  let zoom = 1;
  for (let each: Element | undefined = element; each; each = parentOf(each)) {
    zoom *= Number.parseFloat(getComputedStyle(each).zoom) || 1;
  }
  return zoom;
}

/** The box of an element in client pixels. Browsers without `currentCSSZoom` divide it by the zoom. */
export function clientBox(element: Element): DOMRect {
  const box = element.getBoundingClientRect();
  if ('currentCSSZoom' in element) return box;
  const zoom = zoomOf(element);
  return new DOMRect(box.x * zoom, box.y * zoom, box.width * zoom, box.height * zoom);
}
