(* Slices of networks whose bodies draw their velocities, against whole networks: the same verdicts and the same
   exact numbers, with runs of the whole. *)

open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_property
open Scc_evaluate
open Scc_state_space
open Scc_explain
open Scc_verify
module Gen = QCheck2.Gen

let standard = Scc_engine.Standard.of_model

(* {1 Random walkers} *)

let shapes =
  {|
split_step 1
shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]  right [b,c,g,f]  front [a,b,f,e]  back [d,h,g,c]
}
behaviour Shy    = nil
behaviour Right  = <dock, {right}>. Held
behaviour Left   = <~dock, {left}>. Held
behaviour Held   = omega(dock, {left, right}). Shy
behaviour Late   = eps(1/2). Left
|}

(* Of the laws of a model: all leave velocities to chance, or none, or some of them. *)
let laws =
  let open Gen in
  let kicks = [ "(1,0,0), (-1,0,0)"; "(0,0,0) weight 3, (2,0,0)"; "(1,0,0), (-3/2,0,0)" ] in
  let coin = map (Printf.sprintf "choose { %s }") (oneofl kicks)
  and certain = oneofl [ "(1,0,0)"; "(-1,0,0)" ] in
  let other = oneofl [ "choose { (vx,vy,vz), (0,0,0) }"; "(vx, vy + dt, vz)" ] in
  frequencyl [ (6, coin); (2, certain); (2, oneof [ coin; certain ]); (1, oneof [ coin; other ]) ]

let body_gen law =
  let open Gen in
  let* driven = frequencyl [ (3, true); (1, false) ] and* law = law in
  let* velocity = frequencyl [ (3, 0); (1, 1); (1, -1) ] and* mass = frequencyl [ (3, 1); (1, 4) ] in
  let* behaviour = frequencyl [ (3, "Shy"); (2, "Right"); (2, "Left"); (1, "Late") ] in
  let+ distance = frequencyl [ (2, 3); (2, 4); (2, 6); (3, 9); (3, 14) ]
  and+ pair = frequencyl [ (1, true); (5, false) ] in
  let moves name = if driven then Printf.sprintf "motion %s = %s\n" name law else "" in
  let single i x =
    Printf.sprintf "process p%d = Cube mass %d velocity (%d,0,0) at translate (%d,0,0) [%s]\n" i mass velocity x
      behaviour
    ^ moves (Printf.sprintf "p%d" i)
  and double i x =
    Printf.sprintf "process d%d = p%d : Cube mass 1 at translate (%d,0,0) [Held]\n" i i x
    ^ Printf.sprintf "<dock, {p%d.right, q%d.left}>\n" i i
    ^ Printf.sprintf "q%d : Cube mass %d at translate (%d,0,0) [Held]\n" i mass (x + 2)
    ^ moves (Printf.sprintf "d%d" i)
  in
  (distance, if pair then double else single)

(* One after the other along x, at these distances, to one side or the other. *)
let crowd_gen =
  let open Gen in
  let* law = laws and* n = frequencyl [ (3, 2); (3, 3); (1, 4) ] in
  let* bodies = list_repeat n (body_gen law) in
  let* steps = oneofl [ ""; " steady"; " local" ]
  and* wall = frequencyl [ (3, None); (1, Some ""); (1, Some " absorb") ] in
  let+ beyond = oneofl [ 3; 5; 8 ] and+ side = oneofl [ 1; -1 ] in
  let place (i, x, text) (distance, body) = (i + 1, x + 2 + distance, text ^ body i (side * x)) in
  let _, last, text = List.fold_left place (0, 0, "") bodies in
  let standing = Printf.sprintf "fixed wall = Cube%s at translate (%d,0,0)\n" in
  let wall = match wall with None -> "" | Some absorb -> standing absorb (side * (last - 2 + beyond)) in
  (n, Printf.sprintf "timestep 1%s\n%s%s%s" steps shapes text wall)

let predicate_gen n =
  let open Gen in
  let leaf = frequencyl ((4, 0) :: List.init n (fun i -> (1, i))) in
  let one =
    oneof
      [
        map2 (Printf.sprintf "x(p%d) > %d") leaf (-4 -- 8);
        map2 (Printf.sprintf "vx(p%d) > %d") leaf (-1 -- 1);
        map (Printf.sprintf "size(p%d) > 1") leaf;
        map2 (Printf.sprintf "same(p%d, p%d)") leaf leaf;
        map (Printf.sprintf "gone(p%d)") leaf;
        map (Printf.sprintf "event bounce(p%d)") leaf;
        map (Printf.sprintf "event split(dock, p%d)") leaf;
        map (Printf.sprintf "event bind(dock, p%d)") leaf;
      ]
  in
  let* p = one and* q = one in
  oneofl [ p; Printf.sprintf "(%s and %s)" p q; Printf.sprintf "(%s or not gone(p0) and %s)" p q; "not " ^ p ]

