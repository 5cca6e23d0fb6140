//! The recorder of a take.

use crate::layout::bytes::Writer;
use crate::simulator::take::active_inputs::ActiveInputs;
use crate::simulator::take::bytes;
use crate::simulator::take::log::{Log, Record};
use crate::simulator::take::origin::Origin;

/// Records inputs from an origin on. Without an origin it records nothing.
#[derive(Clone, Debug, Default)]
pub(crate) struct Recorder {
    pub(super) origin: Option<Box<Origin>>,
    pub(super) log: Log,
    /// Number of steps at the farthest point of the take.
    pub(super) end: u64,
}

impl Recorder {
    pub(super) fn new(origin: Origin, log: Log, end: u64) -> Self {
        let origin = Some(Box::new(origin));
        Self { origin, log, end }
    }

    pub fn is_on(&self) -> bool {
        self.origin.is_some()
    }

    /// The first input that has not been applied.
    pub(super) fn next(&self, active_inputs: &ActiveInputs) -> Option<&Record> {
        self.log.records.get(active_inputs.done as usize)
    }

    pub(super) fn write(&self, origin: &Origin, note: &str) -> Vec<u8> {
        let mut body = Writer::default();
        bytes::write(&mut body, origin, &self.log, self.end, note);
        bytes::seal(body)
    }
}
