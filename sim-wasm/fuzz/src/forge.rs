//! Envelopes as the simulator writes them, around anything.

use sim::hash::Hash;

/// Formats of this version; `seeds` finds out when they are others.
pub const SAVE_VERSION: u32 = 2;
pub const TAKE_VERSION: u32 = 1;
/// Kind, version and checksum.
pub const ENVELOPE_BYTES: usize = 16;

/// `body` behind kind, version and a checksum that holds.
pub fn sealed(kind: &[u8; 4], version: u32, body: &[u8]) -> Vec<u8> {
    let mut hash = Hash::new();
    let (words, rest) = body.as_chunks::<4>();
    words.iter().for_each(|word| hash.word(u32::from_le_bytes(*word)));
    hash.bytes(rest);
    let checksum = hash.finish().to_le_bytes();
    [kind.as_slice(), &version.to_le_bytes(), &checksum, body].concat()
}
