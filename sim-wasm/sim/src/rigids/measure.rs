//! What only measurements ask of the rigids.

use super::Rigids;
use super::meshes::{ours, parrys};
use crate::collide::space::{Bounds, Vector};

impl Rigids {
    /// Whether the box that a rigid swept in the last step touches `bounds`.
    pub(crate) fn any_touches(&self, bounds: &Bounds) -> bool {
        self.obstacles.iter().any(|obstacle| obstacle.bounds.touches(bounds))
    }

    /// Appends the signed distance (m) from each point to the nearest rigid, as Rapier's query pipeline answers it.
    pub(crate) fn project(&self, points: impl Iterator<Item = Vector>, limit: f32, distances: &mut Vec<f32>) {
        let pipeline = self.world.physics().query_pipeline();
        distances.extend(
            points.map(|point| match pipeline.project_point(parrys(point), limit, false) {
                Some((_, projection)) => {
                    let distance = (ours(projection.point) - point).length();
                    if projection.is_inside { -distance } else { distance }
                }
                None => limit,
            }),
        );
    }
}
