//! Evaluation of paths. Uses only arithmetic, square roots and libm: the same on every machine.

use crate::math::pose::Pose;
use crate::math::vector::Vector;
use crate::rigids::path::{Keyframe, Pace, Path};

/// Chords per piece of a spline, to measure its length.
const CHORDS: usize = 128;

/// A prepared path.
#[derive(Clone, Debug)]
pub enum Track {
    Keyframes { frames: Vec<Keyframe>, looped: bool },
    Spline(Spline),
}

impl Track {
    /// Prepares a path, whose numbers are valid.
    pub fn new(path: &Path) -> Self {
        match path {
            Path::Keyframes { frames, looped } => Track::Keyframes {
                frames: frames.clone(),
                looped: *looped,
            },
            Path::Spline {
                points,
                pace,
                looped,
                along,
            } => Track::Spline(Spline::new(points, *pace, *looped, *along)),
        }
    }

    /// The pose at `time` (s). `rotation` is used where the path defines none.
    pub fn pose(&self, time: f64, rotation: [f32; 4]) -> Pose {
        match self {
            Track::Keyframes { frames, looped } => between_frames(frames, *looped, time),
            Track::Spline(spline) => spline.pose(time, rotation),
        }
    }
}

fn between_frames(frames: &[Keyframe], looped: bool, time: f64) -> Pose {
    let (first, last) = (&frames[0], &frames[frames.len() - 1]);
    let [begin, end] = [first, last].map(|frame| f64::from(frame.time));
    let time = if looped && time > end && end > begin {
        begin + libm::fmod(time - begin, end - begin)
    } else {
        time
    };
    let next = frames.partition_point(|frame| f64::from(frame.time) <= time);
    if next == 0 || next == frames.len() {
        return if next == 0 { first.pose } else { last.pose };
    }
    let (from, to) = (&frames[next - 1], &frames[next]);
    let [start, stop] = [from, to].map(|frame| f64::from(frame.time));
    let fraction = ((time - start) / (stop - start)) as f32;
    Pose {
        position: from.pose.position.towards(to.pose.position, fraction),
        rotation: from
            .pose
            .rotated_by(from.pose.rotation_vector_to(&to.pose) * fraction)
            .rotation,
    }
}

/// A centripetal Catmull-Rom spline (Yuksel, Schaefer and Keyser, 'Parameterization and applications of Catmull-Rom
/// curves', 2011: no cusps or loops within a piece), parametrised by arc length.
#[derive(Clone, Debug)]
pub struct Spline {
    /// Coefficients of 1, u, u2, u3 for each piece, u in 0..1.
    pieces: Vec<[Vector; 4]>,
    /// Arc length (m) at the end of each chord.
    lengths: Vec<f32>,
    /// Duration of the whole path (s).
    duration: f64,
    looped: bool,
    along: bool,
}

impl Spline {
    fn new(points: &[[f32; 3]], pace: Pace, looped: bool, along: bool) -> Self {
        let count = if looped { points.len() } else { points.len() - 1 };
        let pieces: Vec<[Vector; 4]> = (0..count as isize)
            .map(|piece| {
                let [a, b, c, d] = [-1, 0, 1, 2].map(|step| knot(points, piece + step, looped));
                coefficients(a, b, c, d)
            })
            .collect();
        let mut lengths = Vec::with_capacity(count * CHORDS);
        let mut way = 0.0;
        for chord in 0..count * CHORDS {
            let [from, to] = [chord, chord + 1].map(|end| at_chord(&pieces, end as f32));
            way += (to - from).length();
            lengths.push(way);
        }
        let duration = match pace {
            Pace::Duration(seconds) => f64::from(seconds),
            Pace::Speed(speed) => f64::from(way) / f64::from(speed),
        };
        Self {
            pieces,
            lengths,
            duration,
            looped,
            along,
        }
    }

    fn pose(&self, time: f64, rotation: [f32; 4]) -> Pose {
        let turns = time / self.duration;
        let share = if self.looped {
            turns - libm::floor(turns)
        } else {
            turns.clamp(0.0, 1.0)
        };
        let chord = self.chord_at(share as f32);
        let position = at_chord(&self.pieces, chord);
        let rotation = if self.along {
            looking(self.direction(chord))
        } else {
            rotation
        };
        Pose { position, rotation }
    }

