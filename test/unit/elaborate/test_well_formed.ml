(* Rule WellFormed: each fault of a state is found, and no other. *)

open Scc_exact
open Scc_geometry
open Scc_broad_phase
open Scc_calculus
open Models

let standard = Scc_engine.Standard.of_model

let text =
  cube
  ^ "behaviour K = omega(a, {right, left}). nil\n\
     process p = Cube mass 1 [K] process q = Cube mass 1 at translate (2,0,0) [K] bond <a, {p.right, q.left}>\n\
     process r = Cube mass 1 at translate (0,9,0) [nil] fixed w = Cube at translate (0,-9,0)\n\
     split_step 1/2"

let p = 0
and q = 1
and r = 2
and w = 3

let found ?(model = (accept text).model) state =
  List.map (Well_formed.to_string model state) (Well_formed.check (standard model) state)

let strings = Alcotest.(list string)

let at leaf position =
  { State.leaf; position; turned = Quaternion.identity; waited = Rat.zero;
    behaviour = Behaviour.fresh Behaviour.nil }

(* The declared state with its one split clock set, and its processes by a change of each. *)
let processes () = Array.to_list (accept text).declared.processes

let clocked clock (x : State.process) =
  State.process ~leaves:(Array.to_list x.leaves) ~bonds:(Array.to_list x.bonds) ~velocity:x.velocity ~clock ()

let state processes = State.make ~processes ~step:None ~time:None

let sound () =
  match processes () with
  | pq :: rest -> (clocked (Some Rat.zero) pq, rest)
  | [] -> Alcotest.fail "processes were expected"

let nothing () =
  let pq, rest = sound () in
  Alcotest.(check strings) "sound" [] (found (state (pq :: rest)))

let leaves () =
  let pq, rest = sound () in
  Alcotest.(check strings) "lost" [ "`r` is in no process"; "`w` is in no process" ] (found (state [ pq ]));
  let twice = State.process ~leaves:[ at r (Vec.of_ints 50 0 0) ] ~bonds:[] ~velocity:Vec.zero ~clock:None () in
  Alcotest.(check strings) "twice" [ "`r` is there more than once" ] (found (state (pq :: twice :: rest)))

let alone ?(velocity = Vec.zero) leaf position =
  State.process ~leaves:[ at leaf position ] ~bonds:[] ~velocity ~clock:None ()

let overlaps () =
  let pq, _ = sound () in
  let near = alone r (Vec.make Rat.zero (Rat.make Z.one (Z.of_int 2)) Rat.zero) in
  let all = state [ pq; near; alone w (Vec.of_ints 0 (-9) 0) ] in
  Alcotest.(check strings) "two bodies" [ "`p` and `r` interpenetrate" ] (found all);
  let flush = state [ pq; alone r (Vec.of_ints 0 2 0); alone w (Vec.of_ints 0 (-9) 0) ] in
  Alcotest.(check strings) "touching is no overlap" [] (found flush)

let walls () =
  let pq, _ = sound () in
  let moving = alone ~velocity:(Vec.of_ints 0 0 1) w (Vec.of_ints 0 (-9) 0) in
  let moves = "the process of `w` holds a fixed body and moves" in
  let with_wall wall = found (state [ pq; alone r (Vec.of_ints 0 9 0); wall ]) in
  Alcotest.(check strings) "moving" [ moves ] (with_wall moving);
  let spin = Vec.of_ints 0 0 1 in
  let spinning = State.with_turn ~spin ~since:Rat.zero ~lasts:None (alone w (Vec.of_ints 0 (-9) 0)) in
  Alcotest.(check strings) "spinning" [ moves; "the process of `w` turns as it cannot" ] (with_wall spinning)

let absorbers () =
  let pq, rest = sound () in
  let m = (accept text).model in
  let absorbs i (l : Model.leaf) = { l with absorbs = i = q } in
  Alcotest.(check strings) "bound" [ "in the process of `p` an absorbing body is bound" ]
    (found ~model:{ m with leaves = Array.mapi absorbs m.leaves } (state (pq :: rest)))

let bond one two = State.bond "a" { State.at = p; site = one } { State.at = q; site = two }
let face k = { Site.part = 0; feature = Feature.Face k }

