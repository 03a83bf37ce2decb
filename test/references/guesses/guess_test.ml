(* The answers of Obstacle do not depend on what Portal guesses: here it guesses at random, mostly near the truth,
   and every answer is held against all facets. What is guessed well hides a proof that asks for too little. *)

open Scc_exact
open Scc_geometry
module Naive = Scc_naive.Naive

(* {1 Wild guesses} *)

let number st =
  match Random.State.int st 12 with
  | 0 -> Float.nan
  | 1 -> Float.infinity
  | 2 -> Float.neg_infinity
  | 3 -> 0.
  | 4 -> 1e-300
  | 5 -> 1e300
  | _ -> Random.State.float st 2. -. 1.

let any st (s : Solid.t) = Random.State.int st (Array.length s.vertices)

let neighbour st (s : Solid.t) v =
  let { Topology.first; neighbour; _ } = s.topology in
  neighbour.(first.(v) + Random.State.int st (first.(v + 1) - first.(v)))

let any_point st (question : Question.t) =
  Point.make ~of_a:(any st question.a) ~of_b:(any st question.b)

let chance st n = Random.State.int st n = 0

(* A point elsewhere: nearby, most of the time. *)
let moved st (question : Question.t) p =
  let of_a = Point.of_a p and of_b = Point.of_b p in
  match Random.State.int st 4 with
  | 0 -> Point.make ~of_a:(neighbour st question.a of_a) ~of_b
  | 1 -> Point.make ~of_a ~of_b:(neighbour st question.b of_b)
  | 2 -> Point.make ~of_a:(neighbour st question.a of_a) ~of_b:(neighbour st question.b of_b)
  | _ -> any_point st question

(* Points like the given ones: moved, or mixed with each other. *)
let scrambled st question points =
  let pick () = points.(Random.State.int st (Array.length points)) in
  let mixed p =
    if chance st 2 then Point.make ~of_a:(Point.of_a (pick ())) ~of_b:(Point.of_b p)
    else Point.make ~of_a:(Point.of_a p) ~of_b:(Point.of_b (pick ()))
  in
  let some = chance st 2 and many = chance st 3 in
  let change p = if chance st 2 then moved st question p else mixed p in
  let one = Random.State.int st (Array.length points) in
  Array.mapi (fun k p -> if (some && k = one) || (many && chance st 2) then change p else p) points

(* The points and the direction of a guess; what it has not comes by chance. *)
type parts = { portal : Portal.triangle; edge : Portal.edge; direction : Shadow.floats }

let any_direction st : Shadow.floats =
  let x = number st in
  let y = number st in
  { x; y; z = number st }

let any_triangle st question : Portal.triangle =
  let p = any_point st question in
  { p; q = moved st question p; r = moved st question p }

let any_edge st question : Portal.edge =
  let right = any_point st question in
  { right; left = moved st question right }

let scramble st question { portal = { p; q; r }; edge = { right; left }; direction } =
  let points = scrambled st question [| p; q; r; right; left |] in
  {
    portal = { p = points.(0); q = points.(1); r = points.(2) };
    edge = { right = points.(3); left = points.(4) };
    direction = (if chance st 3 then any_direction st else direction);
  }

let any_parts st question =
  { portal = any_triangle st question; edge = any_edge st question; direction = any_direction st }

let wild_line st question (found : Portal.line) : Portal.line =
  let any = any_parts st question in
  let parts =
    match found with
    | Apart direction -> { any with direction }
    | Beside edge -> { any with edge }
    | Through { portal; edge } -> { any with portal; edge }
    | Lost -> any
  in
  let { portal; edge; direction } = scramble st question parts in
  match (Random.State.int st 6, found) with
  | 0, _ -> Apart direction
  | 1, _ -> Beside edge
  | 2, _ -> Through { portal; edge }
  | _, Apart _ -> Apart direction
  | _, Beside _ -> Beside edge
  | _, Through _ -> Through { portal; edge }
  | _, Lost -> Lost

let wild_place st question (found : Portal.place) : Portal.place =
  let any = any_parts st question in
  let parts =
    match found with
    | Apart direction -> { any with direction }
    | Inside portal | Facing portal -> { any with portal }
    | Lost -> any
  in
  let { portal; direction; _ } = scramble st question parts in
  match (Random.State.int st 6, found) with
  | 0, _ -> Apart direction
  | 1, _ -> Inside portal
  | 2, _ -> Facing portal
  | _, Apart _ -> Apart direction
  | _, Inside _ -> Inside portal
  | _, Facing _ -> Facing portal
  | _, Lost -> Lost

let wild st : Portal.guess =
  let { Portal.cast; through; locate } = Portal.guess in
  {
    cast = (fun question ~hasty -> wild_line st question (cast question ~hasty));
    through = (fun question edge -> wild_line st question (through question edge));
    locate = (fun question ~hasty -> wild_place st question (locate question ~hasty));
  }

(* {1 Scenes} *)

let hull points = Naive.hull (List.map (fun (x, y, z) -> Vec.of_ints x y z) points)

