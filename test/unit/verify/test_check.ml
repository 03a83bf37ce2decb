(* Whole checks of small models from text: each kind of verdict, and what witnesses tell. *)

open Scc_exact
open Scc_explain
open Scc_verify
open Scc_test_models

let standard = Scc_engine.Standard.of_model

let cube =
  {|
shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}
|}

let bounded bounds = { Setup.default with bounds }

let check ?(options = Setup.default) text =
  let e = Load.exactly (Load.text (cube ^ text)) in
  match Scc_semantics.Network.initial (standard e.model) e.declared with
  | Error _ -> Alcotest.fail "no initial state"
  | Ok initial -> (e.model, Check.run options (standard e.model) ~initial e.checks)

let verdict v = Verdict.to_string v
let outcomes (report : Check.report) = List.map Verdict.outcome_to_string report.outcomes

let verdicts ?options text =
  let _, report = check ?options text in
  List.map (fun (o : Verdict.outcome) -> verdict o.verdict) report.outcomes

let expect what expected got = Alcotest.(check (list string)) what expected got

let witness_lines ?options text =
  let model, report = check ?options text in
  match report.outcomes with
  | [ { verdict = Holds { witness = Some w; _ } | Violated { witness = Some w }; _ } ] ->
    Witness.lines model w
  | _ -> Alcotest.fail "no witness"

(* {1 One body that drifts} *)

let drift = "process p = Cube mass 1 velocity (1,0,0) at translate (-3,0,0) [nil]\n"
let still = "process q = Cube mass 1 at translate (0,5,0) [nil]\n"

let over_the_run () =
  expect "verdicts"
    [ "violated"; "holds (exhaustive)"; "violated"; "holds (exhaustive)"; "violated"; "violated" ]
    (verdicts
       (drift
        ^ {|
check a : always x(p) <= 3
check b : always x(p) <= 3 within 6
check c : always x(p) < 3 within 6
check d : not (possibly (x(p) = 1/3 and x(p) = 1/2))
check e : eventually x(p) < -3
check f : (possibly x(p) = 0) and (always x(p) < 0)
|}))

(* Steps of single processes where no law steers one: there is nothing that could be jumped over. *)
let own_steps () =
  let model = "timestep 1/2 local\n" ^ drift ^ "check a : always x(p) <= 3\n" in
  expect "without jumps" [ "violated" ] (verdicts ~options:{ Setup.default with reductions = [] } model)

let words () =
  expect "an open interval"
    [ "then time passes: right after time 6, for example at time 7"; "x(p) <= 3 fails: x(p) = 4" ]
    (witness_lines (drift ^ "check a : always x(p) <= 3"));
  expect "within a bound, the example too"
    [ "then time passes: right after time 6, for example at time 25/4"; "x(p) <= 3 fails: x(p) = 13/4" ]
    (witness_lines (drift ^ "check a : always x(p) <= 3 within 13/2"));
  expect "an irrational instant"
    [
      "then time passes, until time root of t^2 - 6t - 3 in (32/5, 13/2), about 6.464102";
      "distance2(p, q) = 37 holds: distance2(p, q) = 37";
    ]
    (witness_lines (drift ^ still ^ "check a : possibly distance2(p, q) = 37"))

let undefined () =
  let checks =
    String.concat "\n"
      [
        "check a : always 1 / x(p) != 7 within 3";
        "check b : always 1 / x(p) < 7";
        "check c : always 1 / x(p) < 7 within 2";
      ]
  in
  expect "division by zero"
    [ "undecided: division by zero in (1 / x(p))"; "violated"; "holds (exhaustive)" ]
    (verdicts (drift ^ checks))

(* An evaluation that nobody would wait for. *)
let high_degree () =
  let power n = String.concat " * " (List.init n (fun _ -> "x(p)")) in
  let undecided = "undecided: a polynomial in time of a degree above 200 is not evaluated" in
  expect "degree 200" [ "holds (exhaustive)" ] (verdicts (drift ^ "check a : possibly " ^ power 200 ^ " = 0"));
  expect "degree 201" [ undecided ] (verdicts (drift ^ "check a : possibly " ^ power 201 ^ " = 0"))

(* p passes x = -3 at time 0, 0 at 3 and 3 at 6, and nothing else happens. *)
let nested () =
  expect "nested"
    [
      "violated"; "holds (exhaustive)"; "violated"; "violated"; "violated"; "holds (exhaustive)";
      "holds (exhaustive)"; "violated"; "holds (exhaustive)";
    ]
    (verdicts
       (drift
        ^ {|
check a : always possibly x(p) = 3
check b : A[ x(p) < 0 U x(p) >= 0 ]
check c : EF[1,2] x(p) = 0
check d : EG x(p) < 0
check e : EX x(p) < 0
check f : AF[<= 3] x(p) = 0
check g : x(p) = 0 leads_to x(p) = 3 within 3
check h : x(p) = 0 leads_to[<= 2] x(p) = 3
check i : EF (x(p) = 2 and AG x(p) >= 2)
|}))

