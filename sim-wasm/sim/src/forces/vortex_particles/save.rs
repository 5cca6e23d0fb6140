//! Serialisation of vortex particles; empty before the first shedder.

use crate::forces::vortex_particles::VortexParticles;
use crate::forces::vortex_particles::shedding::Shedding;
use crate::forces::vortex_particles::swarm::{MAX_VORTEX_PARTICLES, Swarm};
use crate::layout::bytes::{Reader, SnapshotSection, Writer};
use crate::layout::error::RestoreError;
use crate::layout::parameters::item::LIST_LIMIT;
use crate::math::random::Random;

impl SnapshotSection for Option<Box<VortexParticles>> {
    fn write(&self, body: &mut Writer) {
        body.byte(u8::from(self.is_some()));
        let Some(all) = self else {
            return;
        };
        write_shedding(body, &all.shedding);
        body.word(all.swarm.count() as u32);
        for column in all.swarm.columns() {
            let values = &column[..all.swarm.count()];
            values.iter().for_each(|value| body.word(value.to_bits()));
        }
    }

    fn read(reader: &mut Reader) -> Result<Self, RestoreError> {
        match reader.byte()? {
            0 => return Ok(None),
            1 => {}
            _ => return Err(invalid_vortex_particle()),
        }
        let shedding = read_shedding(reader)?;
        let swarm = read_swarm(reader)?;
        Ok(Some(Box::new(VortexParticles::of(swarm, shedding))))
    }
}

fn write_shedding(body: &mut Writer, shedding: &Shedding) {
    shedding.owed.iter().for_each(|owed| body.number(*owed));
    shedding.due.iter().for_each(|due| body.long(*due));
    body.long(shedding.random.state());
}

fn read_shedding(reader: &mut Reader) -> Result<Shedding, RestoreError> {
    let mut shedding = Shedding::new(0);
    for index in 0..LIST_LIMIT {
        shedding.owed[index] = reader.number()?.clamp(-1.0, 1.0);
    }
    for index in 0..LIST_LIMIT {
        shedding.due[index] = reader.long()?;
    }
    shedding.random = Random::from_state(reader.long()?);
    Ok(shedding)
}

fn read_swarm(reader: &mut Reader) -> Result<Swarm, RestoreError> {
    let count = reader.word()? as usize;
    if count > MAX_VORTEX_PARTICLES {
        return Err(invalid_vortex_particle());
    }
    let mut swarm = Swarm::new();
    for column in swarm.columns_mut() {
        for value in &mut column[..count] {
            *value = reader.float()?;
        }
    }
    swarm.set_count(count);
    if (0..count).all(|i| swarm.get(i).is_sound()) {
        Ok(swarm)
    } else {
        Err(invalid_vortex_particle())
    }
}

fn invalid_vortex_particle() -> RestoreError {
    RestoreError::new("the saved simulation holds a vortex particle that no shedder can have shed")
}