    /// Position at a share of the length, in chords.
    fn chord_at(&self, share: f32) -> f32 {
        let way = share * self.lengths[self.lengths.len() - 1];
        let chord = self
            .lengths
            .partition_point(|end| *end < way)
            .min(self.lengths.len() - 1);
        let begin = if chord == 0 { 0.0 } else { self.lengths[chord - 1] };
        let length = (self.lengths[chord] - begin).max(f32::MIN_POSITIVE);
        chord as f32 + ((way - begin) / length).clamp(0.0, 1.0)
    }

    fn direction(&self, chord: f32) -> Vector {
        let (piece, u) = piece_at(&self.pieces, chord);
        let [_, b, c, d] = self.pieces[piece];
        (b + c * (2.0 * u) + d * (3.0 * u * u)).unit_or(Vector::new(0.0, 0.0, 1.0))
    }
}

fn piece_at(pieces: &[[Vector; 4]], chord: f32) -> (usize, f32) {
    let along = chord / CHORDS as f32;
    let piece = (along as usize).min(pieces.len() - 1);
    (piece, along - piece as f32)
}

fn at_chord(pieces: &[[Vector; 4]], chord: f32) -> Vector {
    let (piece, u) = piece_at(pieces, chord);
    let [a, b, c, d] = pieces[piece];
    a + (b + (c + d * u) * u) * u
}

/// Point `index`, cyclic if looped; beyond an open end the reflection of the point before it.
fn knot(points: &[[f32; 3]], index: isize, looped: bool) -> Vector {
    let count = points.len() as isize;
    let point = |index: isize| Vector::from(points[index.rem_euclid(count) as usize]);
    if looped || (0..count).contains(&index) {
        point(index)
    } else if index < 0 {
        point(0) * 2.0 - point(1)
    } else {
        point(count - 1) * 2.0 - point(count - 2)
    }
}

/// Coefficients of the piece from `b` to `c`. Knot distances are square roots of the distances of the points.
fn coefficients(a: Vector, b: Vector, c: Vector, d: Vector) -> [Vector; 4] {
    let [before, here, after] = [b - a, c - b, d - c].map(|step| step.length().sqrt());
    let slope = |first: Vector, second: Vector, early: f32, late: f32| {
        first * (1.0 / early) - (first + second) * (1.0 / (early + late)) + second * (1.0 / late)
    };
    let start = slope(b - a, c - b, before, here) * here;
    let end = slope(c - b, d - c, here, after) * here;
    let step = c - b;
    [b, start, step * 3.0 - start * 2.0 - end, start + end - step * 2.0]
}

/// The rotation with the z axis along `ahead` and the y axis up as far as possible.
fn looking(ahead: Vector) -> [f32; 4] {
    let side = Vector::Y.cross(ahead);
    let x = side.unit_or(Vector::new(1.0, 0.0, 0.0));
    let y = ahead.cross(x);
    quaternion(x, y, ahead)
}

/// The rotation with these axes (Shepperd, 'Quaternion from rotation matrix', 1978: largest component first).
fn quaternion(x: Vector, y: Vector, z: Vector) -> [f32; 4] {
    let squares = [
        1.0 + x.x - y.y - z.z,
        1.0 - x.x + y.y - z.z,
        1.0 - x.x - y.y + z.z,
        1.0 + x.x + y.y + z.z,
    ];
    let largest = (1..4).fold(0, |best, part| if squares[part] > squares[best] { part } else { best });
    let mut parts = match largest {
        0 => [squares[0], x.y + y.x, z.x + x.z, y.z - z.y],
        1 => [x.y + y.x, squares[1], y.z + z.y, z.x - x.z],
        2 => [z.x + x.z, y.z + z.y, squares[2], x.y - y.x],
        _ => [y.z - z.y, z.x - x.z, x.y - y.x, squares[3]],
    };
    let scale = 0.5 / squares[largest].sqrt();
    parts.iter_mut().for_each(|part| *part *= scale);
    parts
}
