//! Colliders in closed form: restitution, friction, containment.

use sim::collide::analytic::{AnalyticCollider, ColliderShape};
use sim::particles::radius::RadiusLaw;
use sim::particles::{Newborn, Particles};
#[cfg(feature = "rigids")]
use sim::rigids::Rigids;
use sim::simulator::collisions::{Scratch, resolve};

const DT: f32 = 1.0 / 60.0;
const RADII: RadiusLaw = RadiusLaw::linear(1.0, 0.0);
/// A lifetime so long that the radius does not change during a test.
const LIFETIME: f32 = 1e9;

const GROUND: AnalyticCollider = AnalyticCollider {
    shape: ColliderShape::Plane,
    position: [0.0; 3],
    axis: [0.0, 1.0, 0.0],
    half_extents: [0.5; 3],
    radius: 0.5,
    restitution: 0.0,
    friction: 0.0,
    roughness: 0.0,
    action: sim::collide::contact::Action::Bounce,
};

struct Probe {
    position: [f32; 3],
    slip: [f32; 3],
}

/// One particle of radius `radius` goes from `from` to `to` in a step, meeting `colliders`; `age` is 0 or, for a
/// new one, minus the seconds of the step before its birth.
fn fly(from: [f32; 3], to: [f32; 3], radius: f32, age: f32, colliders: &[AnalyticCollider]) -> Probe {
    let mut particles = Particles::new(1);
    let newborn = Newborn {
        position: from,
        slip: [0.0; 3],
        age,
        lifetime: LIFETIME,
        size: radius,
        temperature: 0.0,
        attributes: 0,
    };
    assert!(particles.push(&newborn));
    let span = DT + age;
    let velocity: [f32; 3] = std::array::from_fn(|axis| (to[axis] - from[axis]) / span);
    [particles.x[0], particles.y[0], particles.z[0]] = to;
    [particles.sx[0], particles.sy[0], particles.sz[0]] = velocity;
    let mut scratch = Scratch::new(1);
    resolve(
        &mut particles,
        &RADII,
        colliders.iter().map(AnalyticCollider::obstacle),
        #[cfg(feature = "rigids")]
        &mut Rigids::new(),
        DT,
        &mut scratch,
    );
    Probe {
        position: [particles.x[0], particles.y[0], particles.z[0]],
        slip: [particles.sx[0], particles.sy[0], particles.sz[0]],
    }
}

fn near(a: f32, b: f32, tolerance: f32) -> bool {
    (a - b).abs() <= tolerance
}

#[test]
fn restitution_reflects_the_normal_velocity_and_friction_reduces_the_tangential_one() {
    for (restitution, friction) in [(0.0, 0.0), (0.5, 0.0), (1.0, 0.0), (0.3, 0.2), (0.0, 1.0)] {
        let ground = AnalyticCollider {
            restitution,
            friction,
            ..GROUND
        };
        // 0.1 m above the ground after a fall at 6 m/s, 3 m/s along it; half of the step's way is free.
        let probe = fly([0.0, 0.15, 0.0], [0.05, 0.05, 0.0], 0.1, 0.0, &[ground]);
        assert!(
            near(probe.slip[0], 3.0 * (1.0 - friction), 1e-3),
            "along {:?} {friction}",
            probe.slip
        );
        assert!(
            near(probe.slip[1], 6.0 * restitution, 1e-3),
            "back {:?} {restitution}",
            probe.slip
        );
        assert!(
            near(probe.position[1], 0.1 + 0.05 * restitution, 3e-3),
            "height {:?}",
            probe.position
        );
    }
}

#[test]
fn receding_particles_are_not_changed() {
    let probe = fly([0.0, 0.05, 0.0], [0.1, 0.15, 0.0], 0.1, 0.0, &[GROUND]);
    assert_eq!(probe.position, [0.1, 0.15, 0.0]);
    assert!(near(probe.slip[1], 6.0, 1e-4));
}

#[test]
fn a_newborn_keeps_the_velocity_of_its_partial_step() {
    // Spawned after 3/4 of the step; falls at 12 m/s for the last quarter.
    let probe = fly(
        [0.0, 0.12, 0.0],
        [0.0, 0.07, 0.0],
        0.1,
        -0.75 * DT,
        &[AnalyticCollider {
            restitution: 1.0,
            ..GROUND
        }],
    );
    assert!(near(probe.slip[1], 12.0, 0.01), "{:?}", probe.slip);
}

#[test]
fn thin_fixed_plate_stops_particles_of_50_metres_a_second() {
    let plate = AnalyticCollider {
        shape: ColliderShape::Box,
        half_extents: [2.0, 0.01, 2.0],
        friction: 0.1,
        ..GROUND
    };
    let way = 50.0 * DT;
    for k in 0..200 {
        let share = k as f32 / 200.0;
        let slant = 0.4 * (share - 0.5);
        let top = 0.02 + share * way;
        for side in [1.0, -1.0] {
            let radius = 0.01 + 0.2 * share;
            let probe = fly(
                [slant, side * top, 0.0],
                [0.0, side * (top - way), 0.0],
                radius,
                0.0,
                &[plate],
            );
            assert!(
                probe.position[1] * side >= 0.01 + 0.95 * radius.min(top),
                "{k}: {:?} {radius}",
                probe.position
            );
        }
    }
}

