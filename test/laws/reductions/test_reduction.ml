(* Each way to explore less against exploring everything: the same verdicts on random crowds of equal bodies,
   witnesses that replay by the rules, and no more states. *)

open Scc_ctl
open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_property
open Scc_evaluate
open Scc_space
open Scc_explain
open Scc_verify

module Gen = QCheck2.Gen

let standard = Scc_engine.Standard.of_model

(* {1 Random crowds of unit cubes on a grid} *)

let shapes =
  {|
timestep 1
split_step 1
shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]  right [b,c,g,f]  front [a,b,f,e]  back [d,h,g,c]
}
behaviour Shy    = nil
behaviour Right  = <dock, {right}>. Held
behaviour Left   = <~dock, {left}>. Held
behaviour Both   = <dock, {right}>. Held + <~dock, {left}>. Held
behaviour Held   = omega(dock, {left, right}). Shy
behaviour Urgent = <dock, {right}>. rho({<dock, {right}>}). Shy + <~dock, {left}>. rho({<dock, {left}>}). Shy
behaviour Late   = eps(2). Both
|}

let behaviours = [ "Shy"; "Right"; "Left"; "Both"; "Urgent"; "Late" ]

let body_gen =
  let open Gen in
  let* velocity = frequencyl [ (3, (0, 0)); (2, (1, 0)); (2, (-1, 0)); (1, (0, 1)); (1, (0, -1)) ] in
  let* behaviour = frequencyl (List.map (fun b -> ((if b = "Shy" then 2 else 1), b)) behaviours) in
  return (velocity, behaviour)

(* Bodies on different places of a grid: those of one row and next to each other touch, others are apart. *)
let crowd_gen =
  let open Gen in
  let* n = int_range 2 5 in
  let* places = shuffle_l (List.concat_map (fun x -> List.map (fun y -> (x, y)) [ 0; 1 ]) [ 0; 1; 2; 3 ]) in
  let* bodies = list_repeat n body_gen in
  let* gap = oneofl [ 2; 4 ] in
  let* wall = bool in
  let* falls = frequencyl [ (5, false); (1, true) ] in
  let body i ((vx, vy), behaviour) =
    let x, y = List.nth places i in
    Printf.sprintf "process p%d = Cube mass 1 velocity (%d,%d,0) at translate (%d,%d,0) [%s]" i vx vy (gap * x)
      (6 * y) behaviour
  in
  let walls = if wall then [ "fixed wall = Cube scaled (1,20,1) at translate (30,0,0)" ] else [] in
  let law = if falls then [ "motion p0 = (vx, vy, vz - dt)" ] else [] in
  return (n, String.concat "\n" ((shapes :: List.mapi body bodies) @ walls @ law))

(* {1 Random formulas} *)

let atom_gen n =
  let open Gen in
  let leaf = map (Printf.sprintf "p%d") (int_range 0 (n - 1)) in
  let one =
    oneof
      [
        map2 (Printf.sprintf "bound(%s, %s)") leaf leaf;
        map2 (Printf.sprintf "touching(%s, %s)") leaf leaf;
        map (Printf.sprintf "vx(%s) > 0") leaf;
        map2 (Printf.sprintf "x(%s) > %d") leaf (int_range (-4) 12);
        map2 (Printf.sprintf "size(%s) >= %d") leaf (int_range 2 3);
        map2 (Printf.sprintf "distance2(%s, %s) < 17") leaf leaf;
        map (Printf.sprintf "behaviour(%s) = Held") leaf;
        map2 (Printf.sprintf "same(%s, %s)") leaf leaf;
        map2 (Printf.sprintf "bonds(dock, %s, %s) > 0") leaf leaf; map (Printf.sprintf "offers(%s, dock)") leaf;
        map (Printf.sprintf "speed2(%s) >= 1") leaf; map (Printf.sprintf "spin2(%s) = 0") leaf;
      ]
  and all =
    oneof
      [
        map (Printf.sprintf "bonds(dock) >= %d") (int_range 1 2);
        return (Printf.sprintf "processes < %d" n);
        return "exists a in Cube: vy(a) > 0";
        return "count(a in Cube: behaviour(a) = Held) >= 2";
        return "exists a in Cube: exists b in Cube: not same(a, b) and touching(a, b) and vx(a) > 0";
        return "energy > 1";
        oneofl [ "momentum.x > 0"; "angular.z > 0"; "bonds() = 0"; "quiescent" ];
      ]
  in
  let bind = map (Printf.sprintf "event bind(dock, %s)") leaf in
  let parting = oneofl [ "event split(dock)"; "event weak"; "event strong(dock)" ] in
  frequency [ (6, one); (6, all); (2, bind); (2, return "event bounce"); (1, parting) ]

