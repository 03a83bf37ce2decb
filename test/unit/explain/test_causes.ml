(* What the events of runs depend on, and who matters without taking part. *)

open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_property
open Scc_explain
open Scc_test_models
open Scc_test_networks

let standard = Scc_engine.Standard.of_model
module Gen = QCheck2.Gen

let cube =
  {|
shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]  right [b,c,g,f]  front [a,b,f,e]  back [d,h,g,c]
}
|}

(* {1 Runs} *)

let successors m s =
  match Network.successors (standard m) s with
  | Ok list -> list
  | Error _ -> Alcotest.fail "no successors"

(* The first successor, always, as long as time does not go beyond a limit; not for ever at one instant. *)
let run_until (model : Model.t) declared time =
  let initial = Reach.initial model declared in
  let rec go fuel state now steps =
    let rest = Rat.sub time now in
    let leave () =
      let course = Scc_motion.Course.make (standard model) ~initial (List.rev steps) ~rest in
      { Causes.declared; course; over = None }
    in
    match successors model state with
    | [] -> leave ()
    | t :: _ ->
      let d = Transition.duration t in
      if Rat.compare d rest > 0 || fuel = 0 then leave ()
      else go (fuel - 1) t.target (Rat.add now d) ((t.label, t.target) :: steps)
  in
  go 50 initial Rat.zero []

(* A model with one check, run to a time, and explained for the check. *)
let explained text time =
  let e = Load.exactly (Load.text (cube ^ text)) in
  let story = Causes.tell (run_until e.model e.declared (Rat.of_int time)) in
  match e.checks with
  | [ k ] ->
    (e.model, Omission.explain story (Causes.of_formula story k.formula) (Formula.predicates k.formula))
  | _ -> (e.model, Omission.explain story (Causes.of_last_event story) [])

let role : Omission.role -> string = function
  | Irrelevant -> "-"
  | Cause -> "cause"
  | Keeps_away -> "keeps away"

let event (m : Model.t) (e : Causes.event) =
  match e.happening with
  | Discrete label -> Transition.label_to_string m label
  | Expiry leaf -> Printf.sprintf "expiry(%s)" m.leaves.(leaf).name

let roles m (x : Omission.t) =
  List.map2
    (fun e r -> Printf.sprintf "%s: %s" (event m e) (role r))
    (Array.to_list (Causes.events x.story))
    (Array.to_list x.roles)

let names (m : Model.t) leaves = String.concat "+" (List.map (fun l -> m.leaves.(l).name) leaves)
let strings = Alcotest.(list string)

let expect text time ~events ~left_out ~keep_away () =
  let m, x = explained text time in
  Alcotest.check strings "events" events (roles m x);
  Alcotest.check strings "left out" left_out (List.map (names m) x.left_out);
  Alcotest.check strings "keep away" keep_away (List.map (fun (b, _) -> names m b) x.keep_away)

