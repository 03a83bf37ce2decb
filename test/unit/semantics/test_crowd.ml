(* Runs of dense crowds that laws move, against the transition relation, step by step. Cubes of side 2 stand in a
   grid, face to face or with a little room, on a floor or inside a room of walls, and are kicked along the axes:
   they rest on floors and on each other, are wedged between walls, and many collide at one instant. Some bind, and
   chance releases their bonds (rule Lot). *)

open Scc_exact
open Scc_geometry
open Scc_calculus
open Scc_semantics
open Scc_engine
module Gen = QCheck2.Gen

type around = Nothing | Floor | Room

type crowd = {
  places : (int * int * int) list;
  pitch : int;  (** from cube to cube: 2 face to face *)
  around : around;
  slack : int;  (** between the outermost cubes and the walls *)
  laws : int list;  (** of each cube, by {!law} *)
  sticky : bool;  (** some bind, and part again *)
  steady : bool;
  together : bool;
  any_time : bool;
  half : bool;  (** steps of 1/2 *)
  lots : int list;  (** behaviours that leave bonds to chance, of each cube, by {!definitions}; if there are any *)
  split_step : int * int;
  rows : int list;  (** the lengths of rows of cubes that are bound from the start; the others are single *)
}

let const n = Law.Const (Rat.of_int n)
let kick weight (x, y, z) = { Law.motion = Law.velocity_alone (const x, const y, const z); weight = const weight }

let law : int -> Law.t = function
  | 0 -> Inertial
  | 1 -> Gives (Law.velocity_alone (const 1, const 0, const 0))
  | 2 -> Choose (List.map (kick 1) [ (1, 0, 0); (-1, 0, 0); (0, 0, 0) ])
  | 3 -> Choose [ kick 2 (0, 0, -1); kick 1 (0, 0, 1); kick 3 (0, 2, 0) ]
  | _ -> Choose (List.map (kick 1) [ (1, 0, 0); (-1, 0, 0); (0, 1, 0); (0, -1, 0) ])

(* A and B bind in pairs, Chain in chains: bonds with a chance at one end or at both, with free ends that have one
   way or several, with pushes, and beside free splits and reactions. The chances of Much sum to more than 1. *)
let definitions : Behaviour.definitions =
  let open Fixture in
  let call = Behaviour.call and rate r = Odds.Rate { rate = r; alone = Odds.within ~step:(q 1) r } in
  let by odds ?push name faces rest = Behaviour.weak ?push ~odds (channel name faces) rest in
  let chance a b = Odds.Chance (ratio a b) in
  let pushed faces = Behaviour.weak ~push:(ratio 1 2) (channel "a" faces) in
  let right = [ "right" ] and left = [ "left" ] and ahead = [ "right"; "top" ] and behind = [ "left"; "bottom" ] in
  let late side rest = eps (ratio 5 2) (strong [ ("a", side) ] rest) in
  let once = by (chance 1 3) "a" left (call 4) and hard = by (chance 1 3) ~push:(ratio 1 3) "a" left (call 4) in
  [|
    ("A", open_ "a" ahead (call 1));
    ("Ab", by (rate (ratio 3 4)) "a" ahead (call 0));
    ("B", co_open "a" behind (call 3));
    ("Ba", weak "a" behind (call 2) + pushed behind (call 2) + eps (ratio 1 2) (weak "a" behind nil));
    ("Chain", open_ "a" right (call 5) + co_open "a" left (call 6));
    ("Right", co_open "a" left (call 7) + by (chance 1 2) "a" right (call 4) + late right (call 4));
    ("Left", open_ "a" right (call 7) + once + hard + late left (call 4));
    ("Both",
     by (rate (q 2)) "a" right (call 6) + by (rate (q 1)) "a" left (call 5)
     + strong [ ("a", left); ("a", right) ] (call 4));
    ("Free_right", weak "a" right (call 4));
    ("Free_left", weak "a" left (call 4) + pushed left nil);
    ("Free_both", weak "a" right (call 6) + weak "a" left (call 5) + pushed left (call 8));
    ("Much", open_ "a" ahead (by (chance 2 3) "a" ahead nil + by (chance 1 2) "a" ahead (call 11)));
  |]
  |> Array.map (fun (name, body) : Behaviour.definition -> { name; body })

