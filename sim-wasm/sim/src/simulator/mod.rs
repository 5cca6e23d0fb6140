//! One simulation: its state, and the order of a step.
//!
//! A step is 1/60 s. Equal seeds, parameters and inputs at the same steps give the same state to the last bit, natively
//! and in WASM. Memory is allocated on creation; vortex particles allocate when the first shedder is set, held columns
//! when `style.hold` first exceeds 1. `step` and `arrange` never allocate.

pub mod collisions;
#[cfg(feature = "bench")]
pub mod measure;
pub(crate) mod snapshot;
pub mod take;

use crate::arrange::Arranger;
use crate::arrange::glow;
use crate::arrange::row_layout::Attributes;
use crate::arrange::rows::RowSampler;
use crate::arrange::view::View;
use crate::collide::analytic;
use crate::collide::pool::ColliderPool;
use crate::emission::birth::EmissionContext;
use crate::emission::pool::{Emission, write_look};
use crate::emission::surface::{Surface, Surfaces};
use crate::emission::{Births, looks};
use crate::forces::force::{ForceContext, TurbulenceState};
use crate::forces::particle_motion::ParticleMotion;
use crate::forces::prepared::Prepared;
use crate::forces::turbulence;
use crate::forces::vortex_particles::VortexParticles;
use crate::forces::vortex_particles::swarm::VortexParticle;
use crate::layout::bytes::Writer;
use crate::layout::error::ParameterError;
use crate::layout::limits::{STEP, check_capacity};
use crate::layout::parameters::item::LIST_LIMIT;
use crate::layout::parameters::settings::Integrator;
use crate::layout::parameters::table::Parameters;
use crate::layout::scope::StepTime;
use crate::layout::scope::parts::Parts;
use crate::life;
use crate::life::{Ageing, company, hold};
use crate::math::hash::Hash;
use crate::math::random::Random;
#[cfg(feature = "rigids")]
use crate::math::vector::Vector;
use crate::particles::following::FlowLaw;
use crate::particles::looks::{LOOK_LIMIT, NO_LOOK, OTHER_BITS};
use crate::particles::radius::RadiusLaw;
use crate::particles::tile::tiles;
use crate::particles::{Newborn, Particles};
#[cfg(feature = "meshes")]
use crate::rigids::set::Rigids;
use crate::simulator::collisions::Scratch;
use crate::simulator::take::active_inputs::ActiveInputs;
use crate::simulator::take::recorder::Recorder;

/// The parts of a step, in order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StepPart {
    /// The step of Rapier.
    World,
    /// Preparation of the rigids' motions for particles.
    Follow,
    /// Births and motion.
    Motion,
    /// Collisions.
    Collision,
    /// Ageing, and all state that is not particles.
    Rest,
}

/// A simulation. See the module documentation.
pub struct Simulator {
    pub(crate) parameters: Parameters,
    pub(crate) seed: u32,
    pub(crate) steps: u64,
    pub(crate) random: Random,
    pub(crate) births: Births,
    pub(crate) turbulence: [TurbulenceState; LIST_LIMIT + 1],
    prepared: Prepared,
    pub(crate) surfaces: Surfaces,
    pub(crate) particles: Particles,
    pub(crate) colliders: ColliderPool,
    #[cfg(feature = "meshes")]
    pub(crate) rigids: Rigids,
    parts: Parts,
    /// None until the first shedder is set.
    pub(crate) vortex_particles: Option<Box<VortexParticles>>,
    pub(crate) active_inputs: ActiveInputs,
    pub(crate) recorder: Recorder,
    arranger: Arranger,
    scratch: Scratch,
}

impl Simulator {
    /// Creates an empty simulation. `capacity` is the maximum number of particles, 1..=[`CAPACITY_LIMIT`]. `seed`
    /// starts the random numbers and selects the pattern of turbulence.
    pub fn new(capacity: u32, seed: u32) -> Result<Self, ParameterError> {
        let room = check_capacity(capacity)?;
        Ok(Self {
            parameters: Parameters::default(),
            seed,
            steps: 0,
            random: Random::new(seed),
            births: Births::default(),
            turbulence: [TurbulenceState::default(); LIST_LIMIT + 1],
            prepared: Prepared::default(),
            surfaces: Surfaces::default(),
            particles: Particles::new(room),
            colliders: ColliderPool::default(),
            #[cfg(feature = "meshes")]
            rigids: Rigids::new(),
            parts: Parts::default(),
            vortex_particles: None,
            active_inputs: ActiveInputs::default(),
            recorder: Recorder::default(),
            arranger: Arranger::new(room),
            scratch: Scratch::new(room),
        })
    }

