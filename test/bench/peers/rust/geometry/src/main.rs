//! Times parry3d's linear cast and contact tests on the pairs of a file:
//!
//!     peer-parry SHAPE_A SHAPE_B PAIRS [SCALE]
//!
//! Prints one JSON object: for each kind of query the nanoseconds of processor time that one took, and all
//! answers. Shapes and poses are made before the clock starts. All lengths are multiplied by SCALE first
//! (1/1024 unless given, which loses nothing and brings the bodies to the size of one, for which parry's
//! absolute tolerances are meant).

mod clock;
mod data;

use clock::nanoseconds;
use parry3d_f64::query::{self, ShapeCastOptions, ShapeCastStatus};
use parry3d_f64::shape::Shape;

struct Output {
    rows: Vec<String>,
}

impl Output {
    fn row<T>(
        &mut self,
        query: &str,
        name: &str,
        n: usize,
        run: impl Fn(usize) -> T,
        say: impl Fn(T) -> String,
    ) {
        let ns = nanoseconds(n, &run);
        let answers: Vec<String> = (0..n).map(|i| format!("\"{}\"", say(run(i)))).collect();
        self.rows.push(format!(
            "{{\"query\":\"{query}\",\"name\":\"{name}\",\"ns\":{ns:.1},\"answers\":[{}]}}",
            answers.join(",")
        ));
    }
}

fn measure(out: &mut Output, kind: &str, a: &dyn Shape, b: &dyn Shape, cases: &[data::Case]) {
    let n = cases.len();
    let name = |function: &str| format!("parry {function}, {kind}");
    // Bodies that start inside one another are an answer of their own, so penetration has to stop a cast;
    // where they meet is asked of nobody.
    let options = ShapeCastOptions {
        max_time_of_impact: f64::MAX,
        target_distance: 0.0,
        stop_at_penetration: true,
        compute_impact_geometry_on_penetration: false,
    };
    let rest = Default::default();
    if cases.iter().all(|c| c.cast.is_some()) {
        let casts: Vec<_> = cases.iter().map(|c| (c.a, c.cast.expect("a cast"))).collect();
        out.row(
            "cast",
            &name("cast_shapes"),
            n,
            |i| {
                let (at, (from, velocity)) = &casts[i];
                query::cast_shapes(at, rest, a, from, *velocity, b, options).expect("supported")
            },
            |hit| match hit {
                None => "never".to_string(),
                Some(h) if h.status == ShapeCastStatus::PenetratingOrWithinTargetDist => "inside".to_string(),
                Some(h) => format!("hit {:e}", h.time_of_impact),
            },
        );
    }
    let meet = |yes: bool| if yes { "meet" } else { "apart" }.to_string();
    out.row(
        "discrete",
        &name("intersection_test"),
        n,
        |i| query::intersection_test(&cases[i].a, a, &cases[i].near, b).expect("supported"),
        |r| meet(r.intersecting),
    );
    out.row(
        "discrete",
        &name("distance"),
        n,
        |i| query::distance(&cases[i].a, a, &cases[i].near, b).expect("supported"),
        |r| meet(r.distance <= 0.0),
    );
    out.row(
        "discrete",
        &name("contact"),
        n,
        |i| query::contact(&cases[i].a, a, &cases[i].near, b, 0.0).expect("supported"),
        |r| match r {
            None => "apart".to_string(),
            Some(c) if c.dist < 0.0 => "inside".to_string(),
            Some(_) => "touching".to_string(),
        },
    );
}

fn main() {
    let arguments: Vec<String> = std::env::args().collect();
    if arguments.len() < 4 {
        eprintln!("usage: peer-parry SHAPE_A SHAPE_B PAIRS [SCALE]");
        std::process::exit(2);
    }
    let scale = arguments.get(4).map_or(1.0 / 1024.0, |s| s.parse().expect("a scale"));
    let (a, b) = (data::solid(&arguments[1], scale), data::solid(&arguments[2], scale));
    let cases = data::cases(&arguments[3], scale);
    let mut out = Output { rows: Vec::new() };
    measure(&mut out, "polyhedron", &a.polyhedron, &b.polyhedron, &cases);
    if let (Some(a), Some(b)) = (&a.cuboid, &b.cuboid) {
        measure(&mut out, "cuboid", a, b, &cases);
    }
    println!("{{\"program\":\"parry3d-f64\",\"rows\":[{}]}}", out.rows.join(","));
}
