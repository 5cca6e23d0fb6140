/**
 * Styles of the element. Everything inside the shadow tree is independent of the element's own box, so that smoke has a
 * usable size on a page that resets all styles, including those of the element.
 */
export const css = `
:host { display: block; pointer-events: none; }
:host([hidden]) { display: none; }
:host([interactive]) { pointer-events: auto; }
.frame {
  position: relative; block-size: 100%; overflow: hidden; pointer-events: none;
  font: 500 14px/1 system-ui, sans-serif; color: var(--cartoon-smoke-button-color, #1d1720);
}
.sizer { display: block; inline-size: 100%; block-size: 100%; visibility: hidden; }
.layer { position: absolute; inset: 0; inline-size: 100%; block-size: 100%; }
canvas { pointer-events: none; }
.interactive canvas { pointer-events: auto; touch-action: pan-y; cursor: grab; }
.interactive canvas.holding { cursor: grabbing; }
.poster ::slotted(*) { display: block !important; inline-size: 100% !important; block-size: 100% !important; object-fit: cover !important; }
.poster ::slotted(picture) { display: flex !important; flex-flow: column; justify-content: center; }
.fallback { display: none; }
.failed .fallback { display: block; overflow: auto; pointer-events: auto; }
.shown .poster { display: none; }
.frame:not(.shown) canvas { visibility: hidden; }
button {
  all: initial; position: absolute; box-sizing: border-box; display: none; place-items: center; cursor: pointer;
  inset-block-end: var(--cartoon-smoke-button-inset, 10px); inset-inline-end: var(--cartoon-smoke-button-inset, 10px);
  inline-size: var(--cartoon-smoke-button-size, 36px); block-size: var(--cartoon-smoke-button-size, 36px);
  border: 2px solid currentColor; border-radius: 50%; color: inherit; pointer-events: auto;
  background: var(--cartoon-smoke-button-background, #fff8ecd9); opacity: .55; transition: opacity .15s;
}
.shown button { display: grid; }
button:hover, button:focus-visible, .still button { opacity: 1; }
button:focus-visible { outline: 3px solid var(--cartoon-smoke-focus-color, #2f6fde); outline-offset: 2px; }
button svg { inline-size: 50%; block-size: 50%; fill: currentColor; }
@media (forced-colors: active) { button { background: ButtonFace; color: ButtonText; opacity: 1; } }
@media (prefers-reduced-motion: reduce) { button { transition: none; } }
`;
