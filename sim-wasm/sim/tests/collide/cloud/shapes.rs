//! One shape of each kind.

use sim::math::vector::Vector;
use sim::rigids::RigidShape;

pub fn box_vertices(centre: [f32; 3], half: [f32; 3]) -> Vec<[f32; 3]> {
    (0..8)
        .map(|corner| {
            std::array::from_fn(|axis| {
                centre[axis]
                    + if corner >> axis & 1 == 1 {
                        half[axis]
                    } else {
                        -half[axis]
                    }
            })
        })
        .collect()
}

pub const BOX_TRIANGLES: [[u32; 3]; 12] = [
    [0, 4, 6],
    [0, 6, 2],
    [1, 3, 7],
    [1, 7, 5],
    [0, 1, 5],
    [0, 5, 4],
    [2, 6, 7],
    [2, 7, 3],
    [0, 2, 3],
    [0, 3, 1],
    [4, 5, 7],
    [4, 7, 6],
];

/// Two boxes as one mesh of two closed parts, which do not touch.
pub fn two_boxes() -> RigidShape {
    let mut vertices = box_vertices([-0.5, 0.0, 0.0], [0.2, 0.3, 0.4]);
    vertices.extend(box_vertices([0.6, 0.1, 0.0], [0.25, 0.15, 0.3]));
    let mut indices = BOX_TRIANGLES.to_vec();
    indices.extend(BOX_TRIANGLES.map(|triangle| triangle.map(|corner| corner + 8)));
    RigidShape::Trimesh { vertices, indices }
}

pub type Measure = fn(Vector) -> f32;

/// Each shape with its distance outside, by formulas that share nothing with the simulator's.
pub fn shapes() -> [(&'static str, RigidShape, Measure); 6] {
    pub fn gap(part: f32, half: f32) -> f32 {
        (part.abs() - half).max(0.0)
    }
    pub fn box_gap(p: Vector, centre: [f32; 3], half: [f32; 3]) -> f32 {
        Vector::new(
            gap(p.x - centre[0], half[0]),
            gap(p.y - centre[1], half[1]),
            gap(p.z - centre[2], half[2]),
        )
        .length()
    }
    [
        ("ball", RigidShape::Ball { radius: 0.5 }, |p| p.length() - 0.5),
        (
            "cuboid",
            RigidShape::Cuboid {
                half_extents: [0.7, 0.2, 0.4],
            },
            |p| box_gap(p, [0.0; 3], [0.7, 0.2, 0.4]),
        ),
        (
            "capsule",
            RigidShape::Capsule {
                half_height: 0.6,
                radius: 0.2,
            },
            |p| Vector::new(p.x, gap(p.y, 0.6), p.z).length() - 0.2,
        ),
        (
            "cylinder",
            RigidShape::Cylinder {
                half_height: 0.3,
                radius: 0.5,
            },
            |p| Vector::new(gap((p.x * p.x + p.z * p.z).sqrt(), 0.5), gap(p.y, 0.3), 0.0).length(),
        ),
        (
            "hull",
            RigidShape::ConvexHull {
                vertices: box_vertices([0.0; 3], [0.5, 0.6, 0.3]),
            },
            |p| box_gap(p, [0.0; 3], [0.5, 0.6, 0.3]),
        ),
        ("trimesh", two_boxes(), |p| {
            box_gap(p, [-0.5, 0.0, 0.0], [0.2, 0.3, 0.4]).min(box_gap(p, [0.6, 0.1, 0.0], [0.25, 0.15, 0.3]))
        }),
    ]
}
