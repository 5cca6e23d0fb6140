//! The camera, and rays through pixel centres.

use glam::{DMat4, DVec2, DVec3};

use crate::scene::Scene;

/// Points of a ray by view depth: `origin + depth * direction`.
#[derive(Clone, Copy)]
pub struct Ray {
    pub origin: DVec3,
    pub direction: DVec3,
}

impl Ray {
    pub fn at(self, depth: f64) -> DVec3 {
        self.origin + depth * self.direction
    }
}

pub struct Camera {
    pub view_from_world: DMat4,
    world_from_view: DMat4,
    clip_from_view: DMat4,
    view_from_clip: DMat4,
    size: DVec2,
    /// View depths of the near and the far plane.
    pub near: f64,
    pub far: f64,
}

impl Camera {
    pub fn new(scene: &Scene) -> Self {
        Self::of(
            DMat4::from_cols_array(&scene.view_from_world),
            DMat4::from_cols_array(&scene.clip_from_view),
            DVec2::new(scene.width as f64, scene.height as f64),
        )
    }

    fn of(view_from_world: DMat4, clip_from_view: DMat4, size: DVec2) -> Self {
        let view_from_clip = clip_from_view.inverse();
        Self {
            view_from_world,
            world_from_view: view_from_world.inverse(),
            clip_from_view,
            view_from_clip,
            size,
            near: -view_from_clip.project_point3(DVec3::NEG_Z).z,
            far: -view_from_clip.project_point3(DVec3::Z).z,
        }
    }

    /// The ray through a point of the picture in view space. Pixel centres are at halves, rows go upwards.
    pub fn ray(&self, pixel: DVec2) -> Ray {
        let ndc = 2.0 * pixel / self.size - 1.0;
        let nearer = self.view_from_clip.project_point3(ndc.extend(0.0));
        let farther = self.view_from_clip.project_point3(ndc.extend(0.5));
        let direction = (farther - nearer) / (nearer.z - farther.z);
        Ray {
            origin: nearer + nearer.z * direction,
            direction,
        }
    }

    pub fn ray_in_world(&self, pixel: DVec2) -> Ray {
        let Ray { origin, direction } = self.ray(pixel);
        Ray {
            origin: self.world_from_view.transform_point3(origin),
            direction: self.world_from_view.transform_vector3(direction),
        }
    }

    /// Projects a point of view space to the picture.
    pub fn pixel_of(&self, point: DVec3) -> DVec2 {
        0.5 * (self.clip_from_view.project_point3(point).truncate() + 1.0) * self.size
    }

    /// Window depth of a view depth: 0 at the near plane, 1 at the far plane.
    pub fn window_depth(&self, depth: f64) -> f64 {
        0.5 + 0.5 * self.clip_from_view.project_point3(DVec3::new(0.0, 0.0, -depth)).z
    }

    /// View depth of a window depth.
    pub fn depth_of(&self, window_depth: f64) -> f64 {
        -self
            .view_from_clip
            .project_point3(DVec3::new(0.0, 0.0, 2.0 * window_depth - 1.0))
            .z
    }

    /// Metres per pixel at a view depth.
    pub fn metres_per_pixel(&self, depth: f64) -> f64 {
        self.ray(DVec2::Y).at(depth).y - self.ray(DVec2::ZERO).at(depth).y
    }

    /// Minimum and maximum slope of rays relative to the view axis, to the right and up.
    pub fn slopes(&self) -> [DVec2; 2] {
        [DVec2::ZERO, self.size].map(|corner| self.ray(corner).direction.truncate())
    }

    pub fn is_perspective(&self) -> bool {
        self.clip_from_view.z_axis.w != 0.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_ray_comes_back_to_its_pixel_under_any_projection() {
        let off_axis = DMat4::from_cols_array_2d(&[
            [1.5, 0.0, 0.0, 0.0],
            [0.0, 2.0, 0.0, 0.0],
            [0.3, -0.2, -1.1, -1.0],
            [0.0, 0.0, -0.4, 0.0],
        ]);
        let parallel = DMat4::from_cols_array_2d(&[
            [0.5, 0.0, 0.0, 0.0],
            [0.0, 0.7, 0.0, 0.0],
            [0.0, 0.0, -0.1, 0.0],
            [0.2, 0.1, -1.2, 1.0],
        ]);
        for clip_from_view in [off_axis, parallel] {
            let camera = Camera::of(DMat4::IDENTITY, clip_from_view, DVec2::new(30.0, 20.0));
            let pixel = DVec2::new(7.5, 16.5);
            let point = camera.ray(pixel).at(3.0);
            assert!((point.z + 3.0).abs() < 1e-12 && camera.pixel_of(point).distance(pixel) < 1e-9);
            assert!(camera.window_depth(camera.near).abs() < 1e-9);
        }
    }
}
