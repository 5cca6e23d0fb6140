//! The bites of a puff that dissolves: three balls that grow with its erosion and are cut out of its lobes.

use glam::{DMat3, DQuat, DVec3};

/// See src/base/constants.ts.
const FIRST_BITE: [f64; 3] = [0.69, 0.92, 0.0];
const THIRD_BITE: [f64; 3] = [0.0, 0.0, 1.25];
const BITE_RADII: [f64; 3] = [0.15, 0.15, 0.25];
const BITE_GROWTH: [f64; 3] = [1.08, 1.08, 0.75];
const BITE_STARTS: [f64; 3] = [0.0625, 0.2, 0.4];
/// Erosion at which the first bite begins.
pub const FIRST_START: f64 = BITE_STARTS[0];

/// A ball of a puff: a lobe, or a bite that is cut out of lobes.
#[derive(Clone, Copy)]
pub struct Lobe {
    pub center: DVec3,
    pub radius: f64,
}

/// The bites at an erosion, mapped from the puff's frame. Their radii are those of an unstretched puff. With `torn_along`, the
/// axis of the stretch in the puff's frame, they lie about this axis.
pub fn bites(erosion: f64, torn_along: Option<DVec3>, map: DMat3) -> Vec<Lobe> {
    let turn = torn_along.map_or(DQuat::IDENTITY, |axis| DQuat::from_rotation_arc(DVec3::X, axis));
    let first = turn * DVec3::from(FIRST_BITE);
    let centers = [first, -first, turn * DVec3::from(THIRD_BITE)];
    let bite = |(index, center): (usize, DVec3)| {
        let grown = (erosion - BITE_STARTS[index]) / (1.0 - BITE_STARTS[index]);
        (grown > 0.0).then(|| Lobe {
            center: map * center,
            radius: BITE_RADII[index] + BITE_GROWTH[index] * grown * (2.0 - grown),
        })
    };
    centers.into_iter().enumerate().filter_map(bite).collect()
}

/// A part of a line, from its start to its end.
pub type Stretch = (f64, f64);

/// The greatest place on a line that is in a lobe and in no bite, by the parts of the line in each, and the bite whose wall is
/// there.
pub fn top(lobes: &[Stretch], bites: &[Option<Stretch>]) -> Option<(f64, Option<usize>)> {
    let is_bitten = |place: f64, by: Option<usize>| {
        let others = bites.iter().enumerate().filter(|(bite, _)| Some(*bite) != by);
        others
            .flat_map(|(_, stretch)| stretch)
            .any(|(start, end)| *start < place && place < *end)
    };
    let fronts = lobes.iter().map(|(_, end)| (*end, None));
    let walls = bites.iter().enumerate().filter_map(|(bite, stretch)| {
        let (wall, _) = (*stretch)?;
        let is_within = lobes.iter().any(|(start, end)| *start < wall && wall < *end);
        is_within.then_some((wall, Some(bite)))
    });
    fronts
        .chain(walls)
        .filter(|(place, by)| !is_bitten(*place, *by))
        .max_by(|one, other| one.0.total_cmp(&other.0))
}

/// The part of a line in a ball; the line is `origin + place * direction`.
pub fn crossed(origin: DVec3, direction: DVec3, ball: Lobe) -> Option<Stretch> {
    let offset = ball.center - origin;
    let square = direction.length_squared();
    let middle = offset.dot(direction) / square;
    let beside = offset - middle * direction;
    let half = (ball.radius * ball.radius - beside.length_squared()) / square;
    (half > 0.0 && ball.radius > 0.0).then(|| (middle - half.sqrt(), middle + half.sqrt()))
}
