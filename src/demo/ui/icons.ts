/** The icons of the page: strokes of one weight on a 24 x 24 grid, in the text colour. */
const paths = {
  play: 'M7 4.5v15l13-7.5z',
  pause: 'M7 4.5v15M17 4.5v15',
  step: 'M5 4.5v15l10-7.5zM19.5 4.5v15',
  restart: 'M5 12a7.5 7.5 0 1 0 2.6-5.7M8.4 2.6l-1.2 4.2 4.2 1.2',
  undo: 'M4 9h10a5.5 5.5 0 0 1 0 11H9M8.5 4.5 4 9l4.5 4.5',
  redo: 'M20 9H10a5.5 5.5 0 0 0 0 11h5M15.5 4.5 20 9l-4.5 4.5',
  reset: 'M6 12a6.5 6.5 0 1 0 2.2-4.9M9 3.5 7.8 7.4l3.9 1.2',
  close: 'M5.5 5.5l13 13M18.5 5.5l-13 13',
  sliders: 'M4 7h9M18 7h2M4 17h3M12 17h8M15.5 4.5v5M9.5 14.5v5',
  share: 'M12 15V3.5M7.5 7.5 12 3.5l4.5 4M5 12v8h14v-8',
  camera: 'M4 7.5h4l1.8-2.5h4.4L16 7.5h4v11.5H4zM15.4 13a3.4 3.4 0 1 1-6.8 0 3.4 3.4 0 0 1 6.8 0',
  help: 'M8.5 8.5a3.6 3.6 0 1 1 5.2 3.3c-1.2.7-1.7 1.3-1.7 2.7M12 19.3v.4',
  rename: 'M4.5 19.5l1-4.5L16 4.5l3.5 3.5L9 18.5zM13.5 7l3.5 3.5',
  download: 'M12 4v11.5M7.5 11 12 15.5l4.5-4.5M5 20h14',
  remove: 'M4.5 7h15M9 7V4h6v3M6.5 7l1 13h9l1-13',
  fullScreen: 'M4 9V4h5M15 4h5v5M20 15v5h-5M9 20H4v-5',
  pictures: 'M3.5 5.5h17v13h-17zM3.5 16l5-5 4 4 3-3 5 5',
  handles: 'M12 3v18M3 12h18M9.5 5.5 12 3l2.5 2.5M9.5 18.5 12 21l2.5-2.5M5.5 9.5 3 12l2.5 2.5M18.5 9.5 21 12l-2.5 2.5',
  dice: 'M4.5 4.5h15v15h-15zM8.6 8.4v.4M15.4 8.4v.4M12 11.8v.4M8.6 15.2v.4M15.4 15.2v.4',
  drop: 'M12 2.5a3.8 3.8 0 1 0 .01 0M12 12.5v5M9.2 15l2.8 2.8L14.8 15M4.5 21h15',
  sun: 'M12 7.5a4.5 4.5 0 1 0 .01 0M12 2v2M12 20v2M2 12h2M20 12h2M4.9 4.9l1.4 1.4M17.7 17.7l1.4 1.4M4.9 19.1l1.4-1.4M17.7 6.3l1.4-1.4',
  wind: 'M3 9h10.5a3 3 0 1 0-3-3M3 13.5h15a3 3 0 1 1-3 3M3 18h6.5',
  emitter: 'M7 20h10l-1.5-6h-7zM12 10V4M7.5 9.5 5.5 6M16.5 9.5l2-3.5',
  vortex: 'M12 12a2 2 0 1 1 2 2.3 4.6 4.6 0 0 1-6.5-3.6A6.6 6.6 0 0 1 15 4.6a8 8 0 0 1 5 9A8.6 8.6 0 0 1 9 20',
  pen: 'M4 20l1.2-5L16.5 3.7l3.8 3.8L9 18.8zM4 20l5-1.2',
  eraser: 'M9 19.5 3.5 14 14 3.5l6.5 6.5L11 19.5zM8.5 8.8l6.6 6.7M11 19.5h9',
  fill: 'M10.5 3.5 18 11l-7.5 7.5L3 11zM10.5 3.5 8 1M20.5 14.5c1.2 2 1.8 3 1.8 4a1.8 1.8 0 0 1-3.6 0c0-1 .6-2 1.8-4z',
  fold: 'M3.5 17C6 8 9.5 6.5 12 11s5 6 8.5-3.5',
  mirror: 'M12 2.5v3M12 8.5v3M12 14.5v3M12 20v1.5M8.5 6v12L2.5 18zM15.5 6v12l6 0z',
  add: 'M12 5v14M5 12h14',
  copy: 'M8.5 8.5h11v11h-11zM15.5 4.5h-11v11',
  keyframe: 'M12 4.5 19.5 12 12 19.5 4.5 12z',
  record: 'M12 6a6 6 0 1 0 .01 0',
  previous: 'M10.5 6l-6 6 6 6M16.5 8.5 20 12l-3.5 3.5L13 12z',
  next: 'M13.5 6l6 6-6 6M7.5 8.5 11 12l-3.5 3.5L4 12z',
  burst: 'M12 3v4.5M12 16.5V21M3 12h4.5M16.5 12H21M5.6 5.6l3.2 3.2M15.2 15.2l3.2 3.2M5.6 18.4l3.2-3.2M15.2 8.8l3.2-3.2',
  paste: 'M8 5H5.5v15h13V5H16M9 3.5h6V7H9zM9 11.5h6M9 15.5h6',
  duplicate: 'M8.5 7l4.5 5-4.5 5L4 12zM14.5 7l4.5 5-4.5 5',
  box: 'M4.5 8V4.5H8M11 4.5h2M16 4.5h3.5V8M19.5 11v2M19.5 16v3.5H16M13 19.5h-2M8 19.5H4.5V16M4.5 13v-2',
  zoomIn: 'M10.5 4.5a6 6 0 1 0 .01 0M15 15l5 5M10.5 8v5M8 10.5h5',
  zoomOut: 'M10.5 4.5a6 6 0 1 0 .01 0M15 15l5 5M8 10.5h5',
  fit: 'M3.5 6v12M20.5 6v12M7 12h10M9.5 9l-2.7 3 2.7 3M14.5 9l2.7 3-2.7 3',
  loop: 'M6 9.5A6.5 6.5 0 0 1 17.5 8M18 14.5A6.5 6.5 0 0 1 6.5 16M17.8 4.2v4h-4M6.2 19.8v-4h4',
} as const;

export type IconName = keyof typeof paths;

/** Creates an icon. It is hidden from screen readers; its button has a name. */
export function icon(name: IconName): SVGSVGElement {
  const namespace = 'http://www.w3.org/2000/svg';
  const root = document.createElementNS(namespace, 'svg');
  const path = document.createElementNS(namespace, 'path');
  path.setAttribute('d', paths[name]);
  root.setAttribute('viewBox', '0 0 24 24');
  root.setAttribute('class', `icon icon-${name}`);
  root.setAttribute('aria-hidden', 'true');
  root.append(path);
  return root;
}
