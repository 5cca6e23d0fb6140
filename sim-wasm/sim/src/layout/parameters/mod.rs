//! Parameters of the simulator, by the flat keys of the share link.
//!
//! The table consists of sections: single groups, such as `emission.rate`, and lists, such as `vortices.0.circulation`.
//! The items of a list have the same parameters. Setting an item extends the list to its index. Values are checked
//! before anything changes.

pub mod collider;
pub mod density_stop;
pub mod emitter;
pub mod field;
pub mod forces;
pub mod item;
pub mod settings;
pub mod shedder;
pub mod table;

use crate::layout::error::ParameterError;
use crate::layout::parameters::field::Meta;
#[cfg(not(target_family = "wasm"))]
use crate::layout::parameters::field::{Field, OUTLINE_NUMBERS};
use crate::layout::parameters::table::{Section, sections};

pub use item::LIST_LIMIT;
pub use table::Parameters;

/// One number of the table. In a list it stands for all items.
#[derive(Clone, Debug)]
pub struct Row {
    /// The key; `#` stands for the index in a list.
    pub key: String,
    pub default: f64,
    pub is_of_list: bool,
    /// Unit, range and description. `meta.key` is only the last part of the key.
    pub meta: &'static Meta,
}

impl Parameters {
    /// Sets one parameter. An unknown key, or a value that is not finite or out of range, is an error.
    pub fn set(&mut self, key: &str, value: f64) -> Result<(), ParameterError> {
        let (section, index, meta, place) = find(key).ok_or_else(|| ParameterError::unknown_key(key, value))?;
        *section.number(self, index, place) = accept(key, meta, value)?;
        section.lengthen(self, index + 1);
        Ok(())
    }

    /// Sets all `entries`, or none of them and returns the first error.
    pub fn set_all(&mut self, entries: &[(&str, f64)]) -> Result<(), ParameterError> {
        *self = self.changed(entries)?;
        Ok(())
    }

    /// A copy with these entries; the error of the first invalid one.
    #[inline(never)]
    pub fn changed(&self, entries: &[(&str, f64)]) -> Result<Self, ParameterError> {
        let mut changed = *self;
        for (key, value) in entries {
            changed.set(key, *value)?;
        }
        Ok(changed)
    }

    /// All existing keys with their values, except rare ones with their defaults. Setting them on defaults reproduces
    /// these parameters.
    pub fn entries(&self) -> Vec<(String, f64)> {
        let mut copy = *self;
        let mut entries = Vec::new();
        for section in sections() {
            for index in 0..section.len(&mut copy) {
                for_each_number(section, |meta, part, end, place| {
                    let value = *section.number(&mut copy, index, place);
                    if !(meta.rare && value == meta.default(part)) {
                        entries.push((key_of(section, &index.to_string(), meta, end), value));
                    }
                });
            }
        }
        entries
    }
}

/// Checks a value of the parameter that `meta` describes.
#[inline(never)]
pub(crate) fn accept(key: &str, meta: &Meta, value: f64) -> Result<f64, ParameterError> {
    if !(meta.min..=meta.max).contains(&value) {
        return Err(ParameterError::out_of_range(key, value, meta.min, meta.max));
    }
    if meta.whole && libm::floor(value) != value {
        return Err(ParameterError::not_whole(key, value, meta.min, meta.max));
    }
    // Minus zero equals zero and must act the same: adding zero normalises it.
    Ok(value + 0.0)
}

/// The section of a parameter, the index of its item, its description and the place of its number.
fn find(key: &str) -> Option<(&'static Section, usize, &'static Meta, usize)> {
    let (name, rest) = key.split_once('.')?;
    sections().filter(|section| section.name == name).find_map(|section| {
        let (index, rest) = if section.is_list {
            let (digit, rest) = rest.split_once('.')?;
            (index(digit)?, rest)
        } else {
            (0, rest)
        };
        let (meta, place) = number_named(section, rest)?;
        Some((section, index, meta, place))
    })
}

/// Finds a number of `section` by its key after name and index.
fn number_named(section: &Section, key: &str) -> Option<(&'static Meta, usize)> {
    section.fields().find_map(|(field, place)| {
        let end = key.strip_prefix(field.meta.key)?;
        let part = field.parts.iter().position(|part| *part == end)?;
        Some((&field.meta, place + part))
    })
}

/// Parses one digit below [`LIST_LIMIT`].
fn index(text: &str) -> Option<usize> {
    let [digit] = text.as_bytes() else {
        return None;
    };
    let index = usize::from(digit.wrapping_sub(b'0'));
    (index < LIST_LIMIT).then_some(index)
}

