//! Little-endian serialisation, and the envelope of saved bytes. Reading past the end is an error and never panics.

use crate::layout::error::RestoreError;
use crate::math::hash::Hash;

/// A part of the state that can be serialised.
pub(crate) trait SnapshotSection: Sized {
    fn write(&self, body: &mut Writer);
    /// Reads what `write` wrote, and rejects values that `write` cannot produce.
    fn read(reader: &mut Reader) -> Result<Self, RestoreError>;
}

impl SnapshotSection for u64 {
    fn write(&self, body: &mut Writer) {
        body.long(*self);
    }

    fn read(reader: &mut Reader) -> Result<Self, RestoreError> {
        reader.long()
    }
}

impl SnapshotSection for u32 {
    fn write(&self, body: &mut Writer) {
        body.word(*self);
    }

    fn read(reader: &mut Reader) -> Result<Self, RestoreError> {
        reader.word()
    }
}

/// A growing buffer of bytes.
#[derive(Default)]
pub struct Writer(Vec<u8>);

impl Writer {
    pub fn byte(&mut self, byte: u8) {
        self.0.push(byte);
    }

    pub fn short(&mut self, short: u16) {
        self.0.extend_from_slice(&short.to_le_bytes());
    }

    #[inline(never)]
    pub fn word(&mut self, word: u32) {
        self.0.extend_from_slice(&word.to_le_bytes());
    }

    #[inline(never)]
    pub fn long(&mut self, long: u64) {
        self.0.extend_from_slice(&long.to_le_bytes());
    }

    /// Variable-length integer: seven bits per byte, lowest first.
    pub fn count(&mut self, mut count: u64) {
        while count > 0x7f {
            self.byte(count as u8 | 0x80);
            count >>= 7;
        }
        self.byte(count as u8);
    }

    pub fn number(&mut self, number: f64) {
        self.long(number.to_bits());
    }

    pub fn raw(&mut self, bytes: &[u8]) {
        self.0.extend_from_slice(bytes);
    }

    /// Bytes, preceded by their length.
    #[inline(never)]
    pub fn block(&mut self, bytes: &[u8]) {
        self.word(bytes.len() as u32);
        self.raw(bytes);
    }

    /// UTF-8 text as a block.
    pub fn text(&mut self, text: &str) {
        self.block(text.as_bytes());
    }

    /// Calls `fill` and writes the result as a block, preceded by a name of four letters.
    pub fn section(&mut self, name: &[u8; 4], fill: impl FnOnce(&mut Writer)) {
        let mut content = Writer::default();
        fill(&mut content);
        self.raw(name);
        self.block(&content.0);
    }

    pub fn finish(self) -> Vec<u8> {
        self.0
    }

    /// Adds the envelope: `kind`, `version` and a checksum.
    pub fn seal(self, kind: &[u8; 4], version: u32) -> Vec<u8> {
        let mut whole = Writer::default();
        whole.raw(kind);
        whole.word(version);
        whole.long(checksum(&self.0));
        whole.raw(&self.0);
        whole.0
    }
}

/// Reads bytes from the front.
pub struct Reader<'b>(&'b [u8]);

impl<'b> Reader<'b> {
    /// Reads bytes without an envelope.
    pub fn over(bytes: &'b [u8]) -> Self {
        Self(bytes)
    }

    /// Checks the envelope that `Writer::seal` wrote. `name` names the bytes in error messages.
    pub fn open(bytes: &'b [u8], kind: &[u8; 4], version: u32, name: &str) -> Result<Self, RestoreError> {
        let mut reader = Self(bytes);
        if reader.take()? != *kind {
            return Err(RestoreError::new(format!("these bytes are not a {name}")));
        }
        let found = reader.word()?;
        if found != version {
            return Err(RestoreError::new(format!(
                "the {name} has format {found}, this version reads {version} only"
            )));
        }
        if reader.long()? != checksum(reader.0) {
            return Err(RestoreError::new(format!(
                "the {name} is damaged; give all of its bytes"
            )));
        }
        Ok(reader)
    }

