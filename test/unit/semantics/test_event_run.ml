(* Runs from event to event against the transition relation, step by step. *)

open Scc_exact
open Scc_geometry
open Scc_calculus
open Scc_semantics
open Scc_engine
open Scc_test_networks

let standard = Scc_engine.Standard.of_model
module Gen = QCheck2.Gen

let label_and_rules m label rules =
  Transition.label_to_string m label ^ " by " ^ String.concat ", " (List.map Rule.id rules)

let of_transition m (t : Transition.t) = label_and_rules m t.label t.rules
let of_alternative m (a : Event_run.alternative) = label_and_rules m a.label a.rules
let offered m run = List.init (Event_run.count run) (fun i -> Transition.label_to_string m (Event_run.label run i))
let label m (t : Transition.t) = Transition.label_to_string m t.label

(* What has changed, put together, is the state: each process as it came, and moved on since. *)
module Told = Map.Make (Int)

let first (p : State.process) = p.leaves.(0).leaf

let told_after now told (c : Event_run.changes) =
  let drop told leaf = if Told.mem leaf told then Told.remove leaf told else Told.add (-1 - leaf) None told in
  let come told p = Told.add (first p) (Some (p, now)) told in
  List.fold_left come (List.fold_left drop told c.gone) c.come

let same_as_told m now told (s : State.t) =
  let same (p : State.process) =
    match Told.find_opt (first p) told with
    | Some (Some (q, since)) ->
      let moved = Turn.pass m (Rat.sub now since) q in
      State.equal_process (State.with_clock None p) (State.with_clock None moved)
    | Some None | None -> false
  in
  Told.cardinal told = Array.length s.processes && Array.for_all same s.processes

(* Follows both for some steps: the same alternatives in the same order, and the same states. [looks] says before
   which steps to look at the state, since looking must not matter. *)
let follow m s choices ~looks =
  let run = Event_run.start (standard m) s in
  let start = { Event_run.gone = []; come = Array.to_list s.processes } in
  let told = ref (told_after Rat.zero Told.empty start) in
  let rec from step elapsed s = function
    | [] -> true
    | choice :: choices ->
      let transitions = Reach.successors m s in
      let expected = List.map (label m) transitions in
      let offered = offered m run in
      if not (List.equal String.equal expected offered) then
        QCheck2.Test.fail_reportf "step %d: %s\nbut from event to event: %s" step (String.concat "; " expected)
          (String.concat "; " offered)
      else if looks step && not (State.equal s (Event_run.state run)) then
        QCheck2.Test.fail_reportf "step %d: another state" step
      else if not (Rat.equal elapsed (Event_run.elapsed run)) then
        QCheck2.Test.fail_reportf "step %d: another time" step
      else if
        looks step
        && begin
          told := told_after elapsed !told (Event_run.changes run);
          not (same_as_told m elapsed !told s)
        end
      then QCheck2.Test.fail_reportf "step %d: other changes" step
      else
        match transitions with
        | [] -> true
        | _ :: _ ->
          let i = choice mod List.length transitions in
          let t = List.nth transitions i in
          let taken = of_alternative m (Event_run.take run i) in
          if not (String.equal taken (of_transition m t)) then
            QCheck2.Test.fail_reportf "step %d: %s\nbut from event to event: %s" step (of_transition m t) taken;
          from (step + 1) (Rat.add elapsed (Transition.duration t)) t.target choices
  in
  from 0 Rat.zero s choices

let choices length = Gen.list_size (Gen.pure length) Gen.nat
let print (network, choices) =
  Random_network.print network ^ "\nchoices " ^ String.concat " " (List.map string_of_int choices)

let property name ~count ~steps networks adapt ~looks =
  QCheck2.Test.make ~name ~count ~print (Gen.pair networks (choices steps)) (fun (network, choices) ->
      let m, s = Random_network.start (adapt network) in
      follow m s choices ~looks)

