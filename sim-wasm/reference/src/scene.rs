//! The scene, as JSON. Lengths in metres, colours display-encoded from 0 to 255, matrices by columns.

use serde::Deserialize;
use sim::arrange::row_layout::Attributes;

pub type Triple = [f64; 3];

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub struct Scene {
    pub width: usize,
    pub height: usize,
    pub view_from_world: [f64; 16],
    pub clip_from_view: [f64; 16],
    pub light: Light,
    /// Colours at heights of the picture, from bottom to top, blended between them.
    pub backdrop: Option<Vec<Tone>>,
    pub style: Style,
    pub puffs: Puffs,
    pub bodies: Vec<Row>,
    /// The light that casts shadows.
    pub casters: Vec<Row>,
    pub surfaces: Vec<Surface>,
    /// True if there are shadows.
    pub shadows: bool,
}

#[derive(Deserialize)]
#[serde(tag = "type", rename_all = "camelCase")]
pub enum Light {
    /// Unit vector.
    Sun { towards: Triple },
    /// `decay`: exponent of the distance with which the light weakens. `scale`: units of this distance for each metre.
    Lamp { place: Triple, decay: f64, scale: f64 },
}

/// Linear factors on the direct and the ambient part of the light; 1 shows the colours of the style.
#[derive(Clone, Copy, Deserialize)]
pub struct Illumination {
    pub direct: Triple,
    pub ambient: Triple,
}

impl Illumination {
    pub const SAME: Self = Self {
        direct: [1.0; 3],
        ambient: [1.0; 3],
    };
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub struct Style {
    /// Full line width (pixels); 0: no lines.
    pub ink_pixels: f64,
    pub ink_color: Triple,
    /// How far ink follows the light, 0 to 1.
    pub ink_light: f64,
    pub illumination: Illumination,
    /// Factors on the direct part at a unit of distance from a lamp, where it weakens with distance.
    pub lamp_light: Option<Triple>,
    /// Swelling of lines away from the light, 0 to 1.
    pub ink_swell: f64,
    /// Trembling of the lines of puffs, 0 to 1, and the index of the drawing.
    pub boil: f64,
    pub drawing: u32,
    /// True if sharp edges of surfaces have lines, and seams of surfaces at relative rest.
    pub creases: bool,
    /// Depth of a puff's line behind it, in its radii.
    pub inner_line: f64,
    /// Share by which a line's outer edge is deeper than its inner one.
    pub inner_taper: f64,
    pub gradient: Gradient,
    pub gradient_color: Triple,
    pub smoke_color: Triple,
    /// World heights between which the gradient `height` runs (m).
    pub gradient_heights: [f64; 2],
    /// Ramps of smoke without a tint, of the three tints, then of each band of age and temperature, also of looks.
    pub smoke_ramps: Vec<Ramp>,
    pub bands: Bands,
    /// Looks of puffs by their index, from 1 on; those of others are that of the smoke.
    #[serde(default)]
    pub looks: Vec<Look>,
    /// Width of the rim along silhouettes that face away from the light, 0 to 1.
    pub rim: f64,
    pub rim_color: Triple,
    /// How far light leans on the form of the whole smoke, 0 to 1; with one shadow step.
    pub plume_form: f64,
    /// Cosine from which lit smoke differs from smoke in shadow.
    pub lit_from: f64,
    pub volumes: Volumes,
    /// Number of volumes of deep shadow, and the factor on its colours; none for a single shadow step.
    pub shadow_depth: Option<u32>,
    pub deep_shadow: Triple,
    /// Minimum distance from a puff's centre to the start of its volume (radii).
    pub min_cap: f64,
    pub pattern: Option<Pattern>,
}

/// The marks of a print. Lengths in pixels.
#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub struct Pattern {
    pub marks: Marks,
    /// True if shadow, and smoke in tones below full light, have marks.
    pub on_shadow: bool,
    pub on_tones: bool,
    /// Share of shadow, and of the backdrop at the top of the picture, that marks cover.
    pub amount: f64,
    pub backdrop: f64,
    pub color: Triple,
    pub pitch: f64,
    pub softness: f64,
    /// Counterclockwise (radians).
    pub angle: f64,
    /// Of marks to the right and up.
    pub shift: [i64; 2],
    /// Cosine from which smoke has its lightest tone.
    pub full_from: f64,
}

#[derive(Clone, Copy, PartialEq, Deserialize)]
#[serde(rename_all = "camelCase")]
pub enum Marks {
    Dots,
    Lines,
    Crosshatch,
    Grain,
}

/// How the volumes that contain a point are counted.
#[derive(Clone, Copy, Deserialize)]
#[serde(rename_all = "camelCase")]
pub enum Volumes {
    Receiver,
    Counted,
}

