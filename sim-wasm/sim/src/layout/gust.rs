//! A gust: a blow and its age.

use crate::layout::blow::Blow;
use crate::layout::bytes::Writer;

/// Maximum number of active gusts. One more replaces the oldest.
pub const MAX_GUSTS: usize = 16;

/// An active gust.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Gust {
    pub blow: Blow,
    /// Age in steps.
    pub age: u16,
}

impl Gust {
    /// Strength in the coming step, 0..=1: 16 s^2 (1 - s)^2 for the elapsed share s of its duration.
    pub fn level(&self) -> f32 {
        let share = (f32::from(self.age) + 0.5) / f32::from(self.blow.steps);
        let bell = 4.0 * share * (1.0 - share);
        bell * bell
    }

    pub(crate) fn write(&self, body: &mut Writer) {
        self.blow.write(body);
        body.short(self.age);
    }
}