let formula_of atom =
  let open Gen in
  let* p = atom and* q = atom in
  let state = oneofl [ p; Printf.sprintf "(%s and %s)" p q; Printf.sprintf "(%s => %s)" p q; "not " ^ p ] in
  let* s = state and* within = frequencyl [ (2, ""); (1, " within 3") ] in
  frequencyl
    [
      (4, Printf.sprintf "possibly (%s)%s" s within);
      (4, Printf.sprintf "always (%s)%s" s within);
      (2, Printf.sprintf "eventually (%s)%s" s within);
      (1, Printf.sprintf "EG (%s)" s);
      (1, Printf.sprintf "AG EF (%s)" s);
      (1, Printf.sprintf "EX (%s)" s);
      (1, Printf.sprintf "A[ (%s) U (%s) ]" p q);
      (1, Printf.sprintf "(%s) leads_to (%s)" p q);
      (1, Printf.sprintf "EF[1, 3] (%s)" s);
    ]

let formula_gen n = formula_of (atom_gen n)

(* Comparisons of time with constants, with what changes, and within other atoms. *)
let time_atom_gen n =
  let open Gen in
  let leaf = map (Printf.sprintf "p%d") (int_range 0 (n - 1)) in
  let compared =
    let* comparison = oneofl [ "<"; "<="; ">"; ">="; "="; "!=" ] and* c = int_range 0 8 in
    oneofl
      [
        Printf.sprintf "time %s %d" comparison c;
        Printf.sprintf "%d %s time" c comparison;
        Printf.sprintf "3 * time - 1 %s %d" comparison c;
        Printf.sprintf "%d - time / 2 %s 1" c comparison;
      ]
  in
  frequency
    [
      (6, compared);
      (1, map2 (Printf.sprintf "count(a in Cube: %s and touching(a, %s) or vx(a) > 0) >= 1") compared leaf);
      (1, map2 (Printf.sprintf "x(%s) < time - %d") leaf (int_range 0 4));
      (1, map (Printf.sprintf "time * time > %d") (int_range 0 20));
    ]

let some_with_time n =
  let open Gen in
  let timed =
    let* p = time_atom_gen n and* q = atom_gen n in
    oneofl [ p; Printf.sprintf "%s and %s" p q; Printf.sprintf "(%s => %s)" p q ]
  in
  formula_of (frequency [ (2, timed); (1, atom_gen n) ])

let case_of formula_gen =
  let open Gen in
  let* n, text = crowd_gen in
  let* formulas = list_size (int_range 1 3) (formula_gen n) in
  let checks = List.mapi (fun i f -> Printf.sprintf "check c%d : %s" i f) formulas in
  return (text ^ "\n" ^ String.concat "\n" checks)

let case_gen = case_of formula_gen
let timed_case_gen = case_of some_with_time

(* {1 The comparison} *)

let load text =
  match Scc_test_models.Load.text text with
  | Error _ -> None  (* where all are shy, no formula may speak of docking *)
  | Ok e -> Result.to_option (Result.map (fun s -> (e, s)) (Network.initial (standard e.model) e.declared))

let bounds = { Bounds.default with states = Default 3000; time = Given (Rat.of_int 12); instant = Default 60 }

let run ?(bounds = bounds) reductions (e : Scc_elaborate.Elaborate.t) initial =
  Check.run { Check.default with bounds; reductions } (standard e.model) ~initial e.checks

let definite (v : Verdict.t) =
  match v with
  | Holds { bounds = []; _ } -> Some true
  | Violated _ -> Some false
  | Holds _ | Undecided _ -> None

let conflict (a : Verdict.outcome) (b : Verdict.outcome) =
  match (definite a.verdict, definite b.verdict) with
  | Some x, Some y -> not (Bool.equal x y)
  | None, _ | _, None -> false

let witness : Verdict.t -> Witness.t option = function
  | Holds { witness; _ } | Violated { witness } -> witness
  | Undecided _ -> None

(* By the rules alone, in the model as it is. *)
let replays (e : Scc_elaborate.Elaborate.t) initial (o : Verdict.outcome) =
  match witness o.verdict with
  | None -> true
  | Some w -> (
      match Scc_test_networks.Reach.follow (standard e.model) initial (Witness.choices w) with
      | Error _ -> false
      | Ok transitions ->
        let last = match List.rev transitions with [] -> initial | t :: _ -> t.Transition.target in
        State.equal last w.last)

