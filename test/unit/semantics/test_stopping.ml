(* Runs of dense crowds whose walkers do not bounce (rule Blocked), against the transition relation, step by step.
   The crowds are those of {!Test_crowd}, with kicks of more lengths. The relation is computed by brute force. *)

open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_engine
module Gen = QCheck2.Gen

let half n = Law.Const (Rat.make (Z.of_int n) (Z.of_int 2))
let kick (x, y, z) = { Law.motion = Law.velocity_alone (half x, half y, half z); weight = half 2 }

(* In halves of a unit: beside one place, to the next one, past it, askew, or nowhere. *)
let lengths = [ (1, 0, 0); (-4, 0, 0); (0, 3, 0); (0, -8, 0); (2, 2, 0); (-2, 0, -2); (0, 0, 0) ]

type walkers = {
  crowd : Test_crowd.crowd;
  blocked : Model.blocked;
  askew : bool;
  by_contact : bool;
  own : bool;
  tall : bool;  (** some are two cubes high *)
  absorbs : bool;  (** the walls take away whatever hits them *)
  drawn : bool;  (** chance decides between collisions *)
}

(* A cube that has nobody above, and is not below the ceiling. *)
let has_room w (x, y, z) =
  let places = w.crowd.places in
  List.exists (fun (_, _, z') -> z' > z) places && not (List.mem (x, y, z + 1) places)

let raised (l : Model.leaf) =
  let part = l.parts.(0) in
  { l with parts = [| part; { part with name = l.name ^ ".up"; offset = Vec.of_ints 0 0 2 } |] }

let network w =
  let m, declared = Test_crowd.network w.crowd in
  let law i (l : Model.leaf) =
    match l.law with
    | Choose _ when w.askew && i mod 2 = 0 -> { l with law = Choose (List.map kick lengths) }
    | _ -> l
  in
  let shape i (l : Model.leaf) =
    if l.fixed then { l with absorbs = w.absorbs }
    else if w.tall && has_room w (List.nth w.crowd.places i) then raised l
    else l
  in
  let steps : Model.steps = if w.own then Own else m.steps in
  let binding : Model.binding = if w.by_contact then On_contact else m.binding in
  let collisions : Model.collisions = if w.drawn && not w.crowd.together then Drawn else m.collisions in
  let leaves = Array.mapi shape (Array.mapi law m.leaves) in
  ({ m with leaves; blocked = w.blocked; steps; binding; collisions }, declared)

let random =
  let open Gen in
  let* crowd = frequency [ (2, Test_crowd.random_crowd); (1, Test_crowd.random_rows) ] in
  let* blocked = oneofl [ Model.Stop; Wait; Wait ] and* askew = bool in
  let+ by_contact = frequencyl [ (5, false); (1, true) ] and+ own = frequencyl [ (5, false); (1, true) ]
  and+ tall = bool and+ absorbs = frequencyl [ (5, false); (1, true) ] and+ drawn = bool in
  let places = if crowd.rows = [] then List.filteri (fun i _ -> i < 7) crowd.places else crowd.places in
  { crowd = { crowd with places }; blocked; askew; by_contact; own; tall; absorbs; drawn }

let print (w, choices) =
  let how = match w.blocked with Bounce -> "bounce" | Stop -> "stop" | Wait -> "wait" in
  Printf.sprintf "%s askew %b by contact %b own steps %b tall %b absorbs %b drawn %b: %s" how w.askew w.by_contact
    w.own w.tall w.absorbs w.drawn
    (Test_crowd.print (w.crowd, choices))

let texts m = List.map (Transition.label_to_string m)

(* Chance decides what is drawn next, and between urgent transitions in a model that draws ties. *)
let agree_on_chance step run transitions (labels : Run.labels) =
  let is_drawn (t : Transition.t) = Transition.is_drawn t.label in
  let drawn = List.exists is_drawn transitions in
  let by_chance = List.map (fun (t : Transition.t) -> Option.is_some t.chance) transitions in
  let others = List.filter (fun i -> not (List.nth by_chance i)) (List.init (List.length transitions) Fun.id) in
  let expected = if (not drawn) && List.mem true by_chance then Some others else None in
  let found = Option.map (fun (t : Ties.tie) -> t.others) labels.tie in
  if found <> expected then Test_crowd.differ step "what is tied" [ "one" ] [ "another" ];
  if Run.draws_on run <> drawn then Test_crowd.differ step "whether chance is next" [ "one" ] [ "another" ]

let follow (m, declared) choices =
  let plain = Semantics.make m in
  let rec go run step (s : State.t) = function
    | [] -> true
    | choice :: rest -> (
        if not (State.equal s (Run.state run)) then Test_crowd.differ step "the state" [ "one" ] [ "another" ];
        match (Network.successors plain s, Run.labels run) with
        | Ok [], Ok { count = 0; _ } -> true
        | Ok transitions, Ok labels ->
          let expected = texts m (List.map (fun (t : Transition.t) -> t.label) transitions) in
          let found = texts m (Run.list labels) in
          if not (List.equal String.equal expected found) then
            Test_crowd.differ step "what is possible" expected found;
          agree_on_chance step run transitions labels;
          let i = choice mod List.length transitions in
          let t = List.nth transitions i in
          let taken = Run.take run i in
          let expected = Test_crowd.taken_text m t.label t.rules in
          let found = Test_crowd.taken_text m taken.label taken.rules in
          if not (String.equal expected found) then Test_crowd.differ step "what is taken" [ expected ] [ found ];
          let run = if step mod 13 = 12 then Run.resume (Standard.of_model m) t.target else run in
          go run (step + 1) t.target rest
        | Error (Bad_chance f), Error (Bad_chance g) ->
          f = g || Test_crowd.differ step "a fault" [ "one" ] [ "another" ]
        | Error _, _ | _, Error _ -> failwith "a fault of constant laws")
  in
  match (Network.initial plain declared, Run.start (Standard.of_model m) declared) with
  | Ok s, Ok run -> go run 0 s choices
  | Error _, _ | _, Error _ -> failwith "laws that are constant"

let crowds =
  QCheck2.Test.make ~name:"crowds that stop" ~count:30 ~print
    Gen.(pair random (list_size (pure 40) nat))
    (fun (w, choices) -> follow (network w) choices)

(* Walkers that bind, in a room as wide as their kicks: some hit a wall and one to bind to at one instant. *)
let in_corners =
  let open Gen in
  let* places = map (List.sort_uniq Stdlib.compare) (list_size (2 -- 4) (triple (0 -- 1) (0 -- 1) (pure 0))) in
  let+ blocked = oneofl [ Model.Stop; Wait ] and+ laws = list_size (1 -- 2) (oneofl [ 2; 4 ]) and+ tall = bool in
  let crowd : Test_crowd.crowd =
    {
      places; pitch = 3; around = Room; slack = 1; laws; sticky = true; steady = true; together = false;
      any_time = false; half = false; lots = []; split_step = (1, 1); rows = [];
    }
  in
  { crowd; blocked; askew = true; by_contact = false; own = false; tall; absorbs = false; drawn = false }

let corners =
  QCheck2.Test.make ~name:"walkers that bind in corners" ~count:30 ~print
    Gen.(pair in_corners (list_size (pure 30) nat))
    (fun (w, choices) -> follow (network w) choices)

(* {1 Growth}

   n² cubes on a floor, half a side apart, that wait: words allocated for one draw, of all that a kick needs. *)
let words n =
  let places = List.concat (List.init n (fun x -> List.init n (fun y -> (x, y, 0)))) in
  let crowd : Test_crowd.crowd =
    {
      places; pitch = 3; around = Room; slack = 1; laws = [ 4 ]; sticky = false; steady = true; together = false;
      any_time = false; half = false; lots = []; split_step = (1, 1); rows = [];
    }
  in
  let m, declared = network { crowd; blocked = Wait; askew = false; by_contact = false; own = false;
                              tall = false; absorbs = false; drawn = false } in
  match Run.start (Standard.of_model m) declared with
  | Error _ -> Alcotest.fail "laws that are constant"
  | Ok run ->
    let random = ref 1 and draws = ref 0 in
    let before = Gc.minor_words () in
    while Rat.compare (Run.elapsed run) (Rat.of_int 3) < 0 do
      random := ((!random * 1103515245) + 12345) land 0x3fffffff;
      let count = match Run.labels run with Ok labels -> labels.count | Error _ -> Alcotest.fail "a law" in
      match (Run.take run (!random / 1024 mod count)).label with Draw _ -> incr draws | _ -> ()
    done;
    if !draws < 3 * n * n then Alcotest.failf "%d draws of %d cubes" !draws (n * n);
    (Gc.minor_words () -. before) /. float_of_int !draws

let growth () =
  let few = words 10 and many = words 30 in
  if many > 1.4 *. few then Alcotest.failf "words for a draw: %.1f of 100 cubes, %.1f of 900" few many

let suite =
  ( "walkers that stop",
    [
      ("as the transition relation", Scc_test_support.Property.cases [ crowds; corners ]);
      ("known", [ Alcotest.test_case "growth: a draw costs as much in a crowd of 900 as of 100" `Quick growth ]);
    ] )