(* Faces 2 and 3 are left and right. *)
let bonds () =
  let _, rest = sound () in
  let joined position bond =
    state (State.process ~leaves:[ at p Vec.zero; at q position ] ~bonds:[ bond ] ~velocity:Vec.zero
             ~clock:None () :: rest)
  in
  let beside = Vec.of_ints 2 0 0 in
  Alcotest.(check strings) "sound" [] (found (joined beside (bond (face 3) (face 2))));
  Alcotest.(check strings) "other features" [ "the features of the bond <a, {p.top, q.left}> do not touch" ]
    (found (joined beside (bond (face 1) (face 2))));
  Alcotest.(check strings) "apart" [ "the features of the bond <a, {p.right, q.left}> do not touch" ]
    (found (joined (Vec.of_ints 3 0 0) (bond (face 3) (face 2))));
  Alcotest.(check strings) "interpenetrating"
    [ "`p` and `q` interpenetrate"; "the features of the bond <a, {p.right, q.left}> do not touch" ]
    (found (joined (Vec.of_ints 1 0 0) (bond (face 3) (face 2))));
  Alcotest.(check strings) "no such feature" [ "a bond `a` between `p` and `q` names what is not there" ]
    (found (joined beside (bond (face 6) (face 2))));
  Alcotest.(check strings) "no such part" [ "a bond `a` between `p` and `q` names what is not there" ]
    (found (joined beside (bond { (face 3) with part = 1 } (face 2))))

let trees () =
  let _, rest = sound () in
  let walls = List.filter (fun (x : State.process) -> x.leaves.(0).leaf = w) rest in
  let twice = bond (face 3) (face 2) in
  let leaves = [ at p Vec.zero; at q (Vec.of_ints 2 0 0); at r (Vec.of_ints 0 9 0) ] in
  let cyclic = State.process ~leaves ~bonds:[ twice; twice ] ~velocity:Vec.zero ~clock:None () in
  Alcotest.(check strings) "a cycle and a piece apart" [ "the bonds of the process of `p` are not a tree" ]
    (found (state (cyclic :: walls)))

let clocks () =
  let pq, rest = sound () in
  let bad = [ "the split clock of the process of `p` is wrong" ] in
  let with_clock c = found (state (clocked c pq :: rest)) in
  Alcotest.(check strings) "none where a split is enabled" bad (with_clock None);
  Alcotest.(check strings) "not below the split step" bad (with_clock (Some (Rat.make Z.one (Z.of_int 2))));
  Alcotest.(check strings) "within" [] (with_clock (Some (Rat.make Z.one (Z.of_int 3))));
  let idle = List.map (clocked (Some Rat.zero)) rest in
  Alcotest.(check strings) "where none is enabled"
    [ "the split clock of the process of `r` is wrong"; "the split clock of the process of `w` is wrong" ]
    (found (state (pq :: idle)))

let steps () =
  let t = accept (cube ^ "process p = Cube mass 1 [nil] motion (vx + time, 0, 0) timestep 1/2") in
  let with_step step time =
    found ~model:t.model (State.make ~processes:(Array.to_list t.declared.processes) ~step ~time)
  in
  let half = Rat.make Z.one (Z.of_int 2) in
  let step remaining phase = Some { State.remaining; phase } in
  let bad = [ "the movement step is wrong" ] in
  Alcotest.(check strings) "sound" [] (with_step (step half State.Steered) (Some Rat.zero));
  Alcotest.(check strings) "due" [] (with_step (step Rat.zero State.Due) (Some Rat.one));
  Alcotest.(check strings) "none" bad (with_step None (Some Rat.zero));
  Alcotest.(check strings) "too long" bad (with_step (step Rat.one State.Moving) (Some Rat.zero));
  Alcotest.(check strings) "over but not due" bad (with_step (step Rat.zero State.Moving) (Some Rat.zero));
  Alcotest.(check strings) "no time" [ "the time is wrong" ] (with_step (step half State.Moving) None);
  let pq, rest = sound () in
  Alcotest.(check strings) "a time that nothing needs" [ "the time is wrong" ]
    (found (State.make ~processes:(pq :: rest) ~step:None ~time:(Some Rat.zero)))

