/** All words of the page in one place, so that somebody can translate them. Labels of parameters are in the table. */
export const strings = {
  title: 'Cartoon Smoke',
  panel: {
    title: 'Parameters',
    open: 'Parameters',
    presets: 'Presets',
    resetAll: 'Reset all',
    undo: 'Undo',
    redo: 'Redo',
    close: 'Close the parameters',
    caption: 'Turn something: the link in the address bar follows.',
    reset: (label: string) => `Reset ${label}`,
    exactly: (label: string) => `${label}, exact value`,
  },
  curve: {
    stop: (number: number, at: number, value: number) =>
      `Stop ${number}: ${Math.round(100 * value)} % at ${Math.round(100 * at)} %`,
  },
  ramp: {
    stop: (number: number, color: string, at: number) => `Stop ${number}: ${color} from ${Math.round(100 * at)} % on`,
    color: 'Colour of the chosen stop',
    remove: 'Remove this stop',
  },
  items: {
    kind: 'What to add',
    add: 'Add',
    remove: (label: string) => `Remove ${label}`,
    world: 'Nothing',
  },
  transport: {
    title: 'Playback',
    play: 'Play',
    pause: 'Pause',
    step: 'One step',
    restart: 'Start over',
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
    copied: 'The link is copied. It holds every parameter as it is now.',
    byHand: 'The browser did not let the page copy. Copy the link from here:',
    link: 'Link to this smoke',
  },
  ownShape: {
    choose: 'Use a shape of your own\u2026',
    back: 'Back to drawn puffs',
    text: 'Makes puffs of any closed mesh: drop a .glb, .gltf or .obj on the page. The knobs above wait meanwhile.',
    fitting: (name: string) => `Making a puff of ${name}\u2026`,
    shown: (name: string, overlap: number) => `${name}, ${Math.round(100 * overlap)} % alike`,
    unshared: (name: string) => `A link cannot hold a mesh: who opens it sees drawn puffs instead of ${name}.`,
  },
  notices: {
    title: 'Messages',
    dismiss: 'Dismiss this message',
    flat: 'This graphics card does not draw puffs round, so they are flat here and meet in straight lines.',
  },
  help: {
    button: 'Help',
    title: 'Play with smoke',
    paper: 'How it follows the paper of 2006',
    close: 'Close',
    pointer: [
      ['Drag the ball', 'push it through the smoke'],
      ['Drag elsewhere', 'look from another side'],
      ['Alt + drag elsewhere', 'blow into the smoke'],
      ['Wheel or pinch', 'come nearer, go farther'],
      ['Right button or two fingers', 'shift the view'],
    ],
    keys: [
      ['Space', 'play or pause'],
      ['.', 'one step'],
      ['R', 'start over'],
      ['\u2190 \u2192 \u2191 \u2193', 'move the ball'],
      ['Page Up, Page Down', 'move the ball away, towards you'],
      ['Shift + \u2190 \u2192 \u2191 \u2193', 'look from another side'],
      ['+ \u2212', 'come nearer, go farther'],
      ['0', 'back to the first view'],
      ['P', 'show or hide the parameters'],
      ['S', 'copy a link to this smoke'],
      ['Ctrl + Z, Ctrl + Shift + Z', 'undo, redo'],
      ['?', 'this sheet'],
    ],
  },
  progress: {
    loading: 'Rubbing the lamp\u2026',
    winding: (seconds: number) => `Winding forward to ${seconds} s\u2026`,
    cancel: 'Stop here',
    cancelled: (seconds: number) => `Stopped at ${seconds.toFixed(1)} s.`,
  },
  refusal: {
    unsupported: {
      title: 'No smoke in this browser',
      advice: [
        'Try a current Chrome, Edge, Firefox or Safari (16.4 or newer).',
        'Switch hardware acceleration on in the settings of the browser, then start it anew.',
        'Bring the graphics driver up to date; on a remote desktop, try the machine itself.',
      ],
    },
    load: {
      title: 'The smoke did not arrive',
      advice: [
        'Check the connection and reload the page.',
        'A blocker of scripts may have stopped the WebAssembly file.',
      ],
    },
    context: {
      title: 'The graphics stopped',
      advice: ['Reload the page.', 'Close other pages that draw in 3D: browsers allow only a few at once.'],
    },
    other: {
      title: 'The lamp went out',
      advice: [
        'Reload the page.',
        'If it happens again with this link, try the page without what stands behind # in the address.',
      ],
    },
    reload: 'Reload',
  },
  statistics: { title: 'Statistics' },
} as const;