let check_gen n =
  let open Gen in
  let* p = predicate_gen n and* q = predicate_gen n and* h = oneofl [ "1"; "3/2"; "2"; "3" ] in
  let* m = oneofl [ "P"; "Pmin"; "Pmax" ] and* t = oneofl [ "0"; "1"; "3/2"; "2" ] in
  oneofl
    [
      Printf.sprintf "possibly (%s) within %s" p h;
      Printf.sprintf "always (%s) within %s" p h;
      Printf.sprintf "%s = ? [ eventually (%s) within %s ]" m p h;
      Printf.sprintf "%s = ? [ always (%s) within %s ]" m p h;
      Printf.sprintf "%s = ? [ eventually[1, 2] (%s) ]" m p;
      Printf.sprintf "%s = ? [ (%s) U[<= %s] (%s) ]" m p h q;
      Printf.sprintf "P >= 1/2 [ eventually (%s) within %s ]" p h;
      Printf.sprintf "not P <= 1/4 [ eventually (%s) within %s ] and possibly (%s) within %s" p h q t;
      Printf.sprintf "E = ? [ if gone(p0) then 0 else x(p0) at %s ]" t;
      Printf.sprintf "Emax = ? [ if gone(p0) then 0 else vx(p0) at %s ]" t;
      (* what is no business of slices *)
      Printf.sprintf "EF ((%s) and P >= 1 [ eventually[0, 0] (%s) ])" p q;
      Printf.sprintf "E = ? [ event bounce U time > %s ]" t;
    ]

let case_gen =
  let open Gen in
  let* n, text = crowd_gen in
  let+ checks = list_size (1 -- 3) (check_gen n) in
  text ^ String.concat "\n" (List.mapi (fun i c -> Printf.sprintf "check c%d : %s" i c) checks)

(* {1 The comparison} *)

type tally = { mutable sliced : int; mutable numbers : int; mutable searches : int; mutable runs : int }

let tally = { sliced = 0; numbers = 0; searches = 0; runs = 0 }
let bounds = { Bounds.default with states = Given 1500 }

let load text =
  match Scc_test_models.Load.text text with
  | Error _ -> None
  | Ok e -> Result.to_option (Result.map (fun s -> (e, s)) (Network.initial (standard e.model) e.declared))

let run reductions (e : Scc_elaborate.Elaborate.t) initial check =
  Check.run { Setup.default with bounds; reductions } (standard e.model) ~initial [ check ]

(* What is known for certain. *)
type known = Is of bool | Number of (Property.side * Scc_ctl.Eval.measured) list | Open

let known (v : Verdict.t) =
  match v with
  | Holds { bounds = []; _ } -> Is true
  | Violated _ -> Is false
  | Measured { reasons = []; values; _ } -> Number values
  | Holds _ | Measured _ | Depends _ | Undecided _ -> Open

let witness : Verdict.t -> Witness.t option = function
  | Holds { witness; _ } | Violated { witness } | Measured { witness; _ } -> witness
  | Depends _ | Undecided _ -> None

(* By the rules of the whole, at the times that it says. *)
let replays (e : Scc_elaborate.Elaborate.t) initial (w : Witness.t) =
  match Scc_test_networks.Reach.follow (standard e.model) initial (Witness.choices w) with
  | Error _ -> false
  | Ok transitions ->
    let last = match List.rev transitions with [] -> initial | t :: _ -> t.Transition.target in
    let time = List.fold_left (fun t s -> Rat.add t (Transition.duration s)) Rat.zero transitions in
    State.equal last w.last && Rat.equal time (Witness.time w)

let arrived (w : Witness.t) =
  match List.rev w.steps with
  | [] -> fun _ -> false
  | [ only ] -> Event.matches ~source:w.initial only.transition.label
  | last :: before :: _ -> Event.matches ~source:before.transition.target last.transition.label

(* What was searched for is so where the run ends. *)
let shows (e : Scc_elaborate.Elaborate.t) (check : Property.check) v (w : Witness.t) =
  match (w.finish, check.asked, Plan.of_formula check.formula) with
  | At_state, Whether, (Possibly (_, p) | Always (_, p)) -> (
      let there = Trajectory.make ~arrived:(arrived w) (standard e.model) w.last Instant in
      match ((Trajectory.prop there p).start, known v) with
      | Scc_ctl.Truth.True, Is true | False, Is false -> true
      | _ -> false)
  | _ -> true

