//! Groups of parameters, lists of groups, and the scope that many groups share.

use crate::layout::parameters::field::{Field, LENGTH, Meta, PLACE, number, vector};
use crate::layout::scope::parts::{FIRST_PART, MAX_PARTS};

/// Maximum number of items per list.
pub const LIST_LIMIT: usize = 8;

/// Attached to neither rigid nor part: fixed in world space.
pub const WORLD: f64 = -1.0;

/// The parameters of a scope without its region.
pub const WHEN_AND_ON_WHAT: &[Field<Scope>] = Scope::FIELDS.split_at(REGION_FIELDS).1;

/// Number of parameters of the region, which come first in a scope.
const REGION_FIELDS: usize = 4;

/// Number of the last part.
const LAST_PART: f64 = (FIRST_PART + MAX_PARTS - 1) as f64;

/// A group of parameters in the table.
pub trait Item: Copy + Default + 'static {
    /// The parameters in order.
    const FIELDS: &'static [Field<Self>];

    /// Label of one item of a list.
    const LABEL: &'static str = "";

    /// Initial values of scope parameters in a newly added item, by key.
    const STARTS: &'static [(&'static str, f64)] = &[];

    /// The parameters of its scope, if any. They follow its own.
    const SCOPE: &'static [Field<Scope>] = Scope::FIELDS;

    /// Parameters that follow those of the scope, because they were added later.
    const LATER: &'static [Field<Self>] = &[];

    /// The scope, if it has one.
    fn scope(&mut self) -> Option<&mut Scope> {
        None
    }
}

/// Creates an item with the default values of the table.
// Not inlined: every list would hold a copy of the construction of a scope.
#[inline(never)]
pub fn item<I: Item>() -> I {
    let mut item = I::default();
    set_defaults(&mut item, I::FIELDS);
    if !I::LATER.is_empty() {
        set_defaults(&mut item, I::LATER);
    }
    if let Some(scope) = item.scope() {
        *scope = self::item();
    }
    item
}

fn set_defaults<I>(item: &mut I, fields: &[Field<I>]) {
    for field in fields {
        for part in 0..field.parts().len() {
            *field.value(item, part) = field.meta.default(part);
        }
    }
}

/// A list of which items `0..len` exist.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct List<I> {
    items: [I; LIST_LIMIT],
    len: usize,
}

impl<I: Item> Default for List<I> {
    fn default() -> Self {
        Self {
            items: [item(); LIST_LIMIT],
            len: 0,
        }
    }
}

impl<I> List<I> {
    /// The existing items.
    pub fn items(&self) -> &[I] {
        &self.items[..self.len]
    }

    /// Extends the list to `len` items. A list never becomes shorter.
    pub(super) fn lengthen(&mut self, len: usize) {
        self.len = self.len.max(len);
    }

    /// Item `index`, below [`LIST_LIMIT`], existing or not.
    pub(super) fn item_mut(&mut self, index: usize) -> &mut I {
        &mut self.items[index]
    }
}

/// Index of a parameter in its section.
#[derive(Clone, Copy, Debug)]
pub struct Slot {
    pub field: usize,
    pub part: usize,
}

#[cfg(not(target_family = "wasm"))]
pub(super) fn start<I: Item>(key: &str) -> Option<f64> {
    I::STARTS
        .iter()
        .find(|(named, _)| *named == key)
        .map(|(_, value)| *value)
}

/// Scope parameters of `I`; empty without a scope.
fn scope_fields<I: Item>() -> &'static [Field<Scope>] {
    if I::default().scope().is_some() { I::SCOPE } else { &[] }
}

/// Description and key suffixes of parameter `field` of an item; none beyond the last.
pub(crate) fn meta<I: Item>(field: usize) -> Option<(&'static Meta, &'static [&'static str])> {
    if let Some(own) = I::FIELDS.get(field) {
        return Some((&own.meta, own.parts()));
    }
    let field = field - I::FIELDS.len();
    if let Some(shared) = scope_fields::<I>().get(field) {
        return Some((&shared.meta, shared.parts()));
    }
    let later = I::LATER.get(field - scope_fields::<I>().len())?;
    Some((&later.meta, later.parts()))
}

/// Mutable access to a parameter of an item.
pub(crate) fn value<I: Item>(item: &mut I, slot: Slot) -> &mut f64 {
    if let Some(field) = I::FIELDS.get(slot.field) {
        return field.value(item, slot.part);
    }
    let field = slot.field - I::FIELDS.len();
    if let Some(later) = field.checked_sub(I::SCOPE.len()).and_then(|later| I::LATER.get(later)) {
        return later.value(item, slot.part);
    }
    let scope = item.scope().expect("only a scope has fields beyond an item's own");
    I::SCOPE[field].value(scope, slot.part)
}

/// `*.region.*`, `*.envelope.*` and `*.rigid`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Scope {
    pub shape: f64,
    pub position: [f64; 3],
    pub size: [f64; 3],
    pub softness: f64,
    pub start: f64,
    pub duration: f64,
    pub period: f64,
    pub fade: f64,
    pub rigid: f64,
}

impl Item for Scope {
    const FIELDS: &'static [Field<Self>] = &[
        number("region.shape", "1", [0.0, 3.0], 0.0, |s: &mut Self| &mut s.shape)
            .named(&["all", "sphere", "box", "capsule"])
            .says("Region", "Where it acts: everywhere, or within a shape."),
        vector("region.position", "m", PLACE, [0.0; 3], |s: &mut Self| &mut s.position)
            .says("Region position", "Centre of the region."),
        vector("region.size", "m", LENGTH, [1.0; 3], |s: &mut Self| &mut s.size).says(
            "Region size",
            "Half sides of a box. For a sphere, x is the radius. For a capsule, x is the radius and y half its straight part.",
        ),
        number("region.softness", "m", [0.0, 100.0], 0.3, |s: &mut Self| &mut s.softness)
            .says("Soft edge", "Distance outside the region over which the effect fades out."),
        number("envelope.start", "s", [0.0, 3600.0], 0.0, |s: &mut Self| &mut s.start)
            .says("Start", "Time of the first start."),
        number("envelope.duration", "s", [0.0, 3600.0], 0.0, |s: &mut Self| &mut s.duration)
            .says("Duration", "Time from a start to its end; 0 never ends."),
        number("envelope.period", "s", [0.0, 3600.0], 0.0, |s: &mut Self| &mut s.period)
            .says("Period", "Time from one start to the next; 0 starts only once."),
        number("envelope.fade", "s", [0.0, 60.0], 0.0, |s: &mut Self| &mut s.fade)
            .says("Fade time", "Time to fade in after a start and to fade out before the end."),
        number("rigid", "1", [WORLD, LAST_PART], WORLD, |s: &mut Self| &mut s.rigid)
            .whole()
            .says(
                "Attached to",
                "Number of the rigid that it follows, or 4096 plus the number of a moving part; -1 follows nothing.",
            ),
    ];
}
