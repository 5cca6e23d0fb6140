//! Paths of kinematic rigids: descriptions and flat numbers.
//!
//! Keyframes: 0, looped (0 or 1), then time and pose (position, quaternion) of each frame. Spline: 1, looped, along (0
//! or 1), 0 and a duration or 1 and a speed, then x, y, z of each point. No numbers: no path.

use crate::layout::error::ParameterError;
use crate::math::pose::Pose;
use crate::rigids::checks::{AXES, PLACES, TOP_SPEED, pose_numbers, pose_under, ranged, shape_error};

const TIMES: (f64, f64) = (0.0, 1e5);
const DURATIONS: (f64, f64) = (1e-2, 1e5);
const SPEEDS: (f64, f64) = (1e-3, TOP_SPEED as f64);
const MAX_FRAMES: usize = 1024;
const MAX_POINTS: usize = 256;
/// Minimum distance of consecutive points (m), which defines a direction.
const MIN_DISTANCE: f32 = 1e-4;
const FRAME_NUMBERS: usize = 8;

/// A pose at a simulated time (s).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Keyframe {
    pub time: f32,
    pub pose: Pose,
}

/// The pace along a spline.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Pace {
    /// Duration of the whole path, 0.01..=100,000 s.
    Duration(f32),
    /// Speed, 0.001..=[`TOP_SPEED`] m/s.
    Speed(f32),
}

/// The pose of a kinematic rigid as a function of simulated time; 1..=1024 frames or 2..=256 points.
#[derive(Clone, Debug, PartialEq)]
pub enum Path {
    /// Interpolates between poses at an even pace, by the shorter rotation. The rigid rests at the first frame before
    /// its time, and at the last one afterwards, or repeats if `looped`. Times ascend, 0..=100,000.
    Keyframes { frames: Vec<Keyframe>, looped: bool },
    /// A centripetal Catmull-Rom spline through `points` at an even pace from time 0 on. `looped`: closed and repeated.
    /// `along`: the z axis points ahead and the y axis up as far as possible; else the rotation is kept.
    Spline {
        points: Vec<[f32; 3]>,
        pace: Pace,
        looped: bool,
        along: bool,
    },
}

impl Path {
    /// Reads and checks flat numbers. No numbers give no path.
    ///
    /// # Errors
    /// A number is missing, not finite or out of range; the key is `rigid.path.*`.
    pub fn from_numbers(numbers: &[f32]) -> Result<Option<Self>, ParameterError> {
        match numbers {
            [] => Ok(None),
            [0.0, looped, frames @ ..] => keyframes(frames, *looped == 1.0).map(Some),
            [1.0, looped, along, by_speed, pace, points @ ..] => Ok(Some(Path::Spline {
                points: points_of(points, *looped == 1.0)?,
                pace: pace_of(*by_speed == 1.0, *pace)?,
                looped: *looped == 1.0,
                along: *along == 1.0,
            })),
            [other, ..] => Err(ParameterError::out_of_range(
                "rigid.path.type",
                f64::from(*other),
                0.0,
                1.0,
            )),
        }
    }

    /// The inverse of [`Path::from_numbers`].
    pub fn to_numbers(&self) -> Vec<f32> {
        let flag = |is: bool| f32::from(u8::from(is));
        match self {
            Path::Keyframes { frames, looped } => {
                let frame = |frame: &Keyframe| [frame.time].into_iter().chain(pose_numbers(&frame.pose));
                [0.0, flag(*looped)]
                    .into_iter()
                    .chain(frames.iter().flat_map(frame))
                    .collect()
            }
            Path::Spline {
                points,
                pace,
                looped,
                along,
            } => {
                let (by_speed, pace) = match pace {
                    Pace::Duration(seconds) => (0.0, *seconds),
                    Pace::Speed(speed) => (1.0, *speed),
                };
                let mut numbers = vec![1.0, flag(*looped), flag(*along), by_speed, pace];
                numbers.extend(points.as_flattened());
                numbers
            }
        }
    }
}

fn keyframes(numbers: &[f32], looped: bool) -> Result<Path, ParameterError> {
    let (chunks, rest) = numbers.as_chunks::<FRAME_NUMBERS>();
    check_count("rigid.path.keyframes", chunks.len(), (1, MAX_FRAMES), rest.len())?;
    let mut frames: Vec<Keyframe> = Vec::with_capacity(chunks.len());
    for (index, [time, pose @ ..]) in chunks.iter().enumerate() {
        let name = format!("rigid.path.keyframes.{index}");
        let key = format!("{name}.time");
        let time = ranged(&key, *time, TIMES)?;
        if frames.last().is_some_and(|before| before.time >= time) {
            let message = format!("{key} is {time}; give each keyframe a later time than the one before it");
            return Err(shape_error(&key, f64::from(time), message));
        }
        let pose = pose_under(&name, pose)?;
        frames.push(Keyframe { time, pose });
    }
    Ok(Path::Keyframes { frames, looped })
}

fn points_of(numbers: &[f32], looped: bool) -> Result<Vec<[f32; 3]>, ParameterError> {
    let (points, rest) = numbers.as_chunks::<3>();
    check_count("rigid.path.points", points.len(), (2, MAX_POINTS), rest.len())?;
    for (place, value) in numbers.iter().enumerate() {
        let key = format!("rigid.path.points.{}.{}", place / 3, AXES[place % 3]);
        ranged(&key, *value, PLACES)?;
    }
    let steps = if looped { points.len() } else { points.len() - 1 };
    for index in 0..steps {
        let (from, to) = (points[index], points[(index + 1) % points.len()]);
        let apart = (0..3).map(|axis| (to[axis] - from[axis]).abs()).fold(0.0, f32::max);
        if apart < MIN_DISTANCE {
            let key = format!("rigid.path.points.{index}");
            let message =
                format!("{key} is where the next point is, in a loop the first after the last; leave one out");
            return Err(shape_error(&key, f64::from(apart), message));
        }
    }
    Ok(points.to_vec())
}

fn check_count(key: &str, count: usize, (least, most): (usize, usize), rest: usize) -> Result<(), ParameterError> {
    if rest == 0 && (least..=most).contains(&count) {
        return Ok(());
    }
    Err(ParameterError::out_of_range(
        key,
        count as f64,
        least as f64,
        most as f64,
    ))
}

fn pace_of(by_speed: bool, pace: f32) -> Result<Pace, ParameterError> {
    if by_speed {
        ranged("rigid.path.speed", pace, SPEEDS).map(Pace::Speed)
    } else {
        ranged("rigid.path.duration", pace, DURATIONS).map(Pace::Duration)
    }
}
