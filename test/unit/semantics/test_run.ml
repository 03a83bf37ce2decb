(* Runs under laws of motion, as they are made fast, against the rules alone, step by step and by brute force. *)

open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_engine
open Scc_test_networks
module Gen = QCheck2.Gen

let label m l = Transition.label_to_string m l
let told m l rules = label m l ^ " by " ^ String.concat ", " (List.map Rule.id rules)
let texts m labels = String.concat "; " (List.map (label m) labels)

let constant n =
  let const n = Law.Const (Rat.make (Z.of_int n) (Z.of_int 2)) in
  let kick (x, y, z) weight =
    { Law.motion = Law.velocity_alone (const x, const y, const z); weight = const weight }
  in
  Law.Choose [ kick (2, 0, 0) 2; kick (-1, n, 0) 1; kick (0, -2, 1) 3; kick (2, 0, 0) 1; kick (0, 0, -1) 0 ]

(* Every second body that draws does so among velocities that are always the same, some by one and the same law. *)
let with_constant_laws (m : Model.t) =
  let shared = constant 0 in
  let law i (l : Model.leaf) =
    if i mod 2 = 0 && Law.draws l.law then { l with law = (if i mod 3 = 0 then shared else constant i) } else l
  in
  { m with leaves = Array.mapi law m.leaves }

(* Whoever answers for the laws of this model has been asked about those of another one. *)
let standard m =
  let other = Standard.of_model m in
  let still = { Given.velocity = Vec.zero; spin = None } in
  let ask i (l : Model.leaf) =
    if Law.draws l.law then ignore (other.setting.laws i (constant 7) (fun () -> Ok [ (still, Rat.one) ]))
  in
  Array.iteri ask m.leaves;
  Semantics.with_model other m

(* The labels in their order, or why there are none; the rules of what was taken; the states between. [looks] says
   before which steps to look at the state, since looking must not matter. *)
let follow (m : Model.t) declared choices ~looks =
  let plain = Semantics.make m in
  let differ step what expected offered =
    QCheck2.Test.fail_reportf "step %d, %s: %s\nbut in the run: %s" step what expected offered
  in
  let fault f = (Transition.diagnostic m f).message in
  let rec from run step s = function
    | [] -> true
    | choice :: choices -> (
        if looks step && not (State.equal s (Run.state run)) then differ step "the state" "one" "another";
        match (Network.successors plain s, Result.map Run.list (Run.labels run)) with
        | Error f, Error g -> String.equal (fault f) (fault g) || differ step "a fault" (fault f) (fault g)
        | Error f, Ok labels -> differ step "a fault" (fault f) (texts m labels)
        | Ok transitions, Error g ->
          differ step "no fault" (texts m (List.map (fun (t : Transition.t) -> t.label) transitions)) (fault g)
        | Ok transitions, Ok labels ->
          let expected = List.map (fun (t : Transition.t) -> t.label) transitions in
          if not (List.equal Transition.equal_label expected labels) then
            differ step "what is possible" (texts m expected) (texts m labels)
          else if transitions = [] then true
          else
            let i = choice mod List.length transitions in
            let t = List.nth transitions i in
            let taken = Run.take run i in
            let expected = told m t.label t.rules and offered = told m taken.label taken.rules in
            let rounds = Bool.equal (Option.is_some t.rounded) (Option.is_some taken.rounded) in
            if not (String.equal expected offered && rounds) then differ step "taken" expected offered
            else from run (step + 1) t.target choices)
  in
  match (Network.initial plain declared, Run.start (standard m) declared) with
  | Ok s, Ok run -> from run 0 s choices
  | Error f, Error g -> String.equal (fault f) (fault g)
  | Ok _, Error g -> differ 0 "the start" "no fault" (fault g)
  | Error f, Ok _ -> differ 0 "the start" (fault f) "no fault"

let always _ = true
let seldom step = step mod 7 = 6
let choices length = Gen.list_size (Gen.pure length) Gen.nat

let property name ~count ~steps ?(adapt = Fun.id) ?(looks = always) (print, model, declared) networks =
  let print (network, choices) =
    print network ^ "\nchoices " ^ String.concat " " (List.map string_of_int choices)
  in
  QCheck2.Test.make ~name ~count ~print (Gen.pair networks (choices steps)) (fun (network, choices) ->
      follow (adapt (model network)) (declared network) choices ~looks)

let translational = (Random_network.print, Random_network.model, Random_network.declared)
let steered = Random_network.switched ~steered:true ()

let small = property "small networks" ~count:30 ~steps:30 translational steered
let by_constants =
  property "laws that never change" ~count:30 ~steps:30 ~adapt:with_constant_laws translational steered

let unseen =
  property "whether the states are looked at or not" ~count:20 ~steps:40 ~adapt:with_constant_laws ~looks:seldom
    translational steered

(* So many bodies that neighbours are looked for in other ways. *)
let many =
  property "with bodies far away" ~count:13 ~steps:40 ~adapt:with_constant_laws translational
    (Gen.map Random_network.with_bystanders steered)

let rounding =
  property "velocities that are rounded" ~count:40 ~steps:30 ~adapt:(fun m -> { m with round_velocity = Some 1 })
    translational steered

let turning =
  property "bodies that turn" ~count:10 ~steps:20 ~adapt:with_constant_laws
    (Random_rigid.print, Random_rigid.model, Random_rigid.declared)
    (Random_rigid.generate { Random_rigid.anything with laws = true; switched = true; rounds = true })

let suite =
  ("runs under laws",
   [ ("as the rules", Scc_test_support.Property.cases [ small; by_constants; unseen; many; rounding; turning ]) ])
