//! Comparisons of scalars.

/// `value`, limited to `least`..=`greatest`; NaN stays NaN.
// `Ord::clamp` panics with its bounds in the message, and formatting numbers takes much code.
#[inline]
pub fn clamped<N: PartialOrd>(value: N, least: N, greatest: N) -> N {
    if value < least {
        least
    } else if value > greatest {
        greatest
    } else {
        value
    }
}

/// The smaller of two numbers. `f32::min` handles NaN and is a function call in WASM.
#[inline(always)]
pub fn lesser(a: f32, b: f32) -> f32 {
    if a < b { a } else { b }
}

/// The larger of two numbers.
#[inline(always)]
pub fn greater(a: f32, b: f32) -> f32 {
    if a > b { a } else { b }
}
