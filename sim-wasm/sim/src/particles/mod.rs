//! The state of every particle, as a struct of arrays.
//!
//! Each column is as long as the capacity, rounded up to a whole number of SIMD lanes, and never grows. Particles
//! `0..alive` live; the tail holds finite leftovers, so that a kernel may run over the last, partly filled block.
//! A death swaps the last living particle into the gap: order is not kept. 56 bytes a particle.

pub mod density;
pub mod entrainment;
pub mod held;
pub mod radius;
pub mod tile;

use crate::math::radix_sort::{self, Entry, Histogram};
use crate::math::simd::LANES;
use crate::particles::held::Held;

/// Columns of particle state. Positions in metres, velocities in metres a second, times in seconds.
#[derive(Clone, Debug)]
pub struct Particles {
    /// Position now (m, world space, y up).
    pub x: Vec<f32>,
    pub y: Vec<f32>,
    pub z: Vec<f32>,
    /// Position one step earlier (m): what is drawn lies between the two.
    pub px: Vec<f32>,
    pub py: Vec<f32>,
    pub pz: Vec<f32>,
    /// Slip (m/s): the particle's velocity relative to the air. The integrator `paper` keeps its whole velocity here.
    pub sx: Vec<f32>,
    pub sy: Vec<f32>,
    pub sz: Vec<f32>,
    /// Time since birth (s). Negative within the step of birth, for a particle that is born late in that step.
    pub age: Vec<f32>,
    /// Age at death (s), greater than 0.
    pub lifetime: Vec<f32>,
    /// Radius at full density (m), before the global factor `puff.size`.
    pub size: Vec<f32>,
    /// Heat above the air's, 0 and up; buoyancy acts on it.
    pub temperature: Vec<f32>,
    /// Bits 0-7 variation, 8-15 seed byte, 16-27 roll at birth in 4,096ths of a turn, fixed at birth; 28-31 tint, 0: none.
    pub attributes: Vec<u32>,
    /// What is shown instead of the present; none while drawing on ones.
    pub held: Option<Box<Held>>,
    alive: usize,
    capacity: usize,
}

/// One particle at its birth. Units as in [`Particles`].
#[derive(Clone, Copy, Debug)]
pub struct Newborn {
    pub position: [f32; 3],
    pub slip: [f32; 3],
    pub age: f32,
    pub lifetime: f32,
    pub size: f32,
    pub temperature: f32,
    pub attributes: u32,
}

impl Particles {
    /// Room for `capacity` particles, none of them alive. The only allocation that particles ever make.
    pub fn new(capacity: usize) -> Self {
        let padded = capacity.next_multiple_of(LANES);
        let zeros = || vec![0.0_f32; padded];
        Self {
            x: zeros(),
            y: zeros(),
            z: zeros(),
            px: zeros(),
            py: zeros(),
            pz: zeros(),
            sx: zeros(),
            sy: zeros(),
            sz: zeros(),
            age: zeros(),
            // One, not zero: the tail is computed too and must stay finite.
            lifetime: vec![1.0; padded],
            size: zeros(),
            temperature: zeros(),
            attributes: vec![0; padded],
            held: None,
            alive: 0,
            capacity,
        }
    }

    /// How many particles live: they are `0..alive()` of each column.
    pub fn alive(&self) -> usize {
        self.alive
    }

    /// How many particles can live at once.
    pub fn capacity(&self) -> usize {
        self.capacity
    }

    /// Length of the columns that a kernel in blocks of [`LANES`] covers.
    pub fn padded_alive(&self) -> usize {
        self.alive.next_multiple_of(LANES)
    }

    /// Adds a particle at the end. False, and nothing changed, when there is no room.
    pub fn push(&mut self, newborn: &Newborn) -> bool {
        if self.alive == self.capacity {
            return false;
        }
        let i = self.alive;
        [self.x[i], self.y[i], self.z[i]] = newborn.position;
        [self.px[i], self.py[i], self.pz[i]] = newborn.position;
        [self.sx[i], self.sy[i], self.sz[i]] = newborn.slip;
        self.age[i] = newborn.age;
        self.lifetime[i] = newborn.lifetime;
        self.size[i] = newborn.size;
        self.temperature[i] = newborn.temperature;
        self.attributes[i] = newborn.attributes;
        if let Some(held) = &mut self.held {
            held.age[i] = -1.0;
        }
        self.alive += 1;
        true
    }