let compare (e : Scc_elaborate.Elaborate.t) initial check =
  let part = run [ Reduction.Jump; Slice ] e initial check in
  if part.slices <> [] then begin
    tally.sliced <- tally.sliced + 1;
    let verdict (r : Check.report) = (List.hd r.outcomes).verdict in
    let of_part = verdict part and of_whole = verdict (run [ Reduction.Jump ] e initial check) in
    (match (known of_part, known of_whole) with
     | Open, _ | _, Open -> ()
     | Is a, Is b ->
       tally.searches <- tally.searches + 1;
       if not (Bool.equal a b) then QCheck2.Test.fail_reportf "slice: %b, whole: %b" a b
     | Number a, Number b ->
       tally.numbers <- tally.numbers + 1;
       if a <> b then
         QCheck2.Test.fail_reportf "slice: %s, whole: %s" (Likelihoods.values a) (Likelihoods.values b)
     | Is _, Number _ | Number _, Is _ -> QCheck2.Test.fail_report "a number and a truth");
    match witness of_part with
    | None -> ()
    | Some w ->
      tally.runs <- tally.runs + 1;
      if not (replays e initial w) then QCheck2.Test.fail_report "a run does not replay";
      if not (shows e check of_part w) then QCheck2.Test.fail_report "a run does not show what it should"
  end

let agrees text =
  match load text with
  | None -> true  (* where nobody docks, no formula may speak of it *)
  | Some (e, initial) -> List.iter (compare e initial) e.checks; true

let random = QCheck2.Test.make ~name:"Fragments: walkers" ~count:250 ~print:Fun.id case_gen agrees

let counts () =
  Printf.printf "%d slices, %d numbers and %d truths compared, %d runs\n" tally.sliced tally.numbers tally.searches
    tally.runs;
  let some what expected n = if n < expected then Alcotest.failf "only %d %s" n what in
  some "slices" 100 tally.sliced;
  some "numbers" 60 tally.numbers;
  some "truths" 30 tally.searches;
  some "runs" 20 tally.runs

(* {1 By hand} *)

let cube =
  let of_cube i _ = i >= 2 && i <= 6 in
  String.concat "\n" (List.filteri of_cube (String.split_on_char '\n' shapes)) ^ "\n"

let loaded text = match load (cube ^ text) with Some x -> x | None -> Alcotest.failf "it does not load: %s" text
let all_kept = [ "(no slice)" ]

let is what expected text =
  let e, initial = loaded text in
  let formulas = List.map (fun (c : Property.check) -> c.formula) e.checks in
  let left_out =
    match Slice.make (standard e.model) ~initial formulas with
    | None -> all_kept
    | Some slice -> Slice.left_out e.model ~initial slice
  in
  Alcotest.(check (list string)) what expected left_out

let body ?(mass = 1) ?(velocity = 0) name x y =
  Printf.sprintf "process %s = Cube mass %d velocity (%d,0,0) at translate (%d,%d,0) [nil]\n" name mass velocity
    x y

let coin name = Printf.sprintf "motion %s = choose { (1,0,0), (-1,0,0) }\n" name
let walker name x y = body name x y ^ coin name
let still_within h = Printf.sprintf "check a : always x(s) = 0 within %s\n" h

let how_far () =
  let scene = body "s" 0 0 ^ walker "w" 10 0 in
  is "a walker that is too far" [ "w" ] (scene ^ still_within "79/10");
  is "one that may come to touch" all_kept (scene ^ still_within "8");
  let scene = walker "s" 0 0 ^ walker "w" 10 0 in
  is "two that walk" [ "w" ] (scene ^ "check a : P = ? [ eventually x(s) > 3 within 39/10 ]");
  is "and may meet" all_kept (scene ^ "check a : P = ? [ eventually x(s) > 3 within 4 ]");
  is "a mean at a time" [ "w" ] (scene ^ "check a : E = ? [ x(s) at 39/10 ]");
  is "and later" all_kept (scene ^ "check a : E = ? [ x(s) at 4 ]");
  is "with all the time there is" all_kept (scene ^ "check a : P = ? [ eventually x(s) > 3 ]");
  is "one that flies" [ "b" ]
    (walker "s" 0 0 ^ body ~velocity:1 "b" (-20) 20 ^ "check a : possibly x(s) > 0 within 3");
  is "the fastest of its draws" all_kept
    (body "s" 0 0 ^ body "w" 10 0
     ^ "motion w = choose { (0,0,0) weight 1000, (0,4,0) weight 1/1000 }\n" ^ still_within "2");
  is "its law and nothing before" [ "w" ]
    (body "s" 0 0 ^ body ~velocity:(-9) "w" 10 0 ^ coin "w" ^ still_within "79/10")