(* What was searched for is so where the witness ends: whether p holds there, after its last transition. *)
let shows (e : Scc_elaborate.Elaborate.t) ({ check = c; verdict = v; _ } : Verdict.outcome) =
  match (witness v, Plan.of_formula c.formula) with
  | Some ({ finish = At_state; _ } as w), (Possibly (_, p) | Always (_, p))
    when not (Formula.has_events (State p)) ->
    let holds = Trajectory.holds (standard e.model) w.last p in
    let wanted = match v with Holds _ -> Truth.True | Violated _ | Undecided _ -> False in
    Truth.equal holds wanted
  | _ -> true

(* The bound of time cuts both alike. *)
let comparable (s : Check.stats) =
  (not s.decided_early)
  && List.for_all
    (fun (t : Verdict.truncation) -> match t.limit with Time _ -> true | _ -> false)
    s.stopped_by

let decided = ref 0
let refused = ref 0

(* Several explorations may have more states than one: [together] is false. *)
let agrees kinds ~jump ~together text =
  match load text with
  | None -> incr refused; true
  | Some (e, initial) ->
    let full = run [ Reduction.Jump ] e initial in
    let reduced = run kinds e initial in
    let count (o : Verdict.outcome) = if Option.is_some (definite o.verdict) then incr decided in
    List.iter count full.outcomes;
    let comparable = comparable full.stats && comparable reduced.stats in
    if List.exists2 conflict full.outcomes reduced.outcomes then QCheck2.Test.fail_report "verdicts differ"
    else if jump && not (List.for_all (replays e initial) reduced.outcomes) then
      QCheck2.Test.fail_report "a witness does not replay"
    else if not (List.for_all (shows e) reduced.outcomes) then
      QCheck2.Test.fail_report "a witness does not show what it should"
    else if jump && together && comparable && reduced.slices = [] && reduced.stats.states > full.stats.states then
      QCheck2.Test.fail_report "more states than without"
    else true

let property ?(jump = true) name kinds =
  QCheck2.Test.make ~name ~count:400 ~print:Fun.id case_gen (agrees kinds ~jump ~together:true)

let timed name kinds =
  QCheck2.Test.make ~name ~count:400 ~print:Fun.id timed_case_gen (agrees kinds ~jump:true ~together:false)

(* {1 Each does something} *)

let states reductions text =
  match load text with
  | None -> Alcotest.fail "the model is refused"
  | Some (e, initial) ->
    let report = Check.run { Check.default with reductions } (standard e.model) ~initial e.checks in
    let stats = report.stats in
    Alcotest.(check bool) "complete" true stats.complete;
    stats.states

let fewer kind text ~with_it ~without () =
  Alcotest.(check int) "without" without (states [ Reduction.Jump ] text);
  Alcotest.(check int) "with" with_it (states [ kind; Reduction.Jump ] text)

(* Four pairs collide at one instant, and nobody asks: in one order, or in each of the 2^4 sets that may have
   done so. *)
let four_pairs =
  shapes
  ^ {|
for i in 1..4 {
  process p[i] = Cube mass 1 velocity (1,0,0) at translate (0,4*i,0) [Shy]
  process q[i] = Cube mass 1 velocity (-1,0,0) at translate (8,4*i,0) [Shy]
}
process r = Cube mass 1 velocity (0,0,1) at translate (40,0,0) [Shy]
check far : possibly x(r) > 41
|}

(* Two equal balls go round a square, opposite to each other: after half a round they have changed places. *)
let two_balls =
  shapes
  ^ {|
fixed west  = Cube scaled (1,5,1) at translate (-7,0,0)
fixed east  = Cube scaled (1,5,1) at translate (7,0,0)
fixed south = Cube scaled (5,1,1) at translate (0,-7,0)
fixed north = Cube scaled (5,1,1) at translate (0,7,0)
process p = Cube mass 1 velocity (1,-1,0) at translate (-1,-4,0) [Shy]
process q = Cube mass 1 velocity (-1,1,0) at translate (1,4,0) [Shy]
check calm : always energy = 2
|}

(* A pair that drifts, and may come apart at any split instant, or not. *)
let drifting =
  shapes
  ^ {|
process d = p : Cube mass 1 velocity (1,0,0) at translate (0,0,0) [Held] <dock, {p.right, q.left}>
            q : Cube mass 1 velocity (1,0,0) at translate (2,0,0) [Held]
check held : possibly bonds(dock) = 0
check same : eventually bonds(dock) = 0
|}

