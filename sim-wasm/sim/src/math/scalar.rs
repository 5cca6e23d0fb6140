//! Comparisons of single numbers.

/// `value`, or the bound that it lies beyond; what is not a number stays so.
// The library's `clamp` prints bounds that are out of order, and what prints such numbers is large.
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

/// The lesser of two numbers. `f32::min` is a function call in WASM, because it sees to what is no number.
#[inline(always)]
pub fn lesser(a: f32, b: f32) -> f32 {
    if a < b { a } else { b }
}

/// The greater of two numbers.
#[inline(always)]
pub fn greater(a: f32, b: f32) -> f32 {
    if a > b { a } else { b }
}