    /// Sets the parameter `key`. An unknown key, or a value that is not finite or out of range, is an error and changes
    /// nothing.
    pub fn set(&mut self, key: &str, value: f64) -> Result<(), ParameterError> {
        self.set_all(&[(key, value)])
    }

    /// Sets all `entries`, or none of them if one is invalid.
    pub fn set_all(&mut self, entries: &[(&str, f64)]) -> Result<(), ParameterError> {
        let changed = self.changed_parameters(entries)?;
        self.put_parameters(&changed);
        Ok(())
    }

    /// The parameters with these entries; an error if one is invalid, or if there would be too many looks.
    pub(crate) fn changed_parameters(&self, entries: &[(&str, f64)]) -> Result<Parameters, ParameterError> {
        let changed = self.parameters.changed(entries)?;
        looks::needs(&changed, &self.births, &self.particles, self.steps, None)?;
        Ok(changed)
    }

    pub(crate) fn put_parameters(&mut self, changed: &Parameters) {
        let before = self.integrator();
        self.parameters = *changed;
        if self.integrator() != before {
            self.prepared.follow(&self.parameters);
            self.measure_smoke();
            let vortex_particles = self.vortex_particles.as_deref();
            self.motion().take_over(&mut self.particles, vortex_particles);
        }
        if !self.parameters.shedders.items().is_empty() {
            self.vortex_particles_mut();
        }
        self.take_over_parameters();
    }

    /// Allocates or drops what parameters need, and prepares the laws of looks.
    pub(crate) fn take_over_parameters(&mut self) {
        let Self {
            parameters,
            particles,
            prepared,
            ..
        } = self;
        particles.hold(parameters.style.hold > 1.0);
        particles.keep_company(parameters.emission.company > 0.0);
        prepared.follow(parameters);
        if let Some(looks) = &mut particles.looks {
            looks.prepare(parameters);
        }
        let strands = self.allow_looks();
        let radii = RadiusLaw::new(&self.parameters);
        let needed = FlowLaw::new(&self.parameters).is_needed(&self.particles, &radii);
        self.particles.follow(needed || strands);
    }

    /// Allocates what the looks of emitters need. Returns true if puffs of any of them end as strands.
    fn allow_looks(&mut self) -> bool {
        let needs = looks::needs(&self.parameters, &self.births, &self.particles, self.steps, None);
        // Only a forged state has too many.
        let needs = needs.unwrap_or_default();
        if needs.looks {
            self.particles.allow_looks(&self.parameters);
        }
        if needs.strands {
            self.particles.follow(true);
        }
        needs.strands
    }

    /// The current parameters.
    pub fn parameters(&self) -> &Parameters {
        &self.parameters
    }

    /// Returns true if there are rare forces, whose kernels only builds with that feature have. The other builds must not
    /// take the next step.
    pub fn has_rare_forces(&self) -> bool {
        self.parameters.lists.has_rare()
    }

    /// Adds a particle without an emitter. Returns false if the simulator is full.
    pub fn add(&mut self, newborn: &Newborn) -> bool {
        self.particles.push(newborn)
    }

    /// Adds the surface of a mesh for emitters of shape 8 and returns its index. See [`Surface::new`].
    ///
    /// # Errors
    /// The mesh is invalid, or there are 16 surfaces already.
    pub fn add_surface(&mut self, vertices: &[f32], indices: &[u32]) -> Result<u32, ParameterError> {
        self.surfaces.add(Surface::new(vertices, indices)?)
    }

    /// Sets, frees or bursts an emitter. See [`Births::put`].
    ///
    /// # Errors
    /// There is no such emitter, or a number is out of range; nothing changes.
    pub fn set_emitter(&mut self, index: u32, numbers: &[f64], count: u32) -> Result<(), ParameterError> {
        let around = (&self.parameters, &self.particles, self.steps);
        self.births.put(index as usize, numbers, count, Some(around))?;
        self.allow_looks();
        Ok(())
    }

    /// See [`Births::burst_end`].
    pub fn burst_end(&self, index: u32) -> Option<u64> {
        self.births.burst_end(index as usize)
    }

    /// Returns true if emitters have or had looks.
    pub fn has_looks(&self) -> bool {
        self.particles.looks.is_some()
    }

    /// See [`Looks::styles`]; none without looks.
    pub fn look_styles(&self) -> Vec<f64> {
        self.particles.looks.as_ref().map_or(Vec::new(), |looks| looks.styles())
    }

