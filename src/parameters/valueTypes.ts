/** Types of presets and values, from the parameter table. `npm run generate` writes this file. */

/** The names of the presets. */
export type PresetName =
  | 'lamp'
  | 'lamp-noir'
  | 'lamp-sunset'
  | 'lamp-ghost'
  | 'lamp-ember'
  | 'lamp-storm'
  | 'lamp-blueprint'
  | 'lamp-newspaper'
  | 'lamp-candy'
  | 'lamp-papercut'
  | 'lamp-wind-waker'
  | 'lamp-engraving'
  | 'airplane'
  | 'airplane-ukiyo-e'
  | 'airplane-air-show'
  | 'airplane-corkscrew'
  | 'airplane-manga'
  | 'train'
  | 'train-night-mail'
  | 'train-rubber-hose'
  | 'train-ghost-fog'
  | 'train-dusk'
  | 'train-night'
  | 'campfire'
  | 'campfire-night'
  | 'campfire-popcorn'
  | 'rocket'
  | 'rocket-night'
  | 'rocket-newsprint'
  | 'genie'
  | 'genie-sumi-e'
  | 'genie-potion'
  | 'dust'
  | 'cloudscape'
  | 'cloudscape-gouache'
  | 'cloudscape-cumulus'
  | 'cloudscape-ink-wash'
  | 'cloudscape-dusk'
  | 'cloudscape-night'
  | 'cloudscape-woodcut'
  | 'cloudscape-riso'
  | 'wisp'
  | 'wisp-matcha'
  | 'wisp-hearts'
  | 'wisp-flourish'
  | 'wisp-valentine'
  | 'wisp-charcoal'
  | 'firework'
  | 'title'
  | 'dragon'
  | 'dragon-night'
  | 'teapot'
  | 'air'
  | 'air-ring'
  | 'air-comic-explosion'
  | 'air-leaves'
  | 'air-pow';

