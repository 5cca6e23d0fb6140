//! Numbers kept within bounds that are only known at run time.

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
