declare module '@hotwired/turbo' {
  export function morphElements(from: Element, to: Element): void;
  export function morphBodyElements(from: Element, to: Element): void;
}
