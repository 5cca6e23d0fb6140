//! The simulator and the memory pass outside the browser, for `npm run bench -- sim`. It reads one command per line
//! from standard input and answers each with a line. It measures time itself, so communication costs nothing.
//!
//! - `load CAPACITY BYTES`, then that many bytes of a saved state: restores the state with its parameters. Answers
//!   `loaded`.
//! - `restart`: restores that state again. Answers `restarted`.
//! - `step COUNT`, `memory COUNT`: COUNT steps, or COUNT memory passes over as many particles. Answers with
//!   milliseconds.
//! - `hash`: answers with the hash of the state.

#[path = "memory/pass.rs"]
mod pass;

use std::error::Error;
use std::hint::black_box;
use std::io::{self, BufRead, Read, Write};
use std::time::Instant;

use pass::Columns;
use sim::Simulator;

/// The two measured subjects, and the state from which they start each round.
struct Contest {
    simulator: Simulator,
    columns: Columns,
    start: Vec<u8>,
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut input = io::stdin().lock();
    let mut contest = None;
    let mut line = String::new();
    while input.read_line(&mut line)? > 0 {
        let words: Vec<&str> = line.split_whitespace().collect();
        let answer = if let ["load", capacity, length] = words[..] {
            // Drop the old one first: two of them would need twice the memory.
            drop(contest.take());
            contest = Some(load(&mut input, capacity.parse()?, length.parse()?)?);
            "loaded".into()
        } else {
            obey(contest.as_mut().ok_or("nothing was loaded")?, &words)?
        };
        println!("{answer}");
        io::stdout().flush()?;
        line.clear();
    }
    Ok(())
}

fn load(input: &mut impl Read, capacity: u32, length: usize) -> Result<Contest, Box<dyn Error>> {
    let mut start = vec![0; length];
    input.read_exact(&mut start)?;
    let mut simulator = Simulator::new(capacity, 0).map_err(|error| error.message)?;
    simulator.restore(&start).map_err(|error| error.message)?;
    Ok(Contest {
        simulator,
        columns: Columns::new(capacity as usize),
        start,
    })
}

fn obey(contest: &mut Contest, words: &[&str]) -> Result<String, Box<dyn Error>> {
    let Contest {
        simulator,
        columns,
        start,
    } = contest;
    Ok(match *words {
        ["restart"] => {
            simulator.restore(start).map_err(|error| error.message)?;
            "restarted".into()
        }
        ["step", count] => milliseconds(count.parse()?, || simulator.step()),
        ["memory", count] => milliseconds(count.parse()?, || {
            black_box(columns.pass());
        }),
        ["hash"] => format!("{:016x}", simulator.hash()),
        _ => return Err(format!("unknown: {}", words.join(" ")).into()),
    })
}

fn milliseconds(count: u32, mut work: impl FnMut()) -> String {
    let start = Instant::now();
    (0..count).for_each(|_| work());
    (start.elapsed().as_secs_f64() * 1000.0).to_string()
}
