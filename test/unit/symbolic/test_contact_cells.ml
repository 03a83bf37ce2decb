(* Cells of contact against the cast of the ordinary calculus, at points of the parameters. *)

open Scc_exact
open Scc_geometry
open Scc_polyhedra
open Scc_offsets
open Scc_symbolic
module Gen = QCheck2.Gen

(* {1 Against points} *)

type answer = Hit of Rat.t * int list | Miss

let at_point o scene ~limit point =
  let r = Scenes.offset_at scene point and w = Scenes.velocity scene in
  let in_time t = match limit with None -> true | Some l -> Rat.compare t (Linear.eval l point) <= 0 in
  match Obstacle.first_time_of_contact o r w with
  | At t when in_time t -> Hit (t, Scenes.tight o (Vec.axpy t w r))
  | At _ | Never -> Miss
  | Inside -> failwith "they interpenetrate"

let answers (hits, misses) point =
  let all answer = List.filter_map (fun p -> if Polyhedron.mem p point then Some answer else None) in
  let hit (h : Contact_cells.hit) = all (Hit (Linear.eval h.time point, h.tight)) [ h.region ] in
  List.concat_map hit hits @ all Miss misses

let same a b =
  match (a, b) with
  | Hit (s, f), Hit (t, g) -> Rat.equal s t && List.equal Int.equal f g
  | Miss, Miss -> true
  | (Hit _ | Miss), _ -> false

let seen = Hashtbl.create 8

let note answer =
  let kind =
    match answer with
    | Hit (t, [ _ ]) -> if Rat.sign t = 0 then "a hit now" else "a hit"
    | Hit (_, _) -> "a hit by several facets"
    | Miss -> "a miss"
  in
  Hashtbl.replace seen kind (1 + Option.value ~default:0 (Hashtbl.find_opt seen kind))

(* Where they do not interpenetrate now: the region of all parameters is cut by that first. *)
let agrees (scene, limit) =
  let o = Scenes.obstacle scene in
  let offset = Scenes.offset scene and velocity = Scenes.velocity scene in
  let expected point =
    let answer = at_point o scene ~limit point in
    note answer;
    answer
  in
  let outside = function
    | _, Touching_cells.Interpenetrating -> None
    | region, (Apart | Touching _) -> Some region
  in
  let of_region within =
    let hits, misses = Contact_cells.make o ~offset ~velocity ~limit within in
    if List.exists Polyhedron.is_empty (List.map (fun (h : Contact_cells.hit) -> h.region) hits @ misses) then
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
  let cells = Contact_cells.make o ~offset ~velocity:(Vec.of_ints (-1) 0 0) ~limit:None within in
  let near i = Constraint.[ less (variable i) (constant 2); greater (variable i) (constant (-2)) ] in
  match cells with
  | [ { region; time; tight = [ _ ] } ], misses ->
    let square = Polyhedron.of_constraints 2 (near 0 @ near 1) in
    Alcotest.(check bool) "the open square" true (Polyhedron.equal region square);
    Alcotest.(check bool) "at 10" true (Linear.equal time (constant 10));
    Alcotest.(check bool) "elsewhere not" true (List.for_all (Polyhedron.disjoint region) misses)
  | _ -> Alcotest.fail "one face alone is met"

let suite =
  let quick name f = Alcotest.test_case name `Quick f in
  ("contact cells",
   [
     ("by hand", [ quick "two cubes" meets ]);
     ("random", Scc_test_support.Property.cases [ random ] @ [ quick "enough of all" counts ]);
   ])