(* Three that collide at once are resolved as one, in the same order (reading I-32). *)
let together =
  QCheck2.Test.make ~name:"collisions together" ~count:150 ~print
    (Gen.pair (Random_network.generate ()) (choices 40))
    (fun (network, choices) ->
       let m, s = Random_network.start network in
       follow { m with Model.collisions = Together } s choices ~looks:(fun _ -> true))

(* Leaves of one process that bind to each other, while others collide (reading I-37). *)
let rings =
  QCheck2.Test.make ~name:"bonds that close rings" ~count:150 ~print
    (Gen.pair Random_network.linked (choices 40))
    (fun (network, choices) ->
       let m, s = Random_network.start network in
       follow m s choices ~looks:(fun _ -> true))

(* Bonds may be released at any time, and time may pass by less than it could (rule Time): two thirds of it, or 5/7
   where there is no end. *)
let any_time =
  QCheck2.Test.make ~name:"releases at any time" ~count:200 ~print
    (Gen.pair (Random_network.generate ()) (choices 40))
    (fun (network, choices) ->
       let m, s = Random_network.start network in
       let m = { m with Model.splits = Any_time } in
       let s =
         let restart p = State.with_clock (Option.map (fun _ -> Rat.zero) p.State.clock) p in
         State.make ~processes:(List.map restart (Array.to_list s.processes)) ~step:s.step ~time:s.time
       in
       let c = standard m in
       let run = Event_run.start c s in
       let part s =
         match Time.delay c s with
         | Some d -> Rat.mul d (Rat.make (Z.of_int 2) (Z.of_int 3))
         | None -> Rat.make (Z.of_int 5) (Z.of_int 7)
       in
       let same s = State.equal s (Event_run.state run) in
       let rec go s = function
         | [] -> true
         | choice :: rest -> (
             let transitions = Reach.successors m s in
             let n = List.length transitions in
             let offered = offered m run in
             List.equal String.equal (List.map (label m) transitions) offered
             &&
             match choice mod (n + 2) with
             | i when i < n ->
               let t = List.nth transitions i in
               let taken = of_alternative m (Event_run.take run i) in
               String.equal taken (of_transition m t) && same t.target && go t.target rest
             | _ -> (
                 let d = part s in
                 match (Network.wait c s d, Event_run.wait run d) with
                 | Ok (Some t), Some a ->
                   String.equal (of_transition m t) (of_alternative m a) && same t.target && go t.target rest
                 | Ok None, None -> same s && go s rest
                 | _ -> false))
       in
       go s choices)

let always _ = true
let seldom step = step mod 7 = 6

let small =
  property "small networks" ~count:300 ~steps:40 (Random_network.generate ()) Fun.id ~looks:always

let unseen =
  property "whether the states are looked at or not" ~count:100 ~steps:60 (Random_network.generate ()) Fun.id
    ~looks:seldom

let far_away =
  property "with bodies far away" ~count:30 ~steps:40 (Random_network.generate ())
    Random_network.with_bystanders ~looks:seldom

let crowds = property "crowds" ~count:75 ~steps:120 Random_network.crowd Fun.id ~looks:seldom

(* The run may start from any state, with split clocks at any time and in the midst of a passing of time. *)
let later =
  QCheck2.Test.make ~name:"from the midst of a run" ~count:100 ~print
    (Gen.pair (Random_network.generate ()) (choices 40))
    (fun (network, choices) ->
       let m, s = Random_network.start network in
       let rec advance n s =
         match List.rev (Reach.successors m s) with
         | { label = Time d; _ } :: _ when n = 0 ->
           Time.pass (standard m) (Rat.mul d (Rat.make Z.one (Z.of_int 3))) s
         | t :: _ when n > 0 -> advance (n - 1) t.target
         | _ -> s
       in
       follow m (advance 5 s) choices ~looks:always)

(* {1 A box of walls} *)

