//! The form of the whole smoke: which way its outside faces, from the density of its particles on a grid. The light of smoke
//! leans on it.

use glam::{DMat4, DVec3};

use crate::light::Light;
use crate::ray::Camera;
use crate::scene::{Row, Scene};

/// Cells along each axis, and their minimum size in mean radii.
const FORM_CELLS: usize = 32;
const FORM_CELL: f64 = 0.75;
/// Half of the grid in standard deviations of the positions, and in mean radii.
const FORM_SPREAD: f64 = 2.2;
const FORM_MARGIN: f64 = 3.0;
/// Cells at the border without particles, and the next ones, in which particles fade.
const FORM_EMPTY: f64 = 3.0;
const FORM_FADING: f64 = 2.0;
/// Number of times the density is smoothed, by 1 : 2 : 1 along each axis.
const FORM_ROUNDS: usize = 2;
/// Length of a vector where the density changes by its own amount within a cell; and the density, in that of a mean particle in
/// one cell, below which vectors fade.
const FORM_SLOPE: f64 = 1.5;
const FORM_FAINT: f64 = 0.05;
/// Cosine to the light from which the form adds to the light.
const FORM_MIDDLE: f64 = 0.35;
const STRIDES: [usize; 3] = [1, FORM_CELLS, FORM_CELLS * FORM_CELLS];

pub struct Form<'a> {
    /// How far light leans on the form, 0 to 1.
    pub lean: f64,
    light: &'a Light,
    world_from_view: DMat4,
    corner: DVec3,
    cell: f64,
    /// Vectors of length 0 to 1.
    outward: Vec<DVec3>,
}

impl<'a> Form<'a> {
    /// None if the light does not lean on the form.
    pub fn new(scene: &Scene, camera: &Camera, light: &'a Light) -> Option<Self> {
        let lean = scene.style.plume_form;
        if lean <= 0.0 {
            return None;
        }
        let (corner, cell, radius) = grid_of(&scene.bodies);
        let mut density = vec![0.0; FORM_CELLS.pow(3)];
        for row in &scene.bodies {
            add(&mut density, (DVec3::from(row.place) - corner) / cell, row.radius.powi(3));
        }
        for stride in STRIDES.repeat(FORM_ROUNDS) {
            density = (0..density.len())
                .map(|at| 0.5 * density[at] + 0.25 * (near(&density, at, stride) + far(&density, at, stride)))
                .collect();
        }
        let faint = FORM_FAINT * radius.powi(3);
        let outward = (0..density.len())
            .map(|at| {
                let fall = DVec3::from(STRIDES.map(|stride| near(&density, at, stride) - far(&density, at, stride)));
                (fall * 0.5 * FORM_SLOPE / (density[at] + faint)).clamp_length_max(1.0)
            })
            .collect();
        Some(Self {
            lean,
            light,
            world_from_view: camera.view_from_world.inverse(),
            corner,
            cell,
            outward,
        })
    }

    /// Cosine between the form and the light at a position in view space.
    pub fn facing(&self, place: DVec3) -> f64 {
        let place = self.world_from_view.transform_point3(place);
        let cells = ((place - self.corner) / self.cell - 0.5).clamp(DVec3::ZERO, DVec3::splat(FORM_CELLS as f64 - 1.001));
        let (first, share) = (cells.floor(), cells.fract());
        let mut outward = DVec3::ZERO;
        for corner in 0..8 {
            let step = DVec3::new((corner & 1) as f64, (corner >> 1 & 1) as f64, (corner >> 2) as f64);
            let weight = (step * share + (1.0 - step) * (1.0 - share)).to_array().iter().product::<f64>();
            outward += weight * self.outward[index_of(first + step)];
        }
        outward.dot(self.light.towards(place))
    }

    /// Share of light where the form has this cosine to the light, and smoke itself has `own`, 0 or 1.
    pub fn share(&self, own: f64, facing: f64) -> f64 {
        own + self.lean * (0.5 + 0.5 * (facing - FORM_MIDDLE) - own)
    }
}

/// Lowest corner, size of a cell, and mean radius. Particles count by their volume.
fn grid_of(rows: &[Row]) -> (DVec3, f64, f64) {
    let sum = |value: &dyn Fn(&Row) -> DVec3| rows.iter().map(|row| row.radius.powi(3) * value(row)).sum::<DVec3>();
    let mass = sum(&|_| DVec3::ONE).x;
    let mean = sum(&|row| row.place.into()) / mass;
    let variance = sum(&|row| (DVec3::from(row.place) - mean).powf(2.0)) / mass;
    let radius = sum(&|row| DVec3::splat(row.radius)).x / mass;
    let half = FORM_SPREAD * variance.max_element().sqrt() + FORM_MARGIN * radius;
    let cell = (FORM_CELL * radius).max(2.0 * half / (FORM_CELLS - 1) as f64);
    (mean - 0.5 * FORM_CELLS as f64 * cell, cell, radius)
}

/// Adds a volume at a position in cells, by quadratic B-splines.
fn add(density: &mut [f64], place: DVec3, volume: f64) {
    let inside = place.min(FORM_CELLS as f64 - place).min_element();
    let fade = ((inside - FORM_EMPTY) / FORM_FADING).min(1.0);
    if fade <= 0.0 {
        return;
    }
    for number in 0..27 {
        let step = DVec3::new((number % 3) as f64, (number / 3 % 3) as f64, (number / 9) as f64) - 1.0;
        let away = (place - place.floor() - step - 0.5).abs().to_array();
        density[index_of(place.floor() + step)] += fade * volume * away.map(spline).iter().product::<f64>();
    }
}

fn spline(away: f64) -> f64 {
    if away < 0.5 {
        0.75 - away * away
    } else {
        0.5 * (1.5 - away).max(0.0).powi(2)
    }
}

fn index_of(cell: DVec3) -> usize {
    let [x, y, z] = cell.to_array().map(|number| number as usize);
    x + FORM_CELLS * (y + FORM_CELLS * z)
}

/// The neighbour of a cell with the lower number along an axis; nothing is outside of the grid.
fn near(density: &[f64], at: usize, stride: usize) -> f64 {
    at.checked_sub(stride).map_or(0.0, |neighbour| density[neighbour])
}

fn far(density: &[f64], at: usize, stride: usize) -> f64 {
    density.get(at + stride).copied().unwrap_or(0.0)
}
