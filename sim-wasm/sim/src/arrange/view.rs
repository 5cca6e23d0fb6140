//! A view: the input of `arrange`. `view_layout` documents its numbers.

use wide::f32x4;

use crate::arrange::coverage::plan::Plan;
use crate::arrange::coverage::solids::BALLS_LIMIT;
use crate::arrange::coverage::start_caps::ENTRIES;
use crate::arrange::view_layout::{LIFTERS_LIMIT, VIEW_LENGTH, ViewNumbers};
use crate::arrange::volume::{LampSweep, Sweep};
use crate::layout::error::ParameterError;
use crate::math::simd::{Vector4, positive_part};

/// Maximum number of covers.
const COVERS_LIMIT: f64 = 16.0;

/// Maximum number of sides: the sides of 32 variations have a byte.
const SIDES_LIMIT: f64 = 8.0;

/// A checked view.
#[derive(Clone, Copy, Debug)]
pub struct View<'v> {
    /// Interpolation between the previous step (0) and now (1).
    pub blend: f32,
    /// Unit vector along which rows are sorted, near to far.
    pub direction: [f32; 3],
    /// Place of a lamp, whose rows are sorted by their distance from it.
    pub lamp: Option<[f32; 3]>,
    /// True for the casters of a light: rows hold the ends of shadows instead of ages.
    pub is_light: bool,
    /// Sides of each variation, at least 1.
    pub sides: u32,
    /// Share of the roll of puffs that is left out, 0..1.
    pub upright: f32,
    /// Frustum culling, if enabled.
    pub cull: Option<Cull>,
    /// Occlusion culling, if enabled.
    pub coverage: Option<Plan<'v>>,
}

impl<'v> View<'v> {
    /// Checks the numbers. One that is not finite or out of range is an error with its name.
    pub fn new(all: &'v [f32]) -> Result<Self, ParameterError> {
        let (numbers, solids) = all.split_first_chunk().ok_or_else(|| wrong_length(all.len()))?;
        let numbers = &ViewNumbers::read(numbers);
        if let Some(index) = all.iter().position(|value| !value.is_finite()) {
            let limit = f64::from(f32::MAX);
            within(&format!("view[{index}]"), all[index], -limit, limit)?;
        }
        within("view.purpose", numbers.purpose, 0.0, 2.0)?;
        within("view.blend", numbers.blend, 0.0, 1.0)?;
        within("view.cull", numbers.cull, 0.0, 1.0)?;
        within("view.pad", numbers.pad, 0.0, 1e6)?;
        within("view.reach", numbers.reach, 0.0, 1e6)?;
        within("view.sides", numbers.sides, 0.0, SIDES_LIMIT)?;
        within("view.upright", numbers.upright, 0.0, 1.0)?;
        check_coverage(numbers, solids)?;
        let direction = direction(numbers.direction)?;
        let cull = (numbers.cull != 0.0).then(|| Cull::new(numbers, direction));
        let coverage = cull.and_then(|_| Plan::new(numbers, solids, direction));
        Ok(Self {
            blend: numbers.blend,
            direction,
            lamp: numbers.place_of_lamp(),
            is_light: numbers.purpose != 0.0,
            sides: (numbers.sides as u32).max(1),
            upright: numbers.upright,
            cull,
            coverage,
        })
    }

    /// Depths by which rows are sorted (m).
    #[inline(always)]
    pub fn depth(&self, place: Vector4) -> f32x4 {
        match self.lamp {
            None => place.dot(Vector4::splat(self.direction)),
            Some(lamp) => (place - Vector4::splat(lamp)).length(),
        }
    }
}

fn check_coverage(numbers: &ViewNumbers, solids: &[f32]) -> Result<(), ParameterError> {
    let lengths = [
        ("view.pixel", numbers.pixel),
        ("view.tolerance", numbers.tolerance),
        ("view.blur", numbers.blur),
        ("view.lift", numbers.lift),
        ("view.depth", numbers.depth),
        ("view.balls", numbers.balls),
    ];
    for (name, length) in lengths {
        within(name, length, 0.0, 1e6)?;
    }
    within("view.covers", numbers.covers, 0.0, COVERS_LIMIT)?;
    within("view.lifters", numbers.lifters, 0.0, LIFTERS_LIMIT as f64)?;
    let nearest = f64::from(numbers.nearest);
    within("view.farthest", numbers.farthest, nearest, f64::from(f32::MAX))?;
    let [cap_least, cap_most] = numbers.cap_range;
    within("view.capMost", cap_most, f64::from(cap_least), 1e6)?;
    let balls = numbers.balls as usize;
    if numbers.balls != balls as f32 || !balls.is_multiple_of(4) || balls > BALLS_LIMIT {
        let value = f64::from(numbers.balls);
        return Err(ParameterError::out_of_range(
            "view.balls",
            value,
            0.0,
            BALLS_LIMIT as f64,
        ));
    }
    within("view.capsFollow", numbers.caps_follow, 0.0, 1.0)?;
    let variation = 4 * balls + if numbers.caps_follow != 0.0 { ENTRIES } else { 0 };
    let is_whole = if balls == 0 {
        solids.is_empty()
    } else {
        solids.len().is_multiple_of(variation)
    };
    if is_whole {
        Ok(())
    } else {
        Err(wrong_length(VIEW_LENGTH + solids.len()))
    }
}

fn within(name: &str, value: f32, min: f64, max: f64) -> Result<(), ParameterError> {
    let value = f64::from(value);
    if (min..=max).contains(&value) {
        Ok(())
    } else {
        Err(ParameterError::out_of_range(name, value, min, max))
    }
}

