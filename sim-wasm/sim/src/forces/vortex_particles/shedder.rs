//! What sheds vortex particles: a place on a rigid, or in the world where the wind blows past it.
//!
//! A shedder sheds `rate` vortex particles a second, evenly, each at its moment within the step. The fastest air around
//! a fresh one has the speed |`strength` + `perSpeed` V|, for the speed V of the air relative to the place, without what
//! other vortex particles add: so a rigid that rests in still air sheds nothing by `perSpeed`, a post in the wind does,
//! and a wake cannot feed itself. Those below 1 mm/s are not shed, and none is above 100 m/s. The envelope and the region of its scope, the
//! latter at the place, weaken what is shed.
//!
//! They are born between `position` - `extent` and `position` + `extent`, all with the sense of `axis`. With `alternate`
//! they are born by turns at the two ends with opposite senses, as in the street that von Karman described: as the
//! shear layers of a body would have it, where the air passes across axis and extent, from whichever side it comes;
//! else the end at +`extent` has the sense of `axis`, as for the tips of a wing with the axis along its way.

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

/// Most that one shedder sheds in a step of 1/60 s.
const MAX_PER_STEP: usize = 34;
/// The fastest air around a vortex particle, as a share of what would turn with its centre at the radius of its core.
const PEAK: f32 = 0.594_107;
/// What is slower (m/s) is not worth a vortex particle.
const MIN_SPEED: f32 = 1e-3;
/// No vortex particle is faster (m/s), however fast a rigid falls.
const MAX_SPEED: f32 = 100.0;
/// The air passes across where this share of its speed does.
const ACROSS: f32 = 0.1;

impl Shedding {
    /// What all shedders shed in one step of `motion`, which is that of `context`.
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
    /// Where the rigid is at the start and at the end of the step.
    ends: [Frame; 2],
    /// Velocity of the air (m/s) at the middle of the shedder.
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

    /// One `moment` seconds after the start of the step, which for an alternating shedder stands at the second end
    /// where `is_second`; none where it would hardly turn.
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

    /// Fastest air (m/s) around what is shed at `place`, which the air passes with the velocity `passing`.
    fn speed(&self, place: Vector, passing: Vector) -> f32 {
        let mut weight = [f32x4::ZERO];
        self.reach.weigh(&[Vector4::splat(place.into())], &mut weight);
        let whole = self.shedder.strength as f32 + self.shedder.per_speed as f32 * passing.length();
        (whole * weight[0].to_array()[0]).clamp(-MAX_SPEED, MAX_SPEED)
    }

    /// Velocity (m/s) of a place that moves with the rigid.
    fn velocity_of(&self, local: Vector) -> Vector {
        let [before, after] = self.ends.map(|frame| frame.world_from_local(local));
        (after - before) * (1.0 / self.context.now.dt as f32)
    }

    /// A random vector no longer than `radius`.
    fn within(&mut self, radius: f64) -> Vector {
        Vector::from(in_ball(self.random)) * radius as f32
    }
}

fn frame(shedder: &Shedder, context: &ForceContext, fraction: f32) -> Frame {
    let pose = context.now.ride(&shedder.scope, fraction);
    Frame::new(&pose.unwrap_or(Pose::at(Vector::ZERO)))
}

/// 1 where at the end of `extent` the shear layer of the air that passes turns with `axis`, or where the air does not
/// pass across, else -1.
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
