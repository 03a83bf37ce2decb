#!/usr/bin/env python3
"""Shows that the tests of the rules can fail: rules of lib/kernel/semantics are broken, one by one.

    test/laws/networks/teeth.py [--tree DIR] [NAME ...]
    test/laws/networks/teeth.py --places     only whether each mistake has a place to be made in; part of the tests

Works on a copy of the source tree (below DIR, to be kept for the next time). Each mistake has to be noticed by the
tests of test/unit/semantics, test/unit/elaborate or test/laws/networks, by the suite of specs/conformance, or by the
random walkers of test/outside/successor: some test fails, or does not end.
"""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "support"))

import mistakes

# name: (file, what stands there, what is put in its place)
MISTAKES = {
    # Chapter 2: behaviours.
    "the second summand offers nothing": (
        "behaviours.ml", "derive defs how (derive defs how found x) y", "(ignore y; derive defs how found x)",
    ),
    "the second summand does not age": (
        "behaviours.ml", "and y' = pass_term defs shortened y in", "and y' = y in",
    ),
    "what a name stands for does not age": (
        "behaviours.ml",
        "if ages defs defs.(k).body then pass_term defs shortened defs.(k).body else b",
        "(ignore k; b)",
    ),
    "the longest delay is the horizon": (
        "behaviours.ml", "Option.merge Rat.min horizon", "Option.merge Rat.max horizon",
    ),
    "equal chances count once": (
        "behaviours.ml", "if by_chance offer then found", "if by_chance offer && found = [] then found",
    ),
    "of repeated summands by chance one remains": (
        "behaviours.ml", "Terms.mem b known && not (left_to_chance defs b)",
        "Terms.mem b known && (ignore left_to_chance; true)",
    ),
    # Chapter 3: bonds are released.
    "bonds are released at any instant": (
        "splits.ml",
        "if Process.at_split_instant p then List.concat_map release (Array.to_list p.bonds) else []",
        "List.concat_map release (Array.to_list p.bonds)",
    ),
    "only the first end pushes": (
        "splits.ml",
        "push = Rat.add (List.hd one).Process.push (List.hd two).push }",
        "push = (ignore two; (List.hd one).Process.push) }",
    ),
    "the first normal of several is pushed along": (
        "splits.ml", "[ n ] -> Some n | [] | _ :: _ -> None", "n :: _ -> Some n | [] -> None",
    ),
    "a push pulls": (
        "splits.ml",
        "of_leaf bond.one.at (Rat.neg push) (of_leaf bond.two.at push q)",
        "of_leaf bond.one.at push (of_leaf bond.two.at (Rat.neg push) q)",
    ),
    "only the first end continues": (
        "splits.ml",
        "[ (bond.one.at, (List.hd one).Process.rest); (bond.two.at, (List.hd two).rest) ]",
        "(ignore two; [ (bond.one.at, (List.hd one).Process.rest) ])",
    ),
    "entries keep the bonds that they match first": (
        "splits.ml", "match augment seen owners other with", "match ignore other; Error seen with",
    ),
    "who has chosen may get another bond": (
        "splits.ml", "i > least && open_yet i", "i > least && (ignore open_yet; true)",
    ),
    "certain chances are too much": (
        "splits.ml", "Rat.compare (n.value q) Rat.one > 0", "Rat.compare (n.value q) Rat.one >= 0",
    ),
    "both let go as often as the rarer one": (
        "splits.ml", "(s @ t, n.mul q r)", "(s @ t, if Rat.compare (n.value q) (n.value r) < 0 then q else r)",
    ),
    "lots wait a whole step": ("lots.ml", "Some (Rat.sub (step m) since)", "(ignore since; Some (step m))"),
    "two bonds of a leaf are not contested": (
        "lots.ml", "List.compare_length_with cluster 1 > 0", "List.compare_length_with cluster 2 > 0",
    ),
    "bonds hang together by their first ends": ("lots.ml", "[ b.one.at; b.two.at ]", "[ b.one.at ]"),
    "any feature releases a bond": (
        "process.ml",
        "when String.equal c.name name && Behaviour.active c f.site ->", "when String.equal c.name name ->",
    ),
    # Chapter 3: bonds are made, and bodies bounce.
    "three bodies close no ring": ("closings.ml", "Array.length p.leaves >= 3", "Array.length p.leaves > 3"),
    "two leaves may be bound twice": (
        "closings.ml", "i <> j && not (Array.exists (joins i j) p.bonds)", "i <> j && (ignore (joins, p); true)",
    ),
    "clocks run on when a ring closes": (
        "closings.ml", "come = [ Process.restart_clock c.setting.model whole ]", "come = (ignore c; [ whole ])",
    ),
    "a name binds to itself": (
        "collisions.ml", "complementary pol1 pol2 && String", "(ignore (complementary pol1 pol2); true) && String",
    ),
    "corners bind where faces do": ("collisions.ml", "| highest :: _ -> highest", "| _ :: _ -> shared"),
    "fixed bodies link collisions": (
        "collisions.ml",
        "let yields i = Option.is_some (Process.yielding_mass model processes.(i)) in",
        "let yields i = ignore (model, processes, i); true in",
    ),
    "clocks run on when bodies bounce": (
        "collisions.ml", "Process.end_step m (Process.restart_clock m p)", "Process.end_step m p",
    ),
    "the lots of what binds are lost": ("collisions.ml", "|> State.with_lots p.lots", "|> State.with_lots None"),
    "who touches collides": (
        "straight.ml", "(Part.relative_velocity a b) then Colliding else Touching",
        "(Part.relative_velocity a b) then Colliding else Colliding",
    ),
    "masses are exchanged": (
        "straight.ml",
        "(Vec.add (Vec.scale mp p.velocity) (Vec.scale mq q.velocity))",
        "(Vec.add (Vec.scale mq p.velocity) (Vec.scale mp q.velocity))",
    ),
    "who turns does not meet those at the same velocity": ("part.ml", "|| turns a || turns b)", "|| turns a)"),
    # Walkers that do not bounce.
    "walkers stop but once": ("blocked.ml", "else until_none c (at_rest stops s)", "else (ignore until_none; at_rest stops s)"),
    "a walker that may bind stops": (
        "blocked.ml", "Ids.diff (Ids.of_list (List.concat_map (Collisions.blocked c processes) meetings)) busy",
        "(ignore busy; Ids.of_list (List.concat_map (Collisions.blocked c processes) meetings))",
    ),
    "a kick up to a wall is blocked": (
        "blocked.ml", "before_the_next_draw t = Rat.compare t c.setting.model.timestep < 0",
        "before_the_next_draw t = Rat.compare t c.setting.model.timestep <= 0",
    ),
    "a kick into a bond is blocked": (
        "blocked.ml", "not (binds_at c t s.processes.(two.first) s.processes.(two.second))",
        "(ignore (t, s); ignore binds_at; true)",
    ),
    "two kicks into one place are taken": (
        "blocked.ml", "List.filter kicked [ two.first; two.second ]",
        "match List.filter kicked [ two.first; two.second ] with [ i ] -> [ i ] | _ -> []",
    ),
    "a blocked kick blocks no other": (
        "blocked.ml", "|> spread ~beside Ids.empty", "|> spread ~beside:(fun _ _ -> ignore beside; []) Ids.empty",
    ),
    "a path is as long as a velocity": (
        "blocked.ml", "~span:model.timestep", "~span:(ignore model; Rat.one)",
    ),
    "who is beside a walker alone blocks its kick": (
        "blocked.ml", "c.setting.neighbours.along c.setting.model.timestep", "c.setting.neighbours.along Rat.zero",
    ),
    "the last collision of a path counts": (
        "blocked.ml", "Option.merge Rat.min first (time pair)", "Option.merge Rat.max first (time pair)",
    ),
    "sweeps that touch meet": ("../../solids/geometry/swept.ml", "inside) < 0) facets", "inside) <= 0) facets"),
    "one of two sweeps goes backwards": ("../../solids/geometry/swept.ml", "Vec.sub r v", "Vec.add r v"),
    "a walker that is hit stops": ("collisions.ml", "stops p && (one || not two)", "stops p && (one || true)"),
    "two that slide into each other go on": ("collisions.ml", "stops q && (two || not one)", "(ignore one; stops q && two)"),
    "walkers connect collisions": (
        "collisions.ml", "Option.is_some (Process.yielding_mass model processes.(i))",
        "Option.is_some (State.mass model processes.(i))",
    ),
    "a walker takes its share of a bounce": (
        "straight.ml", "Process.yielding_mass model processes.(i)", "State.mass model processes.(i)",
    ),
    "a walker in a bounce is at rest": (
        "straight.ml", "[ part first (Vec.neg n); part second n ]",
        "List.filter (fun (i, _, _) -> Option.is_some (Process.yielding_mass model processes.(i)))\n"
        "    [ part first (Vec.neg n); part second n ]",
    ),
    # Laws of motion.
    "fixed bodies are steered": (
        "process.ml", "p.leaves\n  && Option.is_some (State.mass m p)", "p.leaves\n  && (ignore State.mass; true)",
    ),
    "the last one draws first": (
        "process.ml", "if compare first p <= 0 then first else p", "if compare first p >= 0 then first else p",
    ),
    "a velocity that is drawn twice counts once": (
        "steer.ml", "merged Given.compare n.add", "merged Given.compare (fun q _ -> ignore n; q)",
    ),
    "as many outcomes as allowed are too many": (
        "steer.ml", "List.length others > Law.most_outcomes", "List.length others >= Law.most_outcomes",
    ),
    "masses of leaves do not weigh": (
        "steer.ml", "Vec.scale mass (Vec.sub b a)", "(ignore mass; Vec.sub b a)",
    ),
    "laws are asked before collisions": (
        "steer.ml", "if Collisions.collides c s then None", "if false && Collisions.collides c s then None",
    ),
    "who moved a part of a step sees a whole one": (
        "steer.ml", "Rat.sub m.timestep step.remaining", "(ignore step; m.timestep)",
    ),
    # Time.
    "split clocks are not looked at": (
        "time.ml", "Some (Rat.sub step clock)", "(ignore clock; Some step)",
    ),
    "clocks go on when a bond becomes releasable": (
        "time.ml", "expires && gains_split m p aged", "expires && false && gains_split m p aged",
    ),
    "a delay that ends now has not expired": (
        "time.ml", "Some h -> Rat.compare h d <= 0", "Some h -> Rat.compare h d < 0",
    ),
    "time may end a step late": ("time.ml", "if steered then least next step else next", "(ignore steered; next)"),
    "turns without effect go on": (
        "time.ml", "Option.is_some turn && nothing_ahead ()", "Option.is_some turn && false && nothing_ahead ()",
    ),
    # Successors, and what is well-formed.
    "time passes beside what is urgent": (
        "network.ml", "if is_urgent d then [] else time ()", "time ()",
    ),
    "what is steered collides and is steered again": ("network.ml", "| Steered -> Steered", "| Steered -> Due"),
    "who may split is quiescent": (
        "network.ml", "urgent c p = [] && Option.is_none p.State.clock", "urgent c p = []",
    ),
    "outcomes of one label are one": (
        "transition.ml", " && List.equal State.equal_process a.come b.come", "",
    ),
    "a clock may show a whole step": (
        "../../../test/support/well_formed/well_formed.ml", "Rat.sign c >= 0 && Rat.compare c step < 0",
        "Rat.sign c >= 0 && Rat.compare c step <= 0",
    ),
    "a leaf may be there twice": (
        "../../../test/support/well_formed/well_formed.ml", "| Some _ -> Some (Repeated_leaf leaf)",
        "| Some n -> if n > 2 then Some (Repeated_leaf leaf) else None",
    ),
    "a process may be in two pieces": ("../../../test/support/well_formed/well_formed.ml", "| [ _ ] -> true\n  | _ -> false", "| _ -> true"),
    "parts of one process may interpenetrate": (
        "../../../test/support/well_formed/well_formed.ml", "{ p with process = i }", "(ignore i; p)",
    ),
    "an absorber may be bound": (
        "../../../test/support/well_formed/well_formed.ml", "absorbs && Array.length p.leaves > 1", "absorbs && Array.length p.leaves > 2",
    ),
    "a wall may spin": (
        "../../../test/support/well_formed/well_formed.ml", "not (Vec.is_zero p.velocity && Vec.is_zero p.spin)", "not (Vec.is_zero p.velocity)",
    ),
    # Chapter 4: bodies that turn.
    "turns are longer than their bound": (
        "turn.ml", "(Rat.make Z.one (Z.of_int 4)) <= 0", "(Rat.make Z.one (Z.of_int 1)) <= 0",
    ),
    "what has turned is forgotten": ("turn.ml", "Some (Rat.sub d p.since)", "Some d"),
    "the grid counts from the later turn": (
        "turning.ml", "Rat.min one.since two.since", "Rat.max one.since two.since",
    ),
    "what would collide is rounded": (
        "round.ml", "if waiting = [] then (trial, changes)", "if waiting = [] || hit <> [] then (trial, changes)",
    ),
    "who collides begins a turn": (
        "round.ml", "List.filter (fun i -> not (List.exists (involves i) hit)) due", "(ignore hit; due)",
    ),
}

# Random walkers, against the successor function that was written from the text.
def walkers(options: str) -> mistakes.Test:
    compare = "test/outside/successor/compare.py --scc _build/default/bin/main.exe --no-suite --models 0 --rigid 0 "
    return mistakes.Test("bin/main.exe", ("python3", "-B", *(compare + options).split()))



TESTS = [
    mistakes.Test("test/unit/semantics/tests.exe"),
    mistakes.Test("test/unit/elaborate/tests.exe"),
    mistakes.Test(
        "bin/main.exe",
        ("python3", "-B", "specs/conformance/run.py", "--", "_build/default/bin/main.exe", "oracle"),
    ),
    mistakes.Test("test/laws/networks/test_rigid_laws.exe"),
    mistakes.Test("test/laws/networks/tests.exe"),
    walkers("--runs 8 " + " ".join("--file test/outside/successor/models/%s.sc" % m for m in ("blocked-bound", "moving-wall"))),
    walkers("--walks 150 --steps 12 --stop 1"),
]

if __name__ == "__main__":
    sys.exit(mistakes.main(mistakes.Program(__doc__, "lib/kernel/semantics", MISTAKES, TESTS)))
