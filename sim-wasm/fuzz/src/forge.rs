//! Forged envelopes around arbitrary bytes.

use std::sync::OnceLock;

use sim::math::hash::Hash;

use crate::running::lively;

/// Kind, version and checksum.
pub const ENVELOPE_BYTES: usize = 16;
const KIND_AND_VERSION_BYTES: usize = 8;

/// Start of an envelope: its kind and the current version.
pub type Head = [u8; KIND_AND_VERSION_BYTES];

/// Head of saved simulations.
pub fn save() -> &'static Head {
    static HEAD: OnceLock<Head> = OnceLock::new();
    HEAD.get_or_init(|| head_of(&lively().save()))
}

/// Head of takes.
pub fn take() -> &'static Head {
    static HEAD: OnceLock<Head> = OnceLock::new();
    HEAD.get_or_init(|| head_of(&lively().take("").expect("it records")))
}

/// `body` after a head and a valid checksum.
pub fn sealed(head: &Head, body: &[u8]) -> Vec<u8> {
    let mut hash = Hash::new();
    let (words, rest) = body.as_chunks::<4>();
    words.iter().for_each(|word| hash.word(u32::from_le_bytes(*word)));
    hash.bytes(rest);
    [head.as_slice(), &hash.finish().to_le_bytes(), body].concat()
}

fn head_of(bytes: &[u8]) -> Head {
    *bytes.first_chunk().expect("an envelope has a head")
}
