//! A 64-bit hash of state: FNV-1a over 32-bit words instead of bytes, four times as fast and as selective. Not for
//! untrusted input.

const OFFSET: u64 = 0xcbf2_9ce4_8422_2325;
const PRIME: u64 = 0x0000_0100_0000_01b3;

/// A hash in progress.
#[derive(Clone, Copy, Debug)]
pub struct Hash(u64);

impl Default for Hash {
    fn default() -> Self {
        Self::new()
    }
}

impl Hash {
    /// The hash of no input.
    pub fn new() -> Self {
        Self(OFFSET)
    }

    /// Adds one word.
    pub fn word(&mut self, word: u32) {
        self.0 = (self.0 ^ u64::from(word)).wrapping_mul(PRIME);
        // FNV moves bits only upwards: without this the high bits of a word affect only the high half.
        self.0 ^= self.0 >> 32;
    }

    /// Adds two words, the low one first.
    #[inline(never)]
    pub fn long(&mut self, long: u64) {
        self.word(long as u32);
        self.word((long >> 32) as u32);
    }

    /// Adds the bit patterns of `values` in order.
    #[inline(never)]
    pub fn floats(&mut self, values: &[f32]) {
        for value in values {
            self.word(value.to_bits());
        }
    }

    /// Adds `bytes` and their length.
    pub fn bytes(&mut self, bytes: &[u8]) {
        self.long(bytes.len() as u64);
        for byte in bytes {
            self.word(u32::from(*byte));
        }
    }

    /// The hash of all input so far.
    pub fn finish(self) -> u64 {
        self.0
    }
}
