//! Kinematic paths and spin against their closed forms.

use crate::collide::cloud::{DT, kinematic, rigid, turned};
use sim::Simulator;
use sim::math::pose::{Frame, Pose, product};
use sim::math::vector::Vector;
use sim::rigids::{Keyframe, POSE_PAIR_FLOATS, Pace, Path, RigidDescription, RigidKind, RigidShape, Rigids, Spin};

const BALL: RigidShape = RigidShape::Ball { radius: 0.5 };

fn with_path(path: Path, pose: Pose) -> RigidDescription {
    RigidDescription {
        path: Some(path),
        pose,
        ..kinematic(BALL)
    }
}

fn pose(rigids: &Rigids, index: usize) -> Pose {
    let [x, y, z, rotation @ ..] = <[f32; 7]>::try_from(&rigids.poses()[index * POSE_PAIR_FLOATS + 7..][..7]).unwrap();
    Pose {
        position: Vector::new(x, y, z),
        rotation,
    }
}

fn apart(a: &Pose, b: &Pose) -> f32 {
    (a.position - b.position).length() + a.rotation_vector_to(b).length()
}

fn frame(time: f32, x: f32, angle: f32) -> Keyframe {
    let pose = Pose {
        position: Vector::new(x, 1.0, 0.0),
        rotation: turned(Vector::Y, angle),
    };
    Keyframe { time, pose }
}

#[test]
fn keyframes_are_joined_at_an_even_pace_and_hold_or_loop() {
    for looped in [false, true] {
        let frames = vec![frame(0.5, 0.0, 0.0), frame(1.0, 2.0, 2.0), frame(2.0, 0.0, 0.0)];
        let mut rigids = Rigids::new();
        let start = frames[0].pose;
        rigids
            .add(with_path(Path::Keyframes { frames, looped }, start))
            .unwrap();
        for step in 1..=300 {
            rigids.advance(DT);
            let time = step as f32 * DT;
            let within = if looped && time > 2.0 {
                0.5 + (time - 0.5) % 1.5
            } else {
                time.min(2.0)
            };
            // Position and angle alternate between 0 and 2.
            let expected = if within < 1.0 {
                4.0 * (within - 0.5).max(0.0)
            } else {
                2.0 * (2.0 - within)
            };
            let expected = frame(0.0, expected, expected).pose;
            let error = apart(&pose(&rigids, 0), &expected);
            assert!(error < 2e-3, "looped {looped}, {time} s: {error}");
        }
    }
}

fn ring(count: usize) -> Vec<[f32; 3]> {
    let angle = |k: usize| k as f32 * std::f32::consts::TAU / count as f32;
    (0..count).map(|k| [angle(k).sin(), 0.0, angle(k).cos()]).collect()
}

#[test]
fn a_closed_spline_through_a_ring_is_a_circle_at_an_even_pace() {
    let path = Path::Spline {
        points: ring(12),
        pace: Pace::Duration(3.0),
        looped: true,
        along: true,
    };
    let mut rigids = Rigids::new();
    let start = Pose {
        position: Vector::new(0.0, 0.0, 1.0),
        rotation: turned(Vector::Y, 0.5 * std::f32::consts::PI),
    };
    rigids.add(with_path(path, start)).unwrap();
    for step in 1..=400 {
        rigids.advance(DT);
        let angle = std::f32::consts::TAU * step as f32 * DT / 3.0;
        let expected = Pose {
            position: Vector::new(angle.sin(), 0.0, angle.cos()),
            rotation: turned(Vector::Y, angle + 0.5 * std::f32::consts::PI),
        };
        let at = pose(&rigids, 0);
        assert!((at.position - expected.position).length() < 4e-3, "step {step}: {at:?}");
        assert!(at.rotation_vector_to(&expected).length() < 0.02, "step {step}: {at:?}");
    }
}