    /// Starts or changes an emission.
    pub(crate) fn put_emission(&mut self, emission: &Emission) {
        self.births.emit(emission);
        self.allow_looks();
    }

    /// Sets, moves or removes a collider of the pool. See [`ColliderPool::put`].
    ///
    /// # Errors
    /// There is no such collider, or a number is out of range; nothing changes.
    pub fn set_collider(&mut self, index: u32, numbers: &[f32]) -> Result<(), ParameterError> {
        self.colliders.put(index, numbers)
    }

    /// Sets the poses of the scene's parts for the coming step. See [`Parts::place`].
    ///
    /// # Errors
    /// A number is out of range; the previous poses stay.
    pub fn place_parts(&mut self, numbers: &[f32]) -> Result<(), ParameterError> {
        self.parts.place(numbers)
    }

    /// Advances by 1/60 s.
    pub fn step(&mut self) {
        self.step_observed_by(|_| ());
    }

    /// Same as `step`. Calls `ended` at the end of each part, for measurements.
    pub(crate) fn step_observed_by(&mut self, mut ended: impl FnMut(StepPart)) {
        #[cfg(feature = "rigids")]
        {
            let radii = RadiusLaw::new(&self.parameters);
            self.rigids.turn(self.parts.up.unwrap_or(Vector::Y));
            self.rigids.apply_smoke_forces(&mut self.particles, &radii, STEP as f32);
        }
        #[cfg(feature = "meshes")]
        self.rigids.step_world(STEP as f32);
        ended(StepPart::World);
        #[cfg(feature = "meshes")]
        self.rigids.follow_world(STEP as f32);
        self.colliders.advance();
        ended(StepPart::Follow);
        self.begin_parts();
        self.measure_smoke();
        let motion = self.motion();
        self.spawn(&motion);
        let ageing = Ageing::new(&self.parameters, STEP);
        let vortex_particles = self.vortex_particles.as_deref();
        if self.has_obstacles() {
            motion.advance(&mut self.particles, vortex_particles, &mut |_, _, _| ());
            #[cfg(feature = "meshes")]
            self.rigids
                .drag_air(&mut self.particles, &RadiusLaw::new(&self.parameters), STEP as f32);
            ended(StepPart::Motion);
            self.collide();
            ended(StepPart::Collision);
            for tile in tiles(&self.particles, 0) {
                motion.follow(&mut self.particles, self.vortex_particles.as_deref(), tile);
            }
            life::advance(&mut self.particles, &ageing);
        } else {
            // No collision separates motion from ageing: one pass over the memory instead of two.
            motion.advance(&mut self.particles, vortex_particles, &mut |particles, first, len| {
                motion.follow(particles, vortex_particles, (first, len));
                life::advance_tile(particles, &ageing, first, len);
            });
            ended(StepPart::Motion);
            ended(StepPart::Collision);
        }
        self.shed(&motion);
        turbulence::advance(&mut self.turbulence, &self.parameters, STEP);
        self.active_inputs.advance();
        self.steps += 1;
        if self.steps.is_multiple_of(company::PERIOD) {
            company::update(&mut self.particles, &self.parameters);
        }
        hold::follow(&mut self.particles, self.steps, self.parameters.style.hold as u64);
        self.parts.end();
        self.apply_due_inputs();
        ended(StepPart::Rest);
    }

    /// Writes the rows of `view` (see [`View`]) and returns their number. A malformed view is an error and leaves the
    /// rows of the last call.
    pub fn arrange(&mut self, view: &[f32]) -> Result<usize, ParameterError> {
        let view = View::new(view)?;
        let sampler = RowSampler {
            sides: view.sides,
            upright: view.upright,
            ..self.sampler(view.blend)
        };
        Ok(self.arranger.arrange(&self.particles, &view, &sampler))
    }

    /// Lamps at the glowing parts of smoke, as [`glow::lamps`] documents them. `blend`: elapsed share of the step, 0..1.
    pub fn glow(&self, blend: f32, colors: &[f32]) -> Vec<f32> {
        glow::lamps(&self.particles, &self.sampler(blend), colors)
    }

    // Called twice; inlined, it would take more space.
    #[inline(never)]
    fn sampler(&self, blend: f32) -> RowSampler {
        RowSampler {
            radii: RadiusLaw::new(&self.parameters),
            flow: self.particles.flow.as_ref().map(|_| FlowLaw::new(&self.parameters)),
            billow: self.parameters.puff.billow as f32,
            // Held particles do not move between steps.
            blend: if self.particles.held.is_some() { 1.0 } else { blend },
            dt: STEP as f32,
            sides: 1,
            upright: 0.0,
        }
    }