    /// Removes particle `i` by moving the last living one into its place.
    pub fn swap_remove(&mut self, i: usize) {
        assert!(i < self.alive, "particle {i} of {} does not live", self.alive);
        let last = self.alive - 1;
        for column in self.float_columns_mut() {
            column.swap(i, last);
        }
        self.attributes.swap(i, last);
        if let Some(held) = &mut self.held {
            held.columns_mut().into_iter().for_each(|column| column.swap(i, last));
        }
        self.alive = last;
    }

    /// The thirteen columns of numbers in the order in which they are declared.
    pub fn float_columns(&self) -> [&[f32]; 13] {
        [
            &self.x,
            &self.y,
            &self.z,
            &self.px,
            &self.py,
            &self.pz,
            &self.sx,
            &self.sy,
            &self.sz,
            &self.age,
            &self.lifetime,
            &self.size,
            &self.temperature,
        ]
    }

    /// The thirteen columns of numbers, writable, in the order in which they are declared.
    pub fn float_columns_mut(&mut self) -> [&mut [f32]; 13] {
        [
            &mut self.x,
            &mut self.y,
            &mut self.z,
            &mut self.px,
            &mut self.py,
            &mut self.pz,
            &mut self.sx,
            &mut self.sy,
            &mut self.sz,
            &mut self.age,
            &mut self.lifetime,
            &mut self.size,
            &mut self.temperature,
        ]
    }

    /// Declares the first `alive` slots living, after their columns were written. Panics beyond the capacity.
    pub fn set_alive(&mut self, alive: usize) {
        assert!(
            alive <= self.capacity,
            "{alive} particles do not fit into {}",
            self.capacity
        );
        self.alive = alive;
    }

    /// The slots of the `count` particles that have lived the smallest part of their lives, in order.
    fn freshest(&self, count: usize) -> Vec<usize> {
        let worn = |i: usize| self.age[i] / self.lifetime[i];
        let mut entries: Vec<Entry> = (0..self.alive).map(|i| [radix_sort::key(worn(i)), i as u32]).collect();
        let mut sorted = vec![[0; 2]; self.alive];
        radix_sort::sort(&mut entries, &mut sorted, &mut Histogram::new());
        let mut stays = vec![false; self.alive];
        sorted.iter().take(count).for_each(|[_, i]| stays[*i as usize] = true);
        (0..self.alive).filter(|i| stays[*i]).collect()
    }

    /// The same particles with room for `capacity`; where they do not fit, those go that are nearest to their death.
    pub fn resized(&self, capacity: usize) -> Self {
        let kept = self.freshest(capacity);
        let mut resized = Self::new(capacity);
        for (to, from) in resized.float_columns_mut().into_iter().zip(self.float_columns()) {
            kept.iter().zip(to).for_each(|(i, value)| *value = from[*i]);
        }
        kept.iter()
            .zip(&mut resized.attributes)
            .for_each(|(i, attributes)| *attributes = self.attributes[*i]);
        resized.set_alive(kept.len());
        if let Some(held) = &self.held {
            resized.hold(true);
            for (to, from) in resized.held_columns_mut().into_iter().zip(held.columns()) {
                kept.iter().zip(to).for_each(|(i, value)| *value = from[*i]);
            }
        }
        resized
    }

    /// Begins to hold what is shown, as it is now, or ends it; changes nothing where that has been done.
    pub fn hold(&mut self, holds: bool) {
        if !holds {
            self.held = None;
        } else if self.held.is_none() {
            self.held = Some(Box::new(Held {
                x: self.x.clone(),
                y: self.y.clone(),
                z: self.z.clone(),
                age: self.age.clone(),
                size: self.size.clone(),
            }));
        }
    }

    /// The held columns, none where nothing is held.
    pub(crate) fn held_columns_mut(&mut self) -> Vec<&mut [f32]> {
        self.held.iter_mut().flat_map(|held| held.columns_mut()).collect()
    }
}

/// Gives a particle's attributes a tint, 0..=15.
pub(crate) fn set_tint(attributes: &mut u32, tint: u8) {
    *attributes = *attributes & 0x0fff_ffff | u32::from(tint & 15) << 28;
}