(* The instant at which an outer operator fails is not lost when the inner one goes on from there for ever. *)
let inner_instants () =
  Alcotest.(check (list string)) "right after the start"
    [
      "then time passes: right after time 0, for example at time 1"; "x(p) = -3 fails: x(p) = -2"; "why:";
      "  AG AF[<= 0] x(p) = -3 does not hold: right after time 0 from here, for example after 1";
      "    AF[<= 0] x(p) = -3 does not hold: the run then passes the bound of time, which ends after time 0 from \
       here";
    ]
    (witness_lines (drift ^ "check a : AG AF[<= 0] x(p) = -3"))

(* {1 Bounds} *)

(* A state for each step: gravity without a floor never closes. *)
let falls = "timestep 1\nprocess p = Cube mass 1 [nil]\nmotion p = (vx, vy, vz - dt)\n"

let bounds () =
  let checks =
    String.concat "\n"
      [
        "check a : always z(p) <= 0";
        "check b : possibly z(p) > 0";
        "check c : eventually z(p) = -1000";
        "check d : eventually z(p) <= -10";
      ]
  in
  let at options = verdicts ~options (falls ^ checks) in
  let ended = "undecided: the exploration ended at " in
  let all what =
    let open_ = ended ^ what ^ "; one unexplored state matters" in
    [ "holds up to the bound: " ^ what; open_; open_; "holds (exhaustive)" ]
  in
  expect "depth by default" (all "the depth bound 20 (a default)")
    (at (bounded { Bounds.default with depth = Default 20 }));
  expect "depth by the user" (all "the depth bound 20") (at (bounded { Bounds.default with depth = Given 20 }));
  expect "time" (all "the time bound 15/2")
    (at (bounded { Bounds.default with time = Given (Rat.div (Rat.of_int 15) (Rat.of_int 2)) }));
  expect "states" (all "the bound of 30 states") (at (bounded { Bounds.default with states = Given 30 }));
  expect "within is no truncation" [ "holds (exhaustive)"; "violated" ]
    (verdicts (falls ^ "check a : always z(p) <= 0 within 9\ncheck b : possibly z(p) > 0 within 9"));
  expect "unless it is not reached" [ "holds up to the bound: the depth bound 3 (a default)" ]
    (verdicts
       ~options:(bounded { Bounds.default with depth = Default 3 })
       (falls ^ "check a : always z(p) <= 0 within 9"))

let interruption () =
  let polls = ref 0 in
  let stop () = incr polls; if !polls > 10 then Some Scc_graph_search.Limits.Interrupted else None in
  let options = { Setup.default with surroundings = Scc_graph_search.Limits.undivided ~stop () } in
  let _, report = check ~options (falls ^ "check a : always z(p) <= 0") in
  (match report.outcomes with
   | [ { verdict = v; _ } ] ->
     Alcotest.(check string) "verdict" "holds up to the bound: the interruption" (Verdict.to_string v);
     Alcotest.(check bool) "by resources" true (Verdict.resources v)
   | _ -> Alcotest.fail "one verdict");
  Alcotest.(check int) "states" 11 report.stats.states

let early () =
  let options = bounded { Bounds.default with states = Default 1000 } in
  let _, report = check ~options (falls ^ "check a : always z(p) > -10\ncheck b : possibly z(p) < -4") in
  Alcotest.(check bool) "few states" true (report.stats.states < 10);
  Alcotest.(check bool) "decided early" true report.stats.decided_early;
  let seen = ref 0 in
  let options = { options with observe = Some (fun _ -> incr seen) } in
  let _, report = check ~options (falls ^ "check a : always z(p) <= 0") in
  Alcotest.(check int) "every state is observed" report.stats.states !seen;
  Alcotest.(check int) "no early end" 1000 report.stats.states