(* Cubes of side 2 inside walls, some of which are a thousand times as long. *)
let boxed ?(keeps_time = false) velocities =
  let side = 12 and slab = 1000 in
  let solid id x y z = Solid.make ~id Cube.polyhedron (Mat.diagonal (Vec.of_ints x y z)) in
  let cube = solid 0 1 1 1 in
  let leaf name solid fixed : Model.leaf =
    let part : Model.part =
      { name; template = "Cube"; solid; offset = Vec.zero; open_offset = None; mass = Rat.one }
    in
    { name; template = "Cube"; parts = [| part |]; fixed; absorbs = false; mass = Rat.one; law = Inertial;
      law_at = Scc_base.Span.none }
  in
  let body i (x, y, z) =
    let at = Vec.of_ints ((4 * (i mod 3)) - 4) ((4 * (i / 3 mod 3)) - 4) ((4 * (i / 9)) - 4) in
    (leaf (Printf.sprintf "p%d" i) cube false, at, Vec.make (Rat.make (Z.of_int x) (Z.of_int 7))
       (Rat.make (Z.of_int y) (Z.of_int 5)) (Rat.make (Z.of_int z) (Z.of_int 3)))
  in
  let wall k (id, x, y, z) sign =
    let out = side + slab in
    let along c = if k = c then sign * out else 0 in
    let leaf = leaf (Printf.sprintf "w%d%d" k sign) (solid id x y z) true in
    (leaf, Vec.of_ints (along 0) (along 1) (along 2), Vec.zero)
  in
  let walls =
    List.concat_map
      (fun (k, shape) -> [ wall k shape (-1); wall k shape 1 ])
      [ (0, (1, slab, side, side)); (1, (2, side, slab, side)); (2, (3, side, side, slab)) ]
  in
  let all = List.mapi body velocities @ walls in
  let m : Model.t =
    {
      leaves = Array.of_list (List.map (fun (l, _, _) -> l) all);
      definitions = [||];
      timestep = Rat.one;
      splits = Every Rat.one;
      ranges = [||];
      keeps_time;
      collisions = In_turn;
      binding = On_collision;
      bonds = Acyclic;
      blocked = Bounce;
      round_velocity = None;
      lots = false;
      rigid = None;
      steered = false;
      steps = Shared;
    }
  in
  let process i (_, position, velocity) =
    let behaviour = Behaviour.fresh Behaviour.nil in
    let leaf = { State.leaf = i; position; turned = Quaternion.identity; waited = Rat.zero; behaviour } in
    State.process ~leaves:[ leaf ] ~bonds:[] ~velocity ~clock:None ()
  in
  (m, Reach.initial m (State.make ~processes:(List.mapi process all) ~step:None ~time:None))

let in_a_box =
  let velocity = Gen.(triple (-4 -- 4) (-4 -- 4) (-4 -- 4)) in
  QCheck2.Test.make ~name:"a box with long walls" ~count:20
    Gen.(triple (list_size (1 -- 12) velocity) (choices 100) bool)
    (fun (velocities, choices, keeps_time) ->
       let m, s = boxed ~keeps_time velocities in
       follow m s choices ~looks:seldom)

let absolute_time () =
  let m, s = boxed ~keeps_time:true [ (7, 0, 0) ] in
  let run = Event_run.start (standard m) s in
  ignore (Event_run.take run 0);
  let time = (Event_run.state run).time in
  Alcotest.(check (option string)) "the wall at 12, from -4, by 1" (Some "15") (Option.map Rat.to_string time)

(* Those who fly apart are at rest after some sweeps, and the network is seen to be quiescent. *)
let apart () =
  let m, s = boxed [ (1, 2, 3); (3, 2, 1) ] in
  let without_walls = State.make ~processes:[ s.processes.(0); s.processes.(1) ] ~step:None ~time:None in
  let run = Event_run.start (standard m) without_walls in
  Alcotest.(check int) "nothing is possible" 0 (Event_run.count run);
  Alcotest.(check bool) "after few sweeps" true ((Event_run.work run).sweeps < 100)

