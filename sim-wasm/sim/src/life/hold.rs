//! Drawing on twos, threes and fours: a particle is shown as it was at its last *held moment*.
//!
//! With a hold of h each particle has a held moment every h / 24 s. Seed bytes stagger the moments. Held columns are
//! shown and saved, but do not affect the simulation or the hash.

use crate::particles::Particles;

/// Frames per second of the held film.
const FRAME_RATE: u64 = 24;
const STEP_RATE: u64 = 60;
/// Number of values of the seed byte.
const SEEDS: u64 = 256;

/// Updates the held columns of the particles that have a held moment at the end of step `step`, counted from 1, and of
/// those born in it. `hold`: 2..=4.
pub fn follow(particles: &mut Particles, step: u64, hold: u64) {
    let Some(mut held) = particles.held.take() else {
        return;
    };
    for i in 0..particles.alive() {
        let seed = u64::from(particles.attributes[i] >> 8 & 0xff);
        if held.age[i] < 0.0 || is_held_moment(step, hold, seed) {
            let now = [
                particles.x[i],
                particles.y[i],
                particles.z[i],
                particles.age[i],
                particles.size[i],
            ];
            held.columns_mut()
                .into_iter()
                .zip(now)
                .for_each(|(column, value)| column[i] = value);
            if let Some(flow) = &mut particles.flow {
                flow.hold_now(i);
            }
        }
    }
    particles.held = Some(held);
}

/// Returns true if a held moment of a seed lies at the end of a step.
fn is_held_moment(step: u64, hold: u64, seed: u64) -> bool {
    let moments = |step: u64| (step * FRAME_RATE * SEEDS + seed * hold * STEP_RATE) / (hold * STEP_RATE * SEEDS);
    moments(step) > moments(step - 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn held_moments_are_evenly_spaced_and_staggered() {
        for hold in 2..=4 {
            let steps = 600;
            let mut most = 0;
            for step in 1..=steps {
                most = most.max((0..SEEDS).filter(|seed| is_held_moment(step, hold, *seed)).count());
            }
            for seed in 0..SEEDS {
                let moments: Vec<u64> = (1..=steps).filter(|step| is_held_moment(*step, hold, seed)).collect();
                assert_eq!(moments.len() as u64, steps * FRAME_RATE / (hold * STEP_RATE));
                let gaps = moments.windows(2).map(|pair| pair[1] - pair[0]);
                let exact = hold * STEP_RATE;
                assert!(
                    gaps.clone()
                        .all(|gap| gap == exact / FRAME_RATE || gap == exact.div_ceil(FRAME_RATE))
                );
            }
            assert!(
                most as u64 <= SEEDS / (2 * hold),
                "{most} of {SEEDS} at once on a hold of {hold}"
            );
        }
    }
}