let who_gains () =
  let company = walker "w" 0 0 ^ body "c" 4 0 in
  let far = body "s" 0 40 and asked = "check a : possibly x(c) > 20 within 3" in
  is "a body under no law takes energy at each collision" all_kept (company ^ far ^ asked);
  is "at each step that keeps its beat" [ "s" ] ("timestep 1 steady\n" ^ company ^ far ^ asked);
  is "four times until 3, three of it" all_kept
    ("timestep 1 steady\n" ^ company ^ body "s" 0 7 ^ "check a : possibly x(c) > 20 within 3");
  is "which is not enough for" [ "s" ]
    ("timestep 1 steady\n" ^ company ^ body "s" 0 9 ^ "check a : possibly x(c) > 20 within 3");
  let two = walker "w" 0 0 ^ walker "c" 4 0 in
  is "walkers among themselves do not" [ "s" ] (two ^ far ^ asked);
  is "but with steps of their own" all_kept ("timestep 1 local\n" ^ two ^ far ^ asked);
  is "unless they do not meet" [ "w" ]
    ("timestep 1 local\n" ^ walker "w" 0 0 ^ walker "s" 40 0 ^ "check a : possibly x(s) > 42 within 3")

let no_collisions () =
  let two = walker "w" 0 0 ^ walker "c" 4 0 ^ walker "s" 0 40 in
  is "whose collisions end a step of all" all_kept (two ^ still_within "1");
  is "or put it off" all_kept ("timestep 1 steady\n" ^ two ^ still_within "1");
  let walled x = Printf.sprintf "fixed wall = Cube at translate (%d,0,0)\n" x ^ walker "w" 0 0 ^ walker "s" 0 40 in
  is "a wall in reach" all_kept (walled 5 ^ still_within "3");
  is "and out of it" [ "wall"; "w" ] (walled 6 ^ still_within "3");
  is "a wall that the kept may reach" [ "s" ] (walled 5 ^ "check a : possibly x(w) > 1 within 3");
  let pair behaviour =
    Printf.sprintf
      "behaviour B on Cube = %s\n\
       process d = p : Cube mass 1 [B] <a, {p.right, q.left}> q : Cube mass 1 at translate (2,0,0) [B]\n"
      behaviour
    ^ coin "d" ^ walker "s" 0 40
  in
  is "a pair that holds" [ "p"; "q" ] (pair "<b, {top}>. nil" ^ still_within "3");
  is "pieces may meet" all_kept (pair "eps(2). omega(a, {left, right}). nil" ^ still_within "3");
  let chain =
    "process d = p : Cube mass 1 [nil] <a, {p.right, q.left}>\n\
     q : Cube mass 1 at translate (2,0,0) [nil] <a, {q.right, r.left}>\n\
     r : Cube mass 1 at translate (4,0,0) [nil]\n"
  and kicks n = Printf.sprintf "motion d = choose { for i in 1..%d: (i / 1000, 0, 0) }\n" n in
  is "as many draws as may be" [ "p"; "q"; "r" ] (chain ^ kicks 100 ^ walker "s" 0 40 ^ still_within "3");
  is "more than may be drawn together" all_kept (chain ^ kicks 101 ^ walker "s" 0 40 ^ still_within "3")

let which_laws () =
  let with_law law = body "s" 0 0 ^ body ~mass:2 "w" 50 0 ^ "motion w = " ^ law ^ "\n" ^ still_within "3" in
  is "constant" [ "w" ] (with_law "(1,2,3)");
  is "by the mass" [ "w" ] (with_law "(1/mass,0,0)");
  is "diffusion with a drift" [ "w" ] (with_law "diffuse(1/8, (1,0,0))");
  List.iter
    (fun law -> is law all_kept (with_law law))
    [ "(vx,0,0)"; "(0,y,0)"; "(time,0,0)"; "(0,0,dt)"; "choose { (1,0,0) weight x, (0,0,0) }" ];
  is "of which one draws, and one does not" all_kept
    (body "s" 0 0 ^ "motion s = (1,0,0)\n" ^ walker "w" 50 0 ^ still_within "3")

