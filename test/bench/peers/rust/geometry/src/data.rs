//! The data sets of test/data/geometry (its README says what they hold), as parry's shapes and poses.

use parry3d_f64::math::{Pose, Rotation, Vector};
use parry3d_f64::shape::{ConvexPolyhedron, Cuboid};

fn numbers(path: &str) -> impl Iterator<Item = Vec<f64>> {
    let text = std::fs::read_to_string(path).unwrap_or_else(|e| panic!("{path}: {e}"));
    let rows: Vec<Vec<f64>> = text
        .lines()
        .filter(|line| !line.trim().is_empty())
        .map(|line| line.split_whitespace().map(|w| w.parse().expect("an integer")).collect())
        .collect();
    rows.into_iter()
}

/// A solid in its own frame. All lengths are multiplied by `scale`.
pub struct Solid {
    pub polyhedron: ConvexPolyhedron,
    /// Where the solid is a box with faces across the axes and centred at the origin.
    pub cuboid: Option<Cuboid>,
}

pub fn solid(path: &str, scale: f64) -> Solid {
    let mut rows = numbers(path);
    let head = rows.next().expect("the numbers of vertices and faces");
    let corners = head[0] as usize;
    let points: Vec<Vector> =
        rows.by_ref().take(corners).map(|r| Vector::new(r[0], r[1], r[2]) * scale).collect();
    let mut triangles = Vec::new();
    for face in rows.take(head[1] as usize) {
        for k in 2..face.len() - 1 {
            triangles.push([face[1] as u32, face[k] as u32, face[k + 1] as u32]);
        }
    }
    let half = points.iter().fold(Vector::ZERO, |m, p| m.max(p.abs()));
    let is_box = corners == 8 && points.iter().all(|p| p.abs() == half);
    Solid {
        polyhedron: ConvexPolyhedron::from_convex_mesh(points, &triangles).expect("a convex mesh"),
        cuboid: is_box.then(|| Cuboid::new(half)),
    }
}

/// One pair: where A is, where B is for the contact test, and where it starts and how fast it moves for
/// the cast, if the data set has casts.
pub struct Case {
    pub a: Pose,
    pub near: Pose,
    pub cast: Option<(Pose, Vector)>,
}

pub fn cases(path: &str, scale: f64) -> Vec<Case> {
    let turn = |q: &[f64]| Rotation::from_xyzw(q[1], q[2], q[3], q[0]).normalize();
    let vector = |r: &[f64], s: f64| Vector::new(r[0], r[1], r[2]) * s;
    let case = |r: Vec<f64>| {
        if r.len() == 7 {
            let q = &r[3..7];
            let norm2: f64 = q.iter().map(|x| x * x).sum();
            let near = vector(&r, 1.0) / norm2 * scale;
            Case {
                a: Pose::from_parts(Vector::ZERO, turn(q)),
                near: Pose::from_parts(near, turn(q)),
                cast: None,
            }
        } else {
            let b = turn(&r[9..13]);
            Case {
                a: Pose::IDENTITY,
                near: Pose::from_parts(vector(&r, scale), b),
                cast: Some((Pose::from_parts(vector(&r[3..], scale), b), vector(&r[6..], scale))),
            }
        }
    };
    numbers(path).skip(1).map(case).collect()
}
