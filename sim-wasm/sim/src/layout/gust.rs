//! A gust: a blow and how long it has blown.

use crate::layout::blow::Blow;
use crate::layout::bytes::Writer;

/// Most gusts that blow at once; a further one replaces that which has blown longest.
pub const MAX_GUSTS: usize = 16;

/// A gust on its way.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Gust {
    pub blow: Blow,
    /// Steps that it has blown.
    pub age: u16,
}

impl Gust {
    /// How strongly it blows in the coming step, 0..=1: 16 s^2 (1 - s)^2 of the share s of its time.
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