let shapes =
  let signs = [ -1; 1 ] in
  let with_z x y = List.map (fun z -> (x, y, z)) signs in
  let corners = List.concat_map (fun x -> List.concat_map (with_z x) signs) signs in
  let tips = [ (2, 0, 0); (-2, 0, 0); (0, 2, 0); (0, -2, 0); (0, 0, 2); (0, 0, -2) ] in
  [|
    hull corners;
    hull [ (0, 0, 0); (2, 0, 0); (0, 2, 0); (0, 0, 2) ];
    hull tips;
    hull (tips @ corners);
    hull [ (0, 0, 0); (9, 0, 0); (9, 1, 0); (8, 0, 1) ];
    hull [ (0, 0, 0); (9, 0, 1); (9, 9, 0); (0, 9, 1) ];
    hull [ (3, 0, 0); (-3, 1, 0); (0, 3, 1); (1, -3, 0); (0, 1, 3); (1, 0, -3); (2, 2, 2); (-2, -2, 2) ];
  |]

let turn st =
  let c () = Rat.of_int (Random.State.int st 7 - 3) in
  match Mat.of_quaternion (c (), c (), c (), c ()) with Some m when Random.State.bool st -> m | _ -> Mat.identity

let solid st id =
  let shape = shapes.(Random.State.int st (Array.length shapes)) in
  Scc_test_data.Test_data.solid ~id shape (turn st)

let small st = Rat.make (Z.of_int (Random.State.int st 13 - 6)) (Z.of_int (1 + Random.State.int st 3))
let vector st = Vec.make (small st) (small st) (small st)

(* A point of a facet of the obstacle: inside of it, on an edge or at a corner. *)
let on_surface st (o : Obstacle.t) =
  let facets = Obstacle.facets o in
  let n = facets.(Random.State.int st (Array.length facets)).normal in
  let mean (s : Solid.t) n =
    let heights = Array.map (Ivec.dot n) s.vertices in
    let top = Array.fold_left Z.max heights.(0) heights in
    let weight h = if Z.equal h top then Random.State.int st 3 else 0 in
    let weights = Array.map weight heights in
    let total = Array.fold_left ( + ) 0 weights in
    if total = 0 then None
    else
      let add i sum k = Vec.axpy (Rat.make (Z.of_int k) (Z.of_int total)) (Solid.vertex s i) sum in
      let sum = ref Vec.zero in
      Array.iteri (fun i k -> sum := add i !sum k) weights;
      Some !sum
  in
  match (mean o.a n, mean o.b (Ivec.neg n)) with Some a, Some b -> Vec.sub a b | _ -> vector st

let place st o = if Random.State.int st 3 = 0 then vector st else on_surface st o

let line st o =
  match Random.State.int st 3 with
  | 0 -> (place st o, vector st)
  | 1 ->
    let from = Vec.scale (Rat.of_int 3) (vector st) in
    (from, Vec.sub (place st o) from)
  | _ ->
    let from = place st o in
    (from, Vec.sub (place st o) from)

(* {1 The test} *)

let cast_text = function
  | Facets.Never -> "never"
  | Inside -> "inside"
  | At t -> Rat.to_string t

let relation_text = function
  | Facets.Apart -> "apart"
  | Touching -> "touching"
  | Interpenetrating -> "inside"

let meeting_text m =
  let bound = Option.fold ~none:"ever" ~some:Rat.to_string in
  Option.fold ~none:"none" ~some:(fun (low, high) -> bound low ^ " to " ^ bound high) m

let directions_text l = String.concat " " (List.map Ivec.to_string (List.sort Ivec.compare l))

(* Every answer of [o] about one line. *)
let compare_answers pair name o all (r, w) =
  let check what found expected =
    let at =
      Printf.sprintf "pair %d, %s guesses, r %s, w %s: %s" pair name (Vec.to_string r) (Vec.to_string w) what
    in
    Alcotest.(check string) at expected found
  in
  let relation = Facets.relation all r in
  check "relation" (relation_text (Obstacle.relation o r)) (relation_text relation);
  check "cast"
    (cast_text (Obstacle.first_time_of_contact o r w))
    (cast_text (Facets.first_time_of_contact all r w));
  check "meeting" (meeting_text (Obstacle.meeting o r w)) (meeting_text (Facets.meeting all r w));
  match relation with
  | Touching ->
    check "separating" (directions_text (Obstacle.separating o r)) (directions_text (Facets.separating all r))
  | Apart | Interpenetrating -> ()

(* One obstacle for all lines of a pair, and each line backwards as well: what it remembers must not mislead
   either. *)
let ask st pair =
  let a = solid st 0 and b = solid st 1 in
  let good = Obstacle.make a b and bad = Obstacle.make ~guess:(wild st) a b in
  let all = Facets.make a b in
  for _ = 1 to 20 do
    let r, w = line st good in
    let back = (Vec.axpy (Rat.of_int 9) w r, Vec.neg w) in
    List.iter
      (fun line ->
         compare_answers pair "wild" bad all line;
         compare_answers pair "good" good all line)
      [ (r, w); back ]
  done

let wild_guesses () =
  let st = Random.State.make [| 2026 |] in
  for pair = 1 to 1500 do
    ask st pair
  done

let () =
  Alcotest.run "guesses" [ ("portals", [ Alcotest.test_case "wild guesses" `Quick wild_guesses ]) ]
