//! A stable sort by a number such as depth: radix sort of 32-bit keys in three passes of 11 bits, without allocation.

const BITS: usize = 11;
const BUCKETS: usize = 1 << BITS;
const PASSES: usize = 3;

/// A key, and the index of its particle.
pub type Entry = [u32; 2];

/// Digit counts. Allocated once.
#[derive(Debug)]
pub struct Histogram(Box<[[u32; BUCKETS]; PASSES]>);

impl Histogram {
    /// Creates a histogram.
    pub fn new() -> Self {
        Self(Box::new([[0; BUCKETS]; PASSES]))
    }

    fn count(&mut self, entries: &[Entry]) {
        self.0.as_flattened_mut().fill(0);
        for [key, _] in entries {
            for pass in 0..PASSES {
                self.0[pass][digit(*key, pass)] += 1;
            }
        }
        for buckets in self.0.iter_mut() {
            let mut start = 0;
            for bucket in buckets {
                start += std::mem::replace(bucket, start);
            }
        }
    }
}

/// A key that orders like `depth`, which must not be NaN.
pub fn key(depth: f32) -> u32 {
    // Minus zero equals zero: both get the same key.
    let bits = (depth + 0.0).to_bits();
    if bits >> 31 == 1 { !bits } else { bits | 1 << 31 }
}

/// Sorts `entries` by key into `sorted`, which has the same length. Stable. Overwrites `entries`.
pub fn sort(entries: &mut [Entry], sorted: &mut [Entry], histogram: &mut Histogram) {
    histogram.count(entries);
    scatter(entries, sorted, &mut histogram.0[0], 0);
    scatter(sorted, entries, &mut histogram.0[1], 1);
    scatter(entries, sorted, &mut histogram.0[2], 2);
}

fn scatter(from: &[Entry], to: &mut [Entry], starts: &mut [u32; BUCKETS], pass: usize) {
    for entry in from {
        let place = &mut starts[digit(entry[0], pass)];
        to[*place as usize] = *entry;
        *place += 1;
    }
}

fn digit(key: u32, pass: usize) -> usize {
    (key >> (pass * BITS)) as usize & (BUCKETS - 1)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::random::Random;

    #[test]
    fn agrees_with_the_stable_sort_of_the_library() {
        let mut random = Random::new(9);
        for count in [0_usize, 1, 2, 5, 1000] {
            // Few different depths, some of them negative: stability shows in ties.
            let depths: Vec<f32> = (0..count).map(|_| (random.signed() * 20.0).round() * 0.37).collect();
            let mut entries: Vec<Entry> = (0..).zip(&depths).map(|(i, depth)| [key(*depth), i]).collect();
            let mut sorted = vec![[0; 2]; count];
            sort(&mut entries, &mut sorted, &mut Histogram::new());
            let mut expected: Vec<u32> = (0..count as u32).collect();
            expected.sort_by(|a, b| depths[*a as usize].partial_cmp(&depths[*b as usize]).unwrap());
            assert_eq!(sorted.iter().map(|entry| entry[1]).collect::<Vec<_>>(), expected);
        }
    }
}
