//! Groups of parameters, lists of groups, and the scope that many groups share.

use std::mem::offset_of;

use bytemuck::{Pod, Zeroable};

use crate::layout::parameters::field::{Field, LENGTH, PLACE, number, vector};
use crate::layout::scope::parts::{FIRST_PART, MAX_PARTS};

/// Maximum number of items per list.
pub const LIST_LIMIT: usize = 8;

/// Attached to neither rigid nor part: fixed in world space.
pub const WORLD: f64 = -1.0;

/// The parameters of a scope without its region.
pub const WHEN_AND_ON_WHAT: &[Field] = Scope::FIELDS.split_at(REGION_FIELDS).1;

/// Number of parameters of the region, which come first in a scope.
const REGION_FIELDS: usize = 4;

/// Number of the last part.
const LAST_PART: f64 = (FIRST_PART + MAX_PARTS - 1) as f64;

/// Parameters of a struct within an item.
#[derive(Clone, Copy, Debug)]
pub struct Group {
    /// Offset of the struct in the item (bytes).
    offset: usize,
    fields: &'static [Field],
}

impl Group {
    /// The parameters `fields` of a struct at an offset (bytes) in the item.
    pub const fn new(offset: usize, fields: &'static [Field]) -> Self {
        Self { offset, fields }
    }
}

/// The parameters of an item, in order: its own, those of its scope, later ones.
pub type Groups = [Group; 3];

/// A group of parameters in the table, all of them numbers.
pub trait Item: Pod + Default {
    /// The parameters in order.
    const FIELDS: &'static [Field];

    /// Label of one item of a list.
    const LABEL: &'static str = "";

    /// Initial values of scope parameters in a newly added item, by key.
    const STARTS: &'static [(&'static str, f64)] = &[];

    /// The parameters of its scope, if it has one. They follow its own.
    const SCOPE: Group = Group::new(0, &[]);

    /// Parameters that follow those of the scope, because they were added later.
    const LATER: &'static [Field] = &[];

    /// All of them.
    const GROUPS: Groups = [Group::new(0, Self::FIELDS), Self::SCOPE, Group::new(0, Self::LATER)];
}

/// The parameters in order, each with the index of its first number among the numbers of an item.
pub(crate) fn fields(groups: &Groups) -> impl Iterator<Item = (&'static Field, usize)> {
    let of_group = |group: &Group| {
        let offset = group.offset;
        let place = move |field: &'static Field| (field, (offset + field.offset) / size_of::<f64>());
        group.fields.iter().map(place)
    };
    groups.iter().flat_map(of_group)
}

/// The numbers of items.
pub(crate) fn numbers<I: Item>(items: &mut [I]) -> &mut [f64] {
    bytemuck::cast_slice_mut(items)
}

/// A list of which items `0..len` exist.
#[derive(Clone, Copy, Debug, PartialEq, Zeroable)]
pub struct List<I> {
    pub(super) items: [I; LIST_LIMIT],
    pub(super) len: usize,
}

impl<I> List<I> {
    /// The existing items.
    pub fn items(&self) -> &[I] {
        &self.items[..self.len]
    }
}

/// `*.region.*`, `*.envelope.*` and `*.rigid`.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
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

impl Scope {
    /// `*.region.*`, `*.envelope.*` and `*.rigid`.
    pub const FIELDS: &'static [Field] = &[
        number("region.shape", "1", [0.0, 3.0], 0.0, offset_of!(Self, shape))
            .named(&["all", "sphere", "box", "capsule"])
            .says("Region", "Where it acts: everywhere, or within a shape."),
        vector("region.position", "m", PLACE, [0.0; 3], offset_of!(Self, position))
            .says("Region position", "Centre of the region."),
        vector("region.size", "m", LENGTH, [1.0; 3], offset_of!(Self, size)).says(
            "Region size",
            "Half sides of a box. For a sphere, x is the radius. For a capsule, x is the radius and y half its straight part.",
        ),
        number("region.softness", "m", [0.0, 100.0], 0.3, offset_of!(Self, softness))
            .says("Soft edge", "Distance outside the region over which the effect fades out."),
        number("envelope.start", "s", [0.0, 3600.0], 0.0, offset_of!(Self, start))
            .says("Start", "Time of the first start."),
        number("envelope.duration", "s", [0.0, 3600.0], 0.0, offset_of!(Self, duration))
            .says("Duration", "Time from a start to its end; 0 never ends."),
        number("envelope.period", "s", [0.0, 3600.0], 0.0, offset_of!(Self, period))
            .says("Period", "Time from one start to the next; 0 starts only once."),
        number("envelope.fade", "s", [0.0, 60.0], 0.0, offset_of!(Self, fade))
            .says("Fade time", "Time to fade in after a start and to fade out before the end."),
        number("rigid", "1", [WORLD, LAST_PART], WORLD, offset_of!(Self, rigid))
            .whole()
            .says(
                "Attached to",
                "Number of the rigid that it follows, or 4096 plus the number of a moving part; -1 follows nothing.",
            ),
    ];
}