let nth_of list i = List.nth list (i mod List.length list)

let behaviour c i =
  let open Fixture in
  if c.lots <> [] then Behaviour.call (nth_of c.lots i)
  else if not c.sticky then nil
  else
    match i mod 4 with
    | 0 -> open_ "a" [ "right"; "top" ] (weak "a" [ "right"; "top" ] nil)
    | 1 -> co_open "a" [ "left"; "bottom" ] (weak "a" [ "left"; "bottom" ] (eps (ratio 1 3) nil))
    | 2 -> open_ "a" [ "back" ] nil
    | _ -> co_open "a" [ "front"; "right" ] (eps (ratio 3 2) nil)

let slab id x y z = Solid.make ~id Scc_test_networks.Cube.polyhedron (Mat.diagonal (Vec.of_ints x y z))

(* Walls of thickness 2, as parts of one fixed body: a floor alone, or all six. It has a law at times, which moves
   nothing: then there are steps even where no cube is steered. *)
let walls c =
  let part name solid (x, y, z) : Model.part =
    { name; template = "Cube"; solid; offset = Vec.of_ints x y z; open_offset = None; mass = Rat.one }
  in
  let far pick = List.fold_left (fun most place -> Int.max most (pick place)) 0 c.places in
  let high pick = (c.pitch * far pick) + 1 + c.slack and low = -1 - c.slack in
  let x = high (fun (x, _, _) -> x) and y = high (fun (_, y, _) -> y) and z = high (fun (_, _, z) -> z) in
  let long = 60 in
  let floor = part "w.floor" (slab 3 long long 1) (0, 0, -2) in
  match c.around with
  | Nothing -> []
  | Floor -> [ floor ]
  | Room ->
    [
      floor; part "w.top" (slab 3 long long 1) (0, 0, z + 1);
      part "w.left" (slab 1 1 long long) (low - 1, 0, 0); part "w.right" (slab 1 1 long long) (x + 1, 0, 0);
      part "w.front" (slab 2 long 1 long) (0, low - 1, 0); part "w.back" (slab 2 long 1 long) (0, y + 1, 0);
    ]

let bodies c =
  let body i (x, y, z) =
    let at = (c.pitch * x, c.pitch * y, c.pitch * z) in
    let velocity = ((i mod 3) - 1, (i / 3 mod 3) - 1, 0) in
    Fixture.body (Printf.sprintf "p%d" i) at ~velocity ~behaviour:(behaviour c i) ~mass:(1 + (i mod 2))
      ~law:(law (List.nth c.laws (i mod List.length c.laws)))
  in
  List.mapi body c.places

(* Rows of cubes, face to face, become one process each. *)
let bound rows (declared : State.t) =
  let join (p : State.process) (q : State.process) =
    let last = p.leaves.(Array.length p.leaves - 1).leaf in
    let finish at face : State.finish = { at; site = Fixture.site face } in
    let bond = State.bond "a" (finish last "right") (finish (last + 1) "left") in
    State.process ~leaves:(Array.to_list p.leaves @ Array.to_list q.leaves) ~bonds:(bond :: Array.to_list p.bonds)
      ~velocity:p.velocity ~clock:None ()
  in
  let row (done_, left) length =
    let mine = List.filteri (fun i _ -> i < length) left and left = List.filteri (fun i _ -> i >= length) left in
    (List.fold_left join (List.hd mine) (List.tl mine) :: done_, left)
  in
  let joined, left = List.fold_left row ([], Array.to_list declared.processes) rows in
  State.make ~processes:(joined @ left) ~step:None ~time:None

