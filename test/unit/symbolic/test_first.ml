(* The first of random events, against the least time at points. Each event comes at a random affine time where two
   random inequalities hold, if that is not before now, and never elsewhere. *)

open Scc_exact
open Scc_polyhedra
open Scc_symbolic
module Gen = QCheck2.Gen

type event = { number : int; where : Linear.t list;  (** all positive *) time : Linear.t }

let form =
  let open Gen in
  let+ c = -3 -- 6 and+ a = -1 -- 1 and+ b = -1 -- 1 in
  Linear.make ~constant:(Rat.of_int c) [| Rat.of_int a; Rat.of_int b |]

let events =
  let open Gen in
  let event = pair (list_size (0 -- 2) form) form in
  map (List.mapi (fun number (where, time) -> { number; where; time })) (list_size (0 -- 4) event)

let zero = Linear.constant 2 Rat.zero
let conditions e = Constraint.at_least e.time zero :: List.map (fun f -> Constraint.greater f zero) e.where

let comes e ~limit region =
  let step (left, rest) c =
    let parts p c = List.filter (fun p -> not (Polyhedron.is_empty p)) [ Polyhedron.add p c ] in
    (List.concat_map (fun p -> parts p c) left,
     rest @ List.concat_map (fun p -> List.concat_map (parts p) (Constraint.negation c)) left)
  in
  let in_time = match limit with None -> [] | Some t -> [ Constraint.at_most e.time t ] in
  let left, rest = List.fold_left step ([ region ], []) (conditions e @ in_time) in
  (List.map (fun region -> (region, e.time)) left, rest)

let at_point all point =
  let comes e = if List.for_all (fun c -> Constraint.mem c point) (conditions e) then Some e else None in
  let timed = List.map (fun e -> (Linear.eval e.time point, e.number)) (List.filter_map comes all) in
  match timed with
  | [] -> (None, [])
  | (t, _) :: rest ->
    let least = List.fold_left (fun l (t, _) -> Rat.min l t) t rest in
    (Some least, List.filter_map (fun (t, n) -> if Rat.equal t least then Some n else None) timed)

let same (t, due) (t', due') = Option.equal Rat.equal t t' && List.equal Int.equal due due'
let ties = ref 0

let agrees all =
  let cells = List.fold_left (fun cells e -> First.on (comes e) e.number cells) (First.start Scenes.within) all in
  let cells = First.merged Int.equal cells in
  let answer point (c : _ First.cell) =
    if Polyhedron.mem c.region point then Some (Option.map (fun t -> Linear.eval t point) c.time, c.due) else None
  in
  let expected point =
    let found = at_point all point in
    if List.compare_length_with (snd found) 1 > 0 then incr ties;
    found
  in
  Scenes.all_right ~within:Scenes.within ~answers:(fun p -> List.filter_map (answer p) cells) ~expected ~same

let random = QCheck2.Test.make ~name:"the cell of a point has what comes first" ~count:300 events agrees
let enough () = Alcotest.(check bool) "many ties" true (!ties > 500)

let suite =
  ("first",
   [ ("random", Scc_test_support.Property.cases [ random ] @ [ Alcotest.test_case "enough" `Quick enough ]) ])
