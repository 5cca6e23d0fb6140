//! The velocity field of vortex particles, and the search for those near a place.
//!
//! With the vector r from its centre, the angular velocity w there and the radius s of its core, each adds
//!
//! u = (w x r) g(q),  q = |r|^2 / (9 s^2),  g(q) = (1 - q)^2 (1 - 2.56 q + 2.88 q^2),
//!
//! and nothing where q >= 1. This approximates the kernel exp(-|r|^2 / (2 s^2)) of MantaFlow's vortex particles with a
//! smooth end and without an exponential: the velocity differs by at most 6 % of the maximum, at the end of the
//! Gaussian. The maximum, 0.594 |w| s, is at 0.97 s.
//!
//! The flow rotates about the axis with a weight that depends on the distance from the centre only. Any such field is
//! free of divergence: div u = grad g . (w x r) + g div (w x r), and grad g is parallel to r.
//!
//! Grid cells are as wide as the largest reach, so that each vortex particle touches at most 3 x 3 x 3 cells. Each cell
//! has a list of all that touch it. Cells share a list if the sums of their indices times `STRIDE` are equal modulo
//! `LISTS`. Nearby cells never share; unrelated members of a list add exactly nothing.

use wide::{f32x4, u32x4};

use crate::forces::vortex_particles::swarm::{MAX_VORTEX_PARTICLES, Swarm, VortexCore};
use crate::math::simd::{LANES, Vector4, cell_and_fraction, positive_part};
use crate::particles::tile::{Columns, Tile};

/// Reach of the velocity, in core radii.
pub const REACH: f32 = 3.0;

/// Number of lists; a power of two.
const LISTS: usize = 2048;
/// Chosen by trial so that few cells share a list in clouds of any proportions: a box of 11 x 11 x 11 cells uses 83 %
/// of the possible lists.
const STRIDE: [i32; 3] = [1, 925, 805];
/// Cell size relative to the largest reach, and the reach relative to its exact value, against rounding.
const CELL_MARGIN: f32 = 1.02;
const REACH_MARGIN: f32 = 1.01;
/// Maximum number of cells that a vortex particle touches.
const MAX_CELLS: usize = 27;
const MAX_GROUPS: usize = MAX_VORTEX_PARTICLES * MAX_CELLS / LANES + LISTS;

/// Vortex particles, sorted for one time.
pub struct VortexField {
    /// Cells per metre.
    frequency: f32,
    /// First group of each list; the last element is the number of groups.
    starts: Vec<u16>,
    groups: Vec<Group>,
    /// Each vortex particle, then one without effect.
    entries: Vec<VortexEntry>,
    /// The lists of each vortex particle, and their number.
    touched: Vec<u16>,
    cells: Vec<u8>,
    /// Length of each list; then the position of its next member.
    lengths: Vec<u16>,
    /// Indices of the vortex particles in the groups.
    members: Vec<u16>,
}

/// Columns of four vortex particles: x, y, z, 1 / (3 s)^2 and the components of the angular velocity.
type Group = [[f32; LANES]; 7];

/// The same numbers of one vortex particle.
type VortexEntry = [[f32; LANES]; 2];

impl VortexField {
    /// Creates an empty field. Allocates all of its memory.
    pub fn new() -> Self {
        Self {
            frequency: 1.0,
            starts: vec![0; LISTS + 1],
            groups: vec![Group::default(); MAX_GROUPS],
            entries: vec![VortexEntry::default(); MAX_VORTEX_PARTICLES + 1],
            touched: vec![0; MAX_VORTEX_PARTICLES * MAX_CELLS],
            cells: vec![0; MAX_VORTEX_PARTICLES],
            lengths: vec![0; LISTS],
            members: vec![0; MAX_GROUPS * LANES],
        }
    }

    /// Returns true if the field is zero everywhere.
    pub fn is_empty(&self) -> bool {
        self.starts[LISTS] == 0
    }

    /// Sorts `swarm` for the middle of the coming step.
    pub fn sort(&mut self, swarm: &Swarm) {
        let widest = (0..swarm.count()).map(|i| swarm.core(i).radius).fold(0.0, f32::max);
        self.frequency = 1.0 / (CELL_MARGIN * REACH * widest.max(1e-6));
        self.lengths.fill(0);
        let mut end = 0;
        for i in 0..swarm.count() {
            let core = swarm.core(i);
            let before = end;
            end = self.mark_lists(&core, end);
            self.cells[i] = (end - before) as u8;
            self.entries[i] = entry(&core);
        }
        self.assign_groups();
        self.enlist(swarm.count());
        self.fill();
    }

    /// Appends the lists that `core` touches from `end` on, counts them, and returns the new end.
    fn mark_lists(&mut self, core: &VortexCore, mut end: usize) -> usize {
        let reach = REACH_MARGIN * REACH * core.radius * self.frequency;
        let [x, y, z] = core.ahead.map(|place| TouchedCells::new(place * self.frequency, reach));
        let first = list_of([x.first, y.first, z.first]);
        for (k, from_z) in z.squares.iter().enumerate() {
            for (j, from_y) in y.squares.iter().enumerate() {
                let row = first + j * STRIDE[1] as usize + k * STRIDE[2] as usize;
                for (i, from_x) in x.squares.iter().enumerate() {
                    // Branch-free: the condition is unpredictable.
                    let is_touched = from_x + from_y + from_z < reach * reach;
                    let list = (row + i * STRIDE[0] as usize) % LISTS;
                    self.touched[end] = list as u16;
                    self.lengths[list] += u16::from(is_touched);
                    end += usize::from(is_touched);
                }
            }
        }
        end
    }