/** The values of parameters that exist once, by their keys. */
export type SingleValues = {
  /** Scene: The scene to show. */ scene:
    | 'lamp'
    | 'airplane'
    | 'train'
    | 'campfire'
    | 'rocket'
    | 'genie'
    | 'dust'
    | 'cloudscape'
    | 'wisp'
    | 'firework'
    | 'title'
    | 'dragon'
    | 'teapot'
    | 'air';
  /** Seed: Seed of the random numbers. The same seed makes the same smoke. A change restarts the smoke. */ seed: number;
  /** Rate: Number of new puffs per second. */ 'emission.rate': number;
  /** Lifetime: Lifetime of a puff. */ 'emission.lifetime': number;
  /** Growth time: Time in which a new puff grows to full size; 0 starts at full size, as in the paper. */ 'emission.growthTime': number;
  /** Density: Size of a puff over its life, from birth to death; it always ends at 0. */ 'emission.density': string;
  /** Glow: Share of the colour of smoke that no light dims, from cold smoke to temperature 1: fire stays bright at night and lights the ground, models and smoke around it. */ 'emission.glow': string;
  /** Dissolving: How puffs end as their density falls: they shrink; holes open and leave crescents, rings and hooks; they tear along their motion; or they shrink and thin to strands. Billboards and the renderer selle have no holes. */ 'emission.dissolve':
    'shrink' | 'erode' | 'tear' | 'thin';
  /** Entrainment: How much puffs grow with the distance they travel through the air. */ 'emission.entrainment': number;
  /** Company: How much sooner puffs without other smoke around them end, and how much later those inside a group. */ 'emission.company': number;
  /** Puff size: Makes every puff larger or smaller. */ 'puff.size': number;
  /** Size spread: Few large and many small puffs instead of even ones: the smoke swells and thins, and large puffs live longer. */ 'emission.sizeSpread': number;
  /** Puff shapes: Number of different shapes. A puff keeps its shape for life. */ 'puff.variations': number;
  /** Turn: How much puffs turn with the rotation of the air around them; 1 is as fast as the air. Billboards do not. */ 'puff.turn': number;
  /** Stretch: How long fast puffs get along their motion relative to the wind, at most; 1 keeps their shape. Billboards keep it too. */ 'puff.stretch': number;
  /** Billow: How much the lobes of a young puff are drawn together; they swell one after another as it grows. Billboards do not. */ 'puff.billow': number;
  /** Puffs: Lobes have a true shape from every side. Billboards are pictures of puffs that face the camera, as in the paper. */ 'puff.form':
    'lobes' | 'billboards';
  /** Drawn puffs: Up to four puffs of your own instead of round ones. They are billboards; each is at most 1,200 characters of a link. */ 'puff.drawing': string;
  /** Upright: How far puffs stand upright, as letters do; 0 turns each at random. */ 'puff.upright': number;
  /** Views: Number of sides from which billboards are drawn. A puff keeps its side for life. Lobes have all sides. */ 'puff.views':
    1 | 2 | 4 | 8;
  /** Precision: Bits of the normals and depths of billboards; the paper has 8. Lobes are exact. */ 'puff.precision':
    16 | 8;
  /** Lumpiness: How far lobes stand out of a puff: 0 is nearly a ball, 1 a bunch of balls. */ 'puff.lumpiness': number;
  /** Flatness: How flat puffs are. */ 'puff.flatness': number;
  /** Roughness: How much the size and the spacing of lobes vary. */ 'puff.roughness': number;
  /** Lobes: Number of lobes of a puff. More lobes take longer to draw. */ 'puff.lobes': number;
  /** Shape seed: Selects the puff shapes; 0 selects shapes designed by hand. */ 'puff.seed': number;
  /** Shading: Light and shade on puffs; off draws them flat. */ 'style.shading': 0 | 1;
  /** Outlines: Ink around the smoke and between its puffs. */ 'style.outlines': 0 | 1;
  /** Creases: Ink along sharp edges of surfaces and where motionless surfaces meet. */ 'style.creases': 0 | 1;
  /** Shadows: Smoke casts shadows on itself and on the objects of the scene. */ 'style.shadows': 0 | 1;
  /** Shadow steps: With two steps, shadow is darker where many puffs block the light. */ 'style.shadowSteps': 1 | 2;
  /** Volumes: How shadow volumes are counted: at the depth of each pixel, or by entry and exit as in the paper. */ 'style.volumes':
    'receiver' | 'counted';
  /** Deep shadow from: Number of puffs that must shade a point for the second step of shadow. All objects of the scene count as one. */ 'style.shadowDepth': number;
  /** Surface shadow: Multiplies the colours of objects in shadow. By default it has the hue of the first custom tone. */ 'style.surfaceShadowColor': string;
  /** Deep shadow: Multiplies the colours of shadow in the second step. */ 'style.deepShadow': string;
  /** Tones: Number of flat tones of the light. */ 'style.tones': 1 | 2 | 3;
  /** Custom tones: Colours from shadow to full light. They replace the number of tones. */ 'style.ramp': string;
  /** Blend custom tones: Blends neighbouring custom tones; off keeps them flat. */ 'style.rampBlend': 0 | 1;
  /** Fill light: A second tone in shadow, lit by a weaker light from the other side. */ 'style.fill': number;
  /** Simplify: Merges small patches of light and shade into large shapes; 0 keeps them all. */ 'style.simplify': number;
  /** Form: How far light and shade follow the form of the whole smoke instead of that of each puff. */ 'style.form': number;
  /** Strokes: Tapered lines inside the smoke where a lobe stands before another, most of them on the shaded side. */ 'style.strokes': number;
  /** Rim light: Width of a bright band along edges that face away from the light. */ 'style.rim': number;
  /** Rim colour: Colour of the rim light. */ 'style.rimColor': string;
  /** Smoke: Colour of the smoke in full light. */ 'style.smokeColor': string;
  /** Tint 1: Colour of smoke that an emitter or an obstacle has given tint 1, 4, 7, 10 or 13. */ 'style.tint1': string;
  /** Tint 2: Colour of smoke that an emitter or an obstacle has given tint 2, 5, 8, 11 or 14. */ 'style.tint2': string;
  /** Tint 3: Colour of smoke that an emitter or an obstacle has given tint 3, 6, 9, 12 or 15. */ 'style.tint3': string;
  /** Colour by age: Colours of the smoke over its lifetime. They replace the single colour. */ 'style.ageRamp': string;
  /** Colour by heat: Colours of the smoke from cold (0) to temperature 1, such as from smoke to fire. */ 'style.heatRamp': string;
  /** Soft colours: Blends neighbouring colours by age and heat; off keeps them separate. */ 'style.softColors': 0 | 1;
  /** Ink: Colour of the outlines. */ 'style.inkColor': string;
  /** Ink in the light: How far outlines follow the colour and the strength of the light; 0 keeps their colour. */ 'style.inkLight': number;
  /** Custom backdrop: Colours of the backdrop from bottom to top, blended between their heights. They replace those of the scene. */ 'style.backdrop': string;
  /** Wash: How much the objects of the scene take on shades of one colour. */ 'style.wash': number;
  /** Wash colour: The lightest shade of the wash. */ 'style.washColor': string;
  /** Line width: Width of the outlines in CSS pixels, the same near and far. */ 'style.outlineWidth': number;
  /** Line swell: How much lines widen on the side away from the light and narrow towards it; 0 keeps them even. */ 'style.inkSwell': number;
  /** Line boil: How much lines tremble, twelve times a second, as if each drawing were traced by hand. */ 'style.boil': number;
  /** Hold: Number of film frames that each puff stays still: 1 moves smoothly, 2 to 4 animate on twos, threes and fours. */ 'style.hold': number;
  /** Inner lines: Minimum depth between two puffs for ink between them; 0 outlines every puff. */ 'style.innerLine': number;
  /** Inner taper: How gradually a line between puffs widens with their distance; 0 always draws the full width. */ 'style.innerTaper': number;
  /** Gradient: Blends towards the second colour. */ 'style.gradient': 'none' | 'puff' | 'height' | 'screen' | 'age';
  /** Second colour: Second colour of the gradient. */ 'style.gradientColor': string;
  /** Gradient from: Height at which a gradient by height has the second colour. */ 'style.gradientBottom': number;
  /** Gradient to: Height at which a gradient by height has the colour of the smoke. */ 'style.gradientTop': number;
  /** Pattern: Marks of a print that move with the puffs and keep their size on screen. */ 'style.pattern':
    'none' | 'dots' | 'lines' | 'crosshatch' | 'grain';
  /** Pattern on: Where the marks are: in shadow, on lit tones below the lightest, or on both. */ 'style.patternOn':
    'shadow' | 'tones' | 'both';
  /** Pattern coverage: Share of shadow that the marks cover. */ 'style.patternCoverage': number;
  /** Pattern on the backdrop: Share of the backdrop that marks cover at the top of the picture, falling to 0 at its bottom. */ 'style.patternBackdrop': number;
  /** Pattern colour: Colour of the marks. */ 'style.patternColor': string;
  /** Pattern size: Distance between marks in CSS pixels. */ 'style.patternSize': number;
  /** Pattern angle: Direction of lines and of rows of dots, counterclockwise in degrees. */ 'style.patternAngle': number;
  /** Pattern softness: Width of the soft edge of marks in CSS pixels. */ 'style.patternSoftness': number;
  /** Pattern shift X: Offset of the marks to the right in CSS pixels, as of a plate that is out of register. */ 'style.patternShiftX': number;
  /** Pattern shift Y: Offset of the marks upwards in CSS pixels. */ 'style.patternShiftY': number;
  /** Renderer: The rendering method; selle is for comparison. */ 'style.renderer': 'nailboards' | 'selle';
  /** Light: The sun is a directional light; a lamp is a point light, and shadows spread away from it. */ 'light.kind':
    'sun' | 'lamp';
  /** Direction: Azimuth of the light: 0 is the front, 90 the right. */ 'light.azimuth': number;
  /** Height: Elevation of the light: 90 is straight above. */ 'light.elevation': number;
  /** Distance: Distance of a lamp from the centre of the scene; the sun ignores it. */ 'light.distance': number;
  /** Decay: How fast the light of a lamp weakens with distance: 0 not at all, 2 as in nature. At the centre of the scene it keeps its strength. */ 'light.decay': number;
  /** Light colour: Colour of the light. White shows the tones of the style. */ 'light.color': string;
  /** Light strength: Strength of the light: 1 shows the tones of the style, 0 leaves their first one. */ 'light.intensity': number;
  /** Ambient colour: Colour of the light that also reaches shadow. White shows the tones of the style. */ 'light.ambientColor': string;
  /** Ambient strength: Strength of the light that also reaches shadow; 1 shows the tones of the style. */ 'light.ambient': number;
  /** Camera direction: Azimuth of the camera: 0 is the front, 90 the right. */ 'camera.azimuth': number;
  /** Camera elevation: Elevation of the camera: 0 is level. */ 'camera.elevation': number;
  /** Camera distance: Distance of the camera from its target. */ 'camera.distance': number;
  /** Camera target x: Distance of the camera's target right of the scene's centre. */ 'camera.target.x': number;
  /** Camera target y: Distance of the camera's target above the ground. */ 'camera.target.y': number;
  /** Camera target z: Distance of the camera's target in front of the scene's centre. */ 'camera.target.z': number;
  /** Gravity: Downward pull on all smoke. */ 'forces.gravity': number;
  /** Buoyancy: Lift of warm smoke. It decreases as the smoke cools. */ 'forces.buoyancy': number;
  /** Turbulence: Small irregular swirls in the air. */ 'forces.turbulence': number;
  /** Vortices: Strength of all vortices together. */ 'forces.vortex': number;
  /** Drag: How strongly the air carries smoke. */ 'forces.drag': number;
  /** Wind to the right: Steady wind along x; negative blows to the left. */ 'forces.wind.x': number;
  /** Wind upwards: Steady wind along y; negative blows down. */ 'forces.wind.y': number;
  /** Wind to the front: Steady wind along z; negative blows away from the viewer. */ 'forces.wind.z': number;
  /** Speed: Typical (root mean square) speed of the swirls. */ 'turbulence.speed': number;
  /** Scale: Size of the largest swirls. */ 'turbulence.scale': number;
  /** Octaves: Number of layers of swirls, each finer than the one before; 0 is still air. */ 'turbulence.octaves': number;
  /** Evolution: Rate at which the pattern of swirls changes. */ 'turbulence.evolution': number;
  /** Gravity strength: Downward acceleration of all smoke. */ 'gravity.acceleration': number;
  /** Buoyancy strength: Upward acceleration of smoke at temperature 1. */ 'buoyancy.acceleration': number;
  /** Cooling time: Time in which warm smoke loses two thirds of its warmth. */ 'buoyancy.coolingTime': number;
  /** Drag rate: How strongly the air of this scene carries smoke. */ 'drag.rate': number;
  /** Quadratic drag: Drag that grows with speed, so it slows fast smoke most. */ 'drag.quadratic': number;
  /** Gusts: Typical (root mean square) speed of gusts along the wind. */ 'wind.gusts': number;
  /** Gust time: How long a strong gust lasts. */ 'wind.gustTime': number;
  /** Wind shear: Increase of the wind speed per metre of height, as a fraction. */ 'wind.shear': number;
  /** Shear height: Height at which shear has no effect. */ 'wind.height': number;
  /** Motion: How puffs follow the air. With the paper's method, vortices throw them outwards. */ 'simulation.integrator':
    'airAndSlip' | 'paper';
  /** Maximum particles: Maximum number of puffs alive at once. Further puffs wait. */ 'simulation.maxParticles': number;
  /** Timeline: Keyframes of parameters and bursts of emitters over time. In your own page, drivers change parameters by scrolling, sound or MIDI knobs. */ timeline: string;
};

