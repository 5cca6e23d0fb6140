/** Texts for a scene. */
interface SceneWords {
  /** Shown while the scene loads. */
  readonly loading: string;
  /** Description of the scene. */
  readonly picture: string;
  /** What the user can move, and its effect. */
  readonly hand?: { readonly thing: string; readonly does: string };
}

const scenes: Readonly<Record<string, SceneWords>> = {
  lamp: {
    loading: 'Rubbing the lamp\u2026',
    picture: 'A magic oil lamp that breathes cartoon smoke.',
    hand: { thing: 'the ball', does: 'push it through the smoke' },
  },
  airplane: {
    loading: 'Turning the propeller\u2026',
    picture: 'A toy airplane that parts the clouds.',
    hand: { thing: 'the airplane', does: 'steer it through the clouds' },
  },
  train: {
    loading: 'Shovelling coal\u2026',
    picture: 'A toy steam train that circles an island.',
  },
  campfire: { loading: 'Gathering wood\u2026', picture: 'A campfire at night, with a marshmallow.' },
  rocket: { loading: 'Counting down\u2026', picture: 'A toy rocket that takes off in a ring of smoke.' },
  genie: {
    loading: 'Rubbing the lamp\u2026',
    picture: 'A genie of smoke above his lamp.',
    hand: { thing: 'the genie', does: 'move him to another place' },
  },
  dust: {
    loading: 'Waking the mole\u2026',
    picture: 'Balls and a crate raise dust in a desert. A mole kicks them up.',
    hand: { thing: 'the red ball', does: 'throw it: let go while it moves' },
  },
  cloudscape: { loading: 'Gathering clouds\u2026', picture: 'Clouds that drift over a meadow.' },
  wisp: { loading: 'Boiling water\u2026', picture: 'A steaming cup of tea.' },
  firework: { loading: 'Lighting the fuse\u2026', picture: 'Coloured shells that burst over an island at night.' },
  title: { loading: 'Raising the curtain\u2026', picture: 'Four letters that burst out of a stage: puff.' },
  dragon: { loading: 'Waking the dragon\u2026', picture: 'A small dragon on its gold that breathes fire and smoke.' },
  teapot: { loading: 'Putting the kettle on\u2026', picture: 'A teapot whose steam writes the word TEA.' },
  air: { loading: 'Taking a breath\u2026', picture: 'Nothing but smoke.' },
};

/** A number with its noun. */
function counted(count: number, noun: string): string {
  return `${count.toLocaleString('en')} ${noun}${count === 1 ? '' : 's'}`;
}

/** All texts of the page, in one place for translation. Labels of parameters are in the table. */
/** Size of a file. */
function sizeOf(bytes: number): string {
  return `${(bytes / 1e6).toFixed(bytes < 1e6 ? 2 : 1)} MB`;
}

