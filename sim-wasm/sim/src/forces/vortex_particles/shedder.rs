//! Shedders: they emit vortex particles at a place on a rigid, or at a fixed place in the wind.
//!
//! A shedder emits `rate` vortex particles per second, evenly, each at its time within the step. The maximum air speed
//! around a new one is |`strength` + `perSpeed` V|, for the air speed V relative to the place without other vortex
//! particles. So a rigid at rest in still air sheds nothing by `perSpeed`, a post in the wind does, and a wake does not
//! feed itself. Speeds below 1 mm/s are not shed; the maximum is 100 m/s. The envelope of the scope, and its region at
//! the place, scale the speed.
//!
//! They start between `position` - `extent` and `position` + `extent`, all with the sense of `axis`. With `alternate`
//! they start alternately at the two ends with opposite senses, as in a von Karman vortex street. The senses follow the
//! shear layers where the air passes across axis and extent, from either side. Otherwise the end at +`extent` has the
//! sense of `axis`, as for wing tips with the axis along their motion.

use arrayvec::ArrayVec;
use wide::f32x4;

use crate::forces::force::ForceContext;
use crate::forces::particle_motion::ParticleMotion;
use crate::forces::vortex_particles::shedding::Shedding;
use crate::forces::vortex_particles::swarm::{Swarm, VortexParticle};
use crate::layout::parameters::shedder::Shedder;
use crate::layout::scope::Reach;
use crate::math::double::direction;
use crate::math::pose::{Frame, Pose};
use crate::math::random::{Random, in_ball};
use crate::math::scalar::clamped;
use crate::math::simd::Vector4;
use crate::math::vector::Vector;

/// Maximum number per shedder in a step of 1/60 s.
const MAX_PER_STEP: usize = 34;
/// Maximum air speed of a vortex particle, relative to angular velocity times core radius.
const PEAK: f32 = 0.594_107;
/// Minimum speed of a shed vortex particle (m/s).
const MIN_SPEED: f32 = 1e-3;
/// Maximum speed of a shed vortex particle (m/s).
const MAX_SPEED: f32 = 100.0;
/// Minimum share of the air speed across axis and extent.
const ACROSS: f32 = 0.1;

impl Shedding {
    /// Sheds the vortex particles of one step. `motion` belongs to `context`.
    pub fn step(&mut self, motion: &ParticleMotion, context: &ForceContext, swarm: &mut Swarm) {
        let dt = context.now.dt;
        for (index, shedder) in context.parameters.shedders.items().iter().enumerate() {
            let Some(reach) = Reach::new(&shedder.scope, &context.now) else {
                continue;
            };
            let before = self.owed[index];
            let owed = before + shedder.rate * dt;
            // Sums of decimal fractions miss whole numbers by a few units in the last place.
            let due = libm::floor(owed + 1e-9);
            self.owed[index] = owed - due;
            if due < 1.0 {
                continue;
            }
            let mut newborns = ArrayVec::<_, MAX_PER_STEP>::new();
            let mut source = ShedderSource::new(shedder, reach, motion, context, &mut self.random);
            for number in 1..=due as u64 {
                let moment = clamped((number as f64 - before) / shedder.rate, 0.0, dt);
                newborns.extend(source.shed(moment as f32, self.due[index].wrapping_add(number) % 2 == 0));
            }
            self.due[index] = self.due[index].wrapping_add(due as u64);
            swarm.make_room(newborns.len());
            newborns.iter().for_each(|newborn| swarm.push(newborn));
        }
    }
}

/// A shedder in one step.
struct ShedderSource<'s> {
    shedder: &'s Shedder,
    reach: Reach,
    context: &'s ForceContext<'s>,
    /// Frames of the rigid at the start and at the end of the step.
    ends: [Frame; 2],
    /// Air velocity (m/s) at the centre of the shedder.
    air: Vector,
    random: &'s mut Random,
}

