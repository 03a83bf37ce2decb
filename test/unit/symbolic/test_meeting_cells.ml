(* Regions of a collision against the cast of the ordinary calculus, at points of the parameters. *)

open Scc_exact
open Scc_geometry
open Scc_polyhedra
open Scc_offsets
open Scc_symbolic
module Gen = QCheck2.Gen

(* {1 Against points} *)

type answer = Hit of Rat.t | Miss

let seen = Hashtbl.create 8
let note kind = Hashtbl.replace seen kind (1 + Option.value ~default:0 (Hashtbl.find_opt seen kind))

let at_point o scene ~limit point =
  let r = Scenes.offset_at scene point and w = Scenes.velocity scene in
  let in_time t = match limit with None -> true | Some l -> Rat.compare t (Linear.eval l point) <= 0 in
  match Obstacle.first_time_of_contact o r w with
  | At t when in_time t ->
    note (if Rat.sign t = 0 then "a hit now" else "a hit");
    if List.compare_length_with (Scenes.tight o (Vec.axpy t w r)) 1 > 0 then note "a hit by several facets";
    Hit t
  | At _ | Never ->
    note "a miss";
    Miss
  | Inside -> failwith "they interpenetrate"

let answers (hits, misses) point =
  let all answer = List.filter_map (fun p -> if Polyhedron.mem p point then Some answer else None) in
  let hit (region, time) = all (Hit (Linear.eval time point)) [ region ] in
  List.concat_map hit hits @ all Miss misses

let same a b =
  match (a, b) with
  | Hit s, Hit t -> Rat.equal s t
  | Miss, Miss -> true
  | (Hit _ | Miss), _ -> false

(* Where they do not interpenetrate now: the region of all parameters is cut by that first. *)
let agrees (scene, limit) =
  let o = Scenes.obstacle scene in
  let offset = Scenes.offset scene and velocity = Scenes.velocity scene in
  let expected = at_point o scene ~limit in
  let outside = function
    | _, Touching_cells.Interpenetrating -> None
    | region, (Apart | Touching _) -> Some region
  in
  let of_region within =
    let hits, misses = Meeting_cells.of_solids o ~offset ~velocity ~limit within in
    if List.exists Polyhedron.is_empty (List.map fst hits @ misses) then
      QCheck2.Test.fail_report "an empty region"
    else Scenes.all_right ~within ~answers:(answers (hits, misses)) ~expected ~same
  in
  List.for_all of_region (List.filter_map outside (Touching_cells.make o ~offset Scenes.within))

let limit =
  let open Gen in
  let form c (a, b) = Linear.make ~constant:(Rat.of_int c) [| Rat.of_int a; Rat.of_int b |] in
  option (map2 form (0 -- 6) (pair (-1 -- 1) (-1 -- 1)))

let random =
  QCheck2.Test.make ~name:"the cell of a point is what comes of it" ~count:300
    ~print:(fun (scene, _) -> Scenes.print scene)
    (Gen.pair (Scenes.generate ~far:5) limit)
    agrees

(* So that the property is about something. *)
let counts () =
  let at_least n kind =
    let k = Option.value ~default:0 (Hashtbl.find_opt seen kind) in
    if k < n then Alcotest.failf "only %d of %s" k kind
  in
  List.iter (at_least 200) [ "a hit"; "a hit by several facets"; "a miss" ];
  at_least 30 "a hit now"

(* {1 By hand} *)

(* A cube that comes along x to one at 12: they meet iff it is off by less than 2 in y and in z. *)
let meets () =
  let o = Obstacle.make Scenes.cube Scenes.cube in
  let constant n = Linear.constant 2 (Rat.of_int n) and variable = Linear.variable 2 in
  let offset = (constant 12, Linear.neg (variable 0), Linear.neg (variable 1)) in
  let five = (Rat.of_int (-5), Rat.of_int 5) in
  let within = Polyhedron.box [| five; five |] in
  let cells = Meeting_cells.of_solids o ~offset ~velocity:(Vec.of_ints (-1) 0 0) ~limit:None within in
  let near i = Constraint.[ less (variable i) (constant 2); greater (variable i) (constant (-2)) ] in
  match cells with
  | [ (region, time) ], misses ->
    let square = Polyhedron.of_constraints 2 (near 0 @ near 1) in
    Alcotest.(check bool) "the open square" true (Polyhedron.equal region square);
    Alcotest.(check bool) "at 10" true (Linear.equal time (constant 10));
    Alcotest.(check bool) "elsewhere not" true (List.for_all (Polyhedron.disjoint region) misses)
  | _ -> Alcotest.fail "one face alone is met"

let suite =
  let quick name f = Alcotest.test_case name `Quick f in
  ("meeting cells",
   [
     ("by hand", [ quick "two cubes" meets ]);
     ("random", Scc_test_support.Property.cases [ random ] @ [ quick "enough of all" counts ]);
   ])
