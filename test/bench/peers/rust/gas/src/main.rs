//! Runs a gas of cubes in a box with rapier3d, in fixed steps:
//!
//!     peer-rapier GAS STEP [CONTACTS]
//!
//! GAS is written by test/bench/gas.exe (its header tells the format). The simulation has no gravity, friction,
//! damping or sleep, restitution 1, no rotations, and continuous collision detection for every body; the walls are
//! thick slabs. Prints one JSON object: processor seconds of all steps, the contacts that started between
//! bodies and with walls, the kinetic energy before and after, and how many centres left the box.
//! CONTACTS gets a line for each contact that started: the time at the end of its step, and the two bodies, walls
//! as in the events of gas.exe.

use rapier3d_f64::prelude::*;
use std::sync::Mutex;

#[repr(C)]
struct Timespec {
    seconds: i64,
    nanoseconds: i64,
}

extern "C" {
    fn clock_gettime(clock: i32, time: *mut Timespec) -> i32;
}

/// Processor time of this process, in seconds.
fn clock() -> f64 {
    const PROCESS_CPUTIME: i32 = 2;
    let mut t = Timespec { seconds: 0, nanoseconds: 0 };
    unsafe { clock_gettime(PROCESS_CPUTIME, &mut t) };
    t.seconds as f64 + t.nanoseconds as f64 * 1e-9
}

/// `p` or `p/q`.
fn rational(word: &str) -> f64 {
    let mut parts = word.split('/').map(|p| p.parse::<f64>().expect("a rational number"));
    let numerator = parts.next().expect("a number");
    numerator / parts.next().unwrap_or(1.0)
}

/// The pairs whose contact started in the step that runs, by the numbers of their bodies.
#[derive(Default)]
struct Started(Mutex<Vec<(i64, i64)>>);

impl EventHandler for Started {
    fn handle_collision_event(
        &self,
        _: &RigidBodySet,
        colliders: &ColliderSet,
        event: CollisionEvent,
        _: Option<&ContactPair>,
    ) {
        if let CollisionEvent::Started(a, b, _) = event {
            let number = |handle: ColliderHandle| colliders[handle].user_data as i128 as i64;
            self.0.lock().expect("one thread").push((number(a), number(b)));
        }
    }

    fn handle_contact_force_event(
        &self,
        _: Real,
        _: &RigidBodySet,
        _: &ColliderSet,
        _: &ContactPair,
        _: Real,
    ) {
    }

    fn handle_soft_body_tear_event(&self, _: &SoftBodySet, _: &SoftBodyTearEvent) {}
}

struct World {
    bodies: RigidBodySet,
    colliders: ColliderSet,
    cubes: Vec<RigidBodyHandle>,
}

fn elastic(shape: ColliderBuilder, number: i64) -> ColliderBuilder {
    shape
        .restitution(1.0)
        .restitution_combine_rule(CoefficientCombineRule::Max)
        .friction(0.0)
        .friction_combine_rule(CoefficientCombineRule::Min)
        .active_events(ActiveEvents::COLLISION_EVENTS)
        .user_data(number as i128 as u128)
}

fn world(side: f64, lines: &[Vec<f64>]) -> World {
    let mut w = World { bodies: RigidBodySet::new(), colliders: ColliderSet::new(), cubes: Vec::new() };
    for (i, l) in lines.iter().enumerate() {
        let turn = Rotation::from_xyzw(l[9], l[10], l[11], l[8]).normalize();
        let body = RigidBodyBuilder::dynamic()
            .pose(Pose::from_parts(Vector::new(l[0], l[1], l[2]), turn))
            .linvel(Vector::new(l[3], l[4], l[5]))
            .lock_rotations()
            .linear_damping(0.0)
            .can_sleep(false)
            .ccd_enabled(true);
        let handle = w.bodies.insert(body);
        let cube = elastic(ColliderBuilder::cuboid(l[6], l[6], l[6]).mass(l[7]), i as i64);
        w.colliders.insert_with_parent(cube, handle, &mut w.bodies);
        w.cubes.push(handle);
    }
    let half = side / 2.0;
    for (number, axis, far) in (0..6).map(|k| (-1 - k, k / 2, k % 2 == 1)) {
        let mut centre = Vector::splat(half);
        let mut extent = Vector::splat(side);
        centre[axis as usize] = if far { side + half } else { -half };
        extent[axis as usize] = half;
        let wall = elastic(ColliderBuilder::cuboid(extent.x, extent.y, extent.z), number);
        w.colliders.insert(wall.translation(centre));
    }
    w
}

