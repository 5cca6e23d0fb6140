//! The kinds of input, quantised, and their serialisation.

use crate::emission::pool::Emission;
use crate::layout::blow::Blow;
use crate::layout::bytes::{Reader, Writer};
use crate::layout::error::{ParameterError, RestoreError};
use crate::layout::limits::CAPACITY_LIMIT;
use crate::layout::quantise::{impossible_input, quantise, within};
use crate::layout::quantised::{Grip, QuantisedPose};
use crate::simulator::take::active_inputs::{CHANNELS, STEER_PARTS};

/// One input of a user.
#[derive(Clone, Debug, PartialEq)]
pub enum Input {
    /// Sets a parameter; `key` is its index in the keys of the log.
    Set { key: u16, value: f64 },
    /// Sets the maximum number of particles.
    Resize { capacity: u32 },
    /// Sends a kinematic rigid to a pose, or teleports a dynamic one.
    Move { rigid: u16, pose: QuantisedPose },
    /// Drags a point of a rigid to a position.
    Drag { rigid: u16, grip: Grip },
    /// Ends the drag of a rigid.
    Release { rigid: u16 },
    /// Sets a channel that scenes read, in units of 1 / [`STEER_PARTS`].
    Steer { channel: u8, value: i16 },
    /// Starts a gust.
    Blow(Blow),
    /// Removes all particles.
    Clear,
    /// Starts or changes an emission. Boxed, because it is much larger than the others.
    Emit(Box<Emission>),
}

const SET: u8 = 0;
const RESIZE: u8 = 1;
const MOVE: u8 = 2;
const STEER: u8 = 3;
const BLOW: u8 = 4;
const DRAG: u8 = 5;
pub(super) const RELEASE: u8 = 6;
const CLEAR: u8 = 7;
pub(super) const EMIT: u8 = 8;
/// An emission with all numbers of an emitter; older takes have none.
pub(super) const EMIT_LONG: u8 = 9;

impl Input {
    /// Sets `channel`, below [`CHANNELS`], to `value`, -1..=1.
    pub fn steer(channel: u32, value: f64) -> Result<Self, ParameterError> {
        if channel as usize >= CHANNELS {
            let last = CHANNELS as f64 - 1.0;
            return Err(ParameterError::out_of_range(
                "steer.channel",
                f64::from(channel),
                0.0,
                last,
            ));
        }
        let value = quantise("steer.value", value, [-1.0, 1.0], f64::from(STEER_PARTS))?;
        Ok(Self::Steer {
            channel: channel as u8,
            value: value as i16,
        })
    }

    /// Returns true if this input cancels `earlier`, which was given before it in the same step.
    pub fn supersedes(&self, earlier: &Self) -> bool {
        match (self, earlier) {
            (Self::Set { key: a, .. }, Self::Set { key: b, .. }) => a == b,
            (Self::Move { rigid: a, .. }, Self::Move { rigid: b, .. }) => a == b,
            (Self::Drag { rigid: a, .. }, Self::Drag { rigid: b, .. }) => a == b,
            (Self::Steer { channel: a, .. }, Self::Steer { channel: b, .. }) => a == b,
            (Self::Blow(_), Self::Blow(_)) | (Self::Clear, Self::Clear) => true,
            _ => false,
        }
    }

    /// The rigid that this input moves.
    pub fn rigid(&self) -> Option<u16> {
        match self {
            Self::Move { rigid, .. } | Self::Drag { rigid, .. } | Self::Release { rigid } => Some(*rigid),
            _ => None,
        }
    }

    pub(super) fn write(&self, body: &mut Writer) {
        match self {
            Self::Set { key, value } => {
                body.byte(SET);
                body.short(*key);
                body.number(*value);
            }
            Self::Resize { capacity } => {
                body.byte(RESIZE);
                body.word(*capacity);
            }
            Self::Move { rigid, pose } => {
                body.byte(MOVE);
                body.short(*rigid);
                pose.write(body);
            }
            Self::Drag { rigid, grip } => {
                body.byte(DRAG);
                body.short(*rigid);
                grip.write(body);
            }
            Self::Release { rigid } => {
                body.byte(RELEASE);
                body.short(*rigid);
            }
            Self::Steer { channel, value } => {
                body.byte(STEER);
                body.byte(*channel);
                body.short(*value as u16);
            }
            Self::Blow(blow) => {
                body.byte(BLOW);
                blow.write(body);
            }
            Self::Clear => body.byte(CLEAR),
            Self::Emit(emission) => {
                body.byte(if emission.is_long() { EMIT_LONG } else { EMIT });
                emission.write(body);
            }
        }
    }

    /// Reads what `write` wrote and validates it. The caller checks keys and rigids.
    pub(super) fn read(reader: &mut Reader) -> Result<Self, RestoreError> {
        Ok(match reader.byte()? {
            SET => Self::Set {
                key: reader.short()?,
                value: reader.number()?,
            },
            RESIZE => Self::Resize {
                capacity: within(reader.word()?, 1, CAPACITY_LIMIT)?,
            },
            MOVE => Self::Move {
                rigid: reader.short()?,
                pose: QuantisedPose::read(reader)?,
            },
            STEER => Self::Steer {
                channel: within(reader.byte()?, 0, CHANNELS as u8 - 1)?,
                value: within(reader.short()? as i16, -STEER_PARTS, STEER_PARTS)?,
            },
            DRAG => Self::Drag {
                rigid: reader.short()?,
                grip: Grip::read(reader)?,
            },
            RELEASE => Self::Release { rigid: reader.short()? },
            BLOW => Self::Blow(Blow::read(reader)?),
            CLEAR => Self::Clear,
            kind @ (EMIT | EMIT_LONG) => Self::Emit(Box::new(Emission::read(reader, kind == EMIT_LONG)?)),
            _ => return Err(impossible_input()),
        })
    }
}
