//! Where, when and on what a force acts: a region of space, an envelope in time, and the rigid or part it rides on.

pub mod envelope;
pub mod region;

use wide::f32x4;

use crate::collide::space::{Frame, Pose, Vector};
use crate::parameters::field::{Field, LENGTH, PLACE, number, vector};
use crate::parameters::section::Item;
use crate::parts::{FIRST_PART, MAX_PARTS, Parts, ends_of_rigid};
use crate::simd::Vector4;
use region::Shape;

/// Neither rigid nor part: what is attached to it stands still in the world.
pub const WORLD: f64 = -1.0;

/// The parameters of a scope but for its region, for what acts at places of its own.
pub const WHEN_AND_ON_WHAT: &[Field<Scope>] = Scope::FIELDS.split_at(REGION_FIELDS).1;
/// How many parameters of a scope tell its region; they come first.
const REGION_FIELDS: usize = 4;
/// The number of the last part.
const LAST_PART: f64 = (FIRST_PART + MAX_PARTS - 1) as f64;

/// `*.region.*`, `*.envelope.*` and `*.rigid`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Scope {
    pub shape: f64,
    pub position: [f64; 3],
    pub size: [f64; 3],
    pub softness: f64,
    pub start: f64,
    pub duration: f64,
    pub period: f64,
    pub fade: f64,
    pub rigid: f64,
}

impl Item for Scope {
    const FIELDS: &'static [Field<Self>] = &[
        number("region.shape", "1", [0.0, 3.0], 0.0, |s: &mut Self| &mut s.shape)
            .named(&["all", "sphere", "box", "capsule"])
            .says("Region", "Where it acts: everywhere, or within a shape."),
        vector("region.position", "m", PLACE, [0.0; 3], |s: &mut Self| &mut s.position)
            .says("Region at", "Centre of the region."),
        vector("region.size", "m", LENGTH, [1.0; 3], |s: &mut Self| &mut s.size).says(
            "Region size",
            "Half sides of a box; of a sphere x is the radius; of a capsule x is the radius and y half its straight part.",
        ),
        number("region.softness", "m", [0.0, 100.0], 0.3, |s: &mut Self| &mut s.softness)
            .says("Soft edge", "How far outside of the region its effect fades out."),
        number("envelope.start", "s", [0.0, 3600.0], 0.0, |s: &mut Self| &mut s.start)
            .says("Starts at", "When it is switched on for the first time."),
        number("envelope.duration", "s", [0.0, 3600.0], 0.0, |s: &mut Self| &mut s.duration)
            .says("Stays on for", "How long it stays on; 0 is for ever."),
        number("envelope.period", "s", [0.0, 3600.0], 0.0, |s: &mut Self| &mut s.period)
            .says("Again every", "Time from one switching on to the next; 0 is once only."),
        number("envelope.fade", "s", [0.0, 60.0], 0.0, |s: &mut Self| &mut s.fade)
            .says("Fades over", "How long it takes to come up and, before its end, to go down."),
        number("rigid", "1", [WORLD, LAST_PART], WORLD, |s: &mut Self| &mut s.rigid)
            .whole()
            .says(
                "Rides on",
                "Number of the rigid that carries it along, or 4096 and the number of a moving part; -1 leaves it where it is.",
            ),
    ];
}

/// The moment of a step, and where the rigids and parts are in it.
#[derive(Clone, Copy, Debug)]
pub struct StepTime<'r> {
    /// Simulated seconds at the middle of the step.
    pub time: f64,
    /// Length of the step (s).
    pub dt: f64,
    /// Of each rigid its pose before and after the step, 14 numbers as `rigids::Rigids::poses` has them.
    pub poses: &'r [f32],
    /// The parts in this step.
    pub parts: &'r Parts,
}

impl StepTime<'_> {
    /// Where the rigid or part that `scope` rides on is at `fraction` of the step; none where it rides on none that
    /// exists.
    pub fn ride(&self, scope: &Scope, fraction: f32) -> Option<Pose> {
        let rigid = || {
            (scope.rigid >= 0.0)
                .then(|| ends_of_rigid(self.poses, scope.rigid as usize))
                .flatten()
        };
        let [before, after] = self.parts.ends(scope.rigid).or_else(rigid)?;
        Some(before.towards(&after, fraction))
    }

    /// The frame in which the positions and directions of what has this `scope` are meant, in the middle of the step.
    pub fn frame(&self, scope: &Scope) -> Frame {
        Frame::new(&self.ride(scope, 0.5).unwrap_or(Pose::at(Vector::ZERO)))
    }
}

/// A scope made ready for the lanes.
#[derive(Clone, Copy, Debug)]
pub struct Reach {
    level: f32x4,
    shape: Shape,
}

impl Reach {
    /// How `scope` acts in this step; none while it is switched off.
    pub fn new(scope: &Scope, now: &StepTime) -> Option<Self> {
        let level = envelope::level(scope, now.time);
        (level > 0.0).then(|| Self {
            level: f32x4::splat(level as f32),
            shape: Shape::new(scope, &now.frame(scope)),
        })
    }

    /// Acts fully, at all places and all the time.
    pub fn everywhere() -> Self {
        Self {
            level: f32x4::ONE,
            shape: Shape::All,
        }
    }

    /// How strongly it acts at each place, 0..=1.
    #[inline(always)]
    pub fn weigh(&self, places: &[Vector4], weights: &mut [f32x4]) {
        self.shape.weigh(places, self.level, weights);
    }
}
