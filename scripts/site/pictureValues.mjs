/** What the pictures of the parameters show: which parameters, and which of their values. */

/** @typedef {number | string} Value */
/** @typedef {Readonly<Record<string, Value>>} Values */

/** Groups that a still picture can show. */
export const GROUPS = ['emission', 'style', 'light', 'puff', 'forces', 'turbulence', 'air'];
/** What others show, or what only a film shows. */
export const LEFT_OUT =
  /^(style\.(renderer|volumes|hold|wash|washColor)|puff\.(precision|seed|views|drawing)|light\.decay)$/;

/**
 * Other values without which a parameter has no effect.
 * @type {readonly (readonly [keys: RegExp, values: Values])[]}
 */
export const NEEDED = [
  [/^style\.(shadowDepth|deepShadow)$/, { 'style.shadowSteps': 2 }],
  [/^style\.gradient(Color|Bottom|Top)$/, { 'style.gradient': 'height' }],
  [/^style\.pattern[A-Z]/, { 'style.pattern': 'lines', 'style.patternOn': 'both' }],
  [/^style\.rimColor$/, { 'style.rim': 0.6 }],
  [/^style\.rampBlend$/, { 'style.ramp': '0:3b2a6b,.4:d9577a,1:fff0c2' }],
  [/^style\.inkLight$/, { 'light.color': '#ff9a50', 'light.intensity': 2 }],
  [/^light\.distance$/, { 'light.kind': 'lamp' }],
  [/^wind\./, { 'forces.wind.x': 0.6 }],
  [/^shapes\./, { 'emission.rate': 240, 'puff.size': 0.6 }],
  [/^emission\.glow$/, { 'style.heatRamp': '0:d8d3c8,.5:e8743b,1:ffe08a' }],
];

/**
 * Values where those of the slider are more than a picture shows, and those of texts.
 * @type {Readonly<Record<string, readonly Value[]>>}
 */
export const VALUES = {
  'emission.rate': [8, 28, 120],
  'emission.lifetime': [2, 7, 13],
  'emission.density': ['0:1,1:0', '0:.3,.6:1,1:0', '0:1,.85:.4,1:0'],
  'emission.glow': ['0:0,1:0', '0:1,.5:0,1:0', '0:1,1:1'],
  'puff.size': [0.4, 1, 2],
  'style.ramp': ['', '0:3b2a6b,.4:d9577a,1:fff0c2', '0:1f4e5f,.3:79a8a9,.7:f4f7f7'],
  'style.ageRamp': ['', '0:ffffff,1:5b6ee1', '0:ffd166,.5:ef476f,1:26547c'],
  'style.heatRamp': ['', '0:d8d3c8,.5:e8743b,1:ffe08a', '0:2b2d42,1:8ecae6'],
  'style.backdrop': ['', '0:bfe3ff,1:f7d9c4', '0:24222a,1:5b4b8a'],
  'forces.wind.x': [-1.2, 0, 1.2],
  'forces.wind.y': [-1.2, 0, 1.2],
  'forces.wind.z': [-1.2, 0, 1.2],
  'turbulence.speed': [0, 0.13, 0.6],
  'buoyancy.acceleration': [0.3, 1.5, 5],
  'buoyancy.coolingTime': [0.5, 4, 20],
  'drag.rate': [0.4, 1.5, 10],
  'drag.quadratic': [0, 20],
  'wind.gusts': [0, 1],
  'wind.shear': [-0.5, 0, 0.5],
};

/** Where the smoke of the lamp passes. */
const ABOVE = { 'position.x': 0.1, 'position.y': 1.9 };
const BESIDE = { 'position.x': 0.9, 'position.y': 1.9 };

/**
 * An item of each list, and values of its fields, or none for all words of a choice. Every field of a region and of an
 * envelope works as those of the wind.
 * @type {Readonly<Record<string, { item: Values, fields: Readonly<Record<string, readonly Value[]>> }>>}
 */
