(* How two solids stand to each other, over parameters, against the relation at points. *)

open Scc_geometry
open Scc_polyhedra
open Scc_offsets

let at_point o scene point : Touching_cells.relation =
  let r = Scenes.offset_at scene point in
  match Obstacle.relation o r with
  | Apart -> Apart
  | Touching -> Touching (Scenes.tight o r)
  | Interpenetrating -> Interpenetrating

let same (a : Touching_cells.relation) (b : Touching_cells.relation) =
  match (a, b) with
  | Apart, Apart | Interpenetrating, Interpenetrating -> true
  | Touching f, Touching g -> List.equal Int.equal f g
  | (Apart | Touching _ | Interpenetrating), _ -> false

let touching = ref 0

let agrees scene =
  let o = Scenes.obstacle scene in
  let cells = Touching_cells.make o ~offset:(Scenes.offset scene) Scenes.within in
  let answers point = List.filter_map (fun (p, r) -> if Polyhedron.mem p point then Some r else None) cells in
  let expected point =
    let relation = at_point o scene point in
    (match relation with Touching _ -> incr touching | Apart | Interpenetrating -> ());
    relation
  in
  if List.exists (fun (p, _) -> Polyhedron.is_empty p) cells then QCheck2.Test.fail_report "an empty region"
  else Scenes.all_right ~within:Scenes.within ~answers ~expected ~same

let random =
  QCheck2.Test.make ~name:"the cell of a point is how it is" ~count:300 ~print:Scenes.print
    (Scenes.generate ~far:3) agrees

let enough () = Alcotest.(check bool) "many points touch" true (!touching > 500)

let suite =
  let cases = Scc_test_support.Property.cases [ random ] in
  ("touching cells", [ ("random", cases @ [ Alcotest.test_case "enough" `Quick enough ]) ])