let network c : Model.t * State.t =
  let bodies = bodies c in
  let timestep = if c.half then Fixture.ratio 1 2 else Rat.one in
  let split_step = Fixture.ratio (fst c.split_step) (snd c.split_step) in
  let splits : Model.splits = if c.any_time && c.lots = [] then Any_time else Every split_step in
  let m = { (Fixture.model ~definitions ~timestep ~splits bodies) with lots = c.lots <> [] } in
  let declared = bound c.rows (Fixture.declared bodies) in
  let m, processes =
    match Array.of_list (walls c) with
    | [||] -> (m, Array.to_list declared.processes)
    | parts ->
      let wall =
        { m.leaves.(0) with name = "w"; parts; fixed = true; law = (if c.sticky then Law.Inertial else law 4) }
      in
      let leaf = { declared.processes.(0).leaves.(0) with leaf = List.length bodies; position = Vec.zero;
                                                          behaviour = Behaviour.fresh Behaviour.nil } in
      let process = State.process ~leaves:[ leaf ] ~bonds:[] ~velocity:Vec.zero ~clock:None () in
      let steered = m.steered || not c.sticky in
      let leaves = Array.append m.leaves [| wall |] in
      ({ m with leaves; steered }, Array.to_list declared.processes @ [ process ])
  in
  let steps : Model.steps = if c.steady then Steady else Shared in
  let collisions : Model.collisions = if c.together then Together else In_turn in
  ({ m with steps; collisions }, State.make ~processes ~step:None ~time:None)

let random_crowd =
  let open Gen in
  let place = triple (0 -- 2) (0 -- 2) (0 -- 2) in
  let* places = map (List.sort_uniq Stdlib.compare) (list_size (2 -- 12) place) in
  let* pitch = frequencyl [ (4, 2); (2, 3); (1, 4) ] in
  let* around = oneofl [ Nothing; Floor; Floor; Room; Room ] in
  let* slack = frequencyl [ (3, 0); (2, 1); (1, 2) ] in
  let some_laws = list_size (1 -- 4) (frequencyl [ (1, 0); (1, 1); (2, 2); (2, 3); (6, 4) ]) in
  let* laws = frequency [ (1, pure [ 0 ]); (6, some_laws) ] in
  let* sticky = frequencyl [ (2, false); (1, true) ] and* steady = bool and* half = bool in
  let* together = frequencyl [ (5, false); (1, true) ] and* any_time = frequencyl [ (5, false); (1, true) ] in
  let kind = frequencyl [ (4, 0); (4, 2); (6, 4); (1, 8); (1, 11) ] in
  let* lots = frequency [ (1, pure []); (1, list_size (1 -- 4) kind) ] in
  let* split_step = oneofl [ (1, 1); (1, 1); (1, 2); (2, 3); (3, 2) ] in
  return
    { places; pitch; around; slack; laws; sticky; steady; together; any_time; half; lots; split_step; rows = [] }

(* Rows of one to four cubes, face to face or with a row's room between them, whose bonds are left to chance from
   the start. *)
let random_rows =
  let open Gen in
  let two = oneofl [ [ 1; 3 ]; [ 5; 6 ]; [ 5; 9 ]; [ 8; 6 ]; [ 8; 9 ] ] in
  let single = map (fun kind -> [ kind ]) (oneofl [ 0; 2; 4 ]) and between = oneofl [ 7; 7; 7; 10 ] in
  let long =
    map3 (fun first inner last -> (first :: inner) @ [ last ])
      (oneofl [ 5; 8 ]) (list_size (1 -- 2) between) (oneofl [ 6; 9 ])
  in
  let row = frequency [ (1, single); (2, two); (4, long) ] in
  let* crowd = random_crowd and* rows = list_size (1 -- 4) (pair row (0 -- 2)) and* apart = 1 -- 2 in
  let place y (kinds, x) = List.mapi (fun i _ -> (x + i, y * apart, 0)) kinds in
  let places = List.concat (List.mapi place rows) and lots = List.concat_map fst rows in
  let+ laws = list_size (1 -- 4) (frequencyl [ (1, 0); (1, 1); (2, 2); (6, 4) ]) in
  { crowd with places; laws; lots; rows = List.map (fun (kinds, _) -> List.length kinds) rows; pitch = 2 }

let print (c, choices) =
  let numbers list = String.concat " " (List.map string_of_int list) in
  let place (x, y, z) = Printf.sprintf "(%d,%d,%d)" x y z in
  let around = match c.around with Nothing -> "nothing" | Floor -> "floor" | Room -> "room" in
  Printf.sprintf
    "%s pitch %d around %s slack %d laws %s sticky %b steady %b together %b any time %b half %b \
     lots %s split step %d/%d rows %s\nchoices %s"
    (String.concat " " (List.map place c.places)) c.pitch around c.slack (numbers c.laws) c.sticky c.steady
    c.together c.any_time c.half (numbers c.lots) (fst c.split_step) (snd c.split_step)
    (numbers c.rows) (numbers choices)

