//! Inputs that still act: channels that scenes read, and gusts.

use crate::layout::blow::Blow;
use crate::layout::bytes::{Reader, SnapshotSection, Writer};
use crate::layout::error::RestoreError;
use crate::layout::gust::{Gust, MAX_GUSTS};
use crate::layout::quantise::within;
use crate::math::hash::Hash;

/// Value of a channel at full deflection.
pub const STEER_PARTS: i16 = i16::MAX;

/// Number of channels.
pub const CHANNELS: usize = 8;

/// Channels, gusts, and the number of log entries already applied.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ActiveInputs {
    channels: [i16; CHANNELS],
    gusts: [Gust; MAX_GUSTS],
    count: usize,
    /// Number of log entries applied. Not part of the hash.
    pub(super) done: u32,
}

impl ActiveInputs {
    /// Value of a channel, -1..=1; 0 for an index out of range.
    pub fn control(&self, channel: usize) -> f32 {
        let parts = self.channels.get(channel).copied().unwrap_or(0);
        f32::from(parts) / f32::from(STEER_PARTS)
    }

    /// The active gusts.
    pub fn gusts(&self) -> &[Gust] {
        &self.gusts[..self.count]
    }

    pub(super) fn steer(&mut self, channel: u8, parts: i16) {
        self.channels[usize::from(channel)] = parts;
    }

    /// Starts a gust. It replaces a gust that was started in the same step.
    pub(super) fn blow(&mut self, blow: Blow) {
        if self.gusts().last().is_some_and(|gust| gust.age == 0) {
            self.count -= 1;
        }
        if self.count == MAX_GUSTS {
            self.gusts.copy_within(1.., 0);
            self.count -= 1;
        }
        self.gusts[self.count] = Gust { blow, age: 0 };
        self.count += 1;
    }

    /// Advances all gusts by one step.
    pub(crate) fn advance(&mut self) {
        let mut kept = 0;
        for index in 0..self.count {
            let Gust { blow, age } = self.gusts[index];
            if age + 1 < blow.steps {
                self.gusts[kept] = Gust { blow, age: age + 1 };
                kept += 1;
            }
        }
        self.gusts[kept..self.count].fill(Gust::default());
        self.count = kept;
    }

    /// Returns true if no input still acts.
    pub(super) fn is_nothing(&self) -> bool {
        self.count == 0 && self.channels == [0; CHANNELS]
    }

    /// Adds the gusts that already act to `hash`. Channels, and a gust that starts in the coming step, are inputs and
    /// not part of the state.
    pub(crate) fn hash_into(&self, hash: &mut Hash) {
        let mut body = Writer::default();
        for gust in self.gusts().iter().filter(|gust| gust.age > 0) {
            gust.write(&mut body);
        }
        let bytes = body.finish();
        if !bytes.is_empty() {
            hash.bytes(&bytes);
        }
    }

    fn write_state(&self, body: &mut Writer) {
        self.channels.iter().for_each(|parts| body.short(*parts as u16));
        body.byte(self.count as u8);
        self.gusts().iter().for_each(|gust| gust.write(body));
    }
}

impl SnapshotSection for ActiveInputs {
    fn write(&self, body: &mut Writer) {
        self.write_state(body);
        body.word(self.done);
    }

    fn read(reader: &mut Reader) -> Result<Self, RestoreError> {
        let mut inputs = Self::default();
        for parts in &mut inputs.channels {
            *parts = within(reader.short()? as i16, -STEER_PARTS, STEER_PARTS)?;
        }
        inputs.count = within(usize::from(reader.byte()?), 0, MAX_GUSTS)?;
        for gust in &mut inputs.gusts[..inputs.count] {
            let blow = Blow::read(reader)?;
            let age = within(reader.short()?, 0, blow.steps - 1)?;
            *gust = Gust { blow, age };
        }
        inputs.done = reader.word()?;
        Ok(inputs)
    }
}
