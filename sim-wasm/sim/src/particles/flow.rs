//! Columns that say how particles turn and stretch with the air; see `following`.

/// Number of columns of the current state, and of the state of held particles.
const COLUMNS: usize = 6;
const HELD_COLUMNS: usize = 3;
/// First column of the pairs of velocity and angular velocity.
const PAIRS: usize = 3;
/// Steps of a stored velocity per m/s, and of an angular velocity per rad/s, up to 64.
const STEPS: f32 = 512.0;
/// Steps of a stored change of velocity per m/s, up to 0.5. Coarser ones make the stretch flicker.
const CHANGE_STEPS: f32 = 256.0;
/// Steps of a stored component of a quaternion per unit, in 24 bits and in 16.
const TURN_STEPS: f32 = 8_388_607.0;
const HELD_TURN_STEPS: f32 = 32_767.0;

/// The columns, each of the length of those of the particles, of packed components x, y, z. First the turn, a unit
/// quaternion with positive w, in the upper 24 bits, and the change of velocity in the last step. Then the velocity and, in
/// the upper 16 bits, the angular velocity. While held, the velocity and, in the upper 16 bits, the turn at the last held
/// moment follow. 24 bytes for each particle, 36 while held.
#[derive(Clone, Debug)]
pub struct Flow {
    pub columns: Vec<Vec<u32>>,
}

/// How a particle turns and moves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Motion {
    /// Unit quaternion x, y, z, w.
    pub turn: [f32; 4],
    /// Angular velocity of the air (rad/s).
    pub spin: [f32; 3],
    /// Smoothed velocity relative to the winds (m/s), and its change in the last step.
    pub velocity: [f32; 3],
    pub change: [f32; 3],
}

impl Flow {
    /// Columns for particles that do not turn, in columns of length `padded`.
    pub fn new(padded: usize) -> Self {
        Self {
            columns: vec![vec![0; padded]; COLUMNS],
        }
    }

    /// Starts or stops holding.
    pub fn hold(&mut self, holds: bool) {
        if !holds {
            self.columns.truncate(COLUMNS);
        } else if self.columns.len() == COLUMNS {
            let padded = self.columns[0].len();
            self.columns.resize(COLUMNS + HELD_COLUMNS, vec![0; padded]);
            (0..padded).for_each(|i| self.hold_now(i));
        }
    }

    /// Sets particle `i` to its state at birth.
    pub fn reset(&mut self, i: usize) {
        self.columns.iter_mut().for_each(|column| column[i] = 0);
    }

    /// Holds the current state of particle `i`.
    pub fn hold_now(&mut self, i: usize) {
        let Motion { turn, velocity, .. } = self.get(i);
        for axis in 0..3 {
            self.columns[COLUMNS + axis][i] = pair(velocity[axis] * STEPS, turn[axis] * HELD_TURN_STEPS);
        }
    }

    /// The current state of particle `i`.
    pub fn get(&self, i: usize) -> Motion {
        let (velocity, spin) = self.pairs(PAIRS, i, STEPS);
        Motion {
            turn: unit(self.components(0, i, |word| (word as i32 >> 8) as f32 / TURN_STEPS)),
            spin,
            velocity,
            change: self.components(0, i, |word| f32::from(word as i8) / CHANGE_STEPS),
        }
    }

    pub fn set(&mut self, i: usize, motion: &Motion) {
        let sign = if motion.turn[3] < 0.0 { -1.0 } else { 1.0 };
        for axis in 0..3 {
            let turn = (motion.turn[axis] * sign * TURN_STEPS).round_ties_even() as i32;
            let change = (motion.change[axis] * CHANGE_STEPS).round_ties_even() as i8;
            self.columns[axis][i] = (turn as u32) << 8 | u32::from(change as u8);
            self.columns[PAIRS + axis][i] = pair(motion.velocity[axis] * STEPS, motion.spin[axis] * STEPS);
        }
    }

    /// Turn and velocity of particle `i` at the last held moment.
    pub fn held(&self, i: usize) -> ([f32; 4], [f32; 3]) {
        let (velocity, turn) = self.pairs(COLUMNS, i, HELD_TURN_STEPS);
        (unit(turn), velocity)
    }

    /// The pairs of particle `i` in the columns from `first` on: a velocity, and a vector in units of 1 / `steps`.
    fn pairs(&self, first: usize, i: usize, steps: f32) -> ([f32; 3], [f32; 3]) {
        (
            self.components(first, i, |word| f32::from(word as i16) / STEPS),
            self.components(first, i, |word| f32::from((word >> 16) as i16) / steps),
        )
    }

    fn components(&self, first: usize, i: usize, part: impl Fn(u32) -> f32) -> [f32; 3] {
        std::array::from_fn(|axis| part(self.columns[first + axis][i]))
    }
}

/// Two rounded numbers in a word.
fn pair(low: f32, high: f32) -> u32 {
    let bits = |value: f32| u32::from(value.round_ties_even() as i16 as u16);
    bits(low) | bits(high) << 16
}

/// The unit quaternion with these components and a positive w.
fn unit([x, y, z]: [f32; 3]) -> [f32; 4] {
    [x, y, z, (1.0 - (x * x + y * y + z * z)).max(0.0).sqrt()]
}
