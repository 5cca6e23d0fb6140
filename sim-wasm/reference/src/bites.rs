//! The bites of a puff that dissolves: three balls that grow with its erosion and are cut out of its lobes.

use glam::{DMat3, DVec3};

use crate::lobes::Lobe;

/// See src/constants.ts.
const BITE_DISTANCES: [f64; 2] = [1.15, 1.25];
const BITE_STARTS: [f64; 2] = [0.2, 0.4];
const BITE_DEPTHS: [f64; 2] = [1.08, 0.75];
pub const EROSION_LEAD: f64 = 0.0625;
const GOLDEN_ANGLE: f64 = 2.399_963_229_728_653;

/// The bites of a variation at an erosion, mapped from the puff's frame. Their radii are those of an unstretched puff.
pub fn bites(variation: usize, erosion: f64, map: DMat3) -> Vec<Lobe> {
    let (sin, cos) = (GOLDEN_ANGLE * variation as f64).sin_cos();
    let axis = DVec3::new(0.6 * cos, 0.8, 0.6 * sin);
    let side = DVec3::new(-sin, 0.0, cos);
    let bite = |direction: DVec3, shape: usize, start: f64| {
        let grown = (erosion - start) / (1.0 - start);
        (grown > 0.0).then(|| Lobe {
            center: map * (direction * BITE_DISTANCES[shape]),
            radius: BITE_DISTANCES[shape] - 1.0 + BITE_DEPTHS[shape] * grown * (2.0 - grown),
        })
    };
    [
        bite(axis, 0, EROSION_LEAD),
        bite(-axis, 0, BITE_STARTS[0]),
        bite(side, 1, BITE_STARTS[1]),
    ]
    .into_iter()
    .flatten()
    .collect()
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
