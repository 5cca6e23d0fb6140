//! The parameters that the simulator reads, by the flat keys of the share link.
//!
//! One table names every key with its range, default and unit. `#` stands for an index 0..7 of a list; a list is as
//! long as the greatest index that was ever set, and empty before. Values are checked before anything is changed.

use crate::error::ParameterError;

mod table;
pub use table::{ROWS, Row};

/// Most items of each list: emitters, vortices, colliders.
pub const LIST_LIMIT: usize = 8;

/// One of the three lists.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ListName {
    Emitters,
    Vortices,
    Colliders,
}

/// Items `0..len` exist.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct List<Item> {
    items: [Item; LIST_LIMIT],
    len: usize,
}

impl<Item> List<Item> {
    /// The items that exist.
    pub fn items(&self) -> &[Item] {
        &self.items[..self.len]
    }
}

/// `emission.*` and `puff.*`: what holds for all emitters.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Emission {
    pub rate: f64,
    pub lifetime: f64,
    pub growth_time: f64,
    pub puff_size: f64,
    pub puff_variations: f64,
}

/// `forces.*`: multipliers, and the wind itself.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Forces {
    pub gravity: f64,
    pub buoyancy: f64,
    pub turbulence: f64,
    pub vortex: f64,
    pub drag: f64,
    pub wind: [f64; 3],
}

/// `buoyancy.*`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Buoyancy {
    pub acceleration: f64,
    pub cooling_time: f64,
}

/// `turbulence.*`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Turbulence {
    pub speed: f64,
    pub scale: f64,
    pub octaves: f64,
    pub evolution: f64,
}

/// `emitters.#.*`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Emitter {
    pub shape: f64,
    pub position: [f64; 3],
    pub direction: [f64; 3],
    pub radius: f64,
    pub speed: f64,
    pub speed_variation: f64,
    pub spread: f64,
    pub size: f64,
    pub size_variation: f64,
    pub lifetime_variation: f64,
    pub temperature: f64,
    pub share: f64,
}

/// `vortices.#.*`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Vortex {
    pub position: [f64; 3],
    pub axis: [f64; 3],
    pub circulation: f64,
    pub core_radius: f64,
    pub reach: f64,
}

/// `colliders.#.*`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Collider {
    pub shape: f64,
    pub position: [f64; 3],
    pub axis: [f64; 3],
    pub half_extents: [f64; 3],
    pub radius: f64,
    pub restitution: f64,
    pub friction: f64,
}

/// Every parameter, in the units of the table. All values are within their ranges, always.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameters {
    pub emission: Emission,
    pub forces: Forces,
    pub gravity_acceleration: f64,
    pub buoyancy: Buoyancy,
    pub drag_rate: f64,
    pub turbulence: Turbulence,
    pub integrator: f64,
    pub emitters: List<Emitter>,
    pub vortices: List<Vortex>,
    pub colliders: List<Collider>,
}

impl Default for Parameters {
    /// The defaults of the table, all lists empty.
    fn default() -> Self {
        let mut parameters = Self {
            emission: Emission::default(),
            forces: Forces::default(),
            gravity_acceleration: 0.0,
            buoyancy: Buoyancy::default(),
            drag_rate: 0.0,
            turbulence: Turbulence::default(),
            integrator: 0.0,
            emitters: List::default(),
            vortices: List::default(),
            colliders: List::default(),
        };
        for row in ROWS {
            for index in 0..row.length() {
                *row.field(&mut parameters, index) = row.default;
            }
        }
        parameters
    }
}

/// A key that was found and a value that its row accepts.
#[derive(Clone, Copy)]
struct Assignment {
    row: &'static Row,
    index: usize,
    value: f64,
}

impl Parameters {
    /// Sets one parameter. An unknown key, NaN, an infinite value or one out of range is refused by name.
    pub fn set(&mut self, key: &str, value: f64) -> Result<(), ParameterError> {
        self.assign(check(key, value)?);
        Ok(())
    }

    /// Sets all of `entries`, or none of them and tells the first that is refused.
    pub fn set_all(&mut self, entries: &[(&str, f64)]) -> Result<(), ParameterError> {
        let before = *self;
        let result = entries.iter().try_for_each(|(key, value)| self.set(key, *value));
        if result.is_err() {
            *self = before;
        }
        result
    }

    /// Every key that exists now with its value, lists in full: given to `set` one by one, they make these parameters.
    pub fn entries(&self) -> Vec<(String, f64)> {
        let mut copy = *self;
        let mut entries = Vec::new();
        for row in ROWS {
            let length = row.list.map_or(1, |list| copy.list_length(list));
            for index in 0..length {
                let key = row.key.replace('#', &index.to_string());
                entries.push((key, *row.field(&mut copy, index)));
            }
        }
        entries
    }

    fn assign(&mut self, assignment: Assignment) {
        *assignment.row.field(self, assignment.index) = assignment.value;
        let needed = assignment.index + 1;
        match assignment.row.list {
            None => {}
            Some(ListName::Emitters) => self.emitters.len = self.emitters.len.max(needed),
            Some(ListName::Vortices) => self.vortices.len = self.vortices.len.max(needed),
            Some(ListName::Colliders) => self.colliders.len = self.colliders.len.max(needed),
        }
    }

    fn list_length(&self, list: ListName) -> usize {
        match list {
            ListName::Emitters => self.emitters.len,
            ListName::Vortices => self.vortices.len,
            ListName::Colliders => self.colliders.len,
        }
    }
}

fn check(key: &str, value: f64) -> Result<Assignment, ParameterError> {
    let (row, index) = find(key).ok_or_else(|| ParameterError::unknown_key(key, value))?;
    if !(row.min..=row.max).contains(&value) {
        return Err(ParameterError::out_of_range(key, value, row.min, row.max));
    }
    if row.whole && value.fract() != 0.0 {
        return Err(ParameterError::not_whole(key, value, row.min, row.max));
    }
    // Minus zero equals zero and must do the same: adding zero makes it so.
    Ok(Assignment {
        row,
        index,
        value: value + 0.0,
    })
}

fn find(key: &str) -> Option<(&'static Row, usize)> {
    ROWS.iter().find_map(|row| Some((row, row.index_in(key)?)))
}

/// The table as text, one line a key: `key min max default whole|real unit`, for comparison with other tables.
pub fn describe() -> String {
    let line = |row: &Row| {
        let kind = if row.whole { "whole" } else { "real" };
        format!(
            "{} {} {} {} {kind} {}\n",
            row.key, row.min, row.max, row.default, row.unit
        )
    };
    ROWS.iter().map(line).collect()
}