/// Numbers by byte; their sum is the ramp of smoke without a tint, or of a look without one.
#[derive(Deserialize)]
pub struct Bands {
    pub ages: Vec<usize>,
    pub temperatures: Vec<usize>,
}

/// Colours and ink of puffs of an emitter.
#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub struct Look {
    /// Those of its puffs without a tint, instead of those of the smoke.
    pub bands: Option<Bands>,
    /// Factor on the width of lines.
    pub ink_weight: f64,
}

#[derive(Clone, Copy, Deserialize)]
#[serde(rename_all = "camelCase")]
pub enum Gradient {
    None,
    Puff,
    Height,
    Screen,
    Age,
}

/// Colours in light and in shadow, by the cosine between normal and light.
#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub struct Ramp {
    pub lit: Vec<Tone>,
    pub unlit: Vec<Tone>,
    /// Replaces the first tone where the fill light reaches.
    pub filled: Option<Triple>,
    /// True if tones blend into each other.
    #[serde(default)]
    pub is_blended: bool,
    /// Share of its colours that glows: the light does not scale it, 0 to 1.
    #[serde(default)]
    pub glow: f64,
}

impl Ramp {
    /// Cosine from which lit smoke differs from smoke in shadow.
    pub fn lit_from(&self) -> f64 {
        match &self.lit[..] {
            [first, ..] if self.is_blended => first.from,
            [_, second, ..] => second.from,
            _ => -1.0,
        }
    }
}

#[derive(Deserialize)]
pub struct Tone {
    pub from: f64,
    pub color: Triple,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub struct Puffs {
    /// Lobes of each variation: centre and radius, in particle radii.
    pub lobes: Vec<Vec<[f64; 4]>>,
    /// Radius of the fillet along creases (radii), and share of the common normal in every normal.
    pub fillet: f64,
    pub blend: f64,
    pub start_caps: StartCaps,
    /// Whether puffs turn, stretch and unfold, and the part by which the lobes of young puffs are folded.
    pub is_deformed: bool,
    pub billow: f64,
    /// Whether they have bites.
    pub is_eroded: bool,
    /// Whether the bites lie along the stretch.
    pub is_torn: bool,
    /// Maximum height over the nailboard (radii).
    pub tallest: f64,
    /// Maximum visible depth behind the centre plane (radii).
    pub depth: f64,
    /// True if the shadows of billboards are their silhouettes, within their lobes.
    #[serde(default)]
    pub are_silhouettes: bool,
    /// Baked fronts of billboards, which roll about the view axis; none for lobes.
    pub layers: Option<Layers>,
}

/// Front of each variation on a square grid about its centre, lowest row first.
#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub struct Layers {
    /// Texels per side.
    pub size: usize,
    /// Half the side of the square (radii).
    pub pad: f64,
    /// In radii: coverage 0 is half of it inside of the silhouette, 255 is half of it outside.
    pub distance_range: f64,
    /// Four bytes per texel: (normal + 1) / 2, and 0.5 + height in sides of the square.
    pub normal_depth: Vec<f64>,
    /// Four bytes per texel: colour, and coverage.
    pub color_coverage: Vec<f64>,
}

/// Distance from the centre to the farthest lit point (radii), per variation and direction of the light in the puff's
/// frame. Columns: azimuth about z from -pi. Rows: angle to z.
#[derive(Deserialize)]
pub struct StartCaps {
    pub width: usize,
    pub height: usize,
    pub values: Vec<f64>,
}

/// A particle as the simulator writes it: place and radius, then its packed attributes.
#[derive(Clone, Copy, Deserialize)]
pub struct Row {
    pub place: Triple,
    pub radius: f64,
    pub attributes: Attributes,
}

#[derive(Deserialize)]
pub struct Surface {
    pub shape: Shape,
    pub ramp: Ramp,
    pub casts: bool,
    /// True if it has an outline.
    pub inked: bool,
    /// Surfaces of one group merge without a line between them.
    pub group: usize,
    /// Name of the object it moves with; none if it stands still.
    pub carrier: Option<String>,
    /// Shows the colours of its ramp in any light.
    #[serde(default)]
    pub glows: bool,
}

#[derive(Deserialize)]
#[serde(tag = "type", rename_all = "camelCase", rename_all_fields = "camelCase")]
pub enum Shape {
    Ball {
        center: Triple,
        radius: f64,
    },
    Box {
        center: Triple,
        half: Triple,
    },
    Triangles {
        positions: Vec<f64>,
        normals: Vec<f64>,
        indices: Vec<usize>,
        /// Poses; identity if absent.
        world_from_model: Option<[f64; 16]>,
    },
}
