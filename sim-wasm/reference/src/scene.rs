//! What is drawn, as it comes in: plain data in JSON. Lengths in metres, colours display-encoded from 0 to 255, matrices
//! column by column.

use serde::Deserialize;

pub type Triple = [f64; 3];

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub struct Scene {
    pub width: usize,
    pub height: usize,
    pub view_from_world: [f64; 16],
    pub clip_from_view: [f64; 16],
    pub light: Light,
    pub backdrop: Option<Backdrop>,
    pub style: Style,
    pub puffs: Puffs,
    pub bodies: Vec<Row>,
    /// What throws shadow.
    pub casters: Vec<Row>,
    pub surfaces: Vec<Surface>,
    /// Whether anything throws shadow.
    pub shadows: bool,
}

#[derive(Deserialize)]
#[serde(tag = "type", rename_all = "camelCase")]
pub enum Light {
    /// Unit vector.
    Sun {
        towards: Triple,
    },
    Lamp {
        place: Triple,
    },
}

#[derive(Deserialize)]
pub struct Backdrop {
    pub top: Triple,
    pub bottom: Triple,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub struct Style {
    /// Full width of the line in pixels; 0 draws none.
    pub ink_pixels: f64,
    pub ink_color: Triple,
    /// How much wider lines are away from the light, 0 to 1.
    pub ink_swell: f64,
    /// How much the lines of puffs tremble from drawing to drawing, 0 to 1, and the number of the drawing.
    pub boil: f64,
    pub drawing: u32,
    /// Whether sharp edges of surfaces have a line, and seams of surfaces that stand still to each other.
    pub creases: bool,
    /// How far the line of a puff lies behind it, in its radii.
    pub inner_line: f64,
    /// Share by which a line's outer edge lies deeper than its inner one.
    pub inner_taper: f64,
    pub gradient: Gradient,
    pub gradient_color: Triple,
    pub smoke_color: Triple,
    /// World heights between which the gradient `height` runs.
    pub plume_height: [f64; 2],
    /// Of smoke without a tint, of its three tints, then of each band of age and temperature.
    pub smoke_ramps: Vec<Ramp>,
    pub bands: Bands,
    /// Width of the band along silhouettes that look away from the light, 0 to 1.
    pub rim: f64,
    pub rim_color: Triple,
    /// How many volumes make deep shadow, where the colours of shadow are multiplied by another; none for plain shadow.
    pub shadow_depth: Option<u32>,
    pub deep_shadow: Triple,
    /// How many radii behind its centre a puff's volume begins at the nearest.
    pub least_cap: f64,
}

/// Numbers by byte whose sum is the ramp of smoke without a tint.
#[derive(Deserialize)]
pub struct Bands {
    pub ages: Vec<usize>,
    pub temperatures: Vec<usize>,
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

/// What a material shows in the light and in shadow, by the cosine between its normal and the light.
#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub struct Ramp {
    pub lit: Vec<Tone>,
    pub unlit: Vec<Tone>,
    /// In the place of the first tone where the fill light reaches.
    pub filled: Option<Triple>,
    /// Whether tones run into each other.
    #[serde(default)]
    pub is_blended: bool,
}

#[derive(Deserialize)]
pub struct Tone {
    pub from: f64,
    pub color: Triple,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub struct Puffs {
    /// For each variation its lobes: centre and radius, in radii of the particle.
    pub lobes: Vec<Vec<[f64; 4]>>,
    /// Reach of the fillet along creases, in radii, and share of the overall normal in every normal.
    pub fillet: f64,
    pub blend: f64,
    pub start_caps: StartCaps,
    /// What of them is seen lies no deeper than this behind their centre planes, in radii.
    pub depth: f64,
    /// What billboards show, which roll about the view axis; none of lobes.
    pub layers: Option<Layers>,
}

/// The front of each variation on a square grid about its centre, from the lowest row up.
#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub struct Layers {
    /// Texels along each side.
    pub size: usize,
    /// Half a side of the square, in radii.
    pub pad: f64,
    /// In radii: a coverage of 0 is half of it inside of the silhouette, 255 is half of it outside.
    pub distance_range: f64,
    /// Four for each texel: (normal + 1) / 2, and 0.5 + height in sides of the square.
    pub normal_depth: Vec<f64>,
    pub coverage: Vec<f64>,
}

/// For each variation and direction towards the light, in the frame of the puff, how many radii behind the centre its
/// farthest lit point lies. Columns go by azimuth about z from -pi, rows by the angle to z.
#[derive(Deserialize)]
pub struct StartCaps {
    pub width: usize,
    pub height: usize,
    pub values: Vec<f64>,
}

/// A particle as the simulator writes it: place and radius, then the two words of its look.
#[derive(Clone, Copy, Deserialize)]
pub struct Row {
    pub place: Triple,
    pub radius: f64,
    pub look: [u32; 2],
}

#[derive(Deserialize)]
pub struct Surface {
    pub shape: Shape,
    pub ramp: Ramp,
    pub casts: bool,
    /// Whether it has a line around it.
    pub inked: bool,
    /// Surfaces of one group grow into each other without a line between them.
    pub group: usize,
    /// What it moves with, by name; none where it stands still.
    pub carrier: Option<String>,
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
        /// Where they are as they stand where absent.
        world_from_model: Option<[f64; 16]>,
    },
}
