//! chain-n for stateright: the system of bonds.sc, in three ways to write a state down.
//!
//!     chain MODE N      MODE is bits, bools or bodies; N is 1 to 31
//!
//! Prints the distinct states, and the transitions that were generated, loops of time included.

use stateright::{Checker, Model, Property};
use std::hash::Hash;

/// What the three have in common: how many bonds are left, and the state without one of them.
trait State: Clone + PartialEq + Hash + Send + Sync + 'static {
    fn start(n: usize) -> Self;
    fn bonds(&self, n: usize) -> usize;
    fn pieces(&self, n: usize) -> usize;
    fn left(&self, n: usize, visit: impl FnMut(usize));
    fn without(&self, bond: usize) -> Self;
}

/// A bit for each bond.
#[derive(Clone, PartialEq, Hash)]
struct Bits(u32);

impl State for Bits {
    fn start(n: usize) -> Self {
        Bits(((1u64 << n) - 1) as u32)
    }
    fn bonds(&self, _: usize) -> usize {
        self.0.count_ones() as usize
    }
    fn pieces(&self, n: usize) -> usize {
        n + 1 - self.bonds(n)
    }
    fn left(&self, n: usize, mut visit: impl FnMut(usize)) {
        (0..n).filter(|b| self.0 >> b & 1 == 1).for_each(&mut visit);
    }
    fn without(&self, bond: usize) -> Self {
        Bits(self.0 & !(1 << bond))
    }
}

/// A truth value for each bond.
#[derive(Clone, PartialEq, Hash)]
struct Bools(Vec<bool>);

impl State for Bools {
    fn start(n: usize) -> Self {
        Bools(vec![true; n])
    }
    fn bonds(&self, _: usize) -> usize {
        self.0.iter().filter(|b| **b).count()
    }
    fn pieces(&self, n: usize) -> usize {
        n + 1 - self.bonds(n)
    }
    fn left(&self, n: usize, mut visit: impl FnMut(usize)) {
        (0..n).filter(|b| self.0[*b]).for_each(&mut visit);
    }
    fn without(&self, bond: usize) -> Self {
        let mut next = self.clone();
        next.0[bond] = false;
        next
    }
}

/// What scc keeps: a list of processes, each with its bodies, where they are, how they move and behave,
/// their bonds, and the split clock. Coordinates are whole numbers here, which is all that this system needs.
#[derive(Clone, PartialEq, Hash)]
struct Body {
    name: u16,
    position: [i32; 3],
    behaviour: u16,
}

#[derive(Clone, PartialEq, Hash)]
struct Piece {
    bodies: Vec<Body>,
    velocity: [i32; 3],
    bonds: Vec<(u16, u16)>,
    clock: Option<u32>,
}

#[derive(Clone, PartialEq, Hash)]
struct Bodies(Vec<Piece>);

fn clock(bonds: &[(u16, u16)]) -> Option<u32> {
    if bonds.is_empty() {
        None
    } else {
        Some(0)
    }
}

impl State for Bodies {
    fn start(n: usize) -> Self {
        let body = |i| Body { name: i as u16, position: [i as i32, 0, 0], behaviour: 0 };
        let bonds: Vec<_> = (0..n as u16).map(|b| (b, b + 1)).collect();
        let clock = clock(&bonds);
        Bodies(vec![Piece { bodies: (0..=n).map(body).collect(), velocity: [0; 3], bonds, clock }])
    }
    fn bonds(&self, _: usize) -> usize {
        self.0.iter().map(|p| p.bonds.len()).sum()
    }
    fn pieces(&self, _: usize) -> usize {
        self.0.len()
    }
    fn left(&self, _: usize, mut visit: impl FnMut(usize)) {
        self.0.iter().flat_map(|p| &p.bonds).for_each(|b| visit(b.0 as usize));
    }
    fn without(&self, bond: usize) -> Self {
        let at = self.0.iter().position(|p| p.bonds.iter().any(|b| b.0 as usize == bond)).unwrap();
        let mut next = self.clone();
        let piece = &mut next.0[at];
        let k = piece.bonds.iter().position(|b| b.0 as usize == bond).unwrap();
        let bodies = piece.bodies.split_off(k + 1);
        let bonds = piece.bonds.split_off(k + 1);
        piece.bonds.pop();
        piece.clock = clock(&piece.bonds);
        let velocity = piece.velocity;
        let clock = clock(&bonds);
        next.0.insert(at + 1, Piece { bodies, velocity, bonds, clock });
        next
    }
}

struct Chain<S> {
    n: usize,
    state: std::marker::PhantomData<S>,
}

#[derive(Clone, Debug, PartialEq)]
enum Action {
    Split(usize),
    Time,
}

impl<S: State> Model for Chain<S> {
    type State = S;
    type Action = Action;

    fn init_states(&self) -> Vec<S> {
        vec![S::start(self.n)]
    }

    fn actions(&self, state: &S, actions: &mut Vec<Action>) {
        let before = actions.len();
        state.left(self.n, |b| actions.push(Action::Split(b)));
        if actions.len() > before {
            actions.push(Action::Time);
        }
    }

    fn next_state(&self, state: &S, action: Action) -> Option<S> {
        Some(match action {
            Action::Split(bond) => state.without(bond),
            Action::Time => state.clone(),
        })
    }

    fn properties(&self) -> Vec<Property<Self>> {
        vec![Property::always("conserved", |m: &Self, s: &S| s.bonds(m.n) + s.pieces(m.n) == m.n + 1)]
    }
}

fn explore<S: State>(n: usize) {
    let chain = Chain::<S> { n, state: std::marker::PhantomData };
    let checker = chain.checker().threads(1).spawn_bfs().join();
    let holds = checker.discovery("conserved").is_none();
    println!("states {}", checker.unique_state_count());
    // It counts what it generates, and the start.
    println!("transitions {}", checker.state_count() - 1);
    println!("conserved {}", if holds { "holds" } else { "violated" });
}

fn main() {
    let arguments: Vec<String> = std::env::args().collect();
    let n: usize =
        arguments.get(2).and_then(|n| n.parse().ok()).filter(|n| (1..32).contains(n)).expect("chain MODE N");
    match arguments[1].as_str() {
        "bits" => explore::<Bits>(n),
        "bools" => explore::<Bools>(n),
        "bodies" => explore::<Bodies>(n),
        mode => panic!("no mode {mode}"),
    }
}