/** The index of an item of a list. */
export type ItemIndex = 0 | 1 | 2 | 3 | 4 | 5 | 6 | 7;

/** Where and when an item acts, by the ends of the keys. */
export type ScopeValues = {
  /** Region: Where it acts: everywhere, or within a shape. */ 'region.shape': 'all' | 'sphere' | 'box' | 'capsule';
  /** Region position x: Centre of the region. */ 'region.position.x': number;
  /** Region position y: Centre of the region. */ 'region.position.y': number;
  /** Region position z: Centre of the region. */ 'region.position.z': number;
  /** Region size x: Half sides of a box. For a sphere, x is the radius. For a capsule, x is the radius and y half its straight part. */ 'region.size.x': number;
  /** Region size y: Half sides of a box. For a sphere, x is the radius. For a capsule, x is the radius and y half its straight part. */ 'region.size.y': number;
  /** Region size z: Half sides of a box. For a sphere, x is the radius. For a capsule, x is the radius and y half its straight part. */ 'region.size.z': number;
  /** Soft edge: Distance outside the region over which the effect fades out. */ 'region.softness': number;
  /** Start: Time of the first start. */ 'envelope.start': number;
  /** Duration: Time from a start to its end; 0 never ends. */ 'envelope.duration': number;
  /** Period: Time from one start to the next; 0 starts only once. */ 'envelope.period': number;
  /** Fade time: Time to fade in after a start and to fade out before the end. */ 'envelope.fade': number;
  /** Attached to: Number of the rigid that it follows, or 4096 plus the number of a moving part; -1 follows nothing. */ rigid: number;
};

