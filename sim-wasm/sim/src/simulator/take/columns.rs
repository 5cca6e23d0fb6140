//! Column-wise serialisation of log records. Takes travel in links, so the order favours deflate: records are grouped
//! by kind, each byte is stored as its difference to the previous record, and the rows are transposed.

use crate::layout::bytes::{Reader, Writer};
use crate::layout::error::RestoreError;
use crate::layout::quantise::impossible_input;
use crate::simulator::take::input::{EMIT, Input, RELEASE};
use crate::simulator::take::log::{MAX_INPUTS, Record};

/// Number of input kinds. A kind is the first byte of its inputs.
const KINDS: usize = 10;

/// Returns true if the inputs of a kind have numbers. Takes without emissions have no block of them, as older ones.
fn has_block(kind: usize, count: usize) -> bool {
    kind <= usize::from(RELEASE) || (kind >= usize::from(EMIT) && count > 0)
}

/// Inputs of one kind as bytes of equal length.
type Rows = Vec<Vec<u8>>;

pub fn write(records: &[Record], body: &mut Writer) {
    let (mut kinds, mut waits) = (Writer::default(), Writer::default());
    let mut rows: [Rows; KINDS] = Default::default();
    let mut latest = 0;
    for Record { step, input } in records {
        let mut row = Writer::default();
        input.write(&mut row);
        let row = row.finish();
        kinds.byte(row[0]);
        waits.count(step - latest);
        latest = *step;
        rows[usize::from(row[0])].push(row);
    }
    body.block(&kinds.finish());
    body.block(&waits.finish());
    for (kind, rows) in rows.iter().enumerate() {
        if has_block(kind, rows.len()) {
            body.block(&transposed(rows));
        }
    }
}

/// Reads what `write` wrote. The caller checks that the steps lie within the take.
pub fn read(reader: &mut Reader) -> Result<Vec<Record>, RestoreError> {
    let kinds = reader.block()?;
    if kinds.len() > MAX_INPUTS {
        return Err(RestoreError::new("the take contains too many inputs"));
    }
    let mut waits = Reader::over(reader.block()?);
    let mut rows: [std::vec::IntoIter<Vec<u8>>; KINDS] = Default::default();
    for (kind, rows) in rows.iter_mut().enumerate() {
        let count = kinds.iter().filter(|&&found| usize::from(found) == kind).count();
        let all = if has_block(kind, count) {
            untransposed(reader.block()?, count)?
        } else {
            vec![vec![kind as u8]; count]
        };
        *rows = all.into_iter();
    }
    let mut records = Vec::with_capacity(kinds.len());
    let mut latest: u64 = 0;
    for kind in kinds {
        let rows = rows.get_mut(usize::from(*kind)).ok_or_else(impossible_input)?;
        let row = rows.next().ok_or_else(uneven)?;
        latest = latest.checked_add(waits.count()?).ok_or_else(uneven)?;
        let mut row = Reader::over(&row);
        let input = Input::read(&mut row)?;
        row.end()?;
        records.push(Record { step: latest, input });
    }
    waits.end()?;
    Ok(records)
}

/// Transposes the rows: all first bytes, then all second bytes, each as the difference to the row before.
fn transposed(rows: &[Vec<u8>]) -> Vec<u8> {
    let length = rows.first().map_or(0, Vec::len);
    let mut bytes = Vec::with_capacity(length * rows.len());
    for place in 0..length {
        let mut before: u8 = 0;
        for row in rows {
            bytes.push(row[place].wrapping_sub(before));
            before = row[place];
        }
    }
    bytes
}

fn untransposed(bytes: &[u8], count: usize) -> Result<Rows, RestoreError> {
    if bytes.len().checked_rem(count).unwrap_or(bytes.len()) != 0 {
        return Err(uneven());
    }
    let mut rows = vec![Vec::new(); count];
    for column in bytes.chunks_exact(count.max(1)) {
        let mut before: u8 = 0;
        for (row, difference) in rows.iter_mut().zip(column) {
            before = before.wrapping_add(*difference);
            row.push(before);
        }
    }
    Ok(rows)
}

fn uneven() -> RestoreError {
    RestoreError::new("the take's number of inputs is wrong")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::emission::Births;
    use crate::emission::pool::Emission;
    use crate::layout::blow::{Blow, BlowNumbers};
    use crate::layout::parameters::rows;

    fn emission() -> Emission {
        let own = rows().into_iter().filter(|row| row.key.starts_with("emitters.#."));
        let numbers: Vec<f64> = own.map(|row| row.default).collect();
        Births::default().emission(&numbers, None, 7).unwrap().unwrap()
    }

    fn records() -> Vec<Record> {
        let blow = |speed: f64| {
            let numbers = BlowNumbers {
                origin: [0.0, 1.5, 6.0],
                ray: [0.0, 0.0, -1.0],
                velocity: [speed, -0.3, 0.0],
                radius: 0.4,
                seconds: 0.5,
            };
            Input::Blow(Blow::new(&numbers).unwrap())
        };
        let inputs = [
            blow(0.0),
            Input::Set { key: 1, value: -0.1 },
            blow(-7.25),
            Input::Release { rigid: 300 },
            Input::Resize { capacity: 70_000 },
            Input::Clear,
            Input::Emit(Box::new(emission())),
            blow(7.25),
        ];
        let steps = [3, 3, 130, 131, 40_000, 40_001, 40_001, 1 << 38];
        steps
            .into_iter()
            .zip(inputs)
            .map(|(step, input)| Record { step, input })
            .collect()
    }

    fn written(records: &[Record]) -> Vec<u8> {
        let mut body = Writer::default();
        write(records, &mut body);
        body.finish()
    }

    #[test]
    fn records_round_trip_in_order() {
        for records in [records(), Vec::new()] {
            let bytes = written(&records);
            let mut reader = Reader::over(&bytes);
            assert_eq!(read(&mut reader).unwrap(), records);
            reader.end().unwrap();
        }
    }

    #[test]
    fn truncated_or_changed_bytes_never_panic() {
        let bytes = written(&records());
        for end in 0..bytes.len() {
            assert!(read(&mut Reader::over(&bytes[..end])).is_err());
        }
        for place in 0..bytes.len() {
            for value in [0, 1, 7, 255] {
                let mut changed = bytes.clone();
                changed[place] = value;
                let _ = read(&mut Reader::over(&changed));
            }
        }
    }

    #[test]
    fn uniform_motion_leaves_mostly_zeros() {
        let rows: Rows = (0u8..100).map(|step| vec![5, step, 7, 7]).collect();
        let bytes = transposed(&rows);
        assert_eq!(bytes.iter().filter(|&&byte| byte == 0).count(), 298);
        assert_eq!(untransposed(&bytes, 100).unwrap(), rows);
    }
}
