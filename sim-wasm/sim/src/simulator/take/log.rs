//! The log: inputs in the order of their steps.

use crate::simulator::take::input::Input;

/// Most inputs of a log; what comes later acts but is not kept.
pub const MAX_INPUTS: usize = 20_000;

/// The parameter whose change converts what particles carry: unlike others it cannot be set twice for once.
const INTEGRATOR: &str = "simulation.integrator";

/// An input, and the steps that had been made when it was given.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Record {
    pub step: u64,
    pub input: Input,
}

/// Inputs in the order of their steps, at most [`MAX_INPUTS`].
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Log {
    pub(super) keys: Vec<String>,
    pub(super) records: Vec<Record>,
    pub(super) is_truncated: bool,
}

impl Log {
    /// How many inputs it holds.
    pub fn len(&self) -> usize {
        self.records.len()
    }

    /// Whether it holds none.
    pub fn is_empty(&self) -> bool {
        self.records.is_empty()
    }

    /// Whether inputs came for which there was no room.
    pub fn is_truncated(&self) -> bool {
        self.is_truncated
    }

    /// The most particles that an input makes room for.
    pub(super) fn max_capacity(&self) -> Option<u32> {
        let capacities = self.records.iter().filter_map(|record| match record.input {
            Input::Resize { capacity } => Some(capacity),
            _ => None,
        });
        capacities.max()
    }

    /// The number of a parameter's key in this log.
    pub(super) fn number_of(&mut self, key: &str) -> u16 {
        let known = self.keys.iter().position(|known| known == key);
        let number = known.unwrap_or_else(|| {
            self.keys.push(key.to_owned());
            self.keys.len() - 1
        });
        number as u16
    }

    /// The key of this number.
    pub(super) fn key(&self, number: u16) -> &str {
        &self.keys[usize::from(number)]
    }

    /// Adds an input, in place of one of the same step that it leaves nothing of.
    pub(super) fn push(&mut self, step: u64, input: Input) {
        if self.is_truncated {
            return;
        }
        if let Some(index) = self.superseded(step, &input) {
            self.records[index].input = input;
        } else if self.records.len() < MAX_INPUTS {
            self.records.push(Record { step, input });
        } else {
            self.is_truncated = true;
        }
    }

    /// Drops all inputs but the first `count`, and with them what was said of those that found no room.
    pub(super) fn cut(&mut self, count: usize) {
        if count < self.len() {
            self.records.truncate(count);
            self.is_truncated = false;
        }
    }

    fn superseded(&self, step: u64, input: &Input) -> Option<usize> {
        let of_step = self.records.iter().rev().take_while(|record| record.step == step);
        let mut open = of_step.take_while(|record| !self.is_turning_point(&record.input, input));
        let back = open.position(|record| input.supersedes(&record.input))?;
        Some(self.len() - 1 - back)
    }

    /// Whether it makes a difference if `input` comes before or after `earlier`, which it does not supersede.
    fn is_turning_point(&self, earlier: &Input, input: &Input) -> bool {
        let is_of_same_rigid = earlier.rigid().is_some() && earlier.rigid() == input.rigid();
        self.is_conversion(earlier) || (is_of_same_rigid && !input.supersedes(earlier))
    }

    fn is_conversion(&self, input: &Input) -> bool {
        matches!(input, Input::Set { key, .. } if self.key(*key) == INTEGRATOR)
    }
}