(* The law divides by zero once p has speed 3: what comes after is not known. *)
let faults () =
  let text = "timestep 1\nprocess p = Cube mass 1 [nil]\nmotion p = (0, 0, vz - dt - 0 / (vz + 3))\n" in
  let checks =
    String.concat "\n"
      [
        "check a : always z(p) <= 0";
        "check b : possibly z(p) <= -5/2";
        "check c : eventually z(p) < -100";
      ]
  in
  let _, report = check (text ^ checks) in
  (match List.map (fun (o : Verdict.outcome) -> verdict o.verdict) report.outcomes with
   | [ a; b; c ] ->
     let faulty v = String.length v > 11 && String.equal (String.sub v 0 11) "undecided: " in
     Alcotest.(check bool) ("always is undecided: " ^ a) true (faulty a);
     Alcotest.(check string) "possibly" "holds (exhaustive)" b;
     Alcotest.(check bool) ("eventually is undecided: " ^ c) true (faulty c)
   | _ -> Alcotest.fail "three verdicts");
  Alcotest.(check int) "one fault" 1 (List.length report.stats.faults)

(* {1 Choice} *)

let pair =
  {|
timestep 1
behaviour Held on Cube = omega(a, {right, left}). Free
behaviour Free on Cube = nil
process r = p : Cube mass 1 [Held] <a, {p.right, q.left}> q : Cube mass 1 at translate (2,0,0) [Held]
|}

let fairness () =
  expect "a split put off for ever"
    [
      "1. time(1), at time 1"; "and step 1 again, for ever";
      "it puts off weak(a, p.right, q.left) for ever: no fairness is assumed"; "bound(p, q) holds";
    ]
    (witness_lines (pair ^ "check a : eventually not bound(p, q)"));
  expect "a bound that is passed"
    [
      "1. time(1), at time 1"; "2. time(1), at time 2";
      "then time passes beyond the bound, which ends at time 5/2"; "z(p) <= -10 fails: z(p) = -2";
    ]
    (witness_lines (falls ^ "check a : eventually z(p) <= -10 within 5/2"));
  expect "possible" [ "1. weak(a, p.right, q.left), at time 0"; "bound(p, q) fails" ]
    (witness_lines (pair ^ "check a : possibly not bound(p, q)"));
  expect "the negation of what may be avoided" [ "holds (exhaustive)" ]
    (verdicts (pair ^ "check a : not (eventually not bound(p, q))"))

(* {1 Zeno: a body that exactly fills the gap between two walls, and moves} *)

let slot =
  {|
process p = Cube mass 1 velocity (1,0,0) [nil]
fixed left  = Cube at translate (-2,0,0)
fixed right = Cube at translate (2,0,0)
|}

let zeno () =
  let checks =
    String.concat "\n"
      [
        "check a : eventually vx(p) = 2";
        "check b : eventually vx(p) = -1";
        "check c : always x(p) = 0";
        "check d : EG true";
        "check e : AG EX true";
        "check f : EF[1, 1] true";
        "check g : possibly vx(p) = -1";
      ]
  in
  let text = slot ^ checks in
  let model, report = check text in
  expect "verdicts"
    [
      "violated by a run that goes round within one instant"; "holds (exhaustive)"; "holds (exhaustive)";
      "holds (exhaustive) by a run that goes round within one instant";
      "holds (exhaustive), of runs some of which go round within one instant"; "violated"; "holds (exhaustive)";
    ]
    (outcomes report);
  match report.zeno with
  | None -> Alcotest.fail "the cycle is not reported"
  | Some w ->
    expect "the cycle"
      [
        "1. bounce(p, right), at time 0"; "2. bounce(p, left), at time 0";
        "and the steps from 1 on again, for ever";
      ]
      (Witness.lines model w)

(* {1 Dead ends} *)

(* A cube that turns on a tip below its middle. *)
let tip =
  {|
shape Spike {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)  tip (0,0,3)
  faces    bottom [a,d,c,b]  front [a,b,tip]  right [b,c,tip]  back [c,d,tip]  left [d,a,tip]
}
resolution 1/1024
fixed spike = Spike at translate (0, 0, -4)
process p = Cube mass 1 spin (1, 0, 0) [nil]
check a : AF z(p) > 0
check b : AG z(p) = 0
check c : AG EX true
check d : possibly z(p) = 0
check e : AX false
check f : AG EF z(p) = 0
|}

let dead_ends () =
  let _, report = check tip in
  let at = ", at resolution 1/1024" in
  let by = " by a run that ends in a dead end" ^ at in
  let among = ", of runs some of which end in a dead end" ^ at in
  expect "verdicts"
    [
      "violated" ^ by; "holds (exhaustive)" ^ among; "violated" ^ by; "holds (exhaustive)" ^ at;
      "holds (exhaustive)" ^ among; "holds (exhaustive)" ^ among;
    ]
    (outcomes report);
  Alcotest.(check bool) "complete" true report.stats.complete;
  expect "no fault" [] (List.map (fun (d : Scc_base.Diag.t) -> d.code) report.stats.faults);
  let told (d : Scc_base.Diag.t) = (if Scc_base.Diag.is_error d then "error " else "warning ") ^ d.code in
  expect "the model is given up" [ "warning SC0602" ] (List.map told report.stats.dead_ends)

