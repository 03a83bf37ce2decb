(* Laws that hold of every network, tried on random ones. *)

open Scc_exact
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
  property "Conservation: momentum and energy" (fun network ->
      let m, states = reached network in
      let broken (s, transitions) = List.find_map (Conservation.fault m s) transitions in
      fail_on (List.find_map broken states))

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
            preserves false "Preservation: no transition leaves the well-formed networks";
            preserves true "Preservation: under laws of motion";
            conserves;
          ] );
      ("far away", cases [ bystanders ]);
    ]
