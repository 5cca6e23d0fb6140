//! Three-vectors of double precision, as arrays.

/// The unit vector of `v` in single precision; up if `v` is shorter than 1e-9.
pub fn direction(v: [f64; 3]) -> [f32; 3] {
    let length = libm::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    if length < 1e-9 {
        return [0.0, 1.0, 0.0];
    }
    v.map(|component| (component / length) as f32)
}

pub fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

pub fn unit(a: [f64; 3]) -> [f64; 3] {
    let length = length(a);
    a.map(|component| component / length)
}

pub fn length(a: [f64; 3]) -> f64 {
    libm::sqrt(dot(a, a))
}
