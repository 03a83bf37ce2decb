(* Laws that hold of every network, tried on random ones. *)

open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_test_networks
module Gen = QCheck2.Gen

let standard = Scc_engine.Standard.of_model

let states_per_network = 60

let reached network =
  let m, start = Random_network.start network in
  (m, Reach.states m start ~limit:states_per_network)

let property name ?(count = 300) ?(networks = Random_network.generate ()) holds =
  QCheck2.Test.make ~name ~count ~print:Random_network.print networks holds

let fail_on = function None -> true | Some why -> QCheck2.Test.fail_report why

let well_formed m (s, _) =
  match Well_formed.check (standard m) s with
  | [] -> None
  | fault :: _ -> Some (Well_formed.to_string m s fault)

let preserves ?count networks name =
  property name ?count ~networks (fun network ->
      let m, states = reached network in
      fail_on (List.find_map (well_formed m) states))

let conserves ?count networks name =
  property name ?count ~networks (fun network ->
      let m, states = reached network in
      let broken (s, transitions) = List.find_map (Conservation.fault m s) transitions in
      fail_on (List.find_map broken states))

let meetings m (s : State.t) = Collisions.meetings (standard m) s.processes
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

(* So that the properties above are about something: over the seeds used, every kind of transition comes up. With
   switches: bounces of several processes at once, and bindings where nothing collides. *)
(* Whether what a split releases held a ring: it comes apart into no more pieces than there were bonds. *)
let opens_ring (t : Transition.t) =
  let bonds = Transition.bonds t.label in
  let home at = (Option.get (State.home t.target at)).leaves.(0).leaf in
  let pieces (b : State.bond) = [ home b.one.at; home b.two.at ] in
  List.length (List.sort_uniq Int.compare (List.concat_map pieces bonds)) <= List.length bonds

let kinds m (s, ts) =
  let apart = lazy (not (List.exists (fun (e : Kinematics.meeting) -> e.collide) (meetings m s))) in
  let kind (t : Transition.t) =
    match t.label with
    | Time _ -> "time"
    | Bind _ when Lazy.force apart -> "bind, by contact"
    | Bind _ -> "bind"
    | Close _ -> "close"
    | Bounce { firsts; _ } -> if List.compare_length_with firsts 2 > 0 then "bounce, of several" else "bounce"
    | Weak_split _ when opens_ring t -> "weak, of a ring"
    | Absorb _ -> "absorb"
    | Draw _ -> "draw"
    | Lot { decision; _ } -> Transition.decision_to_string decision
    | Weak_split _ -> "weak"
    | Strong_split _ when opens_ring t -> "strong, of a ring"
    | Strong_split _ -> "strong"
  in
  List.map kind ts

(* As many networks as it takes: which ones are drawn differs between versions of the standard library. *)
let varied networks expected () =
  let rand = Random.State.make [| 42 |] in
  let seen n = let m, states = reached n in List.concat_map (kinds m) states in
  let rec from n found =
    let found = List.sort_uniq String.compare (seen (QCheck2.Gen.generate1 ~rand networks) @ found) in
    if n >= 2000 || (n >= 100 && List.compare_lengths found expected >= 0) then found else from (n + 1) found
  in
  Alcotest.(check (list string)) "kinds of transitions" expected (from 1 [])

let suite =
  let cases = Scc_test_support.Property.cases in
  let any = Random_network.generate () and switched = Random_network.switched () in
  let absorbing = Random_network.absorbing () in
  let steered = Random_network.generate ~steered:true () in
  let drawing = Gen.map (Random_network.with_switches Switches.drawing) steered in
  let all = [ "bind"; "bounce"; "strong"; "time"; "weak" ] in
  let rings = [ "close"; "strong, of a ring"; "weak, of a ring" ] and lots = [ "first"; "keep"; "release" ] in
  let more = "absorb" :: "bind, by contact" :: "bounce, of several" :: (lots @ rings) in
  let more = List.sort String.compare (more @ all) in
  ("random networks",
   [
     ( "scope",
       [
         Alcotest.test_case "every kind of transition comes up" `Quick (varied any all);
         Alcotest.test_case "absorption, too" `Quick (varied absorbing ("absorb" :: all));
         Alcotest.test_case "draws, too" `Quick
           (varied drawing [ "bind"; "bounce"; "draw"; "strong"; "time"; "weak" ]);
         Alcotest.test_case "with switches, too" `Quick (varied switched more);
       ] );
     ( "laws",
       cases
         [
           preserves any "Preservation: no transition leaves the well-formed networks";
           preserves
             (Random_network.generate ~steered:true ())
             "Preservation: under laws of motion";
           preserves (Random_network.rounding ()) "Preservation: with rounding";
           preserves ~count:150
             (Random_network.switched ~steered:true ())
             "Preservation: with the switches of a model";
           preserves absorbing "Preservation: where some are absorbed";
           conserves absorbing "Conservation: where some are absorbed";
           conserves any "Conservation: momentum and energy";
           conserves ~count:150 switched "Conservation: with the switches of a model";
         ] );
     ("far away", cases [ bystanders ]);
   ])