    /// Rows of x, y, z and radius (m). Valid up to the count of the last `arrange`.
    pub fn place(&self) -> &[[f32; 4]] {
        self.arranger.place()
    }

    /// Rows of packed attributes, see `rows`. Valid up to the count of the last `arrange`.
    pub fn attributes(&self) -> &[Attributes] {
        self.arranger.attributes()
    }

    /// See [`Arranger::whole`].
    pub fn whole(&self) -> usize {
        self.arranger.whole()
    }

    /// See [`Arranger::moves`]. Valid until the next step.
    pub fn moves(&self) -> Vec<[f32; 3]> {
        self.arranger.moves(&self.particles)
    }

    /// One more than the highest variation of a living particle; 0 without particles.
    pub fn variations_alive(&self) -> u32 {
        let living = &self.particles.attributes[..self.particles.alive()];
        living
            .iter()
            .map(|attributes| 1 + (attributes & 0xff))
            .max()
            .unwrap_or(0)
    }

    /// Minimum corner and maximum corner (m) of all particles at the last `arrange`, radii included, then the largest
    /// radius. Zeros if no particle is visible.
    pub fn bounds(&self) -> &[f32; 7] {
        self.arranger.bounds()
    }

    /// See [`Arranger::coverage_shape`].
    pub fn coverage_shape(&self) -> [f32; 6] {
        self.arranger.coverage_shape()
    }

    /// See [`Arranger::coverage_depths`].
    pub fn coverage_depths(&self) -> &[f32] {
        self.arranger.coverage_depths()
    }

    /// Number of living particles.
    pub fn alive(&self) -> usize {
        self.particles.alive()
    }

    /// Maximum number of living particles.
    pub fn capacity(&self) -> usize {
        self.particles.capacity()
    }

    /// Number of births that wait for capacity.
    pub fn waiting(&self) -> u64 {
        self.births.waiting()
    }

    /// Number of steps made.
    pub fn steps(&self) -> u64 {
        self.steps
    }

    /// The seed of the random numbers.
    pub fn seed(&self) -> u32 {
        self.seed
    }

    /// The particles.
    pub fn particles(&self) -> &Particles {
        &self.particles
    }

    /// Air velocity (m/s) at `place` (m) in the middle of the coming step.
    pub fn air_velocity(&self, place: [f32; 3]) -> [f32; 3] {
        self.motion().air_velocity(place, self.vortex_particles.as_deref())
    }

    /// Adds a vortex particle without a shedder. Beyond the limit the oldest is removed. Returns false and changes
    /// nothing if `particle` is invalid.
    pub fn add_vortex_particle(&mut self, particle: &VortexParticle) -> bool {
        self.vortex_particles_mut().add(particle)
    }

    /// Number of vortex particles.
    pub fn vortex_particles(&self) -> usize {
        self.vortex_particles.as_ref().map_or(0, |all| all.count())
    }

    /// Vortex particle `index`, in the order of shedding.
    pub fn vortex_particle(&self, index: usize) -> Option<VortexParticle> {
        self.vortex_particles.as_ref()?.get(index)
    }

    /// The rigids.
    #[cfg(feature = "meshes")]
    pub fn rigids(&self) -> &Rigids {
        &self.rigids
    }

    /// Mutable access to the rigids.
    #[cfg(feature = "meshes")]
    pub fn rigids_mut(&mut self) -> &mut Rigids {
        &mut self.rigids
    }

    /// Hash of the state: living particles, rigids, colliders of the pool, emitters, turbulence, vortex particles, random numbers and the step
    /// count. Parameters are inputs and not part of it.
    pub fn hash(&self) -> u64 {
        let mut hash = Hash::new();
        hash.long(self.steps);
        hash.long(self.random.state());
        hash.long(self.particles.alive() as u64);
        for column in self.particles.float_columns() {
            hash.floats(&column[..self.particles.alive()]);
        }
        // As without looks, which only add to the hash.
        for i in 0..self.particles.alive() {
            hash.word(self.particles.attributes[i] & OTHER_BITS | self.particles.tint(i) << 28);
        }
        if let Some(looks) = &self.particles.looks
            && looks.entries != [NO_LOOK; LOOK_LIMIT]
        {
            let living = &self.particles.attributes[..self.particles.alive()];
            living.iter().for_each(|attributes| hash.word(attributes >> 28));
            let mut body = Writer::default();
            looks.entries.iter().for_each(|entry| write_look(&mut body, entry));
            hash.bytes(&body.finish());
        }
        if let Some(company) = &self.particles.company {
            hash.floats(&company.extra_ageing[..self.particles.alive()]);
        }
        let debts = self.births.debts();
        debts.iter().for_each(|debt| hash.long(debt.owed.to_bits()));
        for TurbulenceState { drift, phase } in &self.turbulence {
            drift
                .iter()
                .chain([phase])
                .for_each(|number| hash.long(number.to_bits()));
        }
        debts.iter().for_each(|debt| hash.long(debt.waiting));
        self.births.hash_places_into(&mut hash);
        self.active_inputs.hash_into(&mut hash);
        if let Some(all) = &self.vortex_particles {
            all.hash_into(&mut hash);
        }
        self.colliders.hash_into(&mut hash);
        #[cfg(feature = "meshes")]
        self.rigids.hash_into(&mut hash);
        hash.finish()
    }

