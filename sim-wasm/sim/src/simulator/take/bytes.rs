//! Serialisation of takes, and their validation.

use crate::layout::bytes::{Reader, SnapshotSection, Writer};
use crate::layout::error::RestoreError;
use crate::layout::limits::CAPACITY_LIMIT;
use crate::layout::parameters::table::Parameters;
use crate::simulator::take::columns;
use crate::simulator::take::input::Input;
use crate::simulator::take::log::{Log, Record};
use crate::simulator::take::origin::Origin;

const KIND: &[u8; 4] = b"take";
const VERSION: u32 = 1;
const NAME: &str = "take";
/// Maximum length of the note (bytes).
pub const MAX_NOTE: usize = 65_536;
/// Maximum length of a take (steps): more than 500 years.
const MAX_STEPS: u64 = 1 << 40;

/// A parsed take.
#[derive(Clone, Debug)]
pub struct Take {
    pub origin: Origin,
    pub log: Log,
    /// Number of steps at its end, including those before the take.
    pub end: u64,
    /// Text that the recording page attached.
    pub note: String,
}

impl Take {
    /// Parses a take and validates everything that does not depend on the scene.
    pub fn parse(bytes: &[u8]) -> Result<Self, RestoreError> {
        let mut reader = Reader::open(bytes, KIND, VERSION, NAME)?;
        let (origin, end) = reader.section(b"from", read_origin)?;
        let keys = reader.section(b"keys", read_keys)?;
        let log = reader.section(b"logs", |reader| read_log(reader, keys, origin.step, end))?;
        let note = reader.section(b"note", read_note)?;
        reader.end()?;
        Ok(Self { origin, log, end, note })
    }

    /// Returns true if the take starts from the scene's initial state instead of a saved one.
    pub fn is_fresh(&self) -> bool {
        self.origin.is_fresh
    }

    /// Maximum number of particles in the take, as far as it is recorded. A saved state has a capacity of its own.
    pub fn max_particles(&self) -> u32 {
        self.log.max_capacity().unwrap_or(0).max(self.origin.capacity)
    }

    /// The bytes from which the take was parsed.
    pub fn to_bytes(&self) -> Vec<u8> {
        let mut body = Writer::default();
        write(&mut body, &self.origin, &self.log, self.end, &self.note);
        seal(body)
    }
}

pub(super) fn seal(body: Writer) -> Vec<u8> {
    body.seal(KIND, VERSION)
}

pub(super) fn write(body: &mut Writer, origin: &Origin, log: &Log, end: u64, note: &str) {
    body.section(b"from", |body| write_origin(body, origin, end));
    body.section(b"keys", |body| {
        body.short(log.keys.len() as u16);
        log.keys.iter().for_each(|key| body.text(key));
    });
    body.section(b"logs", |body| write_log(body, log));
    body.section(b"note", |body| body.text(note));
}

fn write_origin(body: &mut Writer, origin: &Origin, end: u64) {
    body.word(origin.seed);
    body.word(origin.capacity);
    body.long(origin.step);
    body.long(end);
    body.long(origin.scene);
    origin.parameters.write(body);
    body.byte(u8::from(origin.is_fresh));
    body.block(if origin.is_fresh { &[] } else { &origin.state });
}

fn read_origin(reader: &mut Reader) -> Result<(Origin, u64), RestoreError> {
    let (seed, capacity) = (reader.word()?, reader.word()?);
    let (step, end) = (reader.long()?, reader.long()?);
    let scene = reader.long()?;
    let parameters = Parameters::read(reader)?;
    let (is_fresh, state) = (reader.byte()?, reader.block()?);
    let is_sound = (1..=CAPACITY_LIMIT).contains(&capacity) && step <= end && end <= MAX_STEPS && is_fresh <= 1;
    let is_fresh = is_fresh == 1;
    if !is_sound || (is_fresh && (step > 0 || !state.is_empty())) {
        return Err(RestoreError::new("the take has an invalid start"));
    }
    let origin = Origin {
        state: state.to_vec(),
        is_fresh,
        scene,
        seed,
        capacity,
        step,
        parameters,
    };
    Ok((origin, end))
}

fn read_keys(reader: &mut Reader) -> Result<Vec<String>, RestoreError> {
    let mut keys = Vec::new();
    for _ in 0..reader.short()? {
        keys.push(reader.text()?.to_owned());
    }
    Ok(keys)
}

fn write_log(body: &mut Writer, log: &Log) {
    body.byte(u8::from(log.is_truncated));
    columns::write(&log.records, body);
}

fn read_log(reader: &mut Reader, keys: Vec<String>, start: u64, end: u64) -> Result<Log, RestoreError> {
    let is_truncated = reader.byte()? != 0;
    let records = columns::read(reader)?;
    let mut scratch = Parameters::default();
    let mut earliest = start;
    for Record { step, input } in &records {
        if !(earliest..=end).contains(step) {
            return Err(RestoreError::new(
                "the take's inputs are not in the order of their steps",
            ));
        }
        earliest = *step;
        check_set(input, &keys, &mut scratch)?;
    }
    Ok(Log {
        keys,
        records,
        is_truncated,
    })
}

/// Checks that the parameter exists and accepts the value.
fn check_set(input: &Input, keys: &[String], scratch: &mut Parameters) -> Result<(), RestoreError> {
    let Input::Set { key, value } = input else {
        return Ok(());
    };
    let key = keys.get(usize::from(*key));
    let key = key.ok_or_else(|| RestoreError::new("the take sets an unknown parameter"))?;
    scratch.set(key, *value).map_err(RestoreError::from)
}

fn read_note(reader: &mut Reader) -> Result<String, RestoreError> {
    let note = reader.text()?;
    if note.len() > MAX_NOTE {
        return Err(RestoreError::new("the take's note is too long"));
    }
    Ok(note.to_owned())
}