#[test]
fn corners_hold_the_particle_out_of_both_planes_even_where_the_wall_hangs_over() {
    let wall = |x: f32, y: f32| AnalyticCollider {
        axis: [x, y, 0.0],
        ..GROUND
    };
    let pairs = [
        [GROUND, wall(1.0, 0.0)],
        [wall(1.0, 0.0), GROUND],
        [GROUND, wall(0.8, -0.6)],
        [wall(0.8, -0.6), GROUND],
        [GROUND, wall(0.8, 0.6)],
    ];
    for pair in pairs {
        let probe = fly([0.5, 0.2, 0.0], [0.02, 0.02, 0.1], 0.1, 0.0, &pair);
        for plane in pair {
            let distance: f32 = (0..3).map(|axis| plane.axis[axis] * probe.position[axis]).sum();
            assert!(distance >= 0.095, "{distance} {:?} {plane:?}", probe.position);
        }
    }
}

#[test]
fn every_shape_keeps_the_whole_sphere_outside() {
    let shapes = [ColliderShape::Ball, ColliderShape::Box, ColliderShape::Capsule];
    for shape in shapes {
        let axis = [0.6, 0.8, 0.0];
        let obstacle = AnalyticCollider {
            shape,
            axis,
            radius: 0.3,
            half_extents: [0.2, 0.4, 0.3],
            ..GROUND
        };
        for k in 0..500 {
            let random = |salt: u32| ((k * 7919 + salt * 104_729) % 1009) as f32 / 1009.0 - 0.5;
            let from = [2.0 * random(1), 3.0, 2.0 * random(2)];
            let to = [random(3), random(4), random(5)];
            let probe = fly(from, to, 0.1, 0.0, &[obstacle]);
            let distance = distance_to(&obstacle, probe.position);
            assert!(distance >= 0.1 * 0.95, "{shape:?} {k}: {distance}");
        }
    }
}

/// An independent reference: the distance to the nearest of many points of the axis or the box.
fn distance_to(collider: &AnalyticCollider, point: [f32; 3]) -> f32 {
    let [ax, ay, _] = collider.axis;
    // The frame in which `axis` is y, for an axis in the plane z = 0.
    let local = [ay * point[0] - ax * point[1], ax * point[0] + ay * point[1], point[2]];
    let gap = |part: f32, half: f32| (part.abs() - half).max(0.0);
    let [hx, hy, hz] = collider.half_extents;
    let length = |v: [f32; 3]| (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]).sqrt();
    match collider.shape {
        ColliderShape::Plane => local[1],
        ColliderShape::Ball => length(local) - collider.radius,
        ColliderShape::Box => length([gap(local[0], hx), gap(local[1], hy), gap(local[2], hz)]),
        ColliderShape::Capsule => length([local[0], gap(local[1], hy), local[2]]) - collider.radius,
    }
}

#[test]
fn a_particle_that_begins_inside_is_brought_to_the_surface() {
    let ball = AnalyticCollider {
        shape: ColliderShape::Ball,
        radius: 1.0,
        ..GROUND
    };
    let probe = fly([0.2, 0.1, 0.0], [0.2, 0.1, 0.0], 0.1, 0.0, &[ball]);
    assert!(near(distance_to(&ball, probe.position), 0.1, 1e-5));
}

/// Heights at which old puffs of 0.2 m come to rest on a ground of this roughness, by their seed bytes.
fn rests(roughness: f32, worn: f32, seeds: &[u32]) -> Vec<f32> {
    let mut particles = Particles::new(seeds.len());
    for (i, seed) in seeds.iter().enumerate() {
        let newborn = Newborn {
            position: [i as f32, 0.3, 0.0],
            slip: [0.0; 3],
            age: worn * LIFETIME,
            lifetime: LIFETIME,
            size: 0.2,
            temperature: 0.0,
            attributes: seed << 8 | 0xff_0000,
        };
        assert!(particles.push(&newborn));
        particles.y[i] = 0.01;
    }
    let ground = AnalyticCollider { roughness, ..GROUND };
    let mut scratch = Scratch::new(seeds.len());
    resolve(
        &mut particles,
        &RADII,
        [ground.obstacle()].into_iter(),
        #[cfg(feature = "rigids")]
        &mut Rigids::new(),
        DT,
        &mut scratch,
    );
    particles.y[..seeds.len()].to_vec()
}

#[test]
fn on_a_rough_surface_each_worn_puff_keeps_its_own_distance() {
    let seeds = [0, 51, 102, 153, 204, 255];
    let close = |found: Vec<f32>, expected: [f32; 6]| {
        let all = found.iter().zip(expected).all(|(a, b)| near(*a, b, 1e-4));
        assert!(all, "{found:?} is not {expected:?}");
    };
    close(rests(0.0, 0.9, &seeds), [0.02; 6]);
    close(rests(1.0, 0.9, &seeds), [0.02, 0.056, 0.092, 0.128, 0.164, 0.2]);
    close(rests(0.5, 0.9, &seeds), [0.02, 0.038, 0.056, 0.074, 0.092, 0.11]);
    // A puff that has lost no size keeps only its own radius as distance.
    close(rests(1.0, 0.0, &seeds), [0.2; 6]);
}