fn wrong_length(length: usize) -> ParameterError {
    let expected = VIEW_LENGTH as f64;
    ParameterError::out_of_range("view.length", length as f64, expected, expected)
}

fn direction(direction: [f32; 3]) -> Result<[f32; 3], ParameterError> {
    let [x, y, z] = direction.map(f64::from);
    let length = libm::sqrt(x * x + y * y + z * z);
    // Accepts rounding, but not a vector that was never normalised: its picture would be wrong elsewhere too.
    if !(0.99..=1.01).contains(&length) {
        return Err(ParameterError::out_of_range(
            "view.direction (length)",
            length,
            0.99,
            1.01,
        ));
    }
    Ok([x, y, z].map(|component| (component / length) as f32))
}

/// Culls rows that are not visible or cast no visible shadow. Conservative.
///
/// Uses the four side planes only. In perspective they also exclude everything behind the eye. Near and far plane must
/// not cull, since nailboards and volumes clamp their depth instead of being clipped.
#[derive(Clone, Copy, Debug)]
pub struct Cull {
    planes: [Plane; 4],
    clip_w: Plane,
    reach: f32x4,
    pad: f32x4,
    sweep: Option<Sweep>,
    lamp: Option<LampSweep>,
}

/// A plane with the signed distance n.x + d, positive inside; also any other linear function of the place.
#[derive(Clone, Copy, Debug)]
struct Plane {
    normal: Vector4,
    offset: f32x4,
}

impl Cull {
    fn new(numbers: &ViewNumbers, direction: [f32; 3]) -> Self {
        let row = |row: usize| [0, 1, 2, 3].map(|column| f64::from(numbers.clip_from_world[4 * column + row]));
        let side = |axis: usize, sign: f64| {
            let (w, other) = (row(3), row(axis));
            ExactPlane::new(std::array::from_fn(|i| w[i] + sign * other[i]))
                .normalised()
                .lanes()
        };
        Self {
            planes: [side(0, 1.0), side(0, -1.0), side(1, 1.0), side(1, -1.0)],
            clip_w: ExactPlane::new(row(3)).lanes(),
            reach: f32x4::splat(numbers.reach),
            pad: f32x4::splat(numbers.pad),
            sweep: (numbers.purpose == 1.0).then(|| Sweep::new(numbers.receivers, direction)),
            lamp: numbers
                .place_of_lamp()
                .map(|place| LampSweep::new(numbers.receivers, place)),
        }
    }

    /// A mask of the particles that may touch the frustum.
    #[inline(always)]
    pub fn keeps(&self, place: Vector4, radius: f32x4) -> f32x4 {
        if let Some(lamp) = &self.lamp {
            return self.keeps_by_lamp(lamp, place, radius * self.reach);
        }
        let length = self.sweep.map_or(f32x4::ZERO, |sweep| sweep.length(place));
        let direction = self.sweep.map_or(Vector4::zero(), |sweep| sweep.direction);
        let w = self.clip_w.value(place);
        let furthest_w = w + positive_part(self.clip_w.normal.dot(direction) * length);
        // Single precision: a distance is a sum of terms as large as the coordinates.
        let slack = (place.x.abs() + place.y.abs() + place.z.abs() + length) * f32x4::splat(2e-6);
        let touch = radius * self.reach + positive_part(furthest_w) * self.pad + slack;
        let mut kept = radius.simd_gt(f32x4::ZERO);
        for plane in &self.planes {
            let start = plane.value(place);
            let gain = positive_part(plane.normal.dot(direction) * length);
            kept &= (start + gain + touch + plane.offset.abs() * f32x4::splat(2e-6)).simd_ge(f32x4::ZERO);
        }
        kept
    }

    /// The same for balls in the light of a lamp.
    #[inline(never)]
    fn keeps_by_lamp(&self, lamp: &LampSweep, place: Vector4, ball: f32x4) -> f32x4 {
        let path = lamp.path(place, ball);
        let size = place.x.abs() + place.y.abs() + place.z.abs() + path.distance;
        let mut kept = ball.simd_gt(f32x4::ZERO);
        for plane in &self.planes {
            let (at_lamp, start) = (plane.value(lamp.place), plane.value(place));
            let touch = path.radius + (size + at_lamp.abs() + plane.offset.abs()) * f32x4::splat(4e-6);
            let end = at_lamp + (start - at_lamp + touch) * path.growth;
            kept &= (start + touch).fast_max(end).simd_ge(f32x4::ZERO);
        }
        kept
    }
}

/// A plane in double precision.
struct ExactPlane {
    normal: [f64; 3],
    offset: f64,
}

impl Plane {
    #[inline(always)]
    fn value(&self, place: Vector4) -> f32x4 {
        self.normal.dot(place) + self.offset
    }
}

impl ExactPlane {
    fn new([x, y, z, offset]: [f64; 4]) -> Self {
        Self {
            normal: [x, y, z],
            offset,
        }
    }

    /// Scales to metres. A plane without a normal excludes nothing.
    fn normalised(self) -> Self {
        let length = libm::sqrt(self.normal.iter().map(|component| component * component).sum());
        if length < 1e-12 {
            return Self {
                normal: [0.0; 3],
                offset: 1.0,
            };
        }
        Self {
            normal: self.normal.map(|component| component / length),
            offset: self.offset / length,
        }
    }

    fn lanes(self) -> Plane {
        Plane {
            normal: Vector4::splat(self.normal.map(|component| component as f32)),
            offset: f32x4::splat(self.offset as f32),
        }
    }
}
