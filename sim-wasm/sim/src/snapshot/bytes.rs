//! Little-endian numbers in a row of bytes. Reading past the end is an error, never a panic.

use crate::error::RestoreError;

/// Bytes in the making.
#[derive(Default)]
pub struct Writer(Vec<u8>);

impl Writer {
    pub fn word(&mut self, word: u32) {
        self.0.extend_from_slice(&word.to_le_bytes());
    }

    pub fn long(&mut self, long: u64) {
        self.0.extend_from_slice(&long.to_le_bytes());
    }

    pub fn number(&mut self, number: f64) {
        self.long(number.to_bits());
    }

    pub fn raw(&mut self, bytes: &[u8]) {
        self.0.extend_from_slice(bytes);
    }

    /// Bytes with their number before them.
    pub fn block(&mut self, bytes: &[u8]) {
        self.word(bytes.len() as u32);
        self.raw(bytes);
    }

    pub fn finish(self) -> Vec<u8> {
        self.0
    }
}

/// Bytes that are read from the front.
pub struct Reader<'b>(&'b [u8]);

impl<'b> Reader<'b> {
    pub fn new(bytes: &'b [u8]) -> Self {
        Self(bytes)
    }

    pub fn word(&mut self) -> Result<u32, RestoreError> {
        self.take().map(u32::from_le_bytes)
    }

    pub fn long(&mut self) -> Result<u64, RestoreError> {
        self.take().map(u64::from_le_bytes)
    }

    /// A number that is finite.
    pub fn number(&mut self) -> Result<f64, RestoreError> {
        let number = f64::from_bits(self.long()?);
        if number.is_finite() {
            Ok(number)
        } else {
            Err(not_finite())
        }
    }

    /// A number of single precision that is finite.
    pub fn float(&mut self) -> Result<f32, RestoreError> {
        let number = f32::from_bits(self.word()?);
        if number.is_finite() {
            Ok(number)
        } else {
            Err(not_finite())
        }
    }

    /// Bytes that their number stands before.
    pub fn block(&mut self) -> Result<&'b [u8], RestoreError> {
        let length = self.word()? as usize;
        let (block, rest) = self.0.split_at_checked(length).ok_or_else(too_short)?;
        self.0 = rest;
        Ok(block)
    }

    /// What has not been read.
    pub fn rest(&self) -> &'b [u8] {
        self.0
    }

    /// Checks that everything has been read.
    pub fn end(&self) -> Result<(), RestoreError> {
        if self.0.is_empty() {
            Ok(())
        } else {
            Err(RestoreError::new("the saved simulation has bytes to spare"))
        }
    }

    fn take<const N: usize>(&mut self) -> Result<[u8; N], RestoreError> {
        let (taken, rest) = self.0.split_first_chunk::<N>().ok_or_else(too_short)?;
        self.0 = rest;
        Ok(*taken)
    }
}

fn too_short() -> RestoreError {
    RestoreError::new("the saved simulation ends too early; give all the bytes that save() returned")
}

fn not_finite() -> RestoreError {
    RestoreError::new("the saved simulation holds a number that is not finite")
}
