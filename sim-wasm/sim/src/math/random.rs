//! Seeded random numbers: PCG32 (XSH RR, 64 bits of state), after O'Neill, "PCG: A Family of Simple Fast
//! Space-Efficient Statistically Good Algorithms for Random Number Generation", HMC-CS-2014-0905.

const MULTIPLIER: u64 = 6_364_136_223_846_793_005;
const INCREMENT: u64 = 1_442_695_040_888_963_407;

/// A stream of random numbers. Equal seeds give equal streams.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Random {
    state: u64,
}

impl Random {
    /// The stream of `seed`.
    pub fn new(seed: u32) -> Self {
        let mut random = Self {
            state: u64::from(seed).wrapping_add(INCREMENT),
        };
        random.bits();
        random
    }

    /// The state to save.
    pub fn state(self) -> u64 {
        self.state
    }

    /// Continues a stream from a saved state.
    pub fn from_state(state: u64) -> Self {
        Self { state }
    }

    /// 32 random bits.
    pub fn bits(&mut self) -> u32 {
        let old = self.state;
        self.state = old.wrapping_mul(MULTIPLIER).wrapping_add(INCREMENT);
        let mixed = (((old >> 18) ^ old) >> 27) as u32;
        mixed.rotate_right((old >> 59) as u32)
    }

    /// Uniform in 0..1, 24 bits, never 1.
    pub fn unit(&mut self) -> f32 {
        (self.bits() >> 8) as f32 * (1.0 / 16_777_216.0)
    }

    /// Uniform in -1..1.
    pub fn signed(&mut self) -> f32 {
        self.unit() * 2.0 - 1.0
    }

    /// A whole number in 0..`bound`. `bound` is at least 1 and small compared to 2^32.
    pub fn below(&mut self, bound: u32) -> u32 {
        ((u64::from(self.bits()) * u64::from(bound)) >> 32) as u32
    }
}

/// A uniform point in the unit ball, by rejection: needs no cube root.
pub(crate) fn in_ball(random: &mut Random) -> [f32; 3] {
    loop {
        let place = [random.signed(), random.signed(), random.signed()];
        if place.iter().map(|component| component * component).sum::<f32>() <= 1.0 {
            return place;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn same_seed_same_stream_and_other_seed_other_stream() {
        let stream = |seed| {
            let mut random = Random::new(seed);
            std::array::from_fn::<u32, 16, _>(|_| random.bits())
        };
        assert_eq!(stream(7), stream(7));
        assert_ne!(stream(7), stream(8));
    }

    #[test]
    fn unit_is_uniform() {
        let mut random = Random::new(1);
        let mut counts = [0_u32; 10];
        for _ in 0..100_000 {
            counts[(random.unit() * 10.0) as usize] += 1;
        }
        // 5 standard deviations of a binomial count of 10,000.
        assert!(counts.iter().all(|&count| count.abs_diff(10_000) < 475), "{counts:?}");
    }
}
