//! Columns that say how particles turn and stretch with the air; see `following`.

/// Number of columns of the current state, and of the state of held particles.
const COLUMNS: usize = 10;
const HELD_COLUMNS: usize = 7;
/// First columns of the angular velocity and of the smoothed velocity.
pub const SPIN: usize = 4;
pub const VELOCITY: usize = 7;
/// First columns of the turn and the smoothed velocity of held particles.
pub const HELD_TURN: usize = COLUMNS;
pub const HELD_VELOCITY: usize = COLUMNS + 4;

/// The columns, each of the length of those of the particles: turn as a unit quaternion x, y, z, w; angular velocity of the
/// air (rad/s); smoothed velocity (m/s). While held, turn and smoothed velocity at the last held moment follow.
#[derive(Clone, Debug)]
pub struct Flow {
    pub columns: Vec<Vec<f32>>,
}

impl Flow {
    /// Columns for particles that do not turn, in columns of length `padded`.
    pub fn new(padded: usize) -> Self {
        let mut columns = vec![vec![0.0; padded]; COLUMNS];
        columns[3].fill(1.0);
        Self { columns }
    }

    /// Starts or stops holding.
    pub fn hold(&mut self, holds: bool) {
        if !holds {
            self.columns.truncate(COLUMNS);
        } else if self.columns.len() == COLUMNS {
            let held = (0..HELD_COLUMNS)
                .map(|at| self.columns[shown(at)].clone())
                .collect::<Vec<_>>();
            self.columns.extend(held);
        }
    }

    /// Sets particle `i` to its state at birth.
    pub fn reset(&mut self, i: usize) {
        for (at, column) in self.columns.iter_mut().enumerate() {
            column[i] = if at == 3 || at == COLUMNS + 3 { 1.0 } else { 0.0 };
        }
    }

    /// Holds the current state of particle `i`.
    pub fn hold_now(&mut self, i: usize) {
        for at in 0..HELD_COLUMNS {
            self.columns[COLUMNS + at][i] = self.columns[shown(at)][i];
        }
    }

    /// Values of particle `i` in the columns from `first` on.
    pub fn values<const N: usize>(&self, first: usize, i: usize) -> [f32; N] {
        std::array::from_fn(|at| self.columns[first + at][i])
    }

    pub fn set<const N: usize>(&mut self, first: usize, i: usize, values: [f32; N]) {
        for (column, value) in self.columns[first..].iter_mut().zip(values) {
            column[i] = value;
        }
    }
}

/// The current column of held column `at`.
fn shown(at: usize) -> usize {
    if at < 4 { at } else { at + 3 }
}
