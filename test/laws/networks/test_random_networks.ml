(* Laws that hold of every network, tried on random ones. *)

open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_test_networks

let standard = Scc_engine.Standard.of_model

let states_per_network = 60

let reached network =
  let m, start = Random_network.start network in
  (m, Reach.states m start ~limit:states_per_network)

let property name ?(count = 400) ?steered holds =
  QCheck2.Test.make ~name ~count ~print:Random_network.print (Random_network.generate ?steered ()) holds

let fail_on = function None -> true | Some why -> QCheck2.Test.fail_report why

let well_formed m (s, _) =
  match Well_formed.check (standard m) s with
  | [] -> None
  | fault :: _ -> Some (Well_formed.to_string m s fault)

let preserves steered name =
  property name ~steered (fun network ->
      let m, states = reached network in
      fail_on (List.find_map (well_formed m) states))

let conserves =
  property "transitions conserve momentum and energy" (fun network ->
      let m, states = reached network in
      let broken (s, transitions) = List.find_map (Conservation.fault m s) transitions in
      fail_on (List.find_map broken states))

let is_time (t : Transition.t) = match t.label with Time _ -> true | _ -> false

let deterministic =
  property "TimeDeterminism: at most one passing of time, to one state" ~steered:true (fun network ->
      let _, states = reached network in
      List.for_all (fun (_, ts) -> List.length (List.filter is_time ts) <= 1) states)

(* Where time d may pass at once, it may pass in two goes to the same state. *)
let additive =
  property "Time is additive" ~steered:true (fun network ->
      let m, states = reached network in
      let part = Rat.make (Z.of_int 2) (Z.of_int 7) in
      let holds s (t : Transition.t) =
        match t.label with
        | Time d ->
          let first = Rat.mul part d in
          let midway = Time.pass (standard m) first s in
          let rest = Rat.sub d first in
          Option.equal Rat.equal (Time.delay (standard m) midway) (Some rest)
          && State.equal (Time.pass (standard m) rest midway) (Time.pass (standard m) d s)
        | Bind _ | Bounce _ | Weak_split _ | Strong_split _ -> true
      in
      List.for_all (fun (s, ts) -> List.for_all (holds s) ts) states)

let invariant ?steered name symmetry_of =
  property name ?steered (fun network ->
      let m, states = reached network in
      fail_on (Symmetry.broken (symmetry_of m) m states))

let translated =
  invariant "nothing depends on where the network is" (fun _ ->
      Symmetry.translation (Vec.make (Rat.of_int 5) (Rat.make Z.one (Z.of_int 3)) (Rat.of_int (-7))))

let reversed m =
  let n = Array.length m.Model.leaves in
  Symmetry.permutation (Array.init n (fun i -> n - 1 - i))

let shifted m =
  let n = Array.length m.Model.leaves in
  Symmetry.permutation (Array.init n (fun i -> (i + 1) mod n))

let turned =
  property "nothing depends on how the network is turned" ~count:80 (fun network ->
      let m, states = reached network in
      fail_on (List.find_map (fun r -> Symmetry.broken r m states) Symmetry.rotations))

let labels m ts = List.map (fun (t : Transition.t) -> Transition.label_to_string m t.label) ts

(* Along one run, taken first with and then without sixteen bodies far away. *)
let bystanders =
  property "bodies that are far away change nothing" ~count:60 (fun network ->
      let m, s = Random_network.start network in
      let m', s' = Random_network.start (Random_network.with_bystanders network) in
      let soon (t : Transition.t) = Rat.compare (Transition.duration t) (Rat.of_int 1_000) < 0 in
      let rec agree n s s' =
        let ts = List.filter soon (Reach.successors m s)
        and ts' = List.filter soon (Reach.successors m' s') in
        if not (List.equal String.equal (labels m ts) (labels m' ts')) then
          QCheck2.Test.fail_reportf "%s, but %s with bystanders"
            (String.concat "; " (labels m ts))
            (String.concat "; " (labels m' ts'))
        else
          match (ts, ts') with
          | t :: _, t' :: _ when n > 0 -> agree (n - 1) t.target t'.target
          | _ -> true
      in
      agree 20 s s')

(* So that the properties above are about something: over the seeds used, every kind of transition comes up. *)
let varied () =
  let rand = Random.State.make [| 42 |] in
  let networks = QCheck2.Gen.generate ~rand ~n:100 (Random_network.generate ()) in
  let kind (t : Transition.t) =
    match t.label with
    | Time _ -> "time"
    | Bind _ -> "bind"
    | Bounce _ -> "bounce"
    | Weak_split _ -> "weak"
    | Strong_split _ -> "strong"
  in
  let seen =
    List.concat_map (fun n -> List.concat_map (fun (_, ts) -> List.map kind ts) (snd (reached n))) networks
  in
  Alcotest.(check (list string))
    "kinds of transitions"
    [ "bind"; "bounce"; "strong"; "time"; "weak" ]
    (List.sort_uniq String.compare seen)

let () =
  let cases = Scc_test_support.Property.cases in
  Alcotest.run "random networks"
    [
      ("scope", [ Alcotest.test_case "every kind of transition comes up" `Quick varied ]);
      ( "laws",
        cases
          [
            preserves false "transitions preserve well-formedness";
            preserves true "so they do under laws of motion";
            conserves;
            deterministic;
            additive;
          ] );
      ( "symmetries",
        cases
          [
            translated;
            invariant ~steered:true "parallel components in reverse order" reversed;
            invariant ~steered:true "parallel components in another order" shifted;
            turned;
            bystanders;
          ] );
    ]