export const ITEMS = {
  emitters: {
    item: {},
    fields: {
      radius: [0.02, 0.1, 0.6],
      speed: [0, 0.5, 3],
      speedVariation: [0, 0.2, 1],
      spread: [0, 0.3, 1.4],
      size: [0.1, 0.3, 0.6],
      sizeVariation: [0, 0.2, 0.9],
      temperature: [0, 1, 3],
      'look.drag': [0.2, 1, 4],
      'look.buoyancy': [0, 1, 3],
      'look.gravity': [0, 1, 4],
      'look.inkWeight': [0, 1, 3],
      'look.sizeCurve': ['', '0:.3,1:1', '0:1,.5:.4,1:1'],
      'look.colors': ['', '0:3b2a6b,.4:d9577a,1:fff0c2', '0:1f4e5f,.3:79a8a9,.7:f4f7f7'],
    },
  },
  colliders: {
    item: { shape: 'ball', 'position.x': 0.8, 'position.y': 1.7 },
    fields: { shape: [], radius: [0.2, 0.5, 0.9] },
  },
  winds: {
    item: { 'velocity.x': -0.5, 'region.position.y': 2.2, 'region.size.x': 0.8, 'region.size.y': 0.8 },
    fields: {
      'velocity.x': [-0.8, 0, 0.3],
      'velocity.y': [-0.5, 0, 0.5],
      gusts: [0, 1],
      shear: [-0.4, 0, 0.4],
      'region.shape': [],
      'envelope.start': [0, 2, 3.5],
      'envelope.duration': [0, 1, 3],
    },
  },
  turbulences: {
    item: { speed: 0.8 },
    fields: { speed: [0, 0.5, 1.5], scale: [0.3, 1, 4], octaves: [0, 1, 4] },
  },
  vortices: {
    item: { circulation: 4, ...ABOVE },
    fields: {
      circulation: [-6, 0, 6],
      coreRadius: [0.1, 0.25, 1.2],
      reach: [0.6, 2, 8],
      inflow: [0, 0.5, 2],
      updraft: [-1, 0, 2],
      profile: [],
    },
  },
  gravities: { item: {}, fields: { 'acceleration.x': [-2, 0, 2], 'acceleration.y': [-3, 0, 3] } },
  buoyancies: { item: {}, fields: { acceleration: [-1.5, 0, 4] } },
  drags: { item: {}, fields: { rate: [0, 2, 20], quadratic: [0, 20] } },
  attractors: {
    item: { acceleration: 4, ...BESIDE },
    fields: { acceleration: [-6, 0, 6], coreRadius: [0.05, 0.1, 1], reach: [0.8, 5] },
  },
  orbits: {
    item: { acceleration: 3, ...ABOVE },
    fields: { acceleration: [0, 2, 8], coreRadius: [0.1, 1] },
  },
  spirals: {
    item: { turn: 3, ...ABOVE },
    fields: { turn: [-5, 0, 5], inward: [0, 1, 3], along: [-1, 0, 2], reach: [0.5, 2, 6] },
  },
  explosions: {
    item: { impulse: 3, ...ABOVE, 'envelope.start': 3.6 },
    fields: { impulse: [0, 2, 8], reach: [0.6, 3, 8] },
  },
  jets: {
    item: { speed: 4, 'position.x': -0.2, 'position.y': 1.4, 'direction.x': 1, 'direction.y': 0 },
    fields: { speed: [0, 3, 10], radius: [0.03, 0.1, 0.4], spread: [0.03, 0.113, 0.6] },
  },
  speedLimits: { item: {}, fields: { speed: [0.2, 0.6, 1000] } },
  flows: {
    item: {
      points: '.85:.7:0,1:1.2:0,.6:1.7:0,-.3:1.8:0,-.6:2.2:0,-.1:2.6:0,.6:2.5:0',
      speed: 1.5,
    },
    fields: {
      speed: [-1.5, 0, 3],
      radius: [0.1, 0.3, 0.8],
      swirl: [-10, 0, 10],
      inflow: [0, 1, 3],
      closed: [],
    },
  },
  shapes: {
    item: {
      // A heart, as traceShape writes it.
      outline: 'IBKiYqM3Owewd_uz8gxgxXxWxB-QuQuJ4WyeneZWOJIQSQSBCXPWPgPgPzE_Swjwi3yq0',
      speed: 2.6,
      size: 2,
      'position.y': 1.9,
    },
    fields: { speed: [0, 1, 4], hold: [0, 6, 20], size: [1.2, 2, 2.6], depth: [0.05, 0.3, 1] },
  },
};
