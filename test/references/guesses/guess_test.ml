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

(* Point [k] elsewhere: nearby, most of the time. *)
let move st (s : Portal.t) k =
  let i = s.va.(k) and j = s.vb.(k) and l = Random.State.int st 6 in
  match Random.State.int st 6 with
  | 0 -> Portal.place s k (neighbour st s.a i) j
  | 1 -> Portal.place s k i (neighbour st s.b j)
  | 2 -> Portal.place s k (neighbour st s.a i) (neighbour st s.b j)
  | 3 -> Portal.place s k s.va.(l) j
  | 4 -> Portal.place s k i s.vb.(l)
  | _ -> Portal.place s k (any st s.a) (any st s.b)

let scramble st (s : Portal.t) (found : Portal.search) : Portal.search =
  let chance n = Random.State.int st n = 0 in
  (* The centre is no vertex, and points that the search has not used have no place yet. *)
  for k = 0 to 5 do
    Portal.place s k (Int.max 0 s.va.(k)) (Int.max 0 s.vb.(k))
  done;
  if chance 2 then move st s (Random.State.int st 6);
  if chance 3 then for k = 0 to 5 do if chance 2 then move st s k done;
  if chance 3 then for k = 0 to 2 do s.x.(Portal.direction + k) <- number st done;
  match Random.State.int st 8 with
  | 0 -> Apart
  | 1 -> Beside
  | 2 -> Inside
  | 3 -> Through
  | _ -> found

let wild st : Portal.guess =
  let { Portal.cast; through; locate } = Portal.guess in
  {
    cast = (fun s ~hasty -> scramble st s (cast s ~hasty));
    through = (fun s -> scramble st s (through s));
    locate = (fun s ~hasty -> scramble st s (locate s ~hasty));
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
