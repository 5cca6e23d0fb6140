//! Repeats the calls that `tests/support/sim/recordedCalls.ts` recorded in a file, with the same bits. Prints the hash
//! for each call of `hash`, one per line.

use sim::Simulator;
use sim::rigids::{RigidDescription, RigidNumbers, pose_of};

fn main() {
    let path = std::env::args().nth(1).expect("the path of a file with calls");
    let bytes = std::fs::read(path).expect("the file can be read");
    let mut reader = Reader { rest: &bytes };
    let mut simulator = Simulator::new(1, 0).expect("the capacity is in range");
    while !reader.rest.is_empty() {
        let name = reader.text();
        let count = reader.byte();
        let arguments: Vec<Argument> = (0..count).map(|_| reader.argument()).collect();
        perform(&mut simulator, &name, &arguments);
    }
}

/// The same as `sim-wasm/bindings` for the call of this name.
fn perform(simulator: &mut Simulator, name: &str, arguments: &[Argument]) {
    use Argument::{Doubles, Floats, Number, Text, Words};
    match (name, arguments) {
        ("new", [Number(capacity), Number(seed)]) => {
            *simulator = Simulator::new(*capacity as u32, *seed as u32).expect("WASM took it");
        }
        ("free", []) => (),
        ("record", []) => simulator.record(),
        ("set", [Text(keys), Doubles(values)]) => {
            let pairs: Vec<(&str, f64)> = keys.lines().zip(values.iter().copied()).collect();
            simulator.set_all(&pairs).expect("WASM took it");
        }
        ("addSurface", [Floats(vertices), Words(indices)]) => {
            simulator.add_surface(vertices, indices).expect("WASM took it");
        }
        ("addRigid", [Floats(numbers), Floats(vertices), Words(indices)]) => {
            let numbers = RigidNumbers {
                numbers,
                vertices,
                indices,
            };
            let rigid = RigidDescription::from_numbers(&numbers).expect("WASM took it");
            simulator.rigids_mut().add(rigid).expect("WASM took it");
        }
        ("moveRigid", [Number(rigid), pose @ ..]) => {
            let pose = pose_of(&singles(pose)).expect("WASM took it");
            simulator
                .rigids_mut()
                .move_to(*rigid as u32, pose)
                .expect("WASM took it");
        }
        ("placeParts", [Floats(numbers)]) => simulator.place_parts(numbers).expect("WASM took it"),
        ("setEmitter", [Number(index), Doubles(numbers), Number(count)]) => {
            let result = simulator.set_emitter(*index as u32, numbers, *count as u32);
            result.expect("WASM took it");
        }
        ("inputEmission", [Doubles(numbers), Number(changed)]) => {
            let changed = (*changed >= 0.0).then_some(*changed as u64);
            simulator.input_emission(numbers, changed).expect("WASM took it");
        }
        ("lookStyles" | "burstEnd", _) => (),
        ("step", [Number(count)]) => (0..*count as u32).for_each(|_| simulator.step()),
        ("hash", []) => println!("{:016x}", simulator.hash()),
        _ => panic!(
            "no call {name} with {} arguments is known: add it here",
            arguments.len()
        ),
    }
}

enum Argument {
    Number(f64),
    Text(String),
    Floats(Vec<f32>),
    Doubles(Vec<f64>),
    Words(Vec<u32>),
}

/// Converts numbers as for parameters of type f32.
fn singles(arguments: &[Argument]) -> Vec<f32> {
    let single = |argument: &Argument| match argument {
        Argument::Number(number) => *number as f32,
        _ => panic!("a number was expected"),
    };
    arguments.iter().map(single).collect()
}

struct Reader<'a> {
    rest: &'a [u8],
}

impl<'a> Reader<'a> {
    fn argument(&mut self) -> Argument {
        match self.byte() {
            0 => Argument::Number(f64::from_le_bytes(*self.array())),
            1 => Argument::Text(self.text()),
            2 => Argument::Floats(self.items().map(f32::from_le_bytes).collect()),
            3 => Argument::Doubles(self.items().map(f64::from_le_bytes).collect()),
            4 => Argument::Words(self.items().map(u32::from_le_bytes).collect()),
            other => panic!("there is no type {other}"),
        }
    }

    fn text(&mut self) -> String {
        String::from_utf8(self.sized().to_vec()).expect("UTF-8")
    }

    fn items<const SIZE: usize>(&mut self) -> impl Iterator<Item = [u8; SIZE]> {
        let (items, rest) = self.sized().as_chunks();
        assert!(rest.is_empty(), "whole items");
        items.iter().copied()
    }

    fn sized(&mut self) -> &'a [u8] {
        let length = u32::from_le_bytes(*self.array()) as usize;
        let (sized, rest) = self.rest.split_at(length);
        self.rest = rest;
        sized
    }

    fn byte(&mut self) -> u8 {
        self.array::<1>()[0]
    }

    fn array<const SIZE: usize>(&mut self) -> &'a [u8; SIZE] {
        let (array, rest) = self.rest.split_first_chunk().expect("the call is whole");
        self.rest = rest;
        array
    }
}
