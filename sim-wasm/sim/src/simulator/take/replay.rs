//! Export, replay and rewind of takes.

use crate::layout::error::RestoreError;
use crate::math::random::Random;
use crate::simulator::snapshot::RestoredCapacity;
use crate::simulator::take::bytes;
use crate::simulator::take::bytes::Take;
use crate::simulator::take::live::origin_of;
use crate::simulator::take::origin::Origin;
use crate::simulator::take::recorder::Recorder;
use crate::simulator::{Simulator, snapshot};

impl Simulator {
    /// Serialises the take with a note of at most 64 KiB. Fails if nothing is recorded.
    pub fn take(&self, note: &str) -> Result<Vec<u8>, RestoreError> {
        if note.len() > bytes::MAX_NOTE {
            return Err(RestoreError::new("the note is too long for a take"));
        }
        Ok(self.recorder.write(self.origin()?, note))
    }

    /// Goes to the start of a take; the following steps apply its inputs. A take of a fresh scene requires a simulator
    /// that records a take of the same fresh scene. Damaged bytes, or bytes of another scene, are an error and change
    /// nothing.
    pub fn replay(&mut self, take: &[u8]) -> Result<(), RestoreError> {
        let Take { origin, log, end, .. } = Take::parse(take)?;
        if origin.is_fresh {
            self.start_afresh(&origin)?;
        } else {
            snapshot::restore(self, &origin.state, RestoredCapacity::Saved, true)?;
        }
        self.active_inputs.done = 0;
        // The simulator's own state: a parsed fresh take has none.
        self.recorder = Recorder::new(origin_of(self), log, end);
        self.apply_due_inputs();
        Ok(())
    }

    /// Goes to a saved state within the take, or to its start. The following steps apply the inputs after it. On error
    /// nothing changes.
    pub fn rewind(&mut self, state: Option<&[u8]>) -> Result<(), RestoreError> {
        let recorder = std::mem::take(&mut self.recorder);
        let start = recorder.origin.as_ref().map(|origin| origin.state.as_slice());
        let result = match state.or(start) {
            Some(bytes) => snapshot::restore(self, bytes, RestoredCapacity::Saved, true),
            None => Err(nothing_recorded()),
        };
        if result.is_ok() {
            let done = if state.is_some() { self.active_inputs.done } else { 0 };
            self.active_inputs.done = done.min(recorder.log.len() as u32);
        }
        self.recorder = recorder;
        self.apply_due_inputs();
        result
    }

    fn origin(&self) -> Result<&Origin, RestoreError> {
        self.recorder.origin.as_deref().ok_or_else(nothing_recorded)
    }

    /// Restores the initial scene with the seed, the capacity and the parameters of the take.
    fn start_afresh(&mut self, take: &Origin) -> Result<(), RestoreError> {
        let own = self.origin()?;
        if !own.is_fresh || own.scene != take.scene {
            return Err(RestoreError::new(
                "the take was made in another scene; set up the scene that it was made in",
            ));
        }
        let start = own.state.clone();
        snapshot::restore(self, &start, RestoredCapacity::Saved, true)?;
        self.resize(take.capacity).map_err(RestoreError::from)?;
        (self.seed, self.random, self.parameters) = (take.seed, Random::new(take.seed), take.parameters);
        self.take_over_parameters();
        Ok(())
    }
}

fn nothing_recorded() -> RestoreError {
    RestoreError::new("no take is recorded; call record() first")
}