(* Two pairs collide at one instant: between their bounces either may be first, which is seen by who names both. *)
let seen () =
  let text =
    shapes
    ^ {|
for i in 1..2 {
  process p[i] = Cube mass 1 velocity (1,0,0) at translate (0,4*i,0) [Shy]
  process q[i] = Cube mass 1 velocity (-1,0,0) at translate (8,4*i,0) [Shy]
}
check first  : possibly vx(p[1]) < 0 and vx(p[2]) > 0
check second : possibly vx(p[1]) > 0 and vx(p[2]) < 0
|}
  in
  match load text with
  | None -> Alcotest.fail "the model is refused"
  | Some (e, initial) ->
    let report = run ~bounds:Bounds.default [ Order; Jump ] e initial in
    let verdicts = List.map (fun (o : Verdict.outcome) -> Verdict.to_string o.verdict) report.outcomes in
    Alcotest.(check (list string)) "both" [ "holds (exhaustive)"; "holds (exhaustive)" ] verdicts

(* A plate bounces for ever within the first instant, unseen; what others do then is not put off for ever. *)
let not_put_off () =
  let text =
    shapes
    ^ {|
fixed floor   = Cube at translate (0,-2,0)
fixed ceiling = Cube at translate (0,2,0)
process plate = Cube mass 1 velocity (0,1,0) [Shy]
process p = Cube mass 1 velocity (1,0,0)  at translate (40,0,0) [Shy]
process q = Cube mass 1 velocity (-1,0,0) at translate (42,0,0) [Shy]
check away : possibly vx(q) = 1
|}
  in
  match load text with
  | None -> Alcotest.fail "the model is refused"
  | Some (e, initial) ->
    let report = run ~bounds:Bounds.default [ Order; Jump ] e initial in
    let verdicts = List.map (fun (o : Verdict.outcome) -> Verdict.to_string o.verdict) report.outcomes in
    Alcotest.(check (list string)) "reached" [ "holds (exhaustive)" ] verdicts

let drift () =
  Alcotest.(check int) "with" 2 (states [ Reduction.Translation; Jump ] drifting)

let verdicts_and_stats reductions text =
  match load text with
  | None -> Alcotest.fail "the model is refused"
  | Some (e, initial) ->
    let bounds = { Bounds.default with states = Default 3000 } in
    let report = Check.run { Check.default with bounds; reductions } (standard e.model) ~initial e.checks in
    (List.map (fun (o : Verdict.outcome) -> Verdict.to_string o.verdict) report.outcomes, report.stats)

(* Alone it is violated in two states, and it stays so whatever else is asked. *)
let unspoilt () =
  let text = drifting ^ "check slow : always time * time >= 0\n" in
  let verdicts, _ = verdicts_and_stats Reduction.all text in
  let limited = "holds up to the bound: the bound of 3000 states (a default)" in
  Alcotest.(check (list string)) "time is kept for one" [ "holds (exhaustive)"; "violated"; limited ] verdicts;
  let verdicts, _ = verdicts_and_stats [ Reduction.Translation; Jump ] text in
  Alcotest.(check bool) "time is kept for all" false (List.nth verdicts 1 = "violated")

let up_to_a_constant () =
  let text =
    two_balls
    ^ {|
check late   : AG (time > 20 => AF touching(p, east))
check early  : possibly time <= 11 and 2 * time > 15 and touching(p, north)
check passes : eventually time = 30
check after  : EF (time > 30 and EG (not touching(p, east)))
|}
  in
  let verdicts, stats = verdicts_and_stats [ Reduction.Time; Jump ] text in
  let holds = "holds (exhaustive)" in
  Alcotest.(check (list string)) "proofs" [ holds; holds; holds; holds; "violated" ] verdicts;
  Alcotest.(check bool) "all is explored" true stats.complete

let enough () =
  Alcotest.(check bool) "few models are refused" true (!refused < 100);
  Alcotest.(check bool) "most formulas are decided" true (!decided > 1000)

let () =
  let with_jump kind = [ kind; Reduction.Jump ] in
  let quick name f = Alcotest.test_case name `Quick f in
  Alcotest.run "reduction"
    [
      ( "random crowds",
        Scc_test_support.Property.cases
          [
            property "symmetry" (with_jump Symmetry);
            property "translation" (with_jump Translation);
            property "order" (with_jump Order);
            property "slice" (with_jump Slice);
            property "all" Reduction.all;
            timed "time" (with_jump Time);
            timed "time, and all else" Reduction.all;
            property "no jumps" ~jump:false [];
          ] );
      ( "effects",
        [
          quick "enough is decided" enough;
          quick "order" (fewer Order four_pairs ~with_it:6 ~without:17);
          quick "symmetry" (fewer Symmetry two_balls ~with_it:9 ~without:17);
          quick "translation" drift;
          quick "time spoils no other property" unspoilt;
          quick "time counts up to a constant" up_to_a_constant;
          quick "what is seen happens in every order" seen;
          quick "nothing is put off for ever" not_put_off;
        ] );
    ]