impl<'s> ShedderSource<'s> {
    fn new(
        shedder: &'s Shedder,
        reach: Reach,
        motion: &ParticleMotion,
        context: &'s ForceContext<'s>,
        random: &'s mut Random,
    ) -> Self {
        let frame = |fraction| frame(shedder, context, fraction);
        let middle = frame(0.5).world_from_local(single(shedder.position));
        Self {
            shedder,
            reach,
            context,
            ends: [frame(0.0), frame(1.0)],
            air: motion.air_velocity(middle.into(), None).into(),
            random,
        }
    }

    /// Sheds one vortex particle `moment` seconds after the start of the step. An alternating shedder uses its second
    /// end if `is_second`. None if the speed is below the minimum.
    fn shed(&mut self, moment: f32, is_second: bool) -> Option<VortexParticle> {
        let Shedder {
            scatter,
            jitter,
            axis,
            core_radius,
            ..
        } = *self.shedder;
        let dt = self.context.now.dt as f32;
        let is_alternating = self.shedder.alternate == 1.0;
        let side = match (is_alternating, is_second) {
            (false, _) => self.random.signed(),
            (true, false) => 1.0,
            (true, true) => -1.0,
        };
        let extent = single(self.shedder.extent);
        let local = single(self.shedder.position) + extent * side + self.within(scatter);
        let axis = Vector::from(direction(axis));
        let frame = frame(self.shedder, self.context, moment / dt);
        let place = frame.world_from_local(local);
        let passing = self.air - self.velocity_of(local);
        let sense = if is_alternating {
            side * sense(frame.rotate(axis), frame.rotate(extent), passing)
        } else {
            1.0
        };
        let direction = frame.rotate((axis + self.within(jitter)).unit_or(axis));
        let speed = self.speed(place, passing);
        (speed.abs() >= MIN_SPEED).then(|| VortexParticle {
            position: (place + self.air * (dt - moment)).into(),
            swirl: (direction * (sense * speed / (PEAK * core_radius as f32))).into(),
            core_radius: core_radius as f32,
            viscosity: self.shedder.viscosity as f32,
            age: dt - moment,
            lifetime: self.shedder.lifetime as f32,
        })
    }

    /// Maximum air speed (m/s) around a vortex particle shed at `place`; `passing` is the relative air velocity.
    fn speed(&self, place: Vector, passing: Vector) -> f32 {
        let mut weight = [f32x4::ZERO];
        self.reach.weigh(&[Vector4::splat(place.into())], &mut weight);
        let whole = self.shedder.strength as f32 + self.shedder.per_speed as f32 * passing.length();
        (whole * weight[0].to_array()[0]).clamp(-MAX_SPEED, MAX_SPEED)
    }

    /// Velocity (m/s) of a point of the rigid.
    fn velocity_of(&self, local: Vector) -> Vector {
        let [before, after] = self.ends.map(|frame| frame.world_from_local(local));
        (after - before) * (1.0 / self.context.now.dt as f32)
    }

    /// A random vector of at most the length `radius`.
    fn within(&mut self, radius: f64) -> Vector {
        Vector::from(in_ball(self.random)) * radius as f32
    }
}

fn frame(shedder: &Shedder, context: &ForceContext, fraction: f32) -> Frame {
    let pose = context.now.ride(&shedder.scope, fraction);
    Frame::new(&pose.unwrap_or(Pose::at(Vector::ZERO)))
}

/// 1 if the shear layer at the end of `extent` rotates with `axis`, or if the air does not pass across; else -1.
fn sense(axis: Vector, extent: Vector, passing: Vector) -> f32 {
    let along = axis.dot(extent.cross(passing));
    if along < -ACROSS * extent.length() * passing.length() {
        -1.0
    } else {
        1.0
    }
}

fn single(vector: [f64; 3]) -> Vector {
    vector.map(|component| component as f32).into()
}