#[test]
fn an_open_spline_goes_through_its_points_at_the_speed_it_is_given_and_stays_at_its_end() {
    let points = vec![[0.0, 0.0, 0.0], [1.0, 0.2, 0.0], [1.1, 3.0, 0.5], [4.0, 3.0, -1.0]];
    let path = Path::Spline {
        points: points.clone(),
        pace: Pace::Speed(1.5),
        looped: false,
        along: false,
    };
    let tilted = Pose {
        position: Vector::ZERO,
        rotation: turned(Vector::new(1.0, 2.0, 0.0), 0.4),
    };
    let mut rigids = Rigids::new();
    rigids.add(with_path(path, tilted)).unwrap();
    let mut nearest = [f32::INFINITY; 4];
    let mut before = Vector::ZERO;
    for step in 0..400 {
        rigids.advance(DT);
        let at = pose(&rigids, 0);
        for (point, nearest) in points.iter().zip(&mut nearest) {
            *nearest = nearest.min((at.position - Vector::from(*point)).length());
        }
        let speed = (at.position - before).length() / DT;
        assert!(speed < 1.5 * 1.01, "step {step}: {speed}");
        assert!(speed > 1.5 * 0.97 || nearest[3] < 0.03, "step {step}: {speed}");
        assert!(at.rotation_vector_to(&tilted).length() < 1e-5);
        before = at.position;
    }
    assert!(nearest.iter().all(|nearest| *nearest < 0.025 + 1e-4), "{nearest:?}");
    assert!((before - Vector::from(points[3])).length() < 1e-5);
}

/// Barry and Goldman's pyramid of linear interpolations, which shares nothing with the simulator's polynomials.
fn centripetal(points: &[Vector; 4], u: f32) -> Vector {
    let mut knots = [0.0; 4];
    for k in 1..4 {
        knots[k] = knots[k - 1] + (points[k] - points[k - 1]).length().sqrt();
    }
    let t = knots[1] + (knots[2] - knots[1]) * u;
    let mut level = points.to_vec();
    for (height, count) in [(1, 3), (2, 2), (3, 1)] {
        // The top of the pyramid spans the middle knots again.
        let span = |k: usize| if height == 3 { (1, 2) } else { (k, k + height) };
        level = (0..count)
            .map(|k| {
                let (from, to) = span(k);
                level[k].towards(level[k + 1], (t - knots[from]) / (knots[to] - knots[from]))
            })
            .collect();
    }
    level[0]
}

#[test]
fn a_spline_is_the_centripetal_one() {
    let points = [[0.0, 0.0, 0.0], [0.2, 1.0, 0.0], [3.0, 1.2, 0.5], [3.1, 0.0, 0.0]];
    let path = Path::Spline {
        points: points.to_vec(),
        pace: Pace::Duration(4.0),
        looped: true,
        along: false,
    };
    let mut rigids = Rigids::new();
    rigids.add(with_path(path, Pose::at(Vector::ZERO))).unwrap();
    let curve: Vec<Vector> = (0..4)
        .flat_map(|piece| {
            let knots = [3, 0, 1, 2].map(|step| Vector::from(points[(piece + step) % 4]));
            (0..500).map(move |k| centripetal(&knots, k as f32 / 500.0))
        })
        .collect();
    for step in 0..240 {
        rigids.advance(DT);
        let at = pose(&rigids, 0).position;
        let off = curve
            .iter()
            .map(|point| (*point - at).length())
            .fold(f32::INFINITY, f32::min);
        assert!(off < 0.01, "step {step}: {at:?} is {off} m off the curve");
    }
}

#[test]
fn spin_combines_with_a_path_and_with_a_target() {
    let axis = Vector::new(0.0, 0.6, 0.8);
    let spinning = RigidDescription {
        spin: Spin { axis, rate: -50.0 },
        ..with_path(
            Path::Keyframes {
                frames: vec![frame(0.0, 0.0, 0.0), frame(10.0, 5.0, 1.0)],
                looped: false,
            },
            frame(0.0, 0.0, 0.0).pose,
        )
    };
    let mut rigids = Rigids::new();
    rigids.add(spinning.clone()).unwrap();
    rigids.add(RigidDescription { path: None, ..spinning }).unwrap();
    let target = frame(0.0, 1.0, 0.3).pose;
    rigids.move_to(1, target).unwrap();
    for step in 1..=60 {
        rigids.advance(DT);
        let time = step as f32 * DT;
        let spin = turned(axis, -50.0 * time);
        for (index, base) in [frame(0.0, 0.5 * time, 0.1 * time).pose, target]
            .into_iter()
            .enumerate()
        {
            let rotation = product(base.rotation, spin);
            let error = apart(&pose(&rigids, index), &Pose { rotation, ..base });
            assert!(error < 1e-3, "step {step}, rigid {index}: {error}");
        }
    }
    // A change of the rate continues from the current angle.
    let before = pose(&rigids, 1);
    rigids.set_spin(1, axis.into(), 3.0).unwrap();
    rigids.advance(DT);
    let turn = before.rotation_vector_to(&pose(&rigids, 1));
    let expected = Frame::new(&before).rotate(axis) * (3.0 * DT);
    assert!((turn - expected).length() < 1e-5, "{turn:?} for {expected:?}");
}

