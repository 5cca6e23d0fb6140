//! Commands to existing rigids.

use crate::layout::error::ParameterError;
use crate::math::pose::Pose;
use crate::rigids::checks::{no_such_rigid, shape_error};
use crate::rigids::description::RigidKind;
use crate::rigids::grab::Grab;
use crate::rigids::path::Path;
use crate::rigids::set::{Member, Rigids};
use crate::rigids::spin::{check_spin, spin_of};
use crate::rigids::track::Track;

impl Rigids {
    /// Sends a kinematic rigid to a pose. It arrives in the coming step, or later if its surface would move faster than
    /// [`TOP_SPEED`]. It leaves its path; its spin continues. A dynamic rigid is teleported instead: it rests at the
    /// pose, without sweeping smoke along, and moves on in the coming step.
    ///
    /// # Errors
    /// The rigid does not exist or is fixed.
    pub fn move_to(&mut self, index: u32, pose: Pose) -> Result<(), ParameterError> {
        self.check_movable(index)?;
        let member = self.member(index)?;
        member.description.path = None;
        member.guide.track = None;
        member.guide.target = Some(pose);
        Ok(())
    }

    /// Sets or removes the path of a kinematic rigid. The path's time is that of the simulator. A rigid that is
    /// elsewhere moves to its path at no more than [`TOP_SPEED`].
    ///
    /// # Errors
    /// The rigid does not exist or is not kinematic.
    pub fn set_path(&mut self, index: u32, path: Option<Path>) -> Result<(), ParameterError> {
        let member = self.kinematic(index)?;
        member.guide.target = None;
        member.guide.track = path.as_ref().map(Track::new);
        member.description.path = path;
        Ok(())
    }

    /// Spins a kinematic rigid about `axis`, in its own space, at `rate` rad/s, in addition to all other motion. The
    /// spin starts at the current rotation.
    ///
    /// # Errors
    /// The rigid does not exist or is not kinematic, the axis is zero, or the surface would move faster than
    /// [`TOP_SPEED`].
    pub fn set_spin(&mut self, index: u32, axis: [f32; 3], rate: f32) -> Result<(), ParameterError> {
        let member = self.kinematic(index)?;
        let spin = spin_of(axis, rate)?;
        check_spin(&spin, member.reach)?;
        member.guide.base = member.guide.pose(&member.description.spin);
        member.guide.angle = 0.0;
        member.description.spin = spin;
        Ok(())
    }

    /// Drags a point of a rigid to a position by a critically damped spring, until [`Rigids::release`].
    ///
    /// # Errors
    /// The rigid does not exist or is fixed.
    pub fn drag(&mut self, index: u32, grab: Grab) -> Result<(), ParameterError> {
        self.check_movable(index)?;
        let member = self.member(index)?;
        member.guide.target = None;
        member.guide.grab = Some(grab);
        Ok(())
    }

    /// Ends the drag. A kinematic rigid stays or returns to its path, a dynamic one keeps its velocity.
    ///
    /// # Errors
    /// The rigid does not exist.
    pub fn release(&mut self, index: u32) -> Result<(), ParameterError> {
        self.member(index)?.guide.grab = None;
        Ok(())
    }

    fn member(&mut self, index: u32) -> Result<&mut Member, ParameterError> {
        let count = self.count();
        self.members
            .get_mut(index as usize)
            .filter(|member| !member.is_removed)
            .ok_or_else(|| no_such_rigid(index, count))
    }

    fn kinematic(&mut self, index: u32) -> Result<&mut Member, ParameterError> {
        let kind = self.kind(index)?;
        if kind != RigidKind::Kinematic {
            let message = format!("rigid {index} is not kinematic; only kinematic rigids have a path or a spin");
            return Err(shape_error("rigid.index", f64::from(index), message));
        }
        self.member(index)
    }

    fn kind(&self, index: u32) -> Result<RigidKind, ParameterError> {
        let member = self.members.get(index as usize);
        member
            .filter(|member| !member.is_removed)
            .map(|member| member.description.kind)
            .ok_or_else(|| no_such_rigid(index, self.count()))
    }

    /// Checks that a rigid exists.
    pub(crate) fn check_exists(&self, index: u32) -> Result<(), ParameterError> {
        self.kind(index).map(|_| ())
    }

    /// Checks that a rigid exists and is not fixed.
    pub(crate) fn check_movable(&self, index: u32) -> Result<(), ParameterError> {
        if self.kind(index)? != RigidKind::Fixed {
            return Ok(());
        }
        let message = format!("rigid {index} is fixed; only kinematic and dynamic rigids can be moved");
        Err(shape_error("rigid.index", f64::from(index), message))
    }
}