export const strings = {
  title: 'Cartoon Smoke',
  scenes,
  picture: (picture: string, thing?: string) =>
    thing ? `${picture} Drag ${thing}, or move it with the arrow keys.` : picture,
  hint: (held?: { readonly thing: string; readonly does: string }) =>
    `${held ? `Drag ${held.thing} to ${held.does}. Drag elsewhere` : 'Drag'} to turn the view. The help (?) lists everything else.`,
  surprise: { card: 'Surprise', name: 'Surprise me', scene: 'Random' },
  drop: 'Drop a ball or a crate',
  blow: 'Blow into the smoke by dragging',
  panel: {
    title: 'Parameters',
    open: 'Parameters',
    search: 'Find a parameter',
    found: (count: number) => (count === 1 ? '1 parameter' : `${count} parameters`),
    sheet: 'Panel height',
    resetAll: 'Reset all',
    undo: 'Undo',
    redo: 'Redo',
    close: 'Close the parameters',
    caption: 'The link in the address bar contains every change.',
    reset: (label: string) => `Reset ${label}`,
    exactly: (label: string) => `${label}, exact value`,
  },
  gallery: { title: 'Presets', toggle: 'Presets' },
  curve: {
    stop: (number: number, at: number, value: number) =>
      `Stop ${number}: ${Math.round(100 * value)} % at ${Math.round(100 * at)} %`,
  },
  ramp: {
    stop: (number: number, color: string, at: number) => `Stop ${number}: ${color} from ${Math.round(100 * at)} %`,
    color: 'Colour of the chosen stop',
    remove: 'Remove this stop',
    begin: 'Empty: press to add',
  },
  items: {
    kind: 'What to add',
    add: 'Add',
    remove: (label: string) => `Remove ${label}`,
    world: 'Nothing',
  },
  dial: {
    words: {
      label: 'Time of day',
      text: 'Moves the sun and changes its colours, the ambient light and the backdrop together. At 14:00 they are those of the preset.',
    },
    /** @param own hour of the preset's own light */
    hour: (hour: number | undefined, own: number) => {
      if (hour === undefined) return 'own light';
      const time = `${Math.floor(hour)}`.padStart(2, '0') + `:${`${60 * (hour % 1)}`.padStart(2, '0')}`;
      const part = hour < 5 ? 'night' : hour < 8 ? 'dawn' : hour < 17 ? 'day' : hour < 20.5 ? 'dusk' : 'night';
      return `${time}, ${hour === own ? 'own light' : part}`;
    },
  },
  gizmos: {
    title: 'Handles',
    how: 'Drag, or use the arrow keys, Page Up and Page Down.',
    light: (azimuth: number, elevation: number) => `Light: azimuth ${azimuth}\u00b0, elevation ${elevation}\u00b0`,
    wind: (speed: number) => `Wind: ${speed.toFixed(1)} m/s`,
    addWhirl: 'Add a vortex',
    attachTo: (label: string) => `Attach ${label} to`,
  },
  flow: {
    draw: 'Draw a flow',
    open: 'Draw in the picture\u2026',
    remove: 'Straight up',
    how: 'Draw a stroke over the picture. Enter draws a straight one.',
    cancel: 'Cancel',
    point: (label: string, point: number, count: number) =>
      `${label}, point ${point} of ${count}. Enter adds one, Delete removes it`,
  },
  transport: {
    title: 'Playback',
    play: 'Play',
    pause: 'Pause',
    step: 'One step',
    restart: 'Start over',
    timeline: 'Timeline',
    fullScreen: 'Full screen',
    speed: 'Speed',
    speeds: [
      [1, '1\u00d7'],
      [0.5, '\u00bd\u00d7'],
      [0.25, '\u00bc\u00d7'],
      [2, '2\u00d7'],
    ] as const,
    time: (seconds: number) => `${seconds.toFixed(1)} s`,
    playSmoke: 'Play the smoke',
  },
  share: {
    button: 'Share',
    title: 'Share this smoke',
    what: 'What to share',
    kinds: {
      look: ['This look', 'All current parameters. The smoke starts from the beginning.'],
      moment: ['This moment', 'This exact frame, with the time and your input.'],
    },
    link: 'Link to this smoke',
    copy: 'Copy link',
    copied: 'Copied.',
    byHand: 'The browser blocked copying. Press Ctrl + C, or \u2318 C on a Mac.',
    send: 'Send\u2026',
    notSent: 'The link could not be shared. Copy it instead.',
    save: 'Save as file',
    saved: (name: string) => `Saved as ${name}. Drop the file on this page to open it.`,
    tooLong: (length: number, max: number) =>
      `The link would have ${length} characters, but chat programs cut links over ${max}. Save a file instead. Drop it on this page to open it.`,
    code: 'QR code of the link',
    scan: 'Scan to open on a phone',
    embed: 'Embed in your page',
  },
  own: {
    title: 'My looks',
    text: 'Looks saved in this browser. Save a look as a file to share it, or drop a file on the page.',
    keep: 'Save this look',
    kept: (name: string) => `${name} is saved in this browser.`,
    numbered: (preset: string, number: number) => `${preset} ${number}`,
    rename: (name: string) => `Rename ${name}`,
    newName: 'New name',
    save: (name: string) => `Save ${name} as file`,
    remove: (name: string) => `Remove ${name}`,
    removed: (name: string) => `Removed ${name}.`,
    bringBack: 'Undo',
    full: 'The browser storage is full. Remove a look, or save this one as a file.',
    noStorage: 'The browser storage is not available. Save the look as a file.',
    damaged: (key: string) => `Some saved looks could not be read. Their data is in localStorage under ${key}.`,
  },
  files: {
    open: 'Open a file\u2026',
    opened: (name: string) => `Opened ${name}.`,
    rejected: (file: string, reason: string) => `${file} could not be opened. ${reason}`,
    tooLarge: (megabytes: number) => `The file is too large. The limit is ${megabytes} MB.`,
  },
  capture: {
    button: 'Capture',
    title: 'Capture the smoke',
    labels: {
      format: 'Format',
      size: 'Size',
      scale: 'Scale',
      seconds: 'Seconds',
      rate: 'Frame rate',
      background: 'With background',
      layers: 'In layers',
      lights: 'Light maps',
    },
    lights: { unity: 'For Unity', unreal: 'For Unreal (RLT, BBF)', none: 'None' },
    formats: {
      png: 'Picture (PNG)',
      svg: 'Drawing (SVG)',
      apng: 'Looped APNG',
      webp: 'Looped WebP',
      gif: 'Looped GIF',
      webm: 'Video (WebM)',
      mp4: 'Video (MP4)',
      zip: 'PNG sequence (ZIP)',
      flipbook: 'Flipbook for games (ZIP)',
    },
    notes: {
      png: '',
      svg: 'Flat colours and ink as grouped paths. Gradients become steps.',
      apng: 'Loops seamlessly, with all colours and exact alpha.',
      webp: 'Loops seamlessly, with exact alpha and a small loss of colour.',
      gif: 'Loops seamlessly, with 256 colours for each frame and no partial transparency.',
      webm: 'Contains every frame, even on a slow machine.',
      mp4: 'Contains every frame, even on a slow machine.',
      zip: 'Layers: one folder each for flat colours, shadow, ink, surfaces and depth.',
      flipbook:
        'A seamless loop as atlases of colour, light, normals and motion. Light maps have light from six sides and take twice the time.',
    },
    window: (width: number, height: number) => `Window, ${width} \u00d7 ${height}`,
    times: (scale: number) => `${scale}\u00d7`,
    perSecond: (rate: number) => `${rate} per second`,
    size: (width: number, height: number) => `${width} \u00d7 ${height} pixels.`,
    frames: (count: number, width: number, height: number) => `${count} frames of ${width} \u00d7 ${height} pixels.`,
    start: 'Capture',
    working: 'Drawing frame by frame\u2026',
    cancelled: 'Stopped. The smoke is unchanged.',
    compare: 'Compare sizes',
    comparing: 'Drawing the clip in each format\u2026',
    compared: (count: number) => `The clip is ready in ${count} formats.`,
    sizes: 'Sizes of this clip',
    megabytes: sizeOf,
    save: 'Save',
    saveAs: (name: string) => `Save ${name}`,
    names: { apng: 'APNG', webp: 'WebP', gif: 'GIF', webm: 'WebM', mp4: 'MP4' },
    missing: 'Not in this browser',
    opaque: 'with background',
    tooFast: (rate: number) => `At most ${rate} per second`,
    saved: (name: string, bytes: number) => `Saved ${name}, ${sizeOf(bytes)}.`,
    failed: (reason: string) => `The capture failed. ${reason}`,
    noWebp: 'This browser cannot encode WebP. Choose APNG, which every browser shows.',
    noEncoder: (format: string, width: number, height: number) =>
      `This browser cannot encode ${format} at ${width} \u00d7 ${height} pixels. Use a smaller size, the other video format or a PNG sequence.`,
  },
  moment: {
    winding: (seconds: number) => `Replaying ${seconds.toFixed(1)} s\u2026`,
    rejected: (reason: string) => `The moment in the link cannot be shown: ${reason}`,
    truncated: 'The recording of this moment is incomplete. The smoke may look different.',
    tooLate: (seconds: number) => `This moment is later than the limit. The smoke is shown at ${seconds} s.`,
    notFresh: 'it starts from a saved state. A file can contain such a moment.',
    tooMany: (particles: number, max: number) =>
      `it needs room for ${particles} particles. The limit for links is ${max}.`,
  },
  drawing: {
    open: 'Draw a puff\u2026',
    remove: 'Remove drawings',
    title: 'Draw a puff',
    done: 'Done',
    cancel: 'Cancel',
    toolbar: 'Tools',
    tools: { pen: 'Pen', eraser: 'Eraser', fill: 'Fill', fold: 'Fold line' },
    mirror: 'Symmetric',
    clear: 'Clear the sheet',
    paper: 'Sheet',
    how: 'The arrow keys move a cursor, with Shift in longer steps. The space bar draws; hold it while the cursor moves to draw a line.',
    width: 'Width',
    colors: 'Colour',
    swatch: (number: number, color: string) => `Colour ${number}, ${color}`,
    color: 'Change the chosen colour',
    puff: (number: number) => `Puff ${number}`,
    add: 'Add a puff',
    duplicate: 'Duplicate this puff',
    removePuff: 'Remove this puff',
    import: 'Picture\u2026',
    text: 'Text',
    letters: 'Letters',
    fourLetters: (count: number) => `Only the first ${count} letters become puffs.`,
    status: (number: number, count: number, tool: string, share: number) =>
      `Puff ${number} of ${count}, ${tool.toLowerCase()}, ${Math.round(100 * share)} % of the sheet painted.`,
    rough: 'Details are left out, so that it fits into a link.',
    tooManyPixels: (max: number) => `The picture is too large. The limit is ${max} pixels per side.`,
    notPng: 'It is not a valid PNG file.',
    notPicture: 'The browser cannot read it as a picture.',
    nothing: 'There is nothing to draw: everything is transparent or outside the picture.',
  },
  timeline: {
    title: 'Timeline',
    open: 'Open the timeline',
    remove: 'Remove the timeline',
  },
  outline: {
    word: 'Type a word',
    picture: 'Picture\u2026',
    remove: 'Remove the outline',
  },
  purpose: {
    title: (file: string) => `What is ${file} for?`,
    cancel: 'Cancel',
    puff: ['Puff', 'Draws it on the sheet as the shape of the puffs.'],
    sheet: ['Puff sheet', 'Uses it as a texture of puffs with normals and depths.'],
    palette: ['Palette', 'Proposes looks in its colours.'],
  },
  palette: {
    open: 'From a palette or a picture\u2026',
    reading: (file: string) => `Reading the colours of ${file}\u2026`,
  },
  model: {
    title: 'Model',
    text: 'A GLB file of at most 32 MB, 200,000 triangles and 64 materials, added to the scene. Drop it on the page. Smoke comes from what you click.',
    choose: 'Choose a GLB file\u2026',
    remove: 'Remove the model',
    none: 'Drop a GLB file on the page to add it to the scene.',
    reading: (name: string) => `Reading ${name}\u2026`,
    placed: (name: string) => `${name} is in the scene. Click it to add smoke.`,
    shown: (name: string, triangles: number, materials: number, box: readonly number[]) =>
      `${name}: ${counted(triangles, 'triangle')}, ${counted(materials, 'material')}, ${box.map((side) => side.toPrecision(2)).join(' \u00d7 ')} m`,
    tooLarge: (megabytes: number, most: number) => `It has ${megabytes} MB. The limit is ${most} MB.`,
    unshared: (name: string) =>
      `A link cannot contain the model ${name}. Save it as a file instead, which contains the model.`,
    notKept: (name: string) => `A preset in the browser cannot contain the model ${name}. Save it as a file instead.`,
    rows: {
      x: ['Position x', 'Moves the model to the right.', 'm'],
      y: ['Position y', 'Height of the underside of the model.', 'm'],
      z: ['Position z', 'Moves the model towards you.', 'm'],
      turn: ['Turn', 'Turns the model about its vertical axis.', '\u00b0'],
      size: ['Size', 'Longest side of the model.', 'm'],
      animation: ['Animation', 'The animation that plays. It repeats.', ''],
      speed: ['Speed of the animation', 'Seconds of the animation per simulated second.', '\u00d7'],
    },
    noAnimation: 'None',
    clicks: 'Click the model to add smoke',
    node: 'Part that smokes',
    add: 'Add smoke',
    added: (node: string, emitter: string) => `${emitter} smokes from ${node}.`,
    full: (most: number) => `There are ${most} emitters already. Remove one of them first.`,
  },
  ownShape: {
    choose: 'Use your own mesh or puff sheet\u2026',
    back: 'Use the default puffs',
    text: 'Makes puffs from a closed mesh or a puff sheet. Choose a .glb, .gltf or .obj file or one or two PNG images, or drop a .gltf or .obj file or a PNG image on the page. They replace the shape controls above.',
    fitting: (name: string) => `Fitting a puff to ${name}\u2026`,
    shown: (name: string, overlap: number) => `${name}, ${Math.round(100 * overlap)} % match`,
    reading: 'Reading the puff sheet\u2026',
    sheet: (name: string, puffs: number) => `${name}, ${puffs === 1 ? 'one puff' : `${puffs} puffs`}`,
    billboards: 'Puffs are now billboards, which show the sheet.',
    save: 'Save puff sheet',
    saving: 'Drawing the puff sheet\u2026',
    saved: (saved: number, all: number) =>
      `Saved puffs-normal-depth.png and puffs-color-coverage.png.${saved < all ? ` A sheet holds ${saved} of the ${all} puffs.` : ''}`,
    unshared: (name: string) =>
      `A link cannot contain a ${/\.png$/i.test(name) ? 'puff sheet' : 'mesh'}. It shows the default puffs instead of ${name}.`,
  },
  notices: {
    title: 'Messages',
    dismiss: 'Dismiss this message',
    newVersion: 'A new version of this page is available.',
    reload: 'Reload',
    retry: 'Try again',
    slow: 'This machine is slow, so playback uses fewer pixels. Pause to draw all pixels, or lower the rate to draw faster.',
    flat: 'This GPU ignores the depth of puffs, so they are flat and meet in straight lines.',
  },
  views: {
    lit: 'Lit: the colours in the light.',
    unlit: 'Unlit: the colours in shadow.',
    ink: 'Ink: black.',
    normals: 'Normals: red points right, green up, blue at you. Surfaces are grey.',
    depth: 'Depth: white is near, black is far.',
    counts: 'Shadow volumes around a pixel: black is none, red is one, then yellow and white.',
    overdraw: 'Polygons drawn at a pixel, hidden or not: black is none, red is one, then yellow and white.',
    coverage: 'Coverage grid: puffs behind a tinted cell are not drawn. Bright is near, dark is far.',
  },
  debugPanel: {
    title: 'Debug views',
    view: 'View',
    picture: 'Final picture',
    names: {
      lit: 'Lit',
      unlit: 'Unlit',
      ink: 'Ink',
      normals: 'Normals',
      depth: 'Depth',
      counts: 'Shadow volumes',
      overdraw: 'Overdraw',
      coverage: 'Coverage grid',
    },
  },
  help: { button: 'Help', close: 'Close' },
  progress: {
    winding: (seconds: number) => `Seeking to ${Number(seconds.toFixed(1))} s\u2026`,
    cancel: 'Stop here',
    cancelled: (seconds: number) => `Stopped at ${seconds.toFixed(1)} s.`,
    simulator: 'Loading the simulator for flows and shapes\u2026',
  },
  error: {
    unsupported: {
      title: 'This browser cannot show the smoke',
      advice: [
        'Use a current Chrome, Edge, Firefox or Safari (16.4 or newer).',
        'Turn on hardware acceleration in the browser settings, then restart the browser.',
        'Update the graphics driver. If you use a remote desktop, try without it.',
      ],
    },
    load: {
      title: 'The smoke could not be loaded',
      advice: ['Check the connection and reload the page.', 'A script blocker may have blocked the WebAssembly file.'],
    },
    context: {
      title: 'The graphics context was lost',
      advice: ['Reload the page.', 'Close other 3D pages. Browsers limit the number of graphics contexts.'],
    },
    other: {
      title: 'The smoke stopped',
      advice: ['Reload the page.', 'If the error comes back, remove # and everything after it from the address.'],
    },
    reload: 'Reload',
  },
  statistics: { title: 'Statistics' },
} as const;