#[test]
fn a_path_follows_the_time_of_the_simulator_through_save_and_restore() {
    let path = Path::Spline {
        points: ring(7),
        pace: Pace::Duration(2.0),
        looped: true,
        along: true,
    };
    let description = RigidDescription {
        spin: Spin {
            axis: Vector::Y,
            rate: 10.0,
        },
        ..with_path(path, Pose::at(Vector::new(0.0, 0.0, 1.0)))
    };
    let mut simulator = Simulator::new(10, 1).unwrap();
    (0..50).for_each(|_| simulator.step());
    // There are no rigids to save yet, but the time continues in the restored simulator.
    let mut twin = Simulator::new(10, 1).unwrap();
    twin.restore(&simulator.save()).unwrap();
    for simulator in [&mut simulator, &mut twin] {
        simulator.rigids_mut().add(description.clone()).unwrap();
        (0..40).for_each(|_| simulator.step());
    }
    assert_eq!(twin.hash(), simulator.hash());
    let mut third = Simulator::new(10, 1).unwrap();
    third.restore(&simulator.save()).unwrap();
    (0..77).for_each(|_| simulator.step());
    (0..77).for_each(|_| third.step());
    assert_eq!(third.hash(), simulator.hash());
    // A round takes 120 steps; 167 have been taken.
    let at = pose(simulator.rigids(), 0).position;
    let angle = std::f32::consts::TAU * 167.0 / 120.0;
    assert!(
        (at - Vector::new(angle.sin(), 0.0, angle.cos())).length() < 0.03,
        "{at:?}"
    );
}

#[test]
fn invalid_numbers_are_errors_and_change_nothing() {
    let numbers: [(&[f32], &str); 12] = [
        (&[2.0], "rigid.path.type"),
        (&[0.0, 1.0], "rigid.path.keyframes"),
        (
            &[0.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0],
            "rigid.path.keyframes.0.time",
        ),
        (
            &[0.0, 0.0, 1.0, 0.0, f32::NAN, 0.0, 0.0, 0.0, 0.0, 1.0],
            "rigid.path.keyframes.0.position.y",
        ),
        (
            &[
                0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0,
            ],
            "rigid.path.keyframes.1.time",
        ),
        (&[1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0], "rigid.path.points"),
        (&[1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0], "rigid.path.points"),
        (
            &[1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
            "rigid.path.points.0",
        ),
        (
            &[1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1e6, 0.0],
            "rigid.path.points.1.y",
        ),
        (
            &[1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0],
            "rigid.path.duration",
        ),
        (
            &[1.0, 0.0, 0.0, 1.0, 1e3, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0],
            "rigid.path.speed",
        ),
        (
            &[1.0, 1.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0],
            "rigid.path.points.2",
        ),
    ];
    for (numbers, key) in numbers {
        assert_eq!(Path::from_numbers(numbers).unwrap_err().key, key);
    }
    let mut rigids = Rigids::new();
    rigids.add(kinematic(BALL)).unwrap();
    rigids
        .add(rigid(RigidKind::Dynamic, BALL, Pose::at(Vector::Y)))
        .unwrap();
    let spins: [(u32, [f32; 3], f32, &str); 5] = [
        (0, [0.0; 3], 1.0, "rigid.spin.axis"),
        (0, [0.0, f32::NAN, 0.0], 1.0, "rigid.spin.axis.y"),
        (0, [0.0, 1.0, 0.0], 500.0, "rigid.spin.rate"),
        (1, [0.0, 1.0, 0.0], 1.0, "rigid.index"),
        (7, [0.0, 1.0, 0.0], 1.0, "rigid.index"),
    ];
    for (index, axis, rate, key) in spins {
        assert_eq!(rigids.set_spin(index, axis, rate).unwrap_err().key, key);
    }
    let way = || Path::Keyframes {
        frames: vec![frame(0.0, 9.0, 0.0)],
        looped: false,
    };
    assert_eq!(rigids.set_path(1, Some(way())).unwrap_err().key, "rigid.index");
    let falling = RigidDescription {
        kind: RigidKind::Dynamic,
        ..with_path(way(), Pose::at(Vector::ZERO))
    };
    assert_eq!(rigids.add(falling).unwrap_err().key, "rigid.kind");
    rigids.advance(DT);
    assert_eq!(pose(&rigids, 0), Pose::at(Vector::ZERO));
}
