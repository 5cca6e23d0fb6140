//! Motion of particles in one step.
//!
//! Air and slip: a particle moves with the air and with its slip, on which accelerations and drag act. The slip has a
//! closed form (see `forces::drag`). The air follows a midpoint rule: its velocity is evaluated half of the last
//! displacement ahead. Velocities hardly change within a step, so this is the middle of the step up to second order, at
//! half the cost of a trial step. Evaluation at the start would throw particles out of vortices. After a second in
//! turbulence of one octave, 1 m and 0.6 m/s, on paths of 0.5 m, the error is 0.5 mm; a trial step has 0.1 mm,
//! evaluation at the start 10 mm (100, 14 and 380 mm at 2 m/s). A vortex uses the direction at the middle, found by a
//! half step (see `forces::vortex`).
//!
//! Paper: forward Euler on one inertial velocity v, as published: x += v h, v += k h (u - v) + a h. The air acts only
//! through drag, and vortices throw particles outwards.

use wide::f32x4;

use crate::forces::Forces;
use crate::forces::drag::Factors;
use crate::forces::force::{ForceContext, Phase};
use crate::forces::looks::MotionLaws;
use crate::forces::vortex_particles::VortexParticles;
use crate::forces::{buoyancy, drag, gravity};
use crate::layout::limits::STEP;
use crate::layout::parameters::settings::Integrator;
use crate::math::simd::{LANES, Vector4, blocks, blocks_mut, positive_part, smaller};
use crate::particles::Particles;
use crate::particles::entrainment::Entrainment;
use crate::particles::following::{self, FlowLaw};
use crate::particles::tile::{Columns, Tile, tiles};

/// The motion of particles in one step.
pub struct ParticleMotion {
    pub integrator: Integrator,
    forces: Forces,
    entrainment: Option<Entrainment>,
    flow: FlowLaw,
    lift: Lift,
    /// Factors of the global drag, and its rate (1/s).
    drag: Factors,
    rate: f32x4,
    exact_rate: f64,
    /// Factor on the velocity of vortex particles.
    vortex_scale: f32,
    dt: f32,
    /// Number of steps before this one.
    step: u64,
}

/// Global accelerations along y: one number per particle. Where up is another direction, forces replace them.
struct Lift {
    gravity: f32x4,
    buoyancy: f32x4,
}

impl Lift {
    #[inline(always)]
    fn acceleration(&self, temperature: f32x4) -> f32x4 {
        self.buoyancy * temperature - self.gravity
    }

    /// The same with a factor on gravity.
    #[inline(always)]
    fn acceleration_by(&self, temperature: f32x4, gravity: f32x4) -> f32x4 {
        self.buoyancy * temperature - self.gravity * gravity
    }
}

impl ParticleMotion {
    /// Prepares the motion for `context`.
    pub fn new(context: &ForceContext) -> Self {
        let parameters = context.parameters;
        let rate = drag::rate(parameters);
        let upright = if context.now.parts.up.is_none() { 1.0 } else { 0.0 };
        Self {
            integrator: Integrator::from_parameter(parameters.simulation.integrator),
            forces: Forces::new(context),
            entrainment: Entrainment::new(parameters, context.now.dt),
            flow: FlowLaw::new(parameters),
            lift: Lift {
                gravity: f32x4::splat(upright * gravity::acceleration(parameters)),
                buoyancy: f32x4::splat(upright * buoyancy::acceleration_per_temperature(parameters)),
            },
            drag: Factors::new(rate, context.now.dt),
            rate: f32x4::splat(rate as f32),
            exact_rate: rate,
            vortex_scale: parameters.forces.vortex as f32,
            dt: context.now.dt as f32,
            step: (context.now.time / context.now.dt) as u64,
        }
    }

    /// Moves all particles by one step and stores the positions at its start in `px`, `py` and `pz`. Tiles are
    /// processed from last to first. `moved` receives the first block and the number of blocks of each tile while it is
    /// in the cache, and may remove particles there.
    pub fn advance(
        &self,
        particles: &mut Particles,
        vortex_particles: Option<&VortexParticles>,
        moved: &mut dyn FnMut(&mut Particles, usize, usize),
    ) {
        let mut tile = Tile::new(self.dt, self.integrator == Integrator::Paper);
        let looks = particles.looks.as_ref();
        let laws = looks.and_then(|looks| MotionLaws::new(looks, self.exact_rate, STEP));
        for (first, len) in tiles(particles, 0).rev() {
            tile.load(particles, first, len);
            let laws = laws.as_ref();
            let laws = laws.filter(|laws| laws.load(&mut tile, &particles.attributes, first));
            self.air(&mut tile, vortex_particles);
            self.forces.act(Phase::Push, &mut tile);
            match self.integrator {
                Integrator::AirAndSlip => self.air_and_slip(&mut tile, laws),
                Integrator::Paper => self.paper(&mut tile, laws),
            }
            if let Some(entrainment) = &self.entrainment {
                entrainment.act(tile.columns().slipped, particles, first);
            }
            store(&mut tile, particles, first);
            moved(particles, first, len);
        }
    }

