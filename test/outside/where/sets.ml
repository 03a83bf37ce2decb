(* sets COUNT SEED: random ranges and sets in them (test/unit/where/samples.ml), and all that is said of them, as
   JSON Lines. A set is given as a list of polyhedra, which may overlap, and a polyhedron as a list of constraints
   [normal, relation, right], with relation -1 for <, 0 for = and 1 for <=. *)

open Scc_polyhedra
open Scc_regions
open Where_samples.Samples

let integer z = `Int (Z.to_int z)

let constraint_ (c : Constraint.t) =
  let relation = match c.relation with Less -> -1 | Equal -> 0 | At_most -> 1 in
  `List [ `List (List.map integer (Array.to_list c.normal)); `Int relation; integer c.right ]

let polyhedron p = `List (List.map constraint_ (Polyhedron.constraints p))
let union u = `List (List.map polyhedron (Union.pieces u))

let picture (w : Where.t) =
  match Plane.view w.ranges ~axes:[] ~fixed:[] with
  | Ok view -> Drawing.svg w.ranges view [ ("it", w) ]
  | Error message -> failwith message

let case number ((w : Where.t), holds, fails) =
  `Assoc
    [
      ("holds", union holds);
      ("fails", union fails);
      ("where", Scc_reports.Where_json.where w);
      ("smt", `String (Smt.script w.ranges ~numbers:[] [ ("it", w) ]));
      ("lines", `List (List.map (fun line -> `String line) (Words.lines w)));
      (* of three parameters one is projected, which takes longer *)
      ("svg", if Array.length w.ranges < 3 || number mod 20 = 2 then `String (picture w) else `Null);
    ]

let () =
  let count = int_of_string Sys.argv.(1) and seed = int_of_string Sys.argv.(2) in
  let rand = Random.State.make [| seed |] in
  for number = 0 to count - 1 do
    let some = QCheck2.Gen.generate1 ~rand (random_where (1 + (number mod 4))) in
    print_endline (Yojson.Basic.to_string (case number some))
  done
