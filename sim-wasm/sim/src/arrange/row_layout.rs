//! The layout of rows, 32 bytes per drawn particle in two arrays. `npm run generate` writes `src/simulator/layout.ts` from it.
//!
//! place: x, y, z in world space (m) and radius (m), blended between the steps. attributes: the fields of
//! [`ATTRIBUTE_BITS`].

pub use crate::layout::limits::MAX_STRETCH;

/// Floats per row of places.
pub const PLACE_FLOATS: usize = 4;

/// Words per row of packed attributes.
pub const ATTRIBUTE_WORDS: usize = 4;

/// The packed attributes of a row.
pub type Attributes = [u32; ATTRIBUTE_WORDS];

/// A field of the packed attributes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bits {
    pub word: usize,
    /// Position of the lowest bit.
    pub shift: u32,
    /// Maximum value.
    pub max: u32,
}

impl Bits {
    const fn new(word: usize, shift: u32, count: u32) -> Self {
        let max = (1 << count) - 1;
        Self { word, shift, max }
    }

    /// The value of this field.
    #[inline(always)]
    pub const fn of(self, attributes: Attributes) -> u32 {
        attributes[self.word] >> self.shift & self.max
    }

    /// The bits of `value` in the word of this field. Drops what exceeds the field.
    #[inline(always)]
    pub const fn packed(self, value: u32) -> u32 {
        (value & self.max) << self.shift
    }
}

/// Roll with a slow spin by age, in 65,536ths of a turn.
pub const ROLL: Bits = Bits::new(0, 0, 16);
/// Age in 65,535ths of the lifetime.
pub const AGE: Bits = Bits::new(0, 16, 16);
/// In rows for the light, in the place of the age: where the shadow may end, in [`END_STEPS`] behind the centre.
pub const END: Bits = AGE;
/// Puff variation.
pub const VARIATION: Bits = Bits::new(1, 0, 8);
/// Random number of the particle.
pub const SEED: Bits = Bits::new(1, 8, 8);
/// Temperature in 255ths of [`MAX_TEMPERATURE`].
pub const TEMPERATURE: Bits = Bits::new(1, 16, 8);
/// Tint, 0 for none. A puff with a look has none, unless a collider has tinted it.
pub const TINT: Bits = Bits::new(1, 24, 4);
/// Index of the look, 0 for none.
pub const LOOK: Bits = Bits::new(1, 28, 4);

/// In rows for the light, in the place of temperature and tint: the age as in [`AGE`].
pub const CASTER_AGE: Bits = Bits::new(1, 16, 16);
/// Turn by the air, without the roll: the components of a unit quaternion x, y, z, w that follow the largest one, which is
/// positive and left out, in 1/[`QUATERNION_STEPS`], plus 512. Stored with the bits of [`NO_ROTATION`] flipped, so that 0
/// is no turn.
pub const TURN: [Bits; 3] = [Bits::new(2, 0, 10), Bits::new(2, 10, 10), Bits::new(2, 20, 10)];
/// Index of the largest component.
pub const TURN_LARGEST: Bits = Bits::new(2, 30, 2);
/// Direction of the stretch: a point of an octahedral map, -1..1 in 127ths, plus 127.
pub const STRETCH_AXIS: [Bits; 2] = [Bits::new(3, 0, 8), Bits::new(3, 8, 8)];
/// Ratio of the axes, from 1 to [`MAX_STRETCH`].
pub const STRETCH: Bits = Bits::new(3, 16, 8);
/// Erosion in 255ths. A puff that is eroded covers nothing.
pub const EROSION: Bits = Bits::new(3, 24, 8);

/// Steps of a quaternion's component per unit: the components left are at most the root of 1/2.
pub const QUATERNION_STEPS: f32 = 720.0;

/// The word of a puff that does not turn.
pub const NO_ROTATION: u32 = 3 << 30 | 512 << 20 | 512 << 10 | 512;

/// All fields by name.
#[cfg(not(target_family = "wasm"))]
pub const ATTRIBUTE_BITS: &[(&str, Bits)] = &[
    ("roll", ROLL),
    ("age", AGE),
    ("end", END),
    ("variation", VARIATION),
    ("seed", SEED),
    ("temperature", TEMPERATURE),
    ("tint", TINT),
    ("look", LOOK),
    ("casterAge", CASTER_AGE),
    ("quaternionX", TURN[0]),
    ("quaternionY", TURN[1]),
    ("quaternionZ", TURN[2]),
    ("quaternionLargest", TURN_LARGEST),
    ("stretchU", STRETCH_AXIS[0]),
    ("stretchV", STRETCH_AXIS[1]),
    ("stretch", STRETCH),
    ("erosion", EROSION),
];

/// Ends of shadows per radius.
pub const END_STEPS: f32 = 256.0;

/// The end of a shadow that continues.
pub const NO_END: u32 = END.max;

/// Temperature above which all temperatures look the same.
pub const MAX_TEMPERATURE: f32 = 4.0;
