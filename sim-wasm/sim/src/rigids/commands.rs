//! Commands to existing rigids.

use crate::layout::error::ParameterError;
use crate::math::pose::Pose;
use crate::rigids::checks::{no_such_rigid, shape_error};
use crate::rigids::description::RigidKind;
use crate::rigids::grab::Grab;
use crate::rigids::set::{Member, Rigids};

impl Rigids {
    /// Sends a kinematic rigid to a pose. It arrives in the coming step, or later if its surface would move faster than
    /// [`TOP_SPEED`]. A dynamic rigid is teleported instead: it rests at the pose, without sweeping smoke along, and
    /// moves on in the coming step.
    ///
    /// # Errors
    /// The rigid does not exist or is fixed.
    pub fn move_to(&mut self, index: u32, pose: Pose) -> Result<(), ParameterError> {
        self.check_movable(index)?;
        self.member(index)?.guide.target = Some(pose);
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

    /// Ends the drag. A kinematic rigid stays, a dynamic one keeps its velocity.
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