impl World {
    fn energy(&self) -> f64 {
        let of = |h: &RigidBodyHandle| {
            let body = &self.bodies[*h];
            0.5 * body.mass() * body.linvel().length_squared()
        };
        self.cubes.iter().map(of).sum()
    }

    fn outside(&self, side: f64) -> usize {
        let gone = |h: &&RigidBodyHandle| {
            let p = self.bodies[**h].translation();
            !(p.min_element() >= 0.0 && p.max_element() <= side)
        };
        self.cubes.iter().filter(gone).count()
    }
}

fn main() {
    let arguments: Vec<String> = std::env::args().collect();
    if arguments.len() < 3 {
        eprintln!("usage: peer-rapier GAS STEP [CONTACTS]");
        std::process::exit(2);
    }
    let text = std::fs::read_to_string(&arguments[1]).expect("the gas");
    let mut lines: Vec<Vec<f64>> = text
        .lines()
        .map(|line| line.split_whitespace().map(rational).collect())
        .collect();
    let head = lines.remove(0);
    let (side, time) = (head[1], head[2]);
    let step = rational(&arguments[2]);

    let mut w = world(side, &lines);
    let parameters = IntegrationParameters { dt: step, ..Default::default() };
    let mut pipeline = PhysicsPipeline::new();
    let mut islands = IslandManager::new();
    let mut broad_phase = DefaultBroadPhase::new();
    let mut narrow_phase = NarrowPhase::new();
    let mut impulse_joints = ImpulseJointSet::new();
    let mut multibody_joints = MultibodyJointSet::new();
    let mut soft_bodies = SoftBodySet::new();
    let mut ccd = CCDSolver::new();
    let started = Started::default();

    let before = w.energy();
    let mut contacts = Vec::new();
    let steps = (time / step).ceil() as usize;
    let start = clock();
    for k in 1..=steps {
        pipeline.step(
            Vector::ZERO,
            &parameters,
            &mut islands,
            &mut broad_phase,
            &mut narrow_phase,
            &mut w.bodies,
            &mut w.colliders,
            &mut impulse_joints,
            &mut multibody_joints,
            &mut soft_bodies,
            &mut ccd,
            &(),
            &started,
        );
        let new = std::mem::take(&mut *started.0.lock().expect("one thread"));
        contacts.extend(new.into_iter().map(|(a, b)| (k as f64 * step, a.max(b), a.min(b))));
    }
    let seconds = clock() - start;

    if let Some(path) = arguments.get(3) {
        let ordered = |a: i64, b: i64| if b < 0 { (a, b) } else { (b, a) };
        let line = |&(t, a, b): &(f64, i64, i64)| {
            let (first, second) = ordered(a, b);
            format!("{t} {first} {second}\n")
        };
        std::fs::write(path, contacts.iter().map(line).collect::<String>()).expect("a file to write");
    }
    let walls = contacts.iter().filter(|c| c.2 < 0).count();
    println!(
        "{{\"program\":\"rapier3d-f64\",\"steps\":{steps},\"seconds\":{seconds:.6},\"contacts\":{},\"walls\":{walls},\
         \"energy_before\":{before:e},\"energy_after\":{:e},\"outside\":{}}}",
        contacts.len() - walls,
        w.energy(),
        w.outside(side)
    );
}