let differ step what expected found =
  let text = String.concat "; " in
  QCheck2.Test.fail_reportf "step %d, %s: %s\nbut from event to event: %s" step what (text expected) (text found)

let taken_text m label rules =
  Transition.label_to_string m label ^ " by " ^ String.concat ", " (List.map Rule.id rules)

let follow (m, declared) choices =
  let c = Standard.of_model m in
  let state = match Network.initial c declared with Ok s -> s | Error _ -> failwith "laws that are constant" in
  if not (Event_run.can_run m) then QCheck2.Test.fail_report "a crowd that does not run from event to event";
  let label (t : Transition.t) = Transition.label_to_string m t.label in
  let rec go run step (s : State.t) = function
    | [] -> true
    | choice :: rest -> (
        if not (State.equal s (Event_run.state run)) then differ step "the state" [ "one" ] [ "another" ];
        let some = List.filter (fun i -> (i + step) mod 3 = 0) (List.init (Array.length m.leaves) Fun.id) in
        if not (State.equal (State.with_leaves s some) (Event_run.part run some)) then
          differ step "a part of the state" [ "one" ] [ "another" ];
        match Network.successors c s with
        | Error (Bad_chance _) -> Event_run.may_fail run || differ step "a fault" [ "one" ] [ "none" ]
        | Error (Bad_law _ | Persistent_contact _) -> failwith "a fault of constant laws"
        | Ok _ when Event_run.may_fail run -> differ step "a fault" [ "none" ] [ "one" ]
        | Ok transitions ->
          let text i = Transition.label_to_string m (Event_run.label run i) in
          let offered = List.init (Event_run.count run) text in
          let expected = List.map label transitions in
          if not (List.equal String.equal expected offered) then differ step "what is possible" expected offered;
          transitions = []
          ||
          let i = choice mod List.length transitions in
          let t = List.nth transitions i in
          let taken = Event_run.take run i in
          let expected = taken_text m t.label t.rules and found = taken_text m taken.label taken.rules in
          if not (String.equal expected found) then differ step "what is taken" [ expected ] [ found ];
          (* a run may begin anywhere, also while bodies draw *)
          let run = if step mod 13 = 12 then Event_run.start c t.target else run in
          go run (step + 1) t.target rest)
  in
  go (Event_run.start c state) 0 state choices

let crowds =
  QCheck2.Test.make ~name:"crowds" ~count:60 ~print
    Gen.(pair random_crowd (list_size (pure 60) nat))
    (fun (c, choices) -> follow (network c) choices)

let rows =
  QCheck2.Test.make ~name:"rows whose bonds are left to chance" ~count:60 ~print
    Gen.(pair random_rows (list_size (pure 60) nat))
    (fun (c, choices) -> follow (network c) choices)

(* {1 Growth} *)

(* n² cubes on the floor of a room, half a side apart, that are kicked twice, some of them down: what a transition
   allocates, in words, and the queries of the broad phase for it. All of a kick is counted: draws, sweeps, and
   bounces until time passes. *)
let costs n =
  let places = List.concat (List.init n (fun x -> List.init n (fun y -> (x, y, 0)))) in
  let crowd =
    {
      places; pitch = 3; around = Room; slack = 1; laws = [ 4; 3; 4 ]; sticky = false; steady = true;
      together = false; any_time = false; half = false; lots = []; split_step = (1, 1);
      rows = [];
    }
  in
  let m, declared = network crowd in
  let c = Standard.of_model m in
  let state = match Network.initial c declared with Ok s -> s | Error _ -> Alcotest.fail "constant laws" in
  let run = Event_run.start c state in
  let random = ref 1 in
  let next () =
    random := ((!random * 1103515245) + 12345) land 0x3fffffff;
    !random / 1024
  in
  let taken = ref 0 and bounces = ref 0 and before = Gc.minor_words () in
  while Rat.compare (Event_run.elapsed run) (Rat.of_int 2) < 0 do
    let a = Event_run.take run (next () mod Event_run.count run) in
    (match a.label with Bounce _ -> incr bounces | _ -> ());
    incr taken
  done;
  let { Flights.sweeps; neighbours; casts } = Event_run.work run in
  if !bounces < n * n then Alcotest.failf "%d bounces of %d cubes: too few to count" !bounces (n * n);
  let each x = float_of_int x /. float_of_int !taken in
  ((Gc.minor_words () -. before) /. float_of_int !taken, each (sweeps + neighbours + casts))

