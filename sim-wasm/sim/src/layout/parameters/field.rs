//! What the table says about one parameter, and where the value stands.

/// What there is to say about a parameter.
#[derive(Clone, Copy, Debug)]
pub struct Meta {
    /// The key behind the section's name, such as `coreRadius`; a vector's three numbers add `.x`, `.y` and `.z`.
    pub key: &'static str,
    /// Unit, `1` for plain numbers.
    pub unit: &'static str,
    pub min: f64,
    pub max: f64,
    /// Default of a number in the first place, of a vector in all three.
    pub default: [f64; 3],
    /// Only whole numbers.
    pub whole: bool,
    /// What a whole number stands for, from 0 on; empty where it is a count. Natively only, as all words.
    #[cfg(not(target_family = "wasm"))]
    pub names: &'static [&'static str],
    /// What a newly added item of a list has instead of its default, which often means that it does nothing.
    #[cfg(not(target_family = "wasm"))]
    pub start: Option<f64>,
    /// Short name for people.
    #[cfg(not(target_family = "wasm"))]
    pub label: &'static str,
    /// One sentence: what turning it does.
    #[cfg(not(target_family = "wasm"))]
    pub text: &'static str,
}

/// A parameter of an `Item`.
pub struct Field<Item> {
    pub meta: Meta,
    accessor: Accessor<Item>,
}

enum Accessor<Item> {
    Number(fn(&mut Item) -> &mut f64),
    Vector(fn(&mut Item) -> &mut [f64; 3]),
}

/// Names of the numbers of a vector.
const PARTS: [&str; 3] = [".x", ".y", ".z"];

impl<Item> Field<Item> {
    const fn new(
        key: &'static str,
        unit: &'static str,
        range: [f64; 2],
        default: [f64; 3],
        accessor: Accessor<Item>,
    ) -> Self {
        let meta = Meta {
            key,
            unit,
            min: range[0],
            max: range[1],
            default,
            whole: false,
            #[cfg(not(target_family = "wasm"))]
            names: &[],
            #[cfg(not(target_family = "wasm"))]
            start: None,
            #[cfg(not(target_family = "wasm"))]
            label: "",
            #[cfg(not(target_family = "wasm"))]
            text: "",
        };
        Self { meta, accessor }
    }

    /// Takes whole numbers only.
    pub const fn whole(mut self) -> Self {
        self.meta.whole = true;
        self
    }

    /// Takes the numbers 0, 1, ... of these names; its range must say so too.
    #[cfg_attr(
        target_family = "wasm",
        allow(unused_variables, reason = "words stay out of the module")
    )]
    pub const fn named(mut self, names: &'static [&'static str]) -> Self {
        self.meta.whole = true;
        #[cfg(not(target_family = "wasm"))]
        {
            self.meta.names = names;
        }
        self
    }

    /// What a page gives an item that somebody adds, where the default would do nothing.
    #[cfg_attr(
        target_family = "wasm",
        allow(unused_variables, unused_mut, reason = "pages know it from the table")
    )]
    pub const fn starts_at(mut self, value: f64) -> Self {
        #[cfg(not(target_family = "wasm"))]
        {
            self.meta.start = Some(value);
        }
        self
    }

    /// What people read about it.
    #[cfg_attr(
        target_family = "wasm",
        allow(unused_variables, unused_mut, reason = "words stay out of the module")
    )]
    pub const fn says(mut self, label: &'static str, text: &'static str) -> Self {
        #[cfg(not(target_family = "wasm"))]
        {
            self.meta.label = label;
            self.meta.text = text;
        }
        self
    }

    /// How many numbers it has, and the end of the key of each.
    pub fn parts(&self) -> &'static [&'static str] {
        match self.accessor {
            Accessor::Number(_) => &[""],
            Accessor::Vector(_) => &PARTS,
        }
    }

    /// The number `part` of it.
    pub fn value<'i>(&self, item: &'i mut Item, part: usize) -> &'i mut f64 {
        match self.accessor {
            Accessor::Number(of) => of(item),
            Accessor::Vector(of) => &mut of(item)[part],
        }
    }
}

/// A parameter that is one number.
pub const fn number<Item>(
    key: &'static str,
    unit: &'static str,
    range: [f64; 2],
    default: f64,
    of: fn(&mut Item) -> &mut f64,
) -> Field<Item> {
    Field::new(key, unit, range, [default; 3], Accessor::Number(of))
}

/// A parameter that is three numbers of the same range.
pub const fn vector<Item>(
    key: &'static str,
    unit: &'static str,
    range: [f64; 2],
    default: [f64; 3],
    of: fn(&mut Item) -> &mut [f64; 3],
) -> Field<Item> {
    Field::new(key, unit, range, default, Accessor::Vector(of))
}

/// Any place in the world (m).
pub const PLACE: [f64; 2] = [-1000.0, 1000.0];
/// A part of a direction, whose length does not matter.
pub const DIRECTION: [f64; 2] = [-1.0, 1.0];
/// A length that must not be 0 (m).
pub const LENGTH: [f64; 2] = [0.001, 1000.0];
/// A share of a whole.
pub const SHARE: [f64; 2] = [0.0, 1.0];
