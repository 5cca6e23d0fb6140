//! What a rigid can be told once it is there.

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
    /// Sends a kinematic rigid to a pose: it is there after the coming step, or after more when its surface would have
    /// to move faster than [`TOP_SPEED`]. It leaves its path for that; its spin goes on. A dynamic rigid is put there
    /// instead, at rest and without a way that would sweep smoke along, and moves on from there in the coming step.
    ///
    /// # Errors
    /// When there is no such rigid or it is fixed.
    pub fn move_to(&mut self, index: u32, pose: Pose) -> Result<(), ParameterError> {
        self.check_movable(index)?;
        let member = self.member(index)?;
        member.description.path = None;
        member.guide.track = None;
        member.guide.target = Some(pose);
        Ok(())
    }

    /// Gives a kinematic rigid a path, or takes it away. The path's time is that of the simulator; a rigid that is
    /// elsewhere goes to its path no faster than [`TOP_SPEED`].
    ///
    /// # Errors
    /// When there is no such rigid or it is not kinematic.
    pub fn set_path(&mut self, index: u32, path: Option<Path>) -> Result<(), ParameterError> {
        let member = self.kinematic(index)?;
        member.guide.target = None;
        member.guide.track = path.as_ref().map(Track::new);
        member.description.path = path;
        Ok(())
    }

    /// Lets a kinematic rigid spin about `axis`, in its own space, at `rate` rad/s on top of all else that moves it. It
    /// goes on from how it is turned now.
    ///
    /// # Errors
    /// When there is no such rigid, it is not kinematic, the axis has no direction, or the surface would move faster
    /// than [`TOP_SPEED`].
    pub fn set_spin(&mut self, index: u32, axis: [f32; 3], rate: f32) -> Result<(), ParameterError> {
        let member = self.kinematic(index)?;
        let spin = spin_of(axis, rate)?;
        check_spin(&spin, member.reach)?;
        member.guide.base = member.guide.pose(&member.description.spin);
        member.guide.angle = 0.0;
        member.description.spin = spin;
        Ok(())
    }

    /// Draws a point of a rigid to a place by a critically damped spring, until [`Rigids::release`].
    ///
    /// # Errors
    /// When there is no such rigid or it is fixed.
    pub fn drag(&mut self, index: u32, grab: Grab) -> Result<(), ParameterError> {
        self.check_movable(index)?;
        let member = self.member(index)?;
        member.guide.target = None;
        member.guide.grab = Some(grab);
        Ok(())
    }

    /// Lets go: a kinematic rigid stays where it is or goes back to its path, a dynamic one flies on.
    ///
    /// # Errors
    /// When there is no such rigid.
    pub fn release(&mut self, index: u32) -> Result<(), ParameterError> {
        self.member(index)?.guide.grab = None;
        Ok(())
    }

    fn member(&mut self, index: u32) -> Result<&mut Member, ParameterError> {
        let count = self.count();
        self.members
            .get_mut(index as usize)
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
            .map(|member| member.description.kind)
            .ok_or_else(|| no_such_rigid(index, self.count()))
    }

    /// Refuses a rigid that does not exist.
    pub(crate) fn check_exists(&mut self, index: u32) -> Result<(), ParameterError> {
        self.member(index).map(|_| ())
    }

    /// Refuses a rigid that does not exist or is fixed.
    pub(crate) fn check_movable(&self, index: u32) -> Result<(), ParameterError> {
        if self.kind(index)? != RigidKind::Fixed {
            return Ok(());
        }
        let message = format!("rigid {index} is fixed; only kinematic and dynamic rigids can be moved");
        Err(shape_error("rigid.index", f64::from(index), message))
    }
}
