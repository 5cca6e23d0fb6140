//! How what an emitter rides on moves in one step.

#[cfg(feature = "rigids")]
use crate::collide::motion::PoseMotion;
use crate::collide::space::{Frame, Pose, Vector};

/// What an emitter rides on.
#[derive(Clone, Copy, Debug)]
pub enum Ride {
    /// A rigid, which may turn by more than half a turn.
    #[cfg(feature = "rigids")]
    Rigid(PoseMotion),
    /// A part, by its poses at the start and at the end of the step.
    Part([Pose; 2]),
}

impl Ride {
    /// Its frame at a fraction of a step of `dt` seconds, and the velocity (m/s) there of what is at `local` in it.
    pub fn at(&self, fraction: f32, dt: f32, local: Vector) -> (Frame, Vector) {
        match self {
            #[cfg(feature = "rigids")]
            Ride::Rigid(motion) => {
                let frame = motion.frame(fraction);
                let place = frame.world_from_local(local);
                (frame, motion.velocity_at(place, fraction))
            }
            Ride::Part([start, end]) => {
                let frame = Frame::new(&start.towards(end, fraction));
                // What `towards` does, differentiated.
                let (half, cosine) = start.half_rotation_to(end);
                let square = 1.0 - 2.0 * fraction * (1.0 - fraction) * (1.0 - cosine);
                let spin = half * (2.0 / (square * dt));
                let velocity = (end.position - start.position) * (1.0 / dt);
                (frame, velocity + spin.cross(frame.rotate(local)))
            }
        }
    }
}
