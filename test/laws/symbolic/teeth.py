#!/usr/bin/env python3
"""Shows that the tests of zones can fail: rules of lib/verification/symbolic, and those they use, are broken one by one.

    test/laws/symbolic/teeth.py [--tree DIR] [NAME ...]
    test/laws/symbolic/teeth.py --places     only whether each mistake has a place to be made in; part of the tests

Works on a copy of the source tree (below DIR, to be kept for the next time). Each mistake has to be noticed by the
tests of test/laws/symbolic, test/laws/invariants and test/unit/symbolic: some test fails, or does not end. It takes
about half a minute for each.
"""

from __future__ import annotations

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "support"))

import mistakes

# Not among them, as they change nothing: that time may be halted for a weak split also at the instant of the next
# event (the split comes then as a choice of that instant), or that of delays that expire together only one does at
# first (the others are over at once, rule Eps0); or only seldom: that the search for invariants takes instants of the
# grid of splits for others (what comes of it is not accepted).
#
# name: (file, what stands there, what is put in its place)
MISTAKES = {
    "grazing is a contact": (
        "../../solids/offsets/half_space.ml",
        "  overlap along\n",
        "  contact along\n",
    ),
    "corners that are only touched are hit": (
        "../../solids/offsets/half_space.ml",
        "Constraint.less (crossing f) (crossing g)",
        "Constraint.at_most (crossing f) (crossing g)",
    ),
    "who leaves may come into contact": (
        "../../solids/offsets/half_space.ml",
        "Constraint.greater (crossing g) (zero g)",
        "Constraint.at_least (crossing g) (zero g)",
    ),
    "a contact at the limit is late": (
        "../../solids/offsets/half_space.ml",
        "Constraint.at_most (crossing f) t ]",
        "Constraint.less (crossing f) t ]",
    ),
    "of a tie, the later is forgotten": (
        "first.ml",
        "(Constraint.equals t time) cell.time (cell.due @ [ event ])",
        "(Constraint.equals t time) cell.time cell.due",
    ),
    "ties are nowhere": (
        "first.ml",
        "    @ on (Constraint.equals t time) cell.time (cell.due @ [ event ])\n",
        "",
    ),
    "entered planes have to be left behind": (
        "../../solids/geometry/side.ml",
        "if speed < 0 then contact else overlap",
        "(ignore speed; overlap)",
    ),
    "other planes may hold the offset": (
        "../../solids/geometry/side.ml",
        "if speed < 0 then contact else overlap",
        "(ignore speed; contact)",
    ),
    "which plane is entered does not matter": (
        "instant.ml",
        "(List.fold_left cut [ meet ] (Half_space.passage facets).entered, rest)",
        "((ignore cut; [ meet ]), rest)",
    ),
    "which features touch does not matter": (
        "instant.ml",
        "by_features c hit) regions)",
        "(fun p -> ignore hit; [ p ])) regions)",
    ),
    "parts beside those that collide do not matter": (
        "instant.ml",
        "List.fold_left (apart_by_touching c) regions beside",
        "(ignore beside; regions)",
    ),
    "only where they are looked at do features touch": (
        "instant.ml",
        "List.concat_map (fall turns) regions",
        "(ignore (fall, turns); regions)",
    ),
    "features touch with their borders": (
        "../../solids/offsets/feature_offsets.ml",
        "let inside normal a = Constraint.greater",
        "let inside normal a = Constraint.at_least",
    ),
    "touching is open": (
        "../../solids/offsets/touching_cells.ml", "Half_space.needs Side.contact h", "Half_space.needs Side.overlap h",
    ),
    "other delays go on from the start": (
        "passing.ml",
        "Behaviour.wait (Linear.sub d passed) rest",
        "(ignore passed; Behaviour.wait d rest)",
    ),
    "ages go on after an eps": ("passing.ml", "ages = set z.ages leaf zero", "ages = z.ages"),
    "ages go on after a bond": (
        "happening.ml",
        "if List.mem i ends || gone i then zero else age",
        "if (ignore ends; gone i) then zero else age",
    ),
    "split clocks go on after an event": (
        "happening.ml",
        "if List.mem i new_clocks then zero else clock",
        "if List.mem i [] then (ignore new_clocks; zero) else clock",
    ),
    "split clocks do not begin anew after an eps": (
        "passing.ml",
        "match !restarted with None -> z.clocks | Some first -> set z.clocks first zero",
        "match !restarted with None -> z.clocks | Some _ -> (ignore zero; z.clocks)",
    ),
    "split clocks run on at split instants": (
        "passing.ml",
        "| Split_instant first -> { z with clocks = set z.clocks first zero }",
        "| Split_instant first -> (ignore zero; { z with clocks = set z.clocks first z.clocks.(first) })",
    ),
    "no time between events": (
        "zone_steps.ml",
        "let may_split = Zone_time.splits_at_any_time (",
        "let may_split = not @@ Zone_time.splits_at_any_time (",
    ),
    "no weak split at once": ("passing.ml", "~begins:Constraint.at_least", "~begins:Constraint.greater"),
    "halted zones do all": ("passing.ml", "halted = true", "halted = false"),
    "eps(0) waits": (
        "passing.ml",
        "match List.find_map of_leaf (State.leaves z.skeleton) with",
        "match List.find_map of_leaf [] with",
    ),
    "eps(t) is eps(0) where it may be": (
        "passing.ml",
        "(expire c (at over) (leaf, [ d ]) :: still)",
        "(ignore still; [ expire c (at over) (leaf, [ d ]) ])",
    ),
    "time passes before what is urgent": (
        "zone_steps.ml",
        "let passes = not (Network.is_urgent happenings || z.halted) in",
        "let passes = not z.halted in",
    ),
    "no weak split beside what is urgent": (
        "zone_steps.ml",
        "let weak = if passes && may_split then",
        "let weak = if Network.is_urgent happenings || (passes && may_split) then",
    ),
    "the horizon is too early": (
        "zone_graph.ml",
        "let in_time = Constraint.at_most time",
        "let in_time = Constraint.less time",
    ),
    "time stands still": (
        "../../kernel/state_sets/zone_time.ml", "time = later z.time;", "time = z.time;",
    ),
    "bodies that wait do not move": (
        "../../kernel/state_sets/zone_time.ml", "Place.moved places.(l.leaf) p.velocity time",
        "Place.moved places.(l.leaf) Scc_exact.Vec.zero time",
    ),
    "delays begin anew when time passes": (
        "../../kernel/state_sets/zone_time.ml", "Linear.add ages.(l.leaf) time", "time",
    ),
    "a delay that has just begun is none": (
        "../../kernel/state_sets/zone_well_formed.ml", "Constraint.at_least z.ages.(l.leaf) zero",
        "Constraint.greater z.ages.(l.leaf) zero",
    ),
    "nobody is at a split instant": (
        "../../kernel/state_sets/zone_well_formed.ml", "Constraint.at_least clock zero", "Constraint.greater clock zero",
    ),
    "borders belong to zones": (
        "zone_form.ml",
        "let set = Polyhedron.minimal set in",
        "let set = Polyhedron.minimal (Polyhedron.closure set) in",
    ),
    "a zone in the closure is known": (
        "zone_form.ml",
        "Polyhedron.included a.set (Polyhedron.preimage b.set ~dimension:n forms)",
        "Polyhedron.included a.set (Polyhedron.closure (Polyhedron.preimage b.set ~dimension:n forms))",
    ),
    "zones that differ in what depends are one": (
        "zone_form.ml",
        "if all 0 && Polyhedron",
        "if (ignore all; true) && Polyhedron",
    ),
    "halted zones are zones": ("zone_form.ml", "Bool.equal a.halted b.halted && List", "List"),
    "what led to a zone is forgotten": ("zone_form.ml", "List.equal Int.equal a.arrived b.arrived && ", ""),
    "open features do not come to meet": (
        "passing.ml",
        "if Model.binds_on_contact (Semantics.model c.semantics) then",
        "if false && Model.binds_on_contact (Semantics.model c.semantics) then",
    ),
    "they have met as soon as one border is passed": (
        "meeting_cells.ml",
        "on (Constraint.at_most f greatest) greatest @ on (Constraint.greater f greatest) f",
        "on (Constraint.at_most f greatest) f @ on (Constraint.greater f greatest) greatest",
    ),
    "all of a zone touches with the same features": (
        "instant.ml",
        "if Model.binds_on_contact m then List.concat_map (of_contacts c all) collisions",
        "if false then List.concat_map (of_contacts c all) collisions",
    ),
    # Formulas, backwards over the graph.
    "a split at once leads nowhere": (
        "timed_sets.ml",
        "(project (restrict (halting n at) [ no_time ]) ~dimension)",
        "(ignore no_time; Union.empty dimension)",
    ),
    "time halts nowhere": (
        "timed_sets.ml",
        "let halts n s at = inter (all_along s) (halting n at)",
        "let halts n s at = (ignore at; ignore n; Union.empty (Zone.dimension s.zone))",
    ),
    "what is bad in between does not matter": (
        "timed_sets.ml",
        "let clear_from_start s ~bad = minus (some s.region) (project bad ~dimension:(Zone.dimension s.zone - 1))",
        "let clear_from_start s ~bad = ignore bad; some s.region",
    ),
    "a formula holds for ever where its stretch is long": (
        "branching.ml",
        "union for_ever (union (late n s) (ends n s at))",
        "union for_ever (union (late n s) (ignore at; some s.region))",
    ),
    "what is next comes before time passes": (
        "branching.ml",
        "union u (union halted (ends n s at))",
        "(ignore at; union u halted)",
    ),
    "no bond is released before what is next": (
        "branching.ml",
        "union (reach s ~bad (halts n s f.at)) (extend_over s (ends n s at))",
        "(ignore bad; extend_over s (ends n s at))",
    ),
    "what is next may be what comes after it": (
        "run_search.ml",
        "breadth_first rule ~moves:passes ~win",
        "breadth_first rule ~moves ~win",
    ),
    # Runs that are shown of formulas: they are looked at again before, and by the tests.
    "a run passes by what it must not": (
        "run_search.ml",
        "within w w.way.here (clear_from_start s ~bad)",
        "(ignore bad; within w w.way.here (some s.region))",
    ),
    "a run splits where it must not": (
        "run_search.ml",
        "(Array.append w.way.here [| last |]) (not_after s ~bad target)",
        "(Array.append w.way.here [| last |]) (ignore bad; target)",
    ),
    "a run comes back to any state of a zone": (
        "run_search.ml",
        "(if takes_time then [ time ] else []) @ Array.to_list same",
        "(ignore same; if takes_time then [ time ] else [])",
    ),
    "time passes before the bound": (
        "run_search.ml", "constrained w [ Constraint.greater late", "constrained w [ Constraint.less late",
    ),
    # Invariants: what is found wrongly is not accepted, and what is checked wrongly accepts what is none.
    "a join forgets what is new": ("zone_hull.ml", "both) a b in", "both) a a in"),
    "a plane that one has crossed parts two bodies": (
        "zone_hull.ml", "let hold c = Polyhedron.implies a c && Polyhedron.implies b c in",
        "let hold c = Polyhedron.implies a c in",
    ),
    "narrowing forgets the start": ("invariant_search.ml", "  List.iter add starts;\n", "  List.iter ignore starts;\n"),
    "bodies that interpenetrate are states": ("plausible.ml", "Zone_well_formed.apart c { z with set }", "[ set ]"),
    "what happens at once is not checked": (
        "../certificate/certificate.ml", "  List.iteri each first;\n", "  ignore each;\n",
    ),
    "what comes of time is not checked": (
        "../certificate/certificate.ml", "    List.iter land_ends (",
        "    List.iter (fun p -> if false then land_ends p) (",
    ),
    "the start is not checked": (
        "../certificate/certificate.ml", "    starts t u ~declared;\n", "    ignore (starts, u, declared);\n",
    ),
    "a single state stands for a cell": (
        "../certificate/certificate.ml", "  && Polyhedron.included z.Zone.set", "  || Polyhedron.included z.Zone.set",
    ),
    "claims are believed": (
        "../certificate/certificate.ml", "if List.exists bad (", "if false && List.exists bad (",
    ),
    "two bodies never collide": (
        "../certificate/flow.ml", "if List.exists (Polyhedron.implies p) conditions then [ p ]", "if true then [ p ]",
    ),
    "contacts are not due": (
        "../certificate/flow.ml", "(Half_space.collision facets)) (moving c ends)",
        "(Half_space.collision facets)) (List.filter (fun _ -> false) (moving c ends))",
    ),
    "delays are not over": (
        "../certificate/certificate.ml", "List.map (fun f -> Polyhedron.add flow.states (over f)) left",
        "(ignore over; [])",
    ),
}

TESTS = [
    mistakes.Test("test/unit/symbolic/tests.exe"),
    mistakes.Test("test/laws/symbolic/test_zones.exe"),
    mistakes.Test("test/laws/symbolic/test_formulas.exe"),
    mistakes.Test("test/laws/symbolic/test_runs.exe"),
    mistakes.Test("test/laws/invariants/test_models.exe"),
    mistakes.Test("test/laws/symbolic/test_invariants.exe"),
]

if __name__ == "__main__":
    sys.exit(mistakes.main(mistakes.Program(__doc__, "lib/verification/symbolic", MISTAKES, TESTS)))
