//! The log: inputs in the order of their steps.

use crate::simulator::take::input::Input;

/// Maximum number of inputs in a log. Later inputs act but are not recorded.
pub const MAX_INPUTS: usize = 20_000;

/// Setting this parameter converts particle state: two changes in a step are not equivalent to the last one.
const INTEGRATOR: &str = "simulation.integrator";

/// An input, and the number of steps made before it.
#[derive(Clone, Debug, PartialEq)]
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
    /// Number of inputs.
    pub fn len(&self) -> usize {
        self.records.len()
    }

    /// Returns true if there are no inputs.
    pub fn is_empty(&self) -> bool {
        self.records.is_empty()
    }

    /// Returns true if inputs exceeded [`MAX_INPUTS`].
    pub fn is_truncated(&self) -> bool {
        self.is_truncated
    }

    /// Largest capacity that an input sets.
    pub(super) fn max_capacity(&self) -> Option<u32> {
        let capacities = self.records.iter().filter_map(|record| match record.input {
            Input::Resize { capacity } => Some(capacity),
            _ => None,
        });
        capacities.max()
    }

    /// Index of a parameter key in this log; adds the key if it is new.
    pub(super) fn number_of(&mut self, key: &str) -> u16 {
        let known = self.keys.iter().position(|known| known == key);
        let number = known.unwrap_or_else(|| {
            self.keys.push(key.to_owned());
            self.keys.len() - 1
        });
        number as u16
    }

    /// The key at an index.
    pub(super) fn key(&self, number: u16) -> &str {
        &self.keys[usize::from(number)]
    }

    /// Adds an input, or replaces one of the same step that it supersedes.
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

    /// Keeps the first `count` inputs. Clears `is_truncated` if it drops any.
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

    /// Returns true if `input` must not be moved before `earlier`, which it does not supersede.
    fn is_turning_point(&self, earlier: &Input, input: &Input) -> bool {
        let is_of_same_rigid = earlier.rigid().is_some() && earlier.rigid() == input.rigid();
        self.is_conversion(earlier) || (is_of_same_rigid && !input.supersedes(earlier))
    }

    fn is_conversion(&self, input: &Input) -> bool {
        matches!(input, Input::Set { key, .. } if self.key(*key) == INTEGRATOR)
    }
}