(* {1 Overlaps of random bodies, against every pair} *)

let solids =
  let t =
    accept
      (cube
       ^ "shape Tetra { vertices a (1,1,1) b (1,-1,-1) c (-1,1,-1) d (-1,-1,1) \
          faces x [b,d,c] y [a,c,d] z [a,d,b] w [a,b,c] }\n\
          process p = Cube mass 1 [nil] \
          process q = Cube mass 1 at translate (9,0,0) * rotate quaternion (2,1,0,0) [nil]\n\
          process r = Tetra mass 1 at translate (0,9,0) [nil] \
          process s = Tetra scaled (1,2,1/3) mass 1 at translate (20,9,0) [nil]")
  in
  (Scc_broad_phase.Obstacle_cache.create (), Array.map (fun (l : Model.leaf) -> l.parts.(0).solid) t.model.leaves)

let placed =
  let open QCheck2.Gen in
  let coordinate = map (fun k -> Rat.make (Z.of_int k) (Z.of_int 2)) (int_range (-6) 6) in
  let body = map3 (fun body kind (x, y, z) -> (body, kind, Vec.make x y z)) (int_range 0 9) (int_range 0 3) in
  let one = body (triple coordinate coordinate coordinate) in
  map
    (List.map (fun (body, kind, position) -> { Overlap.body; solid = (snd solids).(kind); position }))
    (list_size (int_range 0 12) one)

let relation (a : Overlap.placed) (b : Overlap.placed) =
  Obstacle.relation (Obstacle_cache.find (fst solids) a.solid b.solid) (Vec.sub b.position a.position)

let interpenetrate a b =
  match relation a b with
  | Interpenetrating -> true
  | Touching | Apart -> false

let coincide (a : Overlap.placed) (b : Overlap.placed) =
  a.solid.Solid.id = b.solid.Solid.id && Vec.equal a.position b.position

(* Every pair, but for copies at one place, of which each is paired with the first only. *)
let naive bodies =
  let n = Array.length bodies in
  let first i = List.find (fun j -> coincide bodies.(i) bodies.(j)) (List.init n Fun.id) in
  List.concat_map (fun i -> List.init n (fun j -> (i, j))) (List.init n Fun.id)
  |> List.filter (fun (i, j) ->
      i < j
      && bodies.(i).Overlap.body <> bodies.(j).Overlap.body
      && interpenetrate bodies.(i) bodies.(j)
      && (first j = i || (first i = i && first j = j)))

let same_pair (i, j) (k, l) = Int.equal i k && Int.equal j l

let pairs_are_all_pairs =
  QCheck2.Test.make ~name:"overlapping pairs are those of a look at every pair" ~count:150 placed (fun list ->
      let bodies = Array.of_list list in
      List.equal same_pair (naive bodies) (Overlap.pairs (fst solids) bodies))

let a_limit_is_kept =
  QCheck2.Test.make ~name:"a limit gives some pairs iff there are some" ~count:150 placed (fun list ->
      let bodies = Array.of_list list in
      let all = Overlap.pairs (fst solids) bodies and few = Overlap.pairs ~limit:2 (fst solids) bodies in
      List.length few = min 2 (List.length all))

let points_are_inside =
  QCheck2.Test.make ~name:"a common point is given iff two solids interpenetrate" ~count:250
    QCheck2.Gen.(pair placed placed)
    (fun (l, m) ->
       List.for_all
         (fun a ->
            List.for_all (fun b -> Bool.equal (interpenetrate a b) (Option.is_some (Overlap.common_point a b))) m)
         l)

let case name run = Alcotest.test_case name `Quick run

let suite =
  ("well-formed",
   [
     ( "states",
       [
         case "sound" nothing;
         case "leaves" leaves;
         case "overlaps" overlaps;
         case "walls" walls;
         case "absorbers" absorbers;
         case "bonds" bonds;
         case "trees" trees;
         case "clocks" clocks;
         case "steps" steps;
       ] );
     ("overlaps", Scc_test_support.Property.cases [ pairs_are_all_pairs; a_limit_is_kept; points_are_inside ]);
   ])
