//! The layout of a view: the numbers that callers of `arrange` give. `npm run generate` writes `src/simulator/layout.ts` from
//! it.
//!
//! The balls of all variations can follow: for each variation their x, y, z and radii, in particle radii. Behind them
//! can follow the tables of the start caps of all variations, see `coverage::start_caps`.

/// Maximum number of boxes of surfaces that lift ink.
pub const LIFTERS_LIMIT: usize = 8;

/// Defines [`ViewNumbers`] and [`VIEW_PARTS`] from the same list.
macro_rules! view_numbers {
    ($($(#[doc = $text:literal])* $name:ident: $Part:ty,)*) => {
        /// The numbers of a view in the order in which callers give them.
        #[derive(Clone, Copy, Debug, Default, PartialEq)]
        #[repr(C)]
        pub struct ViewNumbers {
            $($(#[doc = $text])* pub $name: $Part,)*
        }

        /// Name and count of numbers of each part of a view, in order.
        #[cfg(not(target_family = "wasm"))]
        pub const VIEW_PARTS: &[(&str, usize)] =
            &[$((stringify!($name), size_of::<$Part>() / size_of::<f32>()),)*];

        impl ViewNumbers {
            /// Place of the lamp, if the view is that of one.
            pub fn place_of_lamp(&self) -> Option<[f32; 3]> {
                (self.purpose == 2.0).then_some(self.lamp)
            }

            /// Reads the numbers that start a view.
            pub fn read(numbers: &[f32; VIEW_LENGTH]) -> Self {
                let mut numbers = numbers.iter();
                Self {
                    $($name: Part::read(&mut numbers),)*
                }
            }

            /// The numbers, as callers give them.
            pub fn to_array(&self) -> [f32; VIEW_LENGTH] {
                let mut all = [0.0; VIEW_LENGTH];
                let mut numbers = all.iter_mut();
                $(self.$name.write(&mut numbers);)*
                all
            }
        }
    };
}

view_numbers! {
    /// 0 for the bodies of the eye, 1 for the casters of a sun, 2 for those of a lamp.
    purpose: f32,
    /// Interpolation between the previous step (0) and now (1).
    blend: f32,
    /// 1 to cull, else 0.
    cull: f32,
    /// Metres added to each radius per unit of clip w.
    pad: f32,
    /// Matrix by columns.
    clip_from_world: [f32; 16],
    /// Direction of the order: a unit vector. For a lamp, the direction towards the middle of the smoke.
    direction: [f32; 3],
    /// Factor on each radius.
    reach: f32,
    /// Box of the receivers (m), minimum corner, then maximum corner.
    receivers: [f32; 6],
    /// Metres that a pixel spans per unit of clip w. This part and those that follow serve coverage, see `coverage`.
    pixel: f32,
    /// Depth (m) of the near plane along the direction.
    nearest: f32,
    /// Depth (m) of the far plane along the direction.
    farthest: f32,
    /// Number of covers that hide what is behind them, 1 to 16. 0 turns coverage off.
    covers: f32,
    /// Maximum distance between what is drawn and the solids, in radii.
    tolerance: f32,
    /// The same distance in pixels, added to it.
    blur: f32,
    /// 1 if puffs turn to the eye; 2 if the balls are discs that such puffs turn to the light; else 0.
    faces_eye: f32,
    /// Metres by which a surface can lift ink in front of its lobe, per unit of clip w.
    lift: f32,
    /// Minimum and maximum distance behind the centre at which shadows start, in radii.
    cap_range: [f32; 2],
    /// Maximum depth behind its centre at which a puff is visible, in radii.
    depth: f32,
    /// Balls of each variation, 0, 4, 8 or 12.
    balls: f32,
    /// Number of boxes of surfaces that lift ink.
    lifters: f32,
    /// These boxes (m), each as minimum corner and maximum corner.
    lifter_boxes: [[f32; 6]; LIFTERS_LIMIT],
    /// 1 if the tables of the start caps follow the balls, else 0.
    caps_follow: f32,
    /// Place (m) of a lamp.
    lamp: [f32; 3],
    /// Sides from which each variation is drawn, up to 8; 0 as 1. The seed selects the side of a puff. In rows the number
    /// of the variation is that of the side: variation * sides + side.
    sides: f32,
    /// Share of the roll of puffs that is left out: 0 none, 1 puffs stand upright.
    upright: f32,
}

/// Count of the numbers of a view, without its solids.
pub const VIEW_LENGTH: usize = size_of::<ViewNumbers>() / size_of::<f32>();

/// One number, or an array of parts.
trait Part {
    fn read<'n>(numbers: &mut impl Iterator<Item = &'n f32>) -> Self;

    fn write<'n>(&self, numbers: &mut impl Iterator<Item = &'n mut f32>);
}

impl Part for f32 {
    fn read<'n>(numbers: &mut impl Iterator<Item = &'n f32>) -> Self {
        numbers.next().copied().unwrap_or_default()
    }

    fn write<'n>(&self, numbers: &mut impl Iterator<Item = &'n mut f32>) {
        if let Some(number) = numbers.next() {
            *number = *self;
        }
    }
}

impl<P: Part, const N: usize> Part for [P; N] {
    fn read<'n>(numbers: &mut impl Iterator<Item = &'n f32>) -> Self {
        std::array::from_fn(|_| P::read(numbers))
    }

    fn write<'n>(&self, numbers: &mut impl Iterator<Item = &'n mut f32>) {
        self.iter().for_each(|part| part.write(numbers));
    }
}