    /// Reserves the groups of each list.
    fn assign_groups(&mut self) {
        let mut next = 0;
        for (start, length) in self.starts.iter_mut().zip(&mut self.lengths) {
            *start = next;
            next += length.div_ceil(LANES as u16);
            *length = *start * LANES as u16;
        }
        self.starts[LISTS] = next;
        self.members[..usize::from(next) * LANES].fill(MAX_VORTEX_PARTICLES as u16);
    }

    /// Adds the first `count` vortex particles to their lists.
    fn enlist(&mut self, count: usize) {
        let mut touched = self.touched.iter();
        for (number, cells) in self.cells[..count].iter().enumerate() {
            for list in touched.by_ref().take(usize::from(*cells)) {
                let place = &mut self.lengths[usize::from(*list)];
                self.members[usize::from(*place)] = number as u16;
                *place += 1;
            }
        }
    }

    /// Copies the members into their groups, so that a lookup reads its list sequentially.
    fn fill(&mut self) {
        let (members, _) = self.members.as_chunks::<LANES>();
        let filled = usize::from(self.starts[LISTS]);
        for (group, members) in self.groups[..filled].iter_mut().zip(members) {
            let entries = members.map(|member| self.entries[usize::from(member)]);
            let [x, y, z, narrowness] = transposed(entries.map(|entry| entry[0]));
            let [wx, wy, wz, _] = transposed(entries.map(|entry| entry[1]));
            *group = [x, y, z, narrowness, wx, wy, wz];
        }
    }

    /// Adds the velocity, times `strength`, to the flow of `tile`.
    pub fn act(&self, strength: f32, tile: &mut Tile) {
        let Columns { ahead, flow, .. } = tile.columns();
        for (ahead, flow) in ahead.iter().zip(flow) {
            let lists = self.lists_of(*ahead).to_array();
            let (x, y, z) = (ahead.x.to_array(), ahead.y.to_array(), ahead.z.to_array());
            let sums: [Vector4; LANES] = std::array::from_fn(|lane| self.sum(lists[lane], [x[lane], y[lane], z[lane]]));
            *flow += folded(sums) * f32x4::splat(strength);
        }
    }

    #[inline(always)]
    fn lists_of(&self, place: Vector4) -> u32x4 {
        let of_axis = |place: f32x4, axis: usize| {
            let (cell, _) = cell_and_fraction(place * f32x4::splat(self.frequency));
            cell * u32x4::splat(STRIDE[axis] as u32)
        };
        let sum = of_axis(place.x, 0) + of_axis(place.y, 1) + of_axis(place.z, 2);
        sum & u32x4::splat(LISTS as u32 - 1)
    }

    /// The velocity at `place`, as four partial sums in the lanes of the groups.
    #[inline(always)]
    fn sum(&self, list: u32, place: [f32; 3]) -> Vector4 {
        let list = list as usize % LISTS;
        let groups = usize::from(self.starts[list])..usize::from(self.starts[list + 1]);
        let place = Vector4::splat(place);
        let mut sum = Vector4::zero();
        for group in &self.groups[groups] {
            sum += velocity(group, place);
        }
        sum
    }
}

/// The cells touched along one axis.
struct TouchedCells {
    first: i32,
    /// Squared distance to each cell; infinite out of reach.
    squares: [f32; 3],
}

impl TouchedCells {
    /// `place` and `reach` in cells.
    fn new(place: f32, reach: f32) -> Self {
        let first = (place - reach).floor();
        let squares = std::array::from_fn(|cell| {
            let below = first + cell as f32 - place;
            let distance = below.max(-1.0 - below).max(0.0);
            distance * distance
        });
        Self {
            first: first as i32,
            squares,
        }
    }
}

fn list_of(cell: [i32; 3]) -> usize {
    let sum = (0..3).fold(0_i32, |sum, axis| {
        sum.wrapping_add(cell[axis].wrapping_mul(STRIDE[axis]))
    });
    sum as usize % LISTS
}

fn entry(core: &VortexCore) -> VortexEntry {
    let reach = REACH * core.radius;
    let [x, y, z] = core.ahead;
    let [wx, wy, wz] = core.swirl;
    [[x, y, z, 1.0 / (reach * reach)], [wx, wy, wz, 0.0]]
}

#[inline(always)]
fn transposed(rows: [[f32; LANES]; LANES]) -> [[f32; LANES]; LANES] {
    f32x4::transpose(rows.map(f32x4::new)).map(f32x4::to_array)
}

/// The velocities of four vortex particles at `place`.
#[inline(always)]
fn velocity(group: &Group, place: Vector4) -> Vector4 {
    let [x, y, z, narrowness, wx, wy, wz] = group.map(f32x4::new);
    let away = place - Vector4 { x, y, z };
    let weight = weight(away.dot(away) * narrowness);
    Vector4 { x: wx, y: wy, z: wz }.cross(away) * weight
}

/// The weight at a squared distance, in reaches.
#[inline(always)]
fn weight(square: f32x4) -> f32x4 {
    let left = positive_part(f32x4::ONE - square);
    left * left * (f32x4::splat(1.32) + left * (f32x4::splat(2.88) * left - f32x4::splat(3.2)))
}

/// The lane sums of four vectors.
#[inline(always)]
fn folded(vectors: [Vector4; LANES]) -> Vector4 {
    let fold = |parts: [f32x4; LANES]| {
        let [a, b, c, d] = f32x4::transpose(parts);
        (a + b) + (c + d)
    };
    Vector4 {
        x: fold(vectors.map(|vector| vector.x)),
        y: fold(vectors.map(|vector| vector.y)),
        z: fold(vectors.map(|vector| vector.z)),
    }
}