let case name run = Alcotest.test_case name `Quick run

(* {1 Bodies} *)

(* y pushes p, which comes back from the wall; meanwhile x has pushed y aside. Far away r and s meet. *)
let billiard =
  {|
process y = Cube mass 1 velocity (2,0,0) at translate (-10,0,0) [nil]
process p = Cube mass 1 at translate (0,0,0) [nil]
fixed wall = Cube at translate (10,0,0)
process r = Cube mass 1 velocity (1,0,0) at translate (0,0,50) [nil]
process s = Cube mass 1 at translate (5,0,50) [nil]
|}

let aside = "process x = Cube mass 1/2 velocity (0,-2,0) at translate (-2,20,0) [nil]\n"

(* The same with x too late to matter. *)
let late = "process x = Cube mass 1/2 velocity (0,-2,0) at translate (-20,20,0) [nil]\n"

let bystanders =
  [
    case "pushed out of the way"
      (expect (billiard ^ aside ^ "check back : possibly x(p) < -3") 14
         ~events:
           [
             "bounce(r, s): -"; "bounce(y, p): cause"; "bounce(p, wall): cause"; "bounce(y, x): keeps away";
           ]
         ~left_out:[ "r"; "s" ] ~keep_away:[ "x" ]);
    case "before it matters"
      (expect (billiard ^ aside ^ "check far : possibly x(p) > 5") 7
         ~events:[ "bounce(r, s): -"; "bounce(y, p): cause" ]
         ~left_out:[ "wall"; "r"; "s"; "x" ] ~keep_away:[]);
    case "in no one's way"
      (expect (billiard ^ late ^ "check back : possibly x(p) < 3") 11
         ~events:[ "bounce(r, s): -"; "bounce(y, p): cause"; "bounce(p, wall): cause" ]
         ~left_out:[ "r"; "s"; "x" ] ~keep_away:[]);
    case "the whole energy"
      (expect (billiard ^ "check all : possibly energy > 0") 5
         ~events:[ "bounce(r, s): cause"; "bounce(y, p): cause" ]
         ~left_out:[ "wall" ] ~keep_away:[]);
    case "the last event" (expect billiard 5 ~events:[ "bounce(r, s): -"; "bounce(y, p): cause" ]
                             ~left_out:[ "wall"; "r"; "s" ] ~keep_away:[]);
    case "nothing has happened"
      (expect (billiard ^ "check still : always x(p) = 0") 1 ~events:[]
         ~left_out:[ "y"; "wall"; "r"; "s" ] ~keep_away:[]);
  ]

(* {1 Behaviours and bonds} *)

(* p opens its channel after a delay and takes q with it; the pair lets go, and q flies on. *)
let reacting =
  {|
split_step 1
behaviour Ready = eps(1). <a, {right}>. eps(1). omega(a, {right}). nil
process p = Cube mass 1 velocity (1,0,0) at translate (-4,0,0) [Ready]
process q = Cube mass 1 at translate (0,0,0) [<~a, {left}>. eps(1). omega(a, {left}). nil]
process other = Cube mass 1 at translate (0,0,50) [eps(3/2). nil]
|}

let reactions =
  [
    case "a bond"
      (expect (reacting ^ "check meet : possibly bonds(a) = 1") 2
         ~events:[ "expiry(p): cause"; "expiry(other): -"; "bind(a, p.right, q.left): cause" ]
         ~left_out:[ "other" ] ~keep_away:[]);
    case "a bond between two"
      (expect (reacting ^ "check meet : possibly bound(q, p)") 2
         ~events:[ "expiry(p): cause"; "expiry(other): -"; "bind(a, p.right, q.left): cause" ]
         ~left_out:[ "other" ] ~keep_away:[]);
    case "a behaviour that nothing has changed"
      (expect (reacting ^ "check idle : possibly behaviour(p) = Ready") 1 ~events:[ "expiry(p): cause" ]
         ~left_out:[ "q"; "other" ] ~keep_away:[]);
    case "a behaviour of another"
      (expect (reacting ^ "check idle : possibly offers(other, a)") 2
         ~events:[ "expiry(p): -"; "expiry(other): cause"; "bind(a, p.right, q.left): -" ]
         ~left_out:[ "p"; "q" ] ~keep_away:[]);
    case "an event"
      (expect (reacting ^ "check meet : possibly event bind(a)") 2
         ~events:[ "expiry(p): cause"; "expiry(other): -"; "bind(a, p.right, q.left): cause" ]
         ~left_out:[ "other" ] ~keep_away:[]);
    case "a bond that is gone"
      (expect (reacting ^ "check free : possibly bonds(a) = 0") 3
         ~events:
           [
             "expiry(p): cause"; "expiry(other): -"; "bind(a, p.right, q.left): cause"; "expiry(p): cause";
             "expiry(q): cause"; "weak(a, p.right, q.left): cause";
           ]
         ~left_out:[ "other" ] ~keep_away:[]);
    case "an event that is over"
      (expect (reacting ^ "check meet : possibly event bind(a, p)") 1 ~events:[ "expiry(p): -" ]
         ~left_out:[ "q"; "other" ] ~keep_away:[]);
  ]

let reasons () =
  let m, x = explained (reacting ^ "check meet : possibly bonds(a) = 1") 2 in
  let events = Causes.events x.story in
  let text (r : Causes.reason) =
    let aspect =
      match r.aspect with
      | Motion -> "motion"
      | Structure -> "structure"
      | Behaviour -> "behaviour"
      | Clock -> "clock"
      | Itself -> "itself"
    in
    Printf.sprintf "%s of %s by %s" aspect m.leaves.(r.leaf).name (event m events.(r.cause))
  in
  Alcotest.check strings "of the bind" [ "behaviour of p by expiry(p)" ]
    (List.map text events.(2).reasons);
  Alcotest.check strings "of the fact" [ "structure of p by bind(a, p.right, q.left)" ]
    (List.map text x.basis.reasons);
  Alcotest.check strings "told" [ "bonds(a) = 1 holds: bonds(a) = 1" ] x.facts

(* {1 Random networks}

   Without the bodies that are left out, the last event happens at the same time in some run: found by looking
   at all runs, in another way than the one that left them out. *)

let without declared leaves =
  let stays (p : State.process) =
    not (Array.exists (fun (l : State.leaf) -> List.mem l.leaf leaves) p.leaves)
  in
  State.make
    ~processes:(List.filter stays (Array.to_list declared.State.processes))
    ~step:declared.step ~time:declared.time

(* [None] when there are too many runs to look at. *)
let some_run_has m start label time =
  let fuel = ref 20_000 in
  let rec look state now =
    decr fuel;
    !fuel > 0
    && List.exists
      (fun (t : Transition.t) ->
         let later = Rat.add now (Transition.duration t) in
         Rat.compare later time <= 0
         && ((Rat.equal later time && Transition.equal_label label t.label) || look t.target later))
      (successors m state)
  in
  let found = look start Rat.zero in
  if found then Some true else if !fuel <= 0 then None else Some false

let last (x : Omission.t) =
  Array.fold_left
    (fun found (e : Causes.event) ->
       match e.happening with
       | Discrete label -> Some (label, e)
       | Expiry _ -> found)
    None (Causes.events x.story)

let still_happens =
  QCheck2.Test.make ~count:300 ~name:"the last event happens without those that are left out"
    ~print:(fun (n, _) -> Random_network.print n)
    (Gen.pair (Random_network.generate ()) (Gen.int_range 1 6))
    (fun (network, time) ->
       let m = Random_network.model network and declared = Random_network.declared network in
       let story = Causes.tell (run_until m declared (Rat.of_int time)) in
       let x = Omission.explain story (Causes.of_last_event story) [] in
       match last x with
       | None -> true
       | Some (label, e) ->
         let start = Reach.initial m (without declared (List.concat x.left_out)) in
         some_run_has m start label e.time <> Some false)

let well_told =
  QCheck2.Test.make ~count:300 ~name:"reasons are earlier, and of those who take part"
    ~print:(fun (n, _) -> Random_network.print n)
    (Gen.pair (Random_network.generate ~steered:true ()) (Gen.int_range 1 4))
    (fun (network, time) ->
       let m = Random_network.model network and declared = Random_network.declared network in
       let events = Causes.events (Causes.tell (run_until m declared (Rat.of_int time))) in
       let good i (e : Causes.event) =
         List.for_all (fun (r : Causes.reason) -> r.cause < i && List.mem r.leaf e.leaves) e.reasons
       in
       List.for_all Fun.id (List.mapi good (Array.to_list events)))

let () =
  Alcotest.run "causes"
    [
      ("bystanders", bystanders);
      ("reactions", reactions @ [ case "reasons" reasons ]);
      ("random networks", Scc_test_support.Property.cases [ well_told; still_happens ]);
    ]