(* An event costs the same whether a few or many others are somewhere else. *)
let local () =
  let casts count =
    let velocities = List.init count (fun i -> if i = 0 then (7, 0, 0) else (0, 0, 0)) in
    let m, s = boxed velocities in
    let far i (p : State.process) =
      if i = 0 || i >= count then p
      else State.map_leaves (fun l -> { l with position = Vec.of_ints (5000 + (10 * i)) 5000 5000 }) p
    in
    let s = State.make ~processes:(List.mapi far (Array.to_list s.processes)) ~step:None ~time:None in
    let run = Event_run.start (standard m) s in
    for _ = 1 to 100 do
      ignore (Event_run.take run 0)
    done;
    (Event_run.work run).casts
  in
  Alcotest.(check int) "casts" (casts 1) (casts 200)

(* At one instant a bonded pair may split, and a third body binds to it: what the pair alone could do is gone. *)
let splits_of_the_bound () =
  let open Fixture in
  let bodies =
    [
      body "p" (-2, 0, 0) ~velocity:(1, 0, 0) ~behaviour:(co_open "b" [ "right" ] nil);
      body "q" (0, 0, 0) ~behaviour:(open_ "b" [ "left" ] (weak "a" [ "right" ] nil) + weak "a" [ "right" ] nil);
      body "r" (2, 0, 0) ~behaviour:(weak "a" [ "left" ] nil);
    ]
  in
  let m = model bodies in
  let p, q, r =
    match List.mapi leaf bodies with [ p; q; r ] -> (p, q, r) | _ -> Alcotest.fail "three bodies"
  in
  let bond = State.bond "a" { at = 1; site = site "right" } { at = 2; site = site "left" } in
  let alone = State.process ~leaves:[ p ] ~bonds:[] ~velocity:(vec (1, 0, 0)) ~clock:None () in
  let pair = State.process ~leaves:[ q; r ] ~bonds:[ bond ] ~velocity:Vec.zero ~clock:None () in
  let s = start m (State.make ~processes:[ alone; pair ] ~step:None ~time:None) in
  check_labels "a choice" [ "weak(a, q.right, r.left)"; "bind(b, p.right, q.left)" ] m s;
  let agree choices = Alcotest.(check bool) "as the transition relation" true (follow m s choices ~looks:always) in
  agree [ 1; 0; 0; 0 ];
  agree [ 0; 0; 0; 0 ]

(* A fixed pair that is hit goes on as before, but for its split clock, which starts anew: what was to come at the
   instants of the old clock must not come. *)
let split_clock_of_the_fixed () =
  let open Fixture in
  let bodies =
    [
      body "p" (-4, 0, 0) ~velocity:(3, 0, 0) ~behaviour:nil;
      body "q" (0, 0, 0) ~fixed:true ~behaviour:(weak "a" [ "right" ] nil);
      body "r" (2, 0, 0) ~behaviour:(weak "a" [ "left" ] nil);
    ]
  in
  let m = model bodies in
  let p, q, r =
    match List.mapi leaf bodies with [ p; q; r ] -> (p, q, r) | _ -> Alcotest.fail "three bodies"
  in
  let bond = State.bond "a" { at = 1; site = site "right" } { at = 2; site = site "left" } in
  let alone = State.process ~leaves:[ p ] ~bonds:[] ~velocity:(vec (3, 0, 0)) ~clock:None () in
  let pair = State.process ~leaves:[ q; r ] ~bonds:[ bond ] ~velocity:Vec.zero ~clock:None () in
  let s = start m (State.make ~processes:[ alone; pair ] ~step:None ~time:None) in
  let wait = List.init 8 (fun _ -> 1) in
  Alcotest.(check bool) "as the transition relation" true (follow m s wait ~looks:always)

let suite =
  ("event run",
   [
     ( "known",
       [
         Alcotest.test_case "absolute time" `Quick absolute_time;
         Alcotest.test_case "splits of those who have been bound" `Quick splits_of_the_bound;
         Alcotest.test_case "split clocks of fixed bodies that are hit" `Quick split_clock_of_the_fixed;
         Alcotest.test_case "those who fly apart" `Quick apart;
         Alcotest.test_case "what is far away costs nothing" `Quick local;
       ] );
     ( "as the transition relation",
       Scc_test_support.Property.cases
         [ small; unseen; far_away; crowds; later; in_a_box; together; rings; any_time ] );
   ])