/// Visits each number of an item: its parameter, its index and its key suffix within that, its place.
fn for_each_number(section: &Section, mut visit: impl FnMut(&'static Meta, usize, &'static str, usize)) {
    for (field, place) in section.fields() {
        for (part, end) in field.parts.iter().enumerate() {
            visit(&field.meta, part, end, place + part);
        }
    }
}

fn key_of(section: &Section, index: &str, meta: &Meta, end: &str) -> String {
    let mut key = String::from(section.name);
    if section.is_list {
        key.push('.');
        key.push_str(index);
    }
    key.push('.');
    key.push_str(meta.key);
    key.push_str(end);
    key
}

/// All numbers of the table in order.
pub fn rows() -> Vec<Row> {
    let mut rows = Vec::new();
    for section in sections() {
        for_each_number(section, |meta, part, end, _| {
            rows.push(Row {
                key: key_of(section, "#", meta, end),
                default: meta.default(part),
                is_of_list: section.is_list,
                meta,
            });
        });
    }
    rows
}

/// The lists as JSON: key, unit, range, default and names of the values of each parameter, one per line.
#[cfg(not(target_family = "wasm"))]
pub fn lists_as_json() -> String {
    lists_as_json_by(|section| {
        let lines = section
            .fields()
            .map(|(field, _)| format!("    {}", field_as_json(field)));
        format!("[\n{}\n  ]", lines.collect::<Vec<_>>().join(",\n"))
    })
}

/// What the panel says of the lists as JSON: the label of each list, and the label, the text and the value of a newly
/// added item of each parameter, one per line.
#[cfg(not(target_family = "wasm"))]
pub fn list_words_as_json() -> String {
    lists_as_json_by(|section| {
        let lines = section
            .fields()
            .map(|(field, _)| format!("      {}", words_as_json(section, &field.meta)));
        let (label, lines) = (section.label, lines.collect::<Vec<_>>().join(",\n"));
        format!("{{\n    \"label\": \"{label}\",\n    \"fields\": {{\n{lines}\n    }}\n  }}")
    })
}

#[cfg(not(target_family = "wasm"))]
fn lists_as_json_by(json: impl Fn(&Section) -> String) -> String {
    let lists = sections().filter(|section| section.is_list);
    let lists: Vec<String> = lists
        .map(|section| format!("  \"{}\": {}", section.name, json(section)))
        .collect();
    format!("{{\n{}\n}}\n", lists.join(",\n"))
}

/// The numbers of single sections as JSON: key, unit, range, default and names of the values, one per line.
#[cfg(not(target_family = "wasm"))]
pub fn singles_as_json() -> String {
    let line = |Row { key, default, meta, .. }: Row| {
        let Meta {
            unit,
            min,
            max,
            whole,
            names,
            ..
        } = meta;
        format!(
            "  \"{key}\": {{ \"unit\": \"{unit}\", \"min\": {min}, \"max\": {max}, \"default\": {default}, \"whole\": \
             {whole}, \"names\": {names:?} }}"
        )
    };
    let lines: Vec<String> = rows().into_iter().filter(|row| !row.is_of_list).map(line).collect();
    format!("{{\n{}\n}}\n", lines.join(",\n"))
}

#[cfg(not(target_family = "wasm"))]
fn field_as_json(field: &Field) -> String {
    let meta = &field.meta;
    let Meta {
        key,
        unit,
        min,
        max,
        whole,
        names,
        ..
    } = meta;
    // The characters of an outline are one text on the page, without a default.
    let numbers = field.parts.len() % OUTLINE_NUMBERS;
    let default: Vec<f64> = (0..numbers).map(|part| meta.default(part)).collect();
    format!(
        "{{ \"key\": \"{key}\", \"unit\": \"{unit}\", \"min\": {min}, \"max\": {max}, \"default\": {default:?}, \
         \"whole\": {whole}, \"names\": {names:?} }}"
    )
}

#[cfg(not(target_family = "wasm"))]
fn words_as_json(section: &Section, meta: &Meta) -> String {
    let Meta {
        key,
        start,
        label,
        text,
        ..
    } = meta;
    let of_section = || section.starts.iter().find(|(named, _)| named == key);
    let start = start.or_else(|| of_section().map(|(_, value)| *value));
    let start = start.map(|start| format!(", \"start\": {start}")).unwrap_or_default();
    format!("\"{key}\": {{ \"label\": \"{label}\", \"text\": \"{text}\"{start} }}")
}

/// The table as text with one line per key: `key min max default whole|real unit`.
#[cfg(not(target_family = "wasm"))]
pub fn describe() -> String {
    let line = |row: Row| {
        let Meta {
            min, max, unit, whole, ..
        } = row.meta;
        let kind = if *whole { "whole" } else { "real" };
        format!("{} {min} {max} {} {kind} {unit}\n", row.key, row.default)
    };
    rows().into_iter().map(line).collect()
}
