(* Laws of the rule book about time and about what must and can happen, of random networks of both calculi. *)

open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_test_networks
module Gen = QCheck2.Gen

let standard = Scc_engine.Standard.of_model
let rational n d = Rat.make (Z.of_int n) (Z.of_int d)
let say = Printf.sprintf
let fail_on = function None -> true | Some why -> QCheck2.Test.fail_report why

(* {1 Networks} *)

let states_per_network = 60

(* The law at each state, with its transitions; and a part of the time that passes. *)
let steered = Random_network.generate ~steered:true ()
let switched = Random_network.switched ~steered:true ()

let straight name ?(count = 50) ?(networks = steered) law =
  QCheck2.Test.make ~name ~count
    ~print:(fun (n, _) -> Random_network.print n)
    (Gen.pair networks Gen.(1 -- 12))
    (fun (network, k) ->
       let m, start = Random_network.start network in
       let states = Reach.states m start ~limit:states_per_network in
       fail_on (List.find_map (law m (rational k 13)) states))

let turning name ?(count = 3) features law =
  QCheck2.Test.make ~name ~count
    ~print:(fun (n, _) -> Random_rigid.print n)
    (Gen.pair (Random_rigid.generate features) Gen.(1 -- 12))
    (fun (network, k) ->
       let m, states = Rigid_reach.reached network in
       let short (s, _) = Rigid_reach.bits s <= Rigid_reach.longest in
       fail_on (List.find_map (law m (rational k 13)) (List.filter short states)))

let falling = { Random_rigid.anything with laws = true; rounds = true }
let falling_switched = { falling with switched = true }

let passes_time (s, transitions) =
  List.filter_map
    (fun (t : Transition.t) ->
       match t.label with
       | Time d -> Some (s, d, t)
       | Bind _ | Close _ | Bounce _ | Absorb _ | Weak_split _ | Strong_split _ | Draw _ | Lot _ -> None)
    transitions

(* {1 TimeDeterminism} *)

let deterministic _ _ state =
  match passes_time state with
  | [] | [ _ ] -> None
  | _ -> Some "time passes in two ways"

(* {1 TimeAdditivity} *)

(* Of states that differ in nothing but in how the passing of time was divided. *)
let additive m part state =
  List.find_map
    (fun (s, d, _) ->
       let first = Rat.mul part d in
       let midway = Time.pass (standard m) first s in
       let again = Time.pass (standard m) (Rat.sub d first) midway in
       if State.equal again (Time.pass (standard m) d s) then None else Some "two passings are not one")
    (passes_time state)

(* {1 TimeContinuity} *)

let one_time_to m target rest (t : Transition.t) =
  match t.label with
  | Time d when Rat.equal d rest -> State.equal t.target target
  | label -> failwith (say "midway %s" (Transition.label_to_string m label))

(* Midway nothing is possible but the rest of the time, to the same state; or, where bodies turn, it is proved
   there already that nothing will ever happen. *)
let continuous m part state =
  List.find_map
    (fun (s, d, (t : Transition.t)) ->
       let first = Rat.mul part d in
       let midway = Time.pass (standard m) first s in
       match Network.successors (standard m) midway with
       | Ok [ u ] when one_time_to m t.target (Rat.sub d first) u -> None
       | Ok [] when Network.quiescent (standard m) midway -> None
       | Ok ts -> Some (say "midway %d transitions" (List.length ts))
       | Error _ -> Some "midway a fault")
    (passes_time state)

(* {1 Urgency} *)

let is_urgent (t : Transition.t) =
  match t.label with
  | Strong_split _ | Bind _ | Close _ | Bounce _ | Absorb _ | Draw _ | Lot _ -> true
  | Weak_split _ | Time _ -> false

let urgent m _ (s, transitions) =
  let times = List.length (passes_time (s, transitions)) in
  let quiescent = Network.quiescent (standard m) s in
  if List.exists is_urgent transitions || Lots.pending s then
    if times > 0 then Some "time passes while something urgent is possible" else None
  else if quiescent && times > 0 then Some "time passes to an event that never comes"
  else if (not quiescent) && times = 0 && transitions <> [] then Some "a weak split holds time up"
  else None

(* {1 Progress} *)

let progresses m _ (s, _) =
  match Network.successors (standard m) s with
  | Error (Persistent_contact firsts) ->
    let together = List.sort Int.compare firsts in
    let first i = s.processes.(i).leaves.(0).leaf in
    let meets (e : Kinematics.meeting) =
      List.equal Int.equal (List.sort Int.compare [ first e.first; first e.second ]) together
    in
    if Option.is_none m.Model.rigid then Some "a persistent contact in translation"
    else if List.exists meets (Collisions.meetings (standard m) s.processes) then None
    else Some "a persistent contact of what does not collide"
  | Error (Bad_chance _) -> Some "chances sum to more than 1"
  | Error (Bad_law _) -> Some "a law of motion cannot be evaluated"
  | Ok [] when not (Network.quiescent (standard m) s) -> Some "nothing is possible, and it is not the end"
  | Ok ts ->
    let lasts (t : Transition.t) = Rat.sign (Transition.duration t) > 0 in
    if List.exists (fun (t : Transition.t) -> not (Bool.equal (Transition.is_time t.label) (lasts t))) ts then
      Some "time passes by nothing, or backwards"
    else None

let suite =
  let group name tests = (name, Scc_test_support.Property.cases tests) in
  ("time laws",
   [
     group "TimeDeterminism"
       [
         straight "TimeDeterminism: at most one passing of time" deterministic;
         turning "TimeDeterminism: bodies that turn, with laws and rounding" falling deterministic;
         straight "TimeDeterminism: with the switches of a model" ~count:12 ~networks:switched deterministic;
         turning "TimeDeterminism: bodies that turn, with the switches of a model" falling_switched deterministic;
       ];
     group "TimeAdditivity"
       [
         straight "TimeAdditivity: two passings of time are one" additive;
         turning "TimeAdditivity: of bodies that turn" falling additive;
         straight "TimeAdditivity: with rounding" ~count:12 ~networks:(Random_network.rounding ()) additive;
         straight "TimeAdditivity: with the switches of a model" ~count:12 ~networks:switched additive;
         turning "TimeAdditivity: bodies that turn, with the switches of a model" falling_switched additive;
       ];
     group "TimeContinuity"
       [
         straight "TimeContinuity: midway there is the rest of the time, and nothing else" continuous;
         turning "TimeContinuity: of bodies that turn, with laws and rounding" ~count:5 falling continuous;
         straight "TimeContinuity: with the switches of a model" ~count:12 ~networks:switched continuous;
         turning "TimeContinuity: bodies that turn, with the switches of a model" falling_switched continuous;
       ];
     group "Urgency"
       [
         straight "Urgency: time passes iff nothing urgent is possible" urgent;
         turning "Urgency: bodies that turn" falling urgent;
         straight "Urgency: with the switches of a model" ~count:12 ~networks:switched urgent;
         turning "Urgency: bodies that turn, with the switches of a model" falling_switched urgent;
       ];
     group "Progress"
       [
         straight "Progress: each state acts, lets time pass, or is quiescent" progresses;
         turning "Progress: so do bodies that turn, or they are in persistent contact" falling progresses;
         straight "Progress: with the switches of a model" ~count:12 ~networks:switched progresses;
         turning "Progress: bodies that turn, with the switches of a model" falling_switched progresses;
       ];
   ])
