(* Seconds are shared by the checks of a model: one without an end leaves the others their parts, and has in the
   end what they leave. The clock counts how often an exploration asks whether it is to stop, so that nothing
   depends on how busy the machine is. *)

open Scc_graph_search
open Scc_semantics
open Scc_verify
open Scc_test_models

(* Surroundings that end after so many questions. Without [fair], all work may take all that is left. *)
let surroundings ~fair total =
  let now = ref 0. in
  let rec until last : Limits.surroundings =
    let stop () : Limits.stop option =
      now := !now +. 1.;
      if !now > last then Some Seconds else None
    in
    let after part = until (!now +. (part *. (last -. !now))) in
    let share ~mine ~all = if fair then after (float_of_int mine /. float_of_int all) else until last in
    { Limits.quiet with stop; share; half = (fun () -> after 0.5) }
  in
  until total

let options ~fair total =
  let bounds = { Bounds.default with seconds = Given 9. } in
  { Setup.default with bounds; surroundings = surroundings ~fair total }

let words (r : Check.report) = List.map (fun (o : Verdict.outcome) -> Verdict.to_string o.verdict) r.outcomes

let ordinary =
  {|
shape C = box(1,1,1)
process p = C mass 1 velocity (1,0,0) [nil]
fixed w1 = C at translate (-2,0,0)
fixed w2 = C at translate (2,0,0)
process q = C mass 1 velocity (1,0,0) at translate (0,9,0) [nil]
fixed w3 = C at translate (-2,9,0)
fixed w4 = C at translate (2,9,0)
check long : always x(p) + time > -9
check met  : possibly event bounce(q)
check late : AF vx(q) = -1
|}

let of_states ~fair =
  let e = Load.exactly (Load.text ordinary) in
  let semantics = Scc_engine.Standard.of_model e.model in
  match Network.initial semantics e.declared with
  | Error _ -> Alcotest.fail "no initial state"
  | Ok initial -> words (Check.run (options ~fair 300.) semantics ~initial e.checks)

let over_starts =
  {|
param x in [0, 1]
timestep 1
shape C = box(1,1,1)
process p = C mass 1 at translate (x,0,0) [nil]
motion p = choose { (1,0,0), (-1,0,0) }
check long : P = ? [ eventually x(p) > 1000000 within 1000000 ]
check soon : P = ? [ eventually x(p) > 2 within 3 ]
check sure : always x(p) < 100 within 3
|}

(* The first check here is decided by sets of states, and all others by chance. *)
let without_chance =
  {|
param x in [0, 1]
shape C = box(1,1,1)
process p = C mass 1 velocity (1,0,0) at translate (x,0,0) [nil]
fixed w1 = C at translate (-9,0,0)
fixed w2 = C at translate (9,0,0)
check long : possibly x(p) > 100 within 1000000
check soon : possibly event bounce(p)
check much : P = ? [ eventually x(p) > 4 within 4 ]
|}

let of_zones text ~fair =
  let e = Load.exactly (Load.text text) in
  let semantics = Scc_engine.Standard.of_model e.model in
  let u = Option.get e.uncertain and declared = e.declared in
  match
    Scc_zones.Zone_check.run (options ~fair 400.) semantics u ~declared ~exactly:true ~premises:[] e.checks
  with
  | Ok report -> words report
  | Error _ -> Alcotest.fail "not well-formed"

let decided = "holds (exhaustive)"
let seconds = "the exploration ended at the limit of 9 seconds"
let share = ", of which it had its share"
let nothing text = "from 0 to 1, not known better, for x in [0, 1], as far as is known: " ^ text

let check what found ~fair ~unfair =
  Alcotest.(check (list string)) what fair (found ~fair:true);
  Alcotest.(check (list string)) (what ^ ", each with all that is left") unfair (found ~fair:false)

let states () =
  check "states" of_states
    ~fair:[ "holds up to the bound: the limit of 9 seconds"; decided; decided ]
    ~unfair:
      (("holds up to the bound: the limit of 9 seconds" ^ share)
       :: List.init 2 (fun _ -> "undecided: " ^ seconds ^ "; one unexplored state matters"))

let starts () =
  let eighths = "1/8 to 1/4, for x in [0, 1]; mean 1/4 = 0.25" in
  check "chance from any start" (of_zones over_starts)
    ~fair:[ nothing seconds; eighths; decided ]
    ~unfair:[ nothing seconds; eighths; "undecided: " ^ seconds ]

let sets () =
  let open_ had = "undecided: " ^ seconds ^ had ^ "; one unexplored state matters" in
  check "sets of states, and chance after them" (of_zones without_chance)
    ~fair:[ open_ ""; decided; "0 to 1, for x in [0, 1]; mean 1" ]
    ~unfair:[ open_ share; decided; nothing seconds ]

let suite =
  let quick name f = Alcotest.test_case name `Quick f in
  ( "shares",
    [
      ( "shares",
        [
          quick "Shares: states" states;
          quick "Shares: chance from any start" starts;
          quick "Shares: sets of states, and chance after them" sets;
        ] );
    ] )
