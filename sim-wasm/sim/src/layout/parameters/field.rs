//! Description of a parameter, and access to its value.

/// Description of a parameter.
#[derive(Clone, Copy, Debug)]
pub struct Meta {
    /// Key after the section's name, such as `coreRadius`. The numbers of a vector add `.x`, `.y` and `.z`.
    pub key: &'static str,
    /// Unit, `1` for plain numbers.
    #[cfg(not(target_family = "wasm"))]
    pub unit: &'static str,
    pub min: f64,
    pub max: f64,
    /// Default value. A single number uses the first element; stops have the same one.
    pub default: [f64; 3],
    /// Accepts whole numbers only.
    pub whole: bool,
    /// Left out of saved parameters while it has its default.
    pub rare: bool,
    /// Names of the values 0, 1, ...; empty for a count. Native builds only, as all text.
    #[cfg(not(target_family = "wasm"))]
    pub names: &'static [&'static str],
    /// Initial value in a newly added item, if the default has no effect.
    #[cfg(not(target_family = "wasm"))]
    pub start: Option<f64>,
    /// Short label of a user interface.
    #[cfg(not(target_family = "wasm"))]
    pub label: &'static str,
    /// One sentence on the effect of the parameter.
    #[cfg(not(target_family = "wasm"))]
    pub text: &'static str,
}

/// A parameter of an item.
#[derive(Clone, Copy, Debug)]
pub struct Field {
    pub meta: Meta,
    /// Key suffix of each of its numbers.
    pub parts: &'static [&'static str],
    /// Offset of its first number in the item (bytes).
    pub offset: usize,
}

/// Maximum number of stops of a curve.
pub const MAX_STOPS: usize = 8;
/// The packed stops of a curve; see [`stops`].
pub type Stops = [f64; MAX_STOPS];

/// Maximum number of points of a stroke.
pub const MAX_POINTS: usize = 24;
/// The packed points of a stroke; see [`points`].
pub type Points = [f64; MAX_POINTS];

/// Key suffixes of the numbers of a vector, of stops, and of points.
const PARTS: [&str; 3] = [".x", ".y", ".z"];
const STOPS: [&str; MAX_STOPS] = [".0", ".1", ".2", ".3", ".4", ".5", ".6", ".7"];
const POINTS: [&str; MAX_POINTS] = [
    ".0", ".1", ".2", ".3", ".4", ".5", ".6", ".7", ".8", ".9", ".10", ".11", ".12", ".13", ".14", ".15", ".16", ".17",
    ".18", ".19", ".20", ".21", ".22", ".23",
];

impl Meta {
    /// Default value of number `part`.
    pub fn default(&self, part: usize) -> f64 {
        self.default[part.min(2)]
    }
}

impl Field {
    #[cfg_attr(
        target_family = "wasm",
        allow(unused_variables, reason = "words stay out of the module")
    )]
    const fn new(
        key: &'static str,
        unit: &'static str,
        range: [f64; 2],
        default: [f64; 3],
        parts: &'static [&'static str],
        offset: usize,
    ) -> Self {
        let meta = Meta {
            key,
            #[cfg(not(target_family = "wasm"))]
            unit,
            min: range[0],
            max: range[1],
            default,
            whole: false,
            rare: false,
            #[cfg(not(target_family = "wasm"))]
            names: &[],
            #[cfg(not(target_family = "wasm"))]
            start: None,
            #[cfg(not(target_family = "wasm"))]
            label: "",
            #[cfg(not(target_family = "wasm"))]
            text: "",
        };
        Self { meta, parts, offset }
    }

    /// Accepts whole numbers only.
    pub const fn whole(mut self) -> Self {
        self.meta.whole = true;
        self
    }

    /// Left out of saved parameters while it has its default.
    pub const fn rare(mut self) -> Self {
        self.meta.rare = true;
        self
    }

    /// Names the values 0, 1, ...; the range must match.
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

    /// Sets the initial value in a newly added item.
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

    /// Sets the label and the sentence of a user interface.
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
}