    /// Turns and stretches the particles of a tile after a step of theirs, if parameters say so.
    pub fn follow(
        &self,
        particles: &mut Particles,
        vortex_particles: Option<&VortexParticles>,
        (first, len): (usize, usize),
    ) {
        if particles.flow.is_some() {
            let air = |tile: &mut Tile| self.blow(tile, vortex_particles);
            let winds = |tile: &mut Tile| self.forces.wind(tile);
            following::follow(&self.flow, particles, (first, len), self.step, air, winds);
        }
    }

    /// Displaces the particles born within this step, from index `first` on, so that the full step that follows takes
    /// them only over the rest of the step.
    pub fn launch(&self, particles: &mut Particles, first: usize, vortex_particles: Option<&VortexParticles>) {
        let mut tile = Tile::new(self.dt, true);
        for (first, len) in tiles(particles, first / LANES) {
            tile.load(particles, first, len);
            if self.integrator == Integrator::AirAndSlip {
                self.blow(&mut tile, vortex_particles);
            }
            let ages = &blocks(&particles.age, first + len)[first..];
            let Columns { flow, slip, .. } = tile.columns();
            for ((flow, slip), age) in flow.iter_mut().zip(&*slip).zip(ages) {
                let delay = positive_part(f32x4::ZERO - f32x4::new(*age));
                *flow = (*flow + *slip) * delay;
            }
            put_back(flow, particles, first);
        }
    }

    /// Air velocity (m/s) at a place.
    pub fn air_velocity(&self, place: [f32; 3], vortex_particles: Option<&VortexParticles>) -> [f32; 3] {
        let mut tile = Tile::at(place, self.dt);
        self.blow(&mut tile, vortex_particles);
        tile.columns().flow[0].first()
    }

    /// Converts slip to velocity or back, so that a change to the integrator of `self` is continuous.
    pub fn take_over(&self, particles: &mut Particles, vortex_particles: Option<&VortexParticles>) {
        let sign = f32x4::splat(if self.integrator == Integrator::Paper {
            1.0
        } else {
            -1.0
        });
        let mut tile = Tile::new(self.dt, true);
        for (first, len) in tiles(particles, 0) {
            tile.load(particles, first, len);
            self.blow(&mut tile, vortex_particles);
            let Columns { flow, slip, .. } = tile.columns();
            for (slip, flow) in slip.iter_mut().zip(flow) {
                *slip += *flow * sign;
            }
            put_slip(slip, particles, first);
        }
    }

    /// Adds the air velocity of all forces to the flow of `tile`.
    #[inline(never)]
    pub fn blow(&self, tile: &mut Tile, vortex_particles: Option<&VortexParticles>) {
        self.air(tile, vortex_particles);
        self.forces.act(Phase::Swirl, tile);
    }

    /// Adds the air velocity without the phase `Swirl`.
    #[inline(always)]
    fn air(&self, tile: &mut Tile, vortex_particles: Option<&VortexParticles>) {
        self.forces.act(Phase::Air, tile);
        if let Some(vortex_particles) = vortex_particles {
            vortex_particles.act(self.vortex_scale, tile);
        }
    }

    /// `laws`: those of looks, if any particle of the tile moves by them.
    #[inline(always)]
    fn air_and_slip(&self, tile: &mut Tile, laws: Option<&MotionLaws>) {
        if tile.is_dragged || laws.is_some() {
            self.push_by_rates(tile, laws);
        } else if tile.is_pushed {
            self.push(tile, |_, _| self.drag, |heat, _| self.lift.acceleration(heat));
        } else {
            self.glide(tile);
        }
        self.forces.act(Phase::Swirl, tile);
        self.forces.act(Phase::Limit, tile);
        let dt = f32x4::splat(self.dt);
        let Columns {
            ahead,
            place,
            flow,
            slipped,
            ..
        } = tile.columns();
        let ways = place.iter().zip(&*flow).zip(&*slipped);
        for (ahead, ((place, flow), slipped)) in ahead.iter_mut().zip(ways) {
            *ahead = *place + *flow * dt + *slipped;
        }
    }

    /// Integrates slip under gravity, buoyancy and drag alone.
    #[inline(always)]
    fn glide(&self, tile: &mut Tile) {
        let Columns {
            slip, slipped, heat, ..
        } = tile.columns();
        for ((slip, slipped), heat) in slip.iter_mut().zip(slipped).zip(heat) {
            let lift = self.lift.acceleration(*heat);
            *slipped = *slip * self.drag.first;
            slipped.y += lift * self.drag.second;
            *slip = *slip * self.drag.kept;
            slip.y += lift * self.drag.first;
        }
    }

