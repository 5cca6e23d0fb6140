/** Texts of the dialog and of palettes, which are fetched with them. */
export const words = {
  title: 'Choose a look',
  source: (file: string, colors: number) => `${file}: ${colors} colours`,
  text: 'A look changes colours and light only. Undo restores the present one.',
  looks: {
    whole: ['Full range', 'All tones that fit, from shadow to light, before a quiet backdrop.'],
    poster: ['Poster', 'Two tones far apart before a flat, vivid colour, as in a print.'],
    night: ['Night', 'Light smoke with a bright rim before a dark backdrop.'],
  },
  drawing: 'Drawing the smoke in these colours\u2026',
  cancel: 'Cancel',
  taken: (look: string, file: string) => `The look is \u201c${look}\u201d from ${file}.`,
  faults: {
    empty: 'It is empty.',
    transparent: 'All of the picture is transparent.',
    notPalette:
      'It is not a palette. Use .gpl (GIMP), .hex, .pal (JASC), .txt (paint.net), .json (Lospec) or .ase (Adobe).',
    sprite: 'It is a sprite of Aseprite, not an Adobe palette. Save its palette as .gpl in Aseprite.',
    json: 'It is not valid JSON.',
    jasc: 'A JASC palette has the version 0100 and the number of its colours in the lines 2 and 3.',
    noColors: 'It has no colours. A palette needs at least two.',
    oneColor: (color: string) => `It has only one colour, ${color}. A palette needs at least two.`,
    tooMany: (count: number, max: number) => `It has ${count} colours. The limit is ${max}.`,
    fewer: (announced: number, found: number) => `It ends after ${found} of its ${announced} colours.`,
    line: (number: number, text: string, wanted: 'channels' | 'hex') =>
      `Line ${number} is \u201c${text}\u201d, not ${wanted === 'hex' ? 'a colour such as ff8800' : 'three numbers from 0 to 255'}.`,
    entry: (number: number, text: string) => `Colour ${number} is ${text}, not a text such as ff8800.`,
    truncated: 'It ends in its header.',
    truncatedAt: (block: number, blocks: number) =>
      `It ends in block ${block} of ${blocks}. Save or download it again.`,
    block: (number: number) => `Block ${number} is no colour in RGB, CMYK, LAB or grey.`,
  },
} as const;