/// A parameter of one number at an offset (bytes) in its item.
pub const fn number(key: &'static str, unit: &'static str, range: [f64; 2], default: f64, offset: usize) -> Field {
    Field::new(key, unit, range, [default; 3], &[""], offset)
}

/// A parameter of three numbers with the same range.
pub const fn vector(key: &'static str, unit: &'static str, range: [f64; 2], default: [f64; 3], offset: usize) -> Field {
    Field::new(key, unit, range, default, &PARTS, offset)
}

/// Steps of the age and of the value of a packed stop.
pub const STOP_STEPS: f64 = 65_535.0;
/// Factor on the value of a packed stop.
pub const STOP_VALUE: f64 = 131_072.0;

/// The packed stops of a curve over life. 0 is no stop; others are 1 + age + [`STOP_VALUE`] * value, both in
/// [`STOP_STEPS`].
pub const fn stops(key: &'static str, offset: usize) -> Field {
    let range = [0.0, 1.0 + STOP_STEPS + STOP_VALUE * STOP_STEPS];
    Field::new(key, "1", range, [0.0; 3], &STOPS, offset).whole().rare()
}

/// Number of values of a coordinate of a packed point, in millimetres from half of it below 0.
pub const POINT_RANGE: f64 = 200_000.0;

/// The packed points of a stroke. 0 is no point; others are x + [`POINT_RANGE`] * (y + [`POINT_RANGE`] * z), each in
/// millimetres from -100 m.
pub const fn points(key: &'static str, offset: usize) -> Field {
    let range = [0.0, POINT_RANGE * POINT_RANGE * POINT_RANGE - 1.0];
    Field::new(key, "1", range, [0.0; 3], &POINTS, offset).whole().rare()
}

/// Numbers of a packed outline.
pub const OUTLINE_NUMBERS: usize = 128;
/// Characters in one number of a packed outline.
pub const OUTLINE_CHARACTERS: u32 = 8;
/// Values of a character in a packed outline: 0 for none, 1 to 64 for the digits of base64url, 65 for `.`, 66 for `;`.
pub const OUTLINE_RADIX: u64 = 67;

/// Key suffixes of the numbers of an outline, `.000` to `.127`.
static OUTLINE_NAMES: [[u8; 4]; OUTLINE_NUMBERS] = {
    let mut names = [*b".000"; OUTLINE_NUMBERS];
    let mut index = 0;
    while index < OUTLINE_NUMBERS {
        names[index][1] += (index / 100) as u8;
        names[index][2] += (index / 10 % 10) as u8;
        names[index][3] += (index % 10) as u8;
        index += 1;
    }
    names
};
static OUTLINE: [&str; OUTLINE_NUMBERS] = {
    let mut parts = [""; OUTLINE_NUMBERS];
    let mut index = 0;
    while index < OUTLINE_NUMBERS {
        if let Ok(name) = std::str::from_utf8(&OUTLINE_NAMES[index]) {
            parts[index] = name;
        }
        index += 1;
    }
    parts
};

/// The text of an outline, packed into numbers of [`OUTLINE_CHARACTERS`]. The first character is the lowest digit to the
/// base [`OUTLINE_RADIX`].
pub const fn outline(key: &'static str, offset: usize) -> Field {
    let range = [0.0, (OUTLINE_RADIX.pow(OUTLINE_CHARACTERS) - 1) as f64];
    Field::new(key, "1", range, [0.0; 3], &OUTLINE, offset).whole().rare()
}

/// Range of a world position (m), the same as for objects of a three.js scene.
pub const PLACE: [f64; 2] = [-5000.0, 5000.0];
/// Range of a component of a direction of any length.
pub const DIRECTION: [f64; 2] = [-1.0, 1.0];
/// Range of a length above 0 (m).
pub const LENGTH: [f64; 2] = [0.001, 1000.0];
/// Range of a share.
pub const SHARE: [f64; 2] = [0.0, 1.0];
