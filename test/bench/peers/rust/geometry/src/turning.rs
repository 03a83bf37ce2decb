//! Times parry3d's nonlinear cast on pairs of turning bodies, made by turning_cast.exe:
//!
//!     peer-parry-turning SHAPE PAIRS
//!
//! Prints one JSON object as peer-parry does: for each kind of pair and for all of them the nanoseconds of processor
//! time of a query, and all answers. The shape is scaled by 1/1024; the pairs are at that size already.
//!
//! parry turns a body at a constant rate, scc by 2 atan(|spin| t/2) about the spin: parry gets the rate at which
//! the angles are equal at t = 1. In between they differ by less than 0.004 radians for the fastest spins.

mod clock;
#[allow(dead_code)]
mod data;

use clock::nanoseconds;
use parry3d_f64::math::{Pose, Rotation, Vector};
use parry3d_f64::query::{self, NonlinearRigidMotion, ShapeCastStatus};
use parry3d_f64::shape::Shape;

struct Pair {
    kind: String,
    a: NonlinearRigidMotion,
    b: NonlinearRigidMotion,
}

fn motion(r: &[f64]) -> NonlinearRigidMotion {
    let vector = |i: usize| Vector::new(r[i], r[i + 1], r[i + 2]);
    let turn = Rotation::from_xyzw(r[10], r[11], r[12], r[9]).normalize();
    let spin = vector(6);
    let length = spin.length();
    let rate = if length == 0.0 { spin } else { spin * (2.0 * (length / 2.0).atan() / length) };
    NonlinearRigidMotion::new(Pose::from_parts(vector(0), turn), Vector::ZERO, vector(3), rate)
}

fn pairs(path: &str) -> Vec<Pair> {
    let text = std::fs::read_to_string(path).unwrap_or_else(|e| panic!("{path}: {e}"));
    let pair = |line: &str| {
        let mut words = line.split_whitespace();
        let kind = words.next().expect("a kind").to_string();
        let numbers: Vec<f64> = words.map(|w| w.parse().expect("a number")).collect();
        assert_eq!(numbers.len(), 26, "two bodies of 13 numbers");
        Pair { kind, a: motion(&numbers), b: motion(&numbers[13..]) }
    };
    text.lines().filter(|line| !line.trim().is_empty()).map(pair).collect()
}

fn measure(rows: &mut Vec<String>, name: &str, shape: &dyn Shape, pairs: &[Pair]) {
    // Bodies that start inside one another stop the cast, as they do for scc.
    let cast = |p: &Pair| {
        query::cast_shapes_nonlinear(&p.a, shape, &p.b, shape, 0.0, 1.0, true).expect("supported")
    };
    for kind in ["hit", "near", "far", "all"] {
        let some: Vec<&Pair> = pairs.iter().filter(|p| kind == "all" || p.kind == kind).collect();
        let ns = nanoseconds(some.len(), |i| cast(some[i]));
        let answers: Vec<String> = if kind == "all" {
            let say = |p: &Pair| match cast(p) {
                None => "\"never\"".to_string(),
                Some(h) if h.status == ShapeCastStatus::PenetratingOrWithinTargetDist => {
                    "\"inside\"".to_string()
                }
                Some(h) if h.status == ShapeCastStatus::Failed => {
                    format!("\"failed {:e}\"", h.time_of_impact)
                }
                Some(h) => format!("\"hit {:e}\"", h.time_of_impact),
            };
            pairs.iter().map(say).collect()
        } else {
            Vec::new()
        };
        rows.push(format!(
            "{{\"query\":\"{kind}\",\"name\":\"{name}\",\"ns\":{ns:.1},\"answers\":[{}]}}",
            answers.join(",")
        ));
    }
}

fn main() {
    let arguments: Vec<String> = std::env::args().collect();
    if arguments.len() != 3 {
        eprintln!("usage: peer-parry-turning SHAPE PAIRS");
        std::process::exit(2);
    }
    let shape = data::solid(&arguments[1], 1.0 / 1024.0);
    let pairs = pairs(&arguments[2]);
    let mut rows = Vec::new();
    measure(&mut rows, "parry polyhedron", &shape.polyhedron, &pairs);
    if let Some(cuboid) = &shape.cuboid {
        measure(&mut rows, "parry cuboid", cuboid, &pairs);
    }
    println!("{{\"program\":\"parry3d-f64\",\"rows\":[{}]}}", rows.join(","));
}
