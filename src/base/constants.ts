/**
 * Constants that several of TypeScript, the shaders and the Rust code share. This is their only definition: a
 * declaration of the same name in shaders/ or sim-wasm/ is a copy, which `npm run generate` writes and
 * tests/unit/constants.test.ts compares. A pair is a vec2 in the shaders.
 */

/** Number of tints that have a ramp. Higher tints repeat them. */
export const TINTS = 3;
/** Maximum number of covers that a view of the simulator can ask for. */
export const COVERS_LIMIT = 16;

/** A lamp counts as at least this many bounding radii of a puff away. */
export const NEAREST_LAMP = 1.2;
/** Distance between the farthest lit point of a puff and the start of its shadow, in radii, against rounding of depth. */
export const CAP_SLACK = 0.02;
/** Least depth of a puff for the shear of its nailboard, in radii: nearer to the camera, it has left the picture. */
export const NEAREST_SHEARED = 0.5;

/** Maximum number of lobes of a puff. Twelve lobes and three other varyings reach the guaranteed minimum of WebGL 2. */
export const MAX_LOBES = 12;
/** Values of a particle's seed. Each stands for one axis about which a lobe puff rolls. */
export const SEEDS = 256;
/** Angle between successive points of a Fibonacci lattice: pi (3 - sqrt 5). */
export const GOLDEN_ANGLE = 2.399963229728653;
/** Steps of a component of a puff's packed turn, a unit quaternion without its largest component, per unit. */
export const QUATERNION_STEPS = 720;
/** Greatest ratio of the axes of a stretched puff. */
export const MAX_STRETCH = 4;
/** Part of its distance from the centre by which a lobe of a young puff is folded, with `puff.billow` 1. */
export const BILLOW_DEPTH = 0.6;
/** Part of the time of unfolding, half of the lifetime, after which the last lobe starts. */
export const BILLOW_DELAY = 0.5;
/** Difference of the start between one lobe and the next, modulo 1: the golden ratio spreads the starts evenly. */
export const BILLOW_STEP = 0.618034;
/** Centres of the first and of the third bite of a puff in its radii; the second is opposite to the first. */
export const FIRST_BITE = [0.69, 0.92, 0] as const;
export const THIRD_BITE = [0, 0, 1.25] as const;
/** Radii of the bites of a puff when they begin, and how much they grow until the erosion is 1, in its radii. */
export const BITE_RADII = [0.15, 0.15, 0.25] as const;
export const BITE_GROWTH = [1.08, 1.08, 0.75] as const;
/** Erosion at which the bites begin. Before the first begins, the shadow of a puff moves behind it. */
export const BITE_STARTS = [0.0625, 0.2, 0.4] as const;
/** Columns of a table of start caps: azimuth of the light about the view axis. */
export const CAP_COLUMNS = 64;
/** Rows of a table of start caps: angle between light and view axis. */
export const CAP_ROWS = 32;

/** Texels of a ramp. An even number, so that a border at 1/2 is exactly between two texels. */
export const RAMP_TEXELS = 256;
/** Rows of a ramp: in shadow, in the light, then both again where the fill light reaches. */
export const RAMP_ROWS = 4;
/** Rows of ramps in a column of the ramp texture, if there are looks: with their bands it has at most 2,048 rows. */
export const COLUMN_ROWS = 2032;
/** Looks of emitters at a time, with that of the smoke. */
export const LOOKS_LIMIT = 16;
/** What the index of a look counts in a ramp index: more than there are materials. */
export const LOOK_PLACE = 4096;
/** Materials in a row of the texture of direct light. */
export const PARTS_WIDTH = 1024;
/** N . towardsFill above which the fill light applies. */
export const FILL_BORDER = 0.65;

/** Radius of a puff, in line widths, from which it has a line, and from which the line has its full width. */
export const LINE_RADII = [1, 3.5] as const;
/** Width of a line, in pixels, from which it is visible, and from which it is opaque. */
export const FADE_WIDTHS = [0.5, 1] as const;
/** Radius of a puff, in line widths, from which its line is visible, and from which it is opaque. */
export const FADE_RADII = [1.5, 3] as const;

/** Side of the square tiles in which the resolve pass looks for edges, pixels. */
export const EDGE_TILE = 8;

/** Side of the square tiles in which the simplify pass looks for light that is the same everywhere, pixels. */
export const FLAT_TILE = 8;

/** Side of the square tiles whose receivers are measured for large shadow volumes, pixels. */
export const DEPTH_TILE = 32;
/** Bits of the number of a tile in a quad of a shadow volume; the other bits of 32 are the number of the caster. */
export const TILE_BITS = 15;

/** Distance of a lifted ring of ink in front of the surface, in steps of a 24-bit depth buffer. */
export const LIFT_STEPS = 3;
/**
 * Steepest slope towards the camera, per unit beside the silhouette, at which a surface still counts as behind the puff.
 */
export const STEEPEST = 8;
/** Least z of a puff's normal for the slope of its surface. Close to the silhouette the slope is meaningless. */
export const FLATTEST = 0.1;
/**
 * Distance of bodies from both ends of the depth range. A volume that contains the camera is clamped to exactly 0 and
 * must be nearer.
 */
export const DEPTH_MARGIN = 4e-7;

/** Vertices that agree when rounded to this many places per metre are the same point. */
export const PLACES_PER_METRE = 1e5;
/** Least angle between the normals of two faces whose edge has a line, degrees. */
export const SHARP_ANGLE = 40;
/** Distance within which a corner counts as on the plane of a face, so that resting contact has a seam, metres. */
export const TOUCHING = 1e-5;
/** Distance of the line of an edge in front of its surface, in line widths, and the upper limit in metres. */
export const CREASE_RAISED = [0.75, 0.03] as const;
/** The same for a seam, which is in a hollow and needs a larger distance. */
export const SEAM_RAISED = [3, 0.05] as const;
/** Distance by which the raised hull of a surface is nearer, in line widths, and the upper limit in metres. */
export const HULL_RAISED = [6, 0.05] as const;
/** Distance by which the shadow of a mesh starts below its lit faces, metres. */
export const SHADOW_INSET = 0.012;

/** Cells of the grid of the whole smoke's form along each axis, and the least size of a cell in mean radii of particles. */
export const FORM_CELLS = 32;
export const FORM_CELL = 0.75;
/** Half of that grid: in standard deviations of the places, and in mean radii. */
export const FORM_SPREAD = 2.2;
export const FORM_MARGIN = 3;
/** Cells at its border without particles, and the next ones, in which particles fade. */
export const FORM_EMPTY = 3;
export const FORM_FADING = 2;
/** How often its density is smoothed. Each time adds half of a squared cell to the variance. */
export const FORM_ROUNDS = 2;
/** Length of a vector of the form where the density changes by its own amount within a cell. */
export const FORM_SLOPE = 1.5;
/** Density, in that of a mean particle in one cell, below which a form fades. */
export const FORM_FAINT = 0.05;
/** Steps of a component of a vector of the form. */
export const FORM_STEPS = 127;
/** N . L of the form from which it adds to the light, so that as much of the smoke stays lit. */
export const FORM_MIDDLE = 0.35;
