(* Explorations that end early because of many draws know as much as those that go on up to the bound. *)

open Scc_semantics
open Scc_verify
open Scc_test_models

let pick random list = List.nth list (Random.State.int random (List.length list))

(* Bodies far apart or side by side, that draw among some velocities, in one of the ways to be blocked. Places may
   be congruent, and laws may have one velocity. *)
let model random =
  let count = pick random [ 12; 16; 20; 24; 30; 40; 70; 75; 80 ] in
  let apart = pick random [ 2; 2; 3; 40 ] in
  let wide = pick random [ 1; 3; 5; 100 ] in
  let body i =
    Printf.sprintf "process w[%d] = box(1,1,1) mass 1 at translate (%d, %d, 0) [nil]\n" i (apart * (i mod wide))
      (apart * (i / wide))
  in
  let velocities = [ "(1,0,0)"; "(-1,0,0)"; "(0,1,0)"; "(0,-1,0)"; "(0,0,0)"; "(2,0,0)" ] in
  let law () =
    let few = pick random [ 1; 2; 3; 4; 4; 5; 6 ] in
    String.concat ", " (List.filteri (fun i _ -> i < few) velocities)
  in
  let common = law () in
  let each i =
    if Random.State.int random 4 = 0 then Printf.sprintf "motion w[%d] = choose { %s }\n" i (law ()) else ""
  in
  let goal =
    pick random
      [ "exists p in w: x(p) > 3"; "exists p in w: x(p) >= 0"; "exists p in w: vx(p) > 0"; "x(w[0]) > 1";
        "exists p in w: y(p) < -1"; "forall p in w: x(p) < 100"; "exists p in w: gone(p)";
        "distance2(w[0], w[1]) < 4" ]
  in
  let check =
    match Random.State.int random 7 with
    | 0 ->
      let number = pick random [ "x(w[0])"; "count(p in w: x(p) > 1)" ] in
      Printf.sprintf "E = ? [ %s at %s ]" number (pick random [ "0"; "1" ])
    | 1 -> Printf.sprintf "E = ? [ time U (%s) ]" goal
    | 2 -> Printf.sprintf "always not (%s)" goal
    | 3 -> "P = ? [ eventually event bounce within 2 ]"
    | _ -> Printf.sprintf "P = ? [ eventually (%s) within %s ]" goal (pick random [ "0"; "1/2"; "2" ])
  in
  Printf.sprintf "timestep 1 steady\n%s%s%smotion choose { %s }\n%scheck c : %s\n"
    (pick random [ ""; ""; "blocked wait\n"; "blocked stop\n" ])
    (pick random [ ""; "collisions drawn\n" ])
    (String.concat "" (List.init count body))
    common
    (String.concat "" (List.init count each))
    check

let run (e : Scc_elaborate.Elaborate.t) options =
  let semantics = Scc_engine.Standard.of_model e.model in
  match Network.initial semantics e.declared with
  | Error _ -> Alcotest.fail "no initial state"
  | Ok initial -> Check.run options semantics ~initial e.checks

(* What it says, but for the bound and what is left. *)
let known (report : Check.report) =
  match (List.hd report.outcomes).verdict with
  | Holds { bounds; _ } -> if bounds = [] then "holds" else "holds up to a bound"
  | Violated _ -> "violated"
  | Measured { values; _ } -> Scc_explain.Likelihoods.values values
  | Depends _ -> "depends"
  | Undecided _ -> "undecided"

let is_ahead (report : Check.report) =
  let of_draws (t : Verdict.truncation) = match t.limit with Draws _ -> true | _ -> false in
  List.exists of_draws report.stats.stopped_by

let tried = ref 0
let ended = ref 0

(* A bound of depth that nothing meets makes it explore all the same. *)
let try_model ~reductions number =
  let random = Random.State.make [| 7; number |] in
  let text = model random in
  match Load.text text with
  | Error faults ->
    let messages = List.map (fun (d : Scc_base.Diag.t) -> d.message) faults in
    Alcotest.failf "%s\n%s" (String.concat "\n" messages) text
  | Ok e ->
    let states = pick random [ 1100; 2000; 4000 ] in
    let options = { Setup.default with bounds = { Bounds.default with states = Given states }; reductions } in
    let early = run e options in
    incr tried;
    if is_ahead early then begin
      incr ended;
      let full = run e { options with bounds = { options.bounds with depth = Given 1_000_000 } } in
      let what = Printf.sprintf "model %d\n%s" number text in
      Alcotest.(check string) what (known full) (known early);
      Alcotest.(check bool) ("few states: " ^ what) true (early.stats.states <= 1024);
      Alcotest.(check bool) ("the bound is met: " ^ what) true (full.stats.states > 1024);
      let time = Option.fold ~none:"none" ~some:Scc_exact.Rat.to_string in
      Alcotest.(check string) ("no time has passed: " ^ what) "0" (time full.stats.model_time)
    end

let count = try int_of_string (Sys.getenv "DRAWS_AHEAD") with Not_found -> 40

let random () =
  List.iter (fun k -> try_model ~reductions:Scc_state_space.Reduction.all k) (List.init count Fun.id);
  List.iter (fun k -> try_model ~reductions:[] (k + 1_000_000)) (List.init count Fun.id);
  Printf.printf "%d of %d explorations ended early\n" !ended !tried;
  if 8 * !ended < !tried then Alcotest.fail "too few explorations ended early"

let suite =
  ( "draws ahead",
    [ ("many draws", [ Alcotest.test_case "as much is known as at the bound" `Quick random ]) ] )
