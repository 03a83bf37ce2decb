(* Checks that are explored together: what is decided keeps nothing going for the others. *)

open Scc_semantics
open Scc_verify
open Scc_test_models

let model =
  {|
timestep 1
shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}
process p = Cube mass 1 [nil]
motion p = (vx, vy, vz - dt)
|}

let explored checks =
  let e = Load.exactly (Load.text (model ^ checks)) in
  let semantics = Scc_engine.Standard.of_model e.model in
  match Network.initial semantics e.declared with
  | Error _ -> Alcotest.fail "no initial state"
  | Ok initial ->
    let bounds = { Bounds.default with states = Default 5000 } in
    let report = Check.run { Setup.default with bounds } semantics ~initial e.checks in
    let verdict (o : Verdict.outcome) = Verdict.to_string o.verdict in
    (List.map verdict report.outcomes, report.stats.states)

let soon = "check soon : AF z(p) < -1\n"
let met = "check met : possibly z(p) < -1\n"
let bounded = "check bounded : always z(p) <= 0 within 3\n"
let long = "check long : always z(p) <= 0 within 40\n"
let never = "check never : possibly z(p) > 1\n"

let fewer what checks expected ~than =
  let verdicts, states = explored (String.concat "" checks) in
  Alcotest.(check (list string)) what expected verdicts;
  let alone = List.fold_left (fun n c -> n + snd (explored c)) 0 than in
  Alcotest.(check bool) (Printf.sprintf "%s: %d states, %d alone" what states alone) true (states <= alone)

let proof = "holds (exhaustive)"

let together () =
  fewer "a formula without a bound beside a bounded search" [ soon; bounded ] [ proof; proof ]
    ~than:[ soon; bounded ];
  fewer "a search without a bound" [ met; long; bounded ] [ proof; proof; proof ] ~than:[ met; long ];
  let left =
    "undecided: the exploration ended at the bound of 5000 states (a default); one unexplored state matters"
  in
  fewer "one that is not decided goes on" [ never; bounded ] [ left; proof ] ~than:[ never ]

let suite =
  ("together", [ ("together", [ Alcotest.test_case "checks of one exploration" `Quick together ]) ])
