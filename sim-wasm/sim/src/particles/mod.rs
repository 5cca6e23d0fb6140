//! The state of all particles, as a struct of arrays.
//!
//! Each column has the length of the capacity, rounded up to whole SIMD blocks, and never grows. Particles `0..alive`
//! are alive. The rest holds finite values, so that kernels may process the last, partly filled block. Removing a
//! particle moves the last one into the gap, so the order is not kept. 56 bytes per particle, 24 more while puffs
//! turn or stretch with the air, 4 more while they age by company, 1 more from the first look of an emitter on.

pub mod company;
pub mod density;
pub mod entrainment;
pub mod flow;
pub mod following;
pub mod held;
pub mod looks;
pub mod radius;
pub mod tile;

use wide::f32x4;

use crate::layout::parameters::table::Parameters;
use crate::math::radix_sort::{self, Entry, Histogram};
use crate::math::simd::LANES;
use crate::particles::company::Company;
use crate::particles::flow::Flow;
use crate::particles::held::Held;
use crate::particles::looks::{Looks, OTHER_BITS, PuffLook};
use crate::particles::radius::RadiusLaw;

/// Columns of particle state: positions in metres, velocities in metres per second, times in seconds.
#[derive(Clone, Debug)]
pub struct Particles {
    /// Position (m, world space, y up).
    pub x: Vec<f32>,
    pub y: Vec<f32>,
    pub z: Vec<f32>,
    /// Position one step earlier (m). Pictures interpolate between the two.
    pub px: Vec<f32>,
    pub py: Vec<f32>,
    pub pz: Vec<f32>,
    /// Slip (m/s): velocity relative to the air. The integrator `paper` stores the whole velocity.
    pub sx: Vec<f32>,
    pub sy: Vec<f32>,
    pub sz: Vec<f32>,
    /// Time since birth (s). Negative within the step of birth.
    pub age: Vec<f32>,
    /// Age at death (s), above 0.
    pub lifetime: Vec<f32>,
    /// Radius at full density (m), before the factor `puff.size`.
    pub size: Vec<f32>,
    /// Temperature above the air's, 0 or more; drives buoyancy.
    pub temperature: Vec<f32>,
    /// Packed: variation (bits 0-7), seed byte (8-15), roll at birth in 4,096ths of a turn (16-27). Then
    /// the tint (28-31, 0: none), or, with looks, the look (0: none).
    pub attributes: Vec<u32>,
    /// Shown instead of the current state; none while drawing on ones.
    pub held: Option<Box<Held>>,
    /// Turning and stretching; none while no parameter needs it.
    pub flow: Option<Box<Flow>>,
    /// Ageing by company; none without it.
    pub company: Option<Box<Company>>,
    /// Looks and tints; none before the first look.
    pub looks: Option<Box<Looks>>,
    alive: usize,
    capacity: usize,
}