let which_formulas () =
  let scene = walker "s" 0 0 ^ walker "w" 50 0 in
  let inside f = is f [ "w" ] (scene ^ "check a : " ^ f) in
  let outside f = is f all_kept (scene ^ "check a : " ^ f) in
  List.iter inside
    [
      "Pmin = ? [ eventually x(s) > 1 within 2 ]"; "P >= 1/3 [ always x(s) < 1 within 2 ]";
      "P = ? [ x(s) < 1 U[1, 2] event bounce(s) ]"; "not P > 1/2 [ eventually x(s) > 1 within 2 ]";
      "P >= 1/3 [ always x(s) < 1 within 2 ] or possibly x(s) > 4 within 3";
      "P = ? [ always not event bounce(s) within 2 ]";
    ];
  List.iter outside
    [
      "P >= 1/3 [ eventually P >= 1/3 [ eventually x(s) > 1 within 1 ] within 2 ]";
      "E = ? [ event bounce(s) U x(s) > 1 ]";
      "P = ? [ event bounce(s) U[<= 2] x(s) > 1 ]";
      "P = ? [ eventually not event bounce(s) and x(s) > 1 within 2 ]";
      "P = ? [ eventually energy > 1 and x(s) > 1 within 2 ]"; "P = ? [ eventually event bounce within 2 ]";
      "AF[0, 2] x(s) > 1";
    ]

(* A body that is let go at the start, after the step of all has begun: it rests until that is over, though nobody
   that is kept was asked when it began. *)
let when_steps_begin () =
  let e, initial =
    loaded
      ("behaviour Let on Cube = rho({<a, {left, right}>}). nil\n"
       ^ "fixed f = Cube [Let]\n"
       ^ "process p = Cube mass 1 at translate (2,0,0) [Let]\nbond <a, {f.right, p.left}>\n"
       ^ "motion p = choose { (1,0,0), (2,0,0) }\n" ^ walker "w" 50 0 ^ "check a : always vx(p) = 0 within 1/2")
  in
  let report = run [ Reduction.Jump; Slice ] e initial (List.hd e.checks) in
  Alcotest.(check (list (list string)))
    "the walker is left out" [ [ "w" ] ]
    (List.map (fun (s : Check.slice) -> s.left_out) report.slices);
  Alcotest.(check bool) "it rests" true (known (List.hd report.outcomes).verdict = Is true);
  compare e initial (List.hd e.checks)

(* {1 What it costs} *)

(* Walkers on a grid, 20 from each other, each with checks of its own, and two of them with one. *)
let grid n =
  let side = if n > 8 then 3 else 2 in
  let each make = String.concat "\n" (List.init n make) ^ "\n" in
  each (fun i ->
      Printf.sprintf "process w[%d] = Cube mass 1 at translate (%d,%d,%d) [nil]" i
        (20 * (i mod side))
        (20 * (i / side mod side))
        (20 * (i / (side * side))))
  ^ "motion diffuse(1/8)\n"
  ^ each (fun i ->
      let x = 20 * (i mod side) in
      Printf.sprintf
        "check p%d : P = ? [ eventually x(w[%d]) > %d within 2 ]\ncheck e%d : E = ? [ x(w[%d]) at 2 ]\n\
         check s%d : possibly x(w[%d]) >= %d within 2"
        i i (x + 1) i i i i (x + 2))

let together = "check t : possibly same(w[0], w[1]) within 1\n"

let cost text =
  let e, initial = loaded text in
  let report = Check.run Setup.default (standard e.model) ~initial e.checks in
  let is_known (o : Verdict.outcome) = match known o.verdict with Open -> false | Is _ | Number _ -> true in
  if not (List.for_all is_known report.outcomes) then Alcotest.fail "some check is open";
  report.stats.transitions

let linear () =
  let one = cost (grid 1) in
  Alcotest.(check int) "eight cost eight times as much as one" (8 * one) (cost (grid 8));
  Alcotest.(check int) "twenty-seven, twenty-seven times" (27 * one) (cost (grid 27));
  let two = cost (grid 2 ^ together) - (2 * one) in
  Alcotest.(check int) "two of them as much in any company" ((8 * one) + two) (cost (grid 8 ^ together))

let () =
  let case name f = Alcotest.test_case name `Quick f in
  Alcotest.run "walkers"
    [
      ("random", [ Scc_test_support.Property.case random; Alcotest.test_case "counts" `Quick counts ]);
      ( "by hand",
        [
          case "how far walkers get" how_far; case "who gains energy" who_gains;
          case "only without collisions" no_collisions; case "which laws" which_laws;
          case "which formulas" which_formulas; case "when steps begin" when_steps_begin;
        ] );
      ("cost", [ case "grows with their number" linear ]);
    ]