let growth () =
  let words, queries = costs 10 and more_words, more_queries = costs 20 in
  let stays what few many =
    if many > 1.4 *. few then Alcotest.failf "%s for a transition: %.1f of 100 cubes, %.1f of 400" what few many
  in
  stays "words" words more_words;
  stays "queries" queries more_queries

(* {1 Laws that have too many values together}

   101 kicks each, no two sums of which are equal: one cube alone may draw, two of them that are bound as well, and
   three of them never. Whether they may be bound is up to a weak choice: the rules decide what is reported. *)
let too_many () =
  let law scale = Law.Choose (List.init 101 (fun k -> kick 1 (1 + (scale * k), 0, 0))) in
  let bodies =
    let open Fixture in
    [
      body "p" (0, 0, 0) ~law:(law 1) ~behaviour:(open_ "a" [ "right" ] nil);
      body "q" (4, 0, 0) ~law:(law 101) ~behaviour:(co_open "a" [ "left" ] (co_open "b" [ "right" ] nil));
      body "r" (16, 0, 0) ~law:(law 10201) ~behaviour:(open_ "b" [ "left" ] nil);
    ]
  in
  let m = Fixture.model bodies in
  let plain = Semantics.make m in
  let rec go run s step =
    match (Network.successors plain s, Run.labels run) with
    | Error f, Error g ->
      let text f = (Transition.diagnostic m f).Scc_base.Diag.message in
      Alcotest.(check string) "the fault" (text f) (text g);
      step
    | Ok transitions, Ok labels ->
      let expected = List.map (fun (t : Transition.t) -> Transition.label_to_string m t.label) transitions in
      let found = List.map (Transition.label_to_string m) (Run.list labels) in
      Alcotest.(check (list string)) "what is possible" expected found;
      (* p is the fastest *)
      let last = List.length transitions - 1 in
      let i = match (List.hd transitions).label with Draw { first = 0; _ } -> last | _ -> 0 in
      ignore (Run.take run i);
      go run (List.nth transitions i).target (step + 1)
    | Ok _, Error _ | Error _, Ok _ -> Alcotest.failf "a fault in one of both, at step %d" step
  in
  let run = Result.get_ok (Run.start (Standard.of_model m) (Fixture.declared bodies)) in
  let steps = go run (Result.get_ok (Network.initial plain (Fixture.declared bodies))) 0 in
  Alcotest.(check bool) "they meet first" true (steps > 4)

(* A pair is run into, by one that binds to it, at the instant at which the lot of its bond is drawn. What comes of
   the collision has been found before, as no walker may stop, and is found anew. *)
let run_into () =
  let open Fixture in
  let lot = Behaviour.weak ~odds:(Chance (ratio 1 2)) (channel "a" [ "right" ]) nil in
  let bodies =
    [
      body "p" (0, 0, 0) ~behaviour:(lot + open_ "b" [ "left" ] nil);
      body "q" (2, 0, 0) ~behaviour:(weak "a" [ "left" ] nil);
      body "r" (-3, 0, 0) ~velocity:(1, 0, 0) ~behaviour:(co_open "b" [ "right" ] nil);
    ]
  in
  let m = { (model bodies) with lots = true; blocked = Stop } in
  let s = bound [ 2 ] (declared bodies) in
  let agree choices = Alcotest.(check bool) "as the relation" true (follow (m, s) choices) in
  agree [ 0; 0; 0; 0; 0 ];
  agree [ 0; 1; 0; 0; 0 ]

let suite =
  ( "crowds",
    [
      ("as the transition relation", Scc_test_support.Property.cases [ crowds; rows ]);
      ( "known",
        [
          Alcotest.test_case "growth: a transition costs as much in a crowd of 400 as of 100" `Quick growth;
          Alcotest.test_case "a lot of one that is run into" `Quick run_into;
          Alcotest.test_case "laws with too many values together" `Quick too_many;
        ] );
    ] )