/// A particle at birth. Units as in [`Particles`].
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
    /// Creates an empty set for `capacity` particles. Nothing else allocates.
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
            // 1 instead of 0: kernels compute the tail too, and it must stay finite.
            lifetime: vec![1.0; padded],
            size: zeros(),
            temperature: zeros(),
            attributes: vec![0; padded],
            held: None,
            flow: None,
            company: None,
            looks: None,
            alive: 0,
            capacity,
        }
    }

    /// Number of living particles, `0..alive()` of each column.
    pub fn alive(&self) -> usize {
        self.alive
    }

    /// Maximum number of living particles.
    pub fn capacity(&self) -> usize {
        self.capacity
    }

    /// Length of the columns that kernels process, in whole blocks of [`LANES`].
    pub fn padded_alive(&self) -> usize {
        self.alive.next_multiple_of(LANES)
    }

    /// Adds a particle at the end. Returns false if there is no capacity.
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
        if let Some(flow) = &mut self.flow {
            flow.reset(i);
        }
        if let Some(company) = &mut self.company {
            company.extra_ageing[i] = 0.0;
        }
        if let Some(looks) = &mut self.looks {
            looks.tints[i] = 0;
        }
        self.alive += 1;
        true
    }

    /// Removes particle `i` by moving the last living particle into its place.
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
        if let Some(flow) = &mut self.flow {
            flow.columns.iter_mut().for_each(|column| column.swap(i, last));
        }
        if let Some(company) = &mut self.company {
            company.extra_ageing.swap(i, last);
        }
        if let Some(looks) = &mut self.looks {
            looks.tints.swap(i, last);
        }
        self.alive = last;
    }

    /// The thirteen columns of numbers in the order of declaration.
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

    /// The thirteen columns of numbers, mutable, in the order of declaration.
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

    /// Sets the number of living particles after their columns were written. Panics beyond the capacity.
    pub fn set_alive(&mut self, alive: usize) {
        assert!(
            alive <= self.capacity,
            "{alive} particles do not fit into {}",
            self.capacity
        );
        self.alive = alive;
    }

    /// Indices of the `count` particles with the smallest share of life over, in order.
    fn freshest(&self, count: usize) -> Vec<usize> {
        let worn = |i: usize| self.age[i] / self.lifetime[i];
        let mut entries: Vec<Entry> = (0..self.alive).map(|i| [radix_sort::key(worn(i)), i as u32]).collect();
        let mut sorted = vec![[0; 2]; self.alive];
        radix_sort::sort(&mut entries, &mut sorted, &mut Histogram::new());
        let mut stays = vec![false; self.alive];
        sorted.iter().take(count).for_each(|[_, i]| stays[*i as usize] = true);
        (0..self.alive).filter(|i| stays[*i]).collect()
    }

    /// Copies the particles to another capacity. If they exceed it, those nearest to their death are dropped.
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
        if let Some(flow) = &self.flow {
            resized.follow(true);
            for (to, from) in resized
                .flow
                .iter_mut()
                .flat_map(|flow| &mut flow.columns)
                .zip(&flow.columns)
            {
                kept.iter().zip(to).for_each(|(i, value)| *value = from[*i]);
            }
        }
        if let Some(company) = &self.company {
            let mut copy = Box::new(Company::new(resized.x.len()));
            kept.iter()
                .zip(&mut copy.extra_ageing)
                .for_each(|(i, extra_ageing)| *extra_ageing = company.extra_ageing[*i]);
            resized.company = Some(copy);
        }
        if let Some(looks) = &self.looks {
            let mut copy = looks.clone();
            copy.tints = vec![0; resized.x.len()];
            kept.iter()
                .zip(&mut copy.tints)
                .for_each(|(i, tint)| *tint = looks.tints[*i]);
            resized.looks = Some(copy);
        }
        resized
    }

    /// Starts or stops ageing by company.
    pub fn keep_company(&mut self, keeps: bool) {
        if !keeps {
            self.company = None;
        } else if self.company.is_none() {
            self.company = Some(Box::new(Company::new(self.x.len())));
        }
    }

    /// Starts or stops holding. Starting holds the current state; no change if already in that mode.
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
        if let Some(flow) = &mut self.flow {
            flow.hold(holds);
        }
    }

    /// Starts or stops turning and stretching with the air. Particles start without either.
    pub fn follow(&mut self, follows: bool) {
        if !follows {
            self.flow = None;
        } else if self.flow.is_none() {
            let mut flow = Box::new(Flow::new(self.x.len()));
            flow.hold(self.held.is_some());
            self.flow = Some(flow);
        }
    }

    /// The law of particle `i`: that of its look, or that of the smoke.
    #[inline]
    pub fn radius_law<'l>(&'l self, smoke: &'l RadiusLaw, i: usize) -> &'l RadiusLaw {
        match &self.looks {
            None => smoke,
            Some(looks) => looks.radius_law(self.attributes[i]),
        }
    }

    /// Radii (m) of a block of particles by the law of the smoke and by looks.
    #[inline(never)]
    pub(crate) fn radii(&self, smoke: &RadiusLaw, block: usize, [size, age, lifetime]: [f32x4; 3]) -> f32x4 {
        match &self.looks {
            None => smoke.radii(size, age, lifetime),
            Some(looks) => looks.radii(&self.attributes.as_chunks().0[block], size, age, lifetime),
        }
    }

    /// The look of particle `i`; 0 for none.
    pub fn look(&self, i: usize) -> u32 {
        self.looks
            .as_ref()
            .map_or(0, |_| looks::index(self.attributes[i]) as u32)
    }

    /// The tint of particle `i`; 0 for none.
    pub fn tint(&self, i: usize) -> u32 {
        match &self.looks {
            None => looks::index(self.attributes[i]) as u32,
            Some(looks) => u32::from(looks.tints[i]),
        }
    }

    /// Sets the tint, 0..=15, of particle `i`.
    pub(crate) fn set_tint(&mut self, i: usize, tint: u8) {
        match &mut self.looks {
            None => self.attributes[i] = self.attributes[i] & OTHER_BITS | u32::from(tint & 15) << 28,
            Some(looks) => looks.tints[i] = tint & 15,
        }
    }

    /// See [`Looks::index_for`].
    #[inline(never)]
    pub(crate) fn look_for(&mut self, entry: &PuffLook, parameters: &Parameters) -> u32 {
        let living = &self.attributes[..self.alive];
        let looks = self.looks.as_mut();
        looks.map_or(0, |looks| looks.index_for(entry, living, parameters))
    }

    /// Tells looks and tints apart from now on.
    #[cold]
    pub(crate) fn allow_looks(&mut self, parameters: &Parameters) {
        if self.looks.is_none() {
            let mut looks = Box::new(Looks::new(self.x.len()));
            for (tint, attributes) in looks.tints.iter_mut().zip(&mut self.attributes) {
                *tint = looks::index(*attributes) as u8;
                *attributes &= OTHER_BITS;
            }
            looks.prepare(parameters);
            self.looks = Some(looks);
        }
    }

    /// The held columns; empty if nothing is held.
    pub(crate) fn held_columns_mut(&mut self) -> Vec<&mut [f32]> {
        self.held.iter_mut().flat_map(|held| held.columns_mut()).collect()
    }
}