    /// Integrates slip with an acceleration, a rate of drag and factors on both for each particle.
    #[inline(never)]
    fn push_by_rates(&self, tile: &mut Tile, laws: Option<&MotionLaws>) {
        let is_dragged = tile.is_dragged;
        let factors = |resistance, looks: &_| {
            let mut rates = self.rate + resistance;
            if let Some(laws) = laws {
                let [kept, first, second, factor] = laws.drag(looks);
                if !is_dragged {
                    return Factors { kept, first, second };
                }
                rates *= factor;
            }
            Factors::of_rates(rates, self.dt)
        };
        let lift = |heat, gravity| match laws {
            None => self.lift.acceleration(heat),
            Some(_) => self.lift.acceleration_by(heat, gravity),
        };
        self.push(tile, factors, lift);
    }

    /// Integrates slip with an acceleration per particle.
    ///
    /// # Arguments
    /// * `factors` - The factors by the rate of drag of particles, without the global one, and their looks.
    /// * `lift` - The global acceleration along y by the temperature and the factor on gravity.
    #[inline(always)]
    fn push(
        &self,
        tile: &mut Tile,
        factors: impl Fn(f32x4, &[u8; LANES]) -> Factors,
        lift: impl Fn(f32x4, f32x4) -> f32x4,
    ) {
        let Columns {
            slip,
            slipped,
            push,
            resistance,
            looks,
            gravity,
            heat,
            ..
        } = tile.columns();
        for (block, slip) in slip.iter_mut().enumerate() {
            let Factors { kept, first, second } = factors(resistance[block], &looks[block]);
            let mut push = push[block];
            push.y += lift(heat[block], gravity[block]);
            slipped[block] = *slip * first + push * second;
            *slip = *slip * kept + push * first;
        }
    }

    /// Explicit Euler oscillates for k h above 1: the product is limited to 1.
    #[inline(always)]
    fn paper(&self, tile: &mut Tile, laws: Option<&MotionLaws>) {
        self.forces.act(Phase::Swirl, tile);
        let dt = f32x4::splat(self.dt);
        let Columns {
            place,
            ahead,
            flow,
            slip,
            slipped,
            push,
            resistance,
            looks,
            gravity,
            heat,
            ..
        } = tile.columns();
        for (block, velocity) in slip.iter_mut().enumerate() {
            let (drag, gravity) = match laws {
                None => (f32x4::ONE, f32x4::ONE),
                Some(laws) => (laws.drag(&looks[block])[3], gravity[block]),
            };
            let share = smaller((self.rate + resistance[block]) * drag * dt, f32x4::ONE);
            ahead[block] = place[block] + *velocity * dt;
            slipped[block] = (*velocity - flow[block]) * dt;
            let mut push = push[block];
            push.y += self.lift.acceleration_by(heat[block], gravity);
            *velocity += (flow[block] - *velocity) * share + push * dt;
        }
        self.forces.act(Phase::Limit, tile);
    }
}

/// Stores a tile after a step: `ahead` holds the positions at its end.
#[inline(always)]
fn store(tile: &mut Tile, particles: &mut Particles, first: usize) {
    let Columns { place, ahead, slip, .. } = tile.columns();
    let count = first + place.len();
    write(
        place,
        [&mut particles.px, &mut particles.py, &mut particles.pz],
        first,
        count,
    );
    write(
        ahead,
        [&mut particles.x, &mut particles.y, &mut particles.z],
        first,
        count,
    );
    put_slip(slip, particles, first);
}

/// Subtracts `back` (m) from the current and the previous positions.
fn put_back(back: &[Vector4], particles: &mut Particles, first: usize) {
    let count = first + back.len();
    let Particles {
        x, y, z, px, py, pz, ..
    } = particles;
    for [x, y, z] in [[x, y, z], [px, py, pz]] {
        let column = |column| &mut blocks_mut(column, count)[first..];
        let (x, y, z) = (column(x), column(y), column(z));
        for (block, back) in back.iter().enumerate() {
            x[block] = (f32x4::new(x[block]) - back.x).to_array();
            y[block] = (f32x4::new(y[block]) - back.y).to_array();
            z[block] = (f32x4::new(z[block]) - back.z).to_array();
        }
    }
}

#[inline(always)]
fn put_slip(slip: &[Vector4], particles: &mut Particles, first: usize) {
    let count = first + slip.len();
    write(
        slip,
        [&mut particles.sx, &mut particles.sy, &mut particles.sz],
        first,
        count,
    );
}

#[inline(always)]
fn write(vectors: &[Vector4], [x, y, z]: [&mut Vec<f32>; 3], first: usize, count: usize) {
    let (x, y, z) = (blocks_mut(x, count), blocks_mut(y, count), blocks_mut(z, count));
    let columns = x[first..].iter_mut().zip(&mut y[first..]).zip(&mut z[first..]);
    for (((x, y), z), vector) in columns.zip(vectors) {
        *x = vector.x.to_array();
        *y = vector.y.to_array();
        *z = vector.z.to_array();
    }
}