    /// Changes the maximum number of particles. Living particles are kept; if they exceed the new capacity, those
    /// nearest to their death are removed.
    pub fn resize(&mut self, capacity: u32) -> Result<(), ParameterError> {
        let room = check_capacity(capacity)?;
        self.put_particles(self.particles.resized(room));
        Ok(())
    }

    /// Replaces the particles, and the buffers if the capacity differs.
    pub(crate) fn put_particles(&mut self, particles: Particles) {
        let room = particles.capacity();
        if room != self.capacity() {
            self.arranger = Arranger::new(room);
            self.scratch = Scratch::new(room);
        }
        self.particles = particles;
    }

    fn integrator(&self) -> Integrator {
        Integrator::from_parameter(self.parameters.simulation.integrator)
    }

    fn motion(&self) -> ParticleMotion {
        ParticleMotion::new(&self.context())
    }

    fn context(&self) -> ForceContext<'_> {
        ForceContext {
            parameters: &self.parameters,
            now: self.now(),
            seed: self.seed,
            turbulence: &self.turbulence,
            gusts: self.active_inputs.gusts(),
            prepared: &self.prepared,
        }
    }

    fn now(&self) -> StepTime<'_> {
        StepTime {
            time: (self.steps as f64 + 0.5) * STEP,
            dt: STEP,
            poses: self.rigid_poses(),
            parts: &self.parts,
        }
    }

    /// Computes what rare forces derive from the places of particles.
    fn measure_smoke(&mut self) {
        let mut prepared = std::mem::take(&mut self.prepared);
        prepared.measure(&self.parameters, &self.particles, &self.now());
        self.prepared = prepared;
    }

    /// Returns true if particles can meet any obstacle.
    fn has_obstacles(&self) -> bool {
        #[cfg(feature = "meshes")]
        if self.rigids.count() > 0 {
            return true;
        }
        !self.parameters.colliders.items().is_empty() || !self.colliders.is_empty()
    }

    #[cfg(feature = "meshes")]
    fn rigid_poses(&self) -> &[f32] {
        self.rigids.poses()
    }

    #[cfg(not(feature = "meshes"))]
    fn rigid_poses(&self) -> &[f32] {
        &[]
    }

    fn begin_parts(&mut self) {
        self.parts.begin();
        #[cfg(feature = "meshes")]
        self.parts.carry(self.rigids.poses());
    }

    fn spawn(&mut self, motion: &ParticleMotion) {
        let around = EmissionContext {
            parameters: &self.parameters,
            surfaces: &self.surfaces,
            parts: &self.parts,
            #[cfg(feature = "meshes")]
            rigid: &|number| self.rigids.ride(number),
            seed: self.seed,
            step: self.steps,
            time: (self.steps as f64 + 0.5) * STEP,
            dt: STEP,
        };
        let first = self.particles.alive();
        self.births.step(&around, &mut self.random, &mut self.particles);
        if self.particles.alive() > first {
            motion.launch(&mut self.particles, first, self.vortex_particles.as_deref());
        }
    }

    fn shed(&mut self, motion: &ParticleMotion) {
        if let Some(mut all) = self.vortex_particles.take() {
            all.step(motion, &self.context());
            self.vortex_particles = Some(all);
        }
    }

    fn vortex_particles_mut(&mut self) -> &mut VortexParticles {
        let seed = self.seed;
        self.vortex_particles
            .get_or_insert_with(|| Box::new(VortexParticles::new(seed)))
    }

    fn collide(&mut self) {
        collisions::resolve(
            &mut self.particles,
            &RadiusLaw::new(&self.parameters),
            analytic::obstacles(&self.parameters).chain(self.colliders.obstacles()),
            #[cfg(feature = "meshes")]
            &mut self.rigids,
            STEP as f32,
            &mut self.scratch,
        );
    }
}