    pub fn byte(&mut self) -> Result<u8, RestoreError> {
        self.take().map(u8::from_le_bytes)
    }

    pub fn short(&mut self) -> Result<u16, RestoreError> {
        self.take().map(u16::from_le_bytes)
    }

    #[inline(never)]
    pub fn word(&mut self) -> Result<u32, RestoreError> {
        self.take().map(u32::from_le_bytes)
    }

    #[inline(never)]
    pub fn long(&mut self) -> Result<u64, RestoreError> {
        self.take().map(u64::from_le_bytes)
    }

    /// Reads what `Writer::count` wrote.
    pub fn count(&mut self) -> Result<u64, RestoreError> {
        let mut count = 0;
        for shift in (0..u64::BITS - 7).step_by(7) {
            let byte = self.byte()?;
            count |= u64::from(byte & 0x7f) << shift;
            if byte <= 0x7f {
                return Ok(count);
            }
        }
        Err(RestoreError::new("the bytes hold a number that is too large"))
    }

    /// A finite number of double precision.
    #[inline(never)]
    pub fn number(&mut self) -> Result<f64, RestoreError> {
        let number = f64::from_bits(self.long()?);
        if number.is_finite() {
            Ok(number)
        } else {
            Err(not_finite())
        }
    }

    /// A finite number of single precision.
    #[inline(never)]
    pub fn float(&mut self) -> Result<f32, RestoreError> {
        let number = f32::from_bits(self.word()?);
        if number.is_finite() {
            Ok(number)
        } else {
            Err(not_finite())
        }
    }

    /// Bytes that are preceded by their length.
    #[inline(never)]
    pub fn block(&mut self) -> Result<&'b [u8], RestoreError> {
        let length = self.word()? as usize;
        let (block, rest) = self.0.split_at_checked(length).ok_or_else(too_short)?;
        self.0 = rest;
        Ok(block)
    }

    /// UTF-8 text.
    pub fn text(&mut self) -> Result<&'b str, RestoreError> {
        let text = std::str::from_utf8(self.block()?);
        text.map_err(|_| RestoreError::new("the bytes contain invalid UTF-8"))
    }

    /// All bytes that were not read.
    pub fn rest(&mut self) -> &'b [u8] {
        std::mem::take(&mut self.0)
    }

    /// Returns true if the next section has this name.
    pub fn is_at(&self, name: &[u8; 4]) -> bool {
        self.0.starts_with(name)
    }

    /// Reads the next section with `read`. The section must have this name and be read to its end.
    pub fn section<T>(
        &mut self,
        name: &[u8; 4],
        read: impl FnOnce(&mut Reader<'b>) -> Result<T, RestoreError>,
    ) -> Result<T, RestoreError> {
        let mut content = self.enter(name)?;
        let result = read(&mut content)?;
        content.end()?;
        Ok(result)
    }

    #[inline(never)]
    fn enter(&mut self, name: &[u8; 4]) -> Result<Self, RestoreError> {
        if self.take()? != *name {
            return Err(RestoreError::new("the bytes have parts of another version"));
        }
        self.block().map(Self)
    }

    /// Checks that all bytes were read.
    #[inline(never)]
    pub fn end(&self) -> Result<(), RestoreError> {
        if self.0.is_empty() {
            Ok(())
        } else {
            Err(RestoreError::new("there are too many bytes"))
        }
    }

    fn take<const N: usize>(&mut self) -> Result<[u8; N], RestoreError> {
        let (taken, rest) = self.0.split_first_chunk::<N>().ok_or_else(too_short)?;
        self.0 = rest;
        Ok(*taken)
    }
}

fn too_short() -> RestoreError {
    RestoreError::new("the bytes end too early; give all of them")
}

fn not_finite() -> RestoreError {
    RestoreError::new("the bytes hold a number that is not finite")
}

fn checksum(bytes: &[u8]) -> u64 {
    let mut hash = Hash::new();
    let (words, rest) = bytes.as_chunks::<4>();
    words.iter().for_each(|word| hash.word(u32::from_le_bytes(*word)));
    hash.bytes(rest);
    hash.finish()
}
