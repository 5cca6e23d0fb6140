//! Sections of the table: groups of parameters that exist once, and lists of items that have the same parameters.

use super::field::{Field, Meta};
use super::{LIST_LIMIT, Parameters};
use crate::scope::Scope;

/// A group of parameters with a place in the table.
pub trait Item: Copy + Default + 'static {
    /// Its parameters in their order.
    const FIELDS: &'static [Field<Self>];

    /// What people call one item of its list.
    const LABEL: &'static str = "";

    /// What a page gives an item that somebody adds, of the scope's parameters: keys as in the scope, and values.
    const STARTS: &'static [(&'static str, f64)] = &[];

    /// The parameters of a scope that apply to it, if it has one; they follow its own.
    const SCOPE: &'static [Field<Scope>] = Scope::FIELDS;

    /// Where, when and on what it acts, if that can be chosen.
    fn scope(&mut self) -> Option<&mut Scope> {
        None
    }
}

/// An item with the defaults of the table.
// A call of its own, or every list would have its copy of how a scope is made.
#[inline(never)]
pub fn item<I: Item>() -> I {
    let mut item = I::default();
    for field in I::FIELDS {
        for part in 0..field.parts().len() {
            *field.value(&mut item, part) = field.meta.default[part];
        }
    }
    if let Some(scope) = item.scope() {
        *scope = self::item();
    }
    item
}

/// Items `0..len` exist.
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
    /// The items that exist.
    pub fn items(&self) -> &[I] {
        &self.items[..self.len]
    }
}

/// A parameter of a section, by its numbers.
#[derive(Clone, Copy, Debug)]
pub struct Slot {
    pub field: usize,
    pub part: usize,
}

/// A section, whatever its items are.
pub trait Section: Sync {
    /// What its keys begin with.
    fn name(&self) -> &'static str;

    /// Whether its keys have an index behind the name.
    fn is_list(&self) -> bool;

    /// What people call one of its items.
    fn label(&self) -> &'static str;

    /// What a page gives an item that somebody adds, where the parameter of this key says nothing itself.
    #[cfg(not(target_family = "wasm"))]
    fn start(&self, key: &str) -> Option<f64>;

    /// How many items exist: 1 where it is no list.
    fn len(&self, parameters: &Parameters) -> usize;

    /// Makes items `0..len` exist, and those beyond too that exist already.
    fn lengthen(&self, parameters: &mut Parameters, len: usize);

    /// What there is to say about parameter number `field`, and the ends of its keys; none beyond the last.
    fn meta(&self, field: usize) -> Option<(&'static Meta, &'static [&'static str])>;

    /// The value in item `index`.
    fn value<'p>(&self, parameters: &'p mut Parameters, index: usize, slot: Slot) -> &'p mut f64;
}

/// A section that exists once.
pub struct Single<I: Item> {
    pub name: &'static str,
    pub of: fn(&mut Parameters) -> &mut I,
}

/// A section that is a list.
pub struct Many<I: Item> {
    pub name: &'static str,
    pub of: fn(&mut Parameters) -> &mut List<I>,
    pub len: fn(&Parameters) -> usize,
}

impl<I: Item> Section for Single<I> {
    fn name(&self) -> &'static str {
        self.name
    }

    fn is_list(&self) -> bool {
        false
    }

    fn label(&self) -> &'static str {
        I::LABEL
    }

    #[cfg(not(target_family = "wasm"))]
    fn start(&self, key: &str) -> Option<f64> {
        start::<I>(key)
    }

    fn len(&self, _parameters: &Parameters) -> usize {
        1
    }

    fn lengthen(&self, _parameters: &mut Parameters, _len: usize) {}

    fn meta(&self, field: usize) -> Option<(&'static Meta, &'static [&'static str])> {
        meta::<I>(field)
    }

    fn value<'p>(&self, parameters: &'p mut Parameters, _index: usize, slot: Slot) -> &'p mut f64 {
        value((self.of)(parameters), slot)
    }
}

impl<I: Item> Section for Many<I> {
    fn name(&self) -> &'static str {
        self.name
    }

    fn is_list(&self) -> bool {
        true
    }

    fn label(&self) -> &'static str {
        I::LABEL
    }

    #[cfg(not(target_family = "wasm"))]
    fn start(&self, key: &str) -> Option<f64> {
        start::<I>(key)
    }

    fn len(&self, parameters: &Parameters) -> usize {
        (self.len)(parameters)
    }

    fn lengthen(&self, parameters: &mut Parameters, len: usize) {
        let list = (self.of)(parameters);
        list.len = list.len.max(len);
    }

    fn meta(&self, field: usize) -> Option<(&'static Meta, &'static [&'static str])> {
        meta::<I>(field)
    }

    fn value<'p>(&self, parameters: &'p mut Parameters, index: usize, slot: Slot) -> &'p mut f64 {
        value(&mut (self.of)(parameters).items[index], slot)
    }
}

#[cfg(not(target_family = "wasm"))]
fn start<I: Item>(key: &str) -> Option<f64> {
    I::STARTS
        .iter()
        .find(|(named, _)| *named == key)
        .map(|(_, value)| *value)
}

/// The parameters of a scope that `I` has.
fn scope_fields<I: Item>() -> &'static [Field<Scope>] {
    if I::default().scope().is_some() { I::SCOPE } else { &[] }
}

fn meta<I: Item>(field: usize) -> Option<(&'static Meta, &'static [&'static str])> {
    if let Some(own) = I::FIELDS.get(field) {
        return Some((&own.meta, own.parts()));
    }
    let shared = scope_fields::<I>().get(field - I::FIELDS.len())?;
    Some((&shared.meta, shared.parts()))
}

fn value<I: Item>(item: &mut I, slot: Slot) -> &mut f64 {
    match I::FIELDS.get(slot.field) {
        Some(field) => field.value(item, slot.part),
        None => {
            let scope = item.scope().expect("only a scope has fields beyond an item's own");
            I::SCOPE[slot.field - I::FIELDS.len()].value(scope, slot.part)
        }
    }
}