(* {1 What is said of runs without time} *)

(* Of formulas that no run decides: both kinds of quantifier matter, and negations turn one into the other. *)
let may_rest () =
  let of_some = ", of runs some of which go round within one instant" in
  let hold =
    [
      ("EG true and AG x(p) = 0", " by a run that goes round within one instant"); ("not EF x(p) > 0", "");
      ("AF AG x(p) = 0", ""); ("AG not AF vx(p) = 2", of_some); ("A[EX true U vx(p) = -1]", of_some);
    ]
  and fail =
    [ ("EX EF x(p) > 0", ""); ("not AG AX x(p) = 0", ""); ("EF AF x(p) > 0", of_some); ("EF AX false", of_some) ]
  in
  let text i (f, _) = Printf.sprintf "check c%d : %s\n" i f and told verdict (_, said) = verdict ^ said in
  expect "what is said" (List.map (told "holds (exhaustive)") hold @ List.map (told "violated") fail)
    (outcomes (snd (check (slot ^ String.concat "" (List.mapi text (hold @ fail))))))

(* {1 Weak splits} *)

(* As in specs/models/window.sc: q catches y without p having caught x iff they part later than 5/4 and by 3/2. *)
let window grid =
  Printf.sprintf
    {|
split_step %s
behaviour One     on Cube = omega(hold, {right}). eps(1). <above, {top}>. nil
behaviour Other   on Cube = omega(hold, {left}). eps(2). <below, {bottom}>. nil
behaviour Falling on Cube = <~above, {bottom}>. nil
behaviour Rising  on Cube = <~below, {top}>. nil
process pair = p : Cube mass 1 at translate (-1,0,0) [One]
               <hold, {p.right, q.left}>
               q : Cube mass 1 at translate (1,0,0) [Other]
process x = Cube scaled (1/2,1/2,1/2) mass 1 velocity (0,0,-1) at translate (-1,0,15/4) [Falling]
process y = Cube scaled (1/2,1/2,1/2) mass 1 velocity (0,0,1)  at translate (1,0,-5)    [Rising]
process far = Cube mass 1 velocity (1,0,0) at translate (1000,0,0) [nil]
|}
    grid

let at_split_step () =
  let told ?options text =
    let _, report = check ?options text in
    outcomes report
  in
  let safe = "check safe : always (bound(q, y) => bound(p, x)) within 4\n" in
  expect "between two instants" [ "holds (exhaustive), at split step 1" ] (told (window "1" ^ safe));
  expect "on a finer grid" [ "violated, at split step 1/4" ] (told (window "1/4" ^ safe));
  expect "where nothing is seen of splits"
    [ "holds (exhaustive), at split step 1"; "holds (exhaustive)" ]
    (told (window "1" ^ safe ^ "check away : possibly vx(far) = 1 within 4\n"));
  expect "without slices both are explored together"
    [ "holds (exhaustive), at split step 1"; "holds (exhaustive), at split step 1" ]
    (told
       ~options:{ Setup.default with reductions = [ Scc_state_space.Reduction.Jump ] }
       (window "1" ^ safe ^ "check away : possibly vx(far) = 1 within 4\n"));
  expect "where nothing can split" [ "violated" ] (told (drift ^ "check a : always x(p) <= 3\n"));
  let few = { Setup.default with bounds = { Bounds.default with states = Given 3 } } in
  match told ~options:few (window "1" ^ "check a : possibly bound(q, y) and x(y) > 5\n") with
  | [ text ] ->
    let starts = String.length text > 11 && String.equal (String.sub text 0 11) "undecided: " in
    Alcotest.(check bool) text true (starts && not (String.contains text ','))
  | _ -> Alcotest.fail "one verdict"

let suite =
  let quick name f = Alcotest.test_case name `Quick f in
  ("check",
   [
     ( "verdicts",
       [
         quick "over the whole run" over_the_run;
         quick "steps of single processes" own_steps;
         quick "a division by zero" undefined;
         quick "a polynomial of high degree" high_degree;
         quick "operators within operators" nested;
         quick "instants of operators within operators" inner_instants;
         quick "bounds" bounds;
         quick "interruption" interruption;
         quick "early end" early;
         quick "faults of laws" faults;
         quick "Zeno" zeno;
         quick "dead ends" dead_ends; quick "what may rest on runs without time" may_rest;
         quick "at which split step" at_split_step;
       ] );
     ("witnesses", [ quick "instants in words" words; quick "no fairness" fairness ]);
   ])