/** The values of an item of each list, by the ends of their keys: `speed` in `emitters.0.speed`. */
export type ListValues = {
  emitters: ScopeValues & {
    /** Shape: Shape of the source. From a sphere or a surface, puffs leave outwards. */ shape:
      'point' | 'disc' | 'ball' | 'ring' | 'sphere' | 'box' | 'cone' | 'line' | 'surface';
    /** Position x: Centre of the shape. */ 'position.x': number;
    /** Position y: Centre of the shape. */ 'position.y': number;
    /** Position z: Centre of the shape. */ 'position.z': number;
    /** Direction x: Direction in which puffs leave. */ 'direction.x': number;
    /** Direction y: Direction in which puffs leave. */ 'direction.y': number;
    /** Direction z: Direction in which puffs leave. */ 'direction.z': number;
    /** Radius: Radius of a disc, ball, ring, sphere or cone. */ radius: number;
    /** Inner radius: Inner radius of a ring, as a fraction of its radius. */ inner: number;
    /** Extent x: Half sides of a box. A line goes from the position minus this vector to the position plus it. */ 'extent.x': number;
    /** Extent y: Half sides of a box. A line goes from the position minus this vector to the position plus it. */ 'extent.y': number;
    /** Extent z: Half sides of a box. A line goes from the position minus this vector to the position plus it. */ 'extent.z': number;
    /** Surface: Number of the mesh that emits the puffs. */ surface: number;
    /** Speed: Speed at which puffs leave, relative to the air. */ speed: number;
    /** Speed variation: Largest random change of the speed, as a fraction. */ speedVariation: number;
    /** Spread: Half angle of the cone in which puffs leave. */ spread: number;
    /** Inherited velocity: Fraction of the emitter's own velocity that its puffs inherit. */ inherit: number;
    /** Size: Radius of puffs at full density. */ size: number;
    /** Size variation: Largest random change of the size, as a fraction. */ sizeVariation: number;
    /** Lifetime: Lifetime of its puffs, relative to the lifetime of all smoke. */ lifetime: number;
    /** Lifetime variation: Largest random change of the lifetime, as a fraction. */ lifetimeVariation: number;
    /** Temperature: Temperature of new puffs. Warm smoke rises. */ temperature: number;
    /** Tint: Number of the tint of new puffs; 0 is none. There are three colours, which repeat: 4 is as 1. */ tint: number;
    /** Share: Share of the emission rate, relative to the other emitters. */ share: number;
    /** Burst: Number of puffs emitted at once at each start. */ 'burst.count': number;
    /** Puffs per metre: Number of puffs for each metre that the emitter travels, besides the emission rate. */ perMetre: number;
    /** Own lifetime: Lifetime of its puffs, which grow within a quarter of it; 0 is that of the smoke. */ 'look.lifetime': number;
    /** Own growth time: Time in which its puffs reach their size; 0 is that of the smoke. */ 'look.growthTime': number;
    /** Size over life: Fraction of its size that a puff has at each age. */ 'look.sizeCurve': string;
    /** Own density over life: How dense its puffs are at each age, instead of the density of the smoke. */ 'look.densityCurve': string;
    /** Own dissolution: How its puffs end: as the rest of the smoke, or in another way. */ 'look.dissolve':
      'smoke' | 'shrink' | 'erode' | 'tear' | 'thin';
    /** Drag: Factor on the drag of its puffs. */ 'look.drag': number;
    /** Buoyancy: Factor on the buoyancy of its puffs. */ 'look.buoyancy': number;
    /** Gravity: Factor on the gravity of its puffs. */ 'look.gravity': number;
    /** Own tones: Colours of its smoke from shadow to full light, instead of those of the smoke. */ 'look.colors': string;
    /** Own colours by age: Colours of its smoke over the life of a puff, instead of those of the smoke. */ 'look.ageColors': string;
    /** Own colours by heat: Colours of its smoke from temperature 0 to 1, instead of those of the smoke. */ 'look.heatColors': string;
    /** Ink weight: Factor on the width of the lines of its smoke. */ 'look.inkWeight': number;
  };
  colliders: {
    /** Shape: Shape that smoke collides with. */ shape: 'plane' | 'ball' | 'box' | 'capsule';
    /** Position x: Centre, or a point on the plane. */ 'position.x': number;
    /** Position y: Centre, or a point on the plane. */ 'position.y': number;
    /** Position z: Centre, or a point on the plane. */ 'position.z': number;
    /** Axis x: Normal of the plane, or the up axis of a box or capsule. */ 'axis.x': number;
    /** Axis y: Normal of the plane, or the up axis of a box or capsule. */ 'axis.y': number;
    /** Axis z: Normal of the plane, or the up axis of a box or capsule. */ 'axis.z': number;
    /** Half sides x: Half sides of a box. For a capsule, y is half the length of its straight part. */ 'halfExtents.x': number;
    /** Half sides y: Half sides of a box. For a capsule, y is half the length of its straight part. */ 'halfExtents.y': number;
    /** Half sides z: Half sides of a box. For a capsule, y is half the length of its straight part. */ 'halfExtents.z': number;
    /** Radius: Radius of a ball or capsule. */ radius: number;
    /** Bounce: Fraction of the normal speed that smoke keeps when it bounces. */ restitution: number;
    /** Friction: Fraction of the tangential speed that smoke loses. */ friction: number;
    /** Roughness: How much the distances of puffs from the surface vary: the largest is this fraction of the size that a puff has lost. */ roughness: number;
    /** On contact: What happens to smoke on contact. */ action: 'bounce' | 'kill' | 'tint';
    /** Tint: Number of the tint that smoke gets, if contact tints. There are three colours, which repeat: 4 is as 1. */ tint: number;
  };
  shedders: ScopeValues & {
    /** Rate: Vortex particles shed per second; 0 disables the shedder. */ rate: number;
    /** Position x: Middle of the line on which they are shed, relative to the rigid. */ 'position.x': number;
    /** Position y: Middle of the line on which they are shed, relative to the rigid. */ 'position.y': number;
    /** Position z: Middle of the line on which they are shed, relative to the rigid. */ 'position.z': number;
    /** Extent x: Vector from the middle of the line to one end. */ 'extent.x': number;
    /** Extent y: Vector from the middle of the line to one end. */ 'extent.y': number;
    /** Extent z: Vector from the middle of the line to one end. */ 'extent.z': number;
    /** Scatter: Largest random distance from the line. */ scatter: number;
    /** Axis x: Direction of their axes, relative to the rigid. */ 'axis.x': number;
    /** Axis y: Direction of their axes, relative to the rigid. */ 'axis.y': number;
    /** Axis z: Direction of their axes, relative to the rigid. */ 'axis.z': number;
    /** Axis variation: How much their axes vary at random. */ jitter: number;
    /** Rotation: All rotate alike, or the two ends shed alternately with opposite rotation. */ alternate:
      'alike' | 'alternating';
    /** Strength: Peak air speed around a new vortex particle, at any speed of the rigid. */ strength: number;
    /** Strength by speed: Fraction of the speed of the air past the rigid that is added to the strength. */ perSpeed: number;
    /** Core: Radius at which a new vortex particle is fastest. It ends at three times this radius. */ coreRadius: number;
    /** Viscosity: How fast they widen and slow down. */ viscosity: number;
    /** Lifetime: Time until they have faded away. */ lifetime: number;
  };
  winds: ScopeValues & {
    /** Wind x: Velocity of the wind. */ 'velocity.x': number;
    /** Wind y: Velocity of the wind. */ 'velocity.y': number;
    /** Wind z: Velocity of the wind. */ 'velocity.z': number;
    /** Gusts: Typical (root mean square) speed of gusts along the wind. */ gusts: number;
    /** Gust time: How long a strong gust lasts. */ gustTime: number;
    /** Shear: Increase of the wind speed per metre of height, as a fraction. */ shear: number;
    /** Shear height: Height at which shear has no effect. */ height: number;
  };
  turbulences: ScopeValues & {
    /** Speed: Typical (root mean square) speed of the swirls; 0 disables the turbulence. */ speed: number;
    /** Scale: Size of the largest swirls. */ scale: number;
    /** Octaves: Number of layers of swirls, each finer than the one before; 0 is still air. */ octaves: number;
    /** Evolution: Rate at which the pattern of swirls changes. */ evolution: number;
  };
  vortices: ScopeValues & {
    /** Circulation: Strength of the swirl; the sign selects its direction. */ circulation: number;
    /** Core: Radius of the calm core, at which the swirl is fastest. */ coreRadius: number;
    /** Reach: Distance from the axis at which the swirl has faded to nothing. */ reach: number;
    /** Profile: A smooth core, or one that rotates like a solid. */ profile: 'lambOseen' | 'rankine';
    /** Inflow: Speed at which smoke is drawn towards the axis, at the core radius. */ inflow: number;
    /** Updraft: Speed along the axis at the centre of the core. */ updraft: number;
    /** Position x: A point on the axis. */ 'position.x': number;
    /** Position y: A point on the axis. */ 'position.y': number;
    /** Position z: A point on the axis. */ 'position.z': number;
    /** Axis x: Direction of the axis. */ 'axis.x': number;
    /** Axis y: Direction of the axis. */ 'axis.y': number;
    /** Axis z: Direction of the axis. */ 'axis.z': number;
  };
  gravities: ScopeValues & {
    /** Acceleration x: Acceleration of all smoke in the region. */ 'acceleration.x': number;
    /** Acceleration y: Acceleration of all smoke in the region. */ 'acceleration.y': number;
    /** Acceleration z: Acceleration of all smoke in the region. */ 'acceleration.z': number;
  };
  buoyancies: ScopeValues & {
    /** Acceleration: Upward acceleration of smoke at temperature 1 in the region. */ acceleration: number;
  };
  drags: ScopeValues & {
    /** Drag: How strongly the air of the region carries smoke. */ rate: number;
    /** Quadratic drag: Drag that grows with speed, so it slows fast smoke most. */ quadratic: number;
  };
  attractors: ScopeValues & {
    /** Pull: Acceleration of smoke towards the centre; negative is away from it. */ acceleration: number;
    /** Core: Radius within which the pull fades towards the centre. */ coreRadius: number;
    /** Reach: Distance at which the pull has faded to nothing. */ reach: number;
    /** Position x: Centre of the pull. */ 'position.x': number;
    /** Position y: Centre of the pull. */ 'position.y': number;
    /** Position z: Centre of the pull. */ 'position.z': number;
  };
  orbits: ScopeValues & {
    /** Pull: Acceleration at a distance of one metre. It is larger nearer the centre and smaller farther away. */ acceleration: number;
    /** Core: Radius within which the pull fades towards the centre. */ coreRadius: number;
    /** Position x: Point that smoke orbits, or a point on the line that it orbits. */ 'position.x': number;
    /** Position y: Point that smoke orbits, or a point on the line that it orbits. */ 'position.y': number;
    /** Position z: Point that smoke orbits, or a point on the line that it orbits. */ 'position.z': number;
    /** Axis x: Direction of the line that smoke orbits; all 0 for a point. */ 'axis.x': number;
    /** Axis y: Direction of the line that smoke orbits; all 0 for a point. */ 'axis.y': number;
    /** Axis z: Direction of the line that smoke orbits; all 0 for a point. */ 'axis.z': number;
  };
  spirals: ScopeValues & {
    /** Rotation speed: Angular velocity of the air about the axis. */ turn: number;
    /** Inward speed: Speed of the air towards the axis; negative is away from it. */ inward: number;
    /** Axial speed: Speed of the air along the axis. */ along: number;
    /** Core: Distance from the axis within which the inward flow slows down. */ coreRadius: number;
    /** Reach: Distance from the axis at which the spiral has faded to nothing. */ reach: number;
    /** Position x: A point on the axis. */ 'position.x': number;
    /** Position y: A point on the axis. */ 'position.y': number;
    /** Position z: A point on the axis. */ 'position.z': number;
    /** Axis x: Direction of the axis. */ 'axis.x': number;
    /** Axis y: Direction of the axis. */ 'axis.y': number;
    /** Axis z: Direction of the axis. */ 'axis.z': number;
  };
  explosions: ScopeValues & {
    /** Impulse: Speed that smoke gains at the centre; negative is inwards. */ impulse: number;
    /** Front speed: Speed of the front. Smoke is accelerated when the front passes. */ speed: number;
    /** Reach: Distance at which the effect has faded to nothing. */ reach: number;
    /** Position x: Centre of the explosion. */ 'position.x': number;
    /** Position y: Centre of the explosion. */ 'position.y': number;
    /** Position z: Centre of the explosion. */ 'position.z': number;
  };
  jets: ScopeValues & {
    /** Speed: How fast the air leaves the nozzle. */ speed: number;
    /** Nozzle radius: Radius of the nozzle. */ radius: number;
    /** Spread: Increase of the jet's width per metre; a jet of air in air has 0.113. */ spread: number;
    /** Reach: Distance from the nozzle at which the jet has faded to nothing. */ reach: number;
    /** Position x: Centre of the nozzle. */ 'position.x': number;
    /** Position y: Centre of the nozzle. */ 'position.y': number;
    /** Position z: Centre of the nozzle. */ 'position.z': number;
    /** Direction x: Direction of the jet. */ 'direction.x': number;
    /** Direction y: Direction of the jet. */ 'direction.y': number;
    /** Direction z: Direction of the jet. */ 'direction.z': number;
  };
  speedLimits: ScopeValues & {
    /** Maximum speed: Maximum speed of smoke in the region. */ speed: number;
  };
  flows: ScopeValues & {
    /** Speed: Speed of the air along the stroke; negative is from its end to its start. */ speed: number;
    /** Radius: Distance from the stroke at which the flow has faded to nothing. */ radius: number;
    /** Swirl: Angular velocity of the air about the stroke. */ swirl: number;
    /** Inflow: Greatest speed at which smoke is drawn to the stroke; negative is away from it. */ inflow: number;
    /** Ends: Whether the stroke ends, or returns to its start. */ closed: 'open' | 'ring';
    /** Stroke: The points that the stroke passes through; without any it goes one metre up. */ points: string;
    /** Position x: Origin of the points. */ 'position.x': number;
    /** Position y: Origin of the points. */ 'position.y': number;
    /** Position z: Origin of the points. */ 'position.z': number;
    /** Scale: Factor on the distances of the points from the origin, and on the radius. */ scale: number;
  };
  shapes: ScopeValues & {
    /** Outline: The shape that smoke fills, as traced from a text, a picture or a mesh. */ outline: string;
    /** Speed: Greatest speed at which smoke goes to where the shape lacks it; 0 disables the shape. */ speed: number;
    /** Hold: How strongly smoke within the shape is slowed down, so that it does not rise or fall out of it. */ hold: number;
    /** Size: Longer side of the shape. */ size: number;
    /** Depth: Thickness of the shape. */ depth: number;
    /** Position x: Centre of the shape. */ 'position.x': number;
    /** Position y: Centre of the shape. */ 'position.y': number;
    /** Position z: Centre of the shape. */ 'position.z': number;
    /** Facing x: Direction from which the shape is read. */ 'facing.x': number;
    /** Facing y: Direction from which the shape is read. */ 'facing.y': number;
    /** Facing z: Direction from which the shape is read. */ 'facing.z': number;
  };
};

/** The values of all items of all lists, by their keys, such as `emitters.0.speed`. */
export type ItemValues = {
  [
    Key in {
      [List in keyof ListValues]: `${List}.${ItemIndex}.${keyof ListValues[List] & string}`;
    }[keyof ListValues]
  ]: Key extends `${infer List extends keyof ListValues}.${ItemIndex}.${infer Field}`
    ? ListValues[List][Field & keyof ListValues[List]]
    : never;
};
