(* The law Bisimilarity: how behaviours are written makes no difference to what happens. *)

open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_test_networks
module Gen = QCheck2.Gen

let standard = Scc_engine.Standard.of_model

(* {1 Two networks, side by side} *)

let discrete = List.filter (fun (t : Transition.t) -> not (Transition.is_time t.label))
let passing = List.find_opt (fun (t : Transition.t) -> Transition.is_time t.label)

let labels m ts =
  String.concat "; " (List.map (fun (t : Transition.t) -> Transition.label_to_string m t.label) ts)

(* After a time up to that of the state's own transition, or any if nothing is to come: with what is due then. *)
let advance m s own d =
  match own with
  | Some (t : Transition.t) when Rat.equal (Transition.duration t) d -> t.target
  | Some _ | None -> (
      match Steer.settle (standard m) (Time.pass (standard m) d s) with
      | Ok { state; _ } -> state
      | Error _ -> failwith "a law of motion could not be evaluated")

let alike s s' = State.equal (Rewriting.without_behaviours s) (Rewriting.without_behaviours s')

(* What tells two states apart, within some steps. The fuel bounds how many pairs are looked at altogether: beyond
   it they count as the same, and so do states of very long numbers. *)
let rec difference fuel steps (m, s) (m', s') =
  decr fuel;
  if not (alike s s') then Some "places, motions, bonds, clocks or steps differ"
  else if steps = 0 || !fuel < 0 || Rigid_reach.(bits s > longest) then None
  else
    let ts = Reach.successors m s and ts' = Reach.successors m' s' in
    let same (t : Transition.t) (t' : Transition.t) =
      Transition.equal_label t.label t'.label
      && Option.is_none (difference fuel (steps - 1) (m, t.target) (m', t'.target))
    in
    let one = discrete ts and other = discrete ts' in
    let answered = List.for_all (fun t -> List.exists (same t) other) one in
    if not (answered && List.for_all (fun t' -> List.exists (fun t -> same t t') one) other) then
      Some (Printf.sprintf "one may do %s, the other %s" (labels m one) (labels m' other))
    else in_time fuel steps (m, s, passing ts) (m', s', passing ts')

(* The two may cut time at different instants: they are looked at again at the earlier one. *)
and in_time fuel steps (m, s, own) (m', s', own') =
  match List.filter_map (Option.map Transition.duration) [ own; own' ] with
  | [] -> None
  | d :: rest ->
    let d = List.fold_left Rat.min d rest in
    difference fuel (steps - 1) (m, advance m s own d) (m', advance m' s' own' d)

let agree ?(fuel = 400) seed m declared =
  let m', declared' = Rewriting.model seed m declared in
  difference (ref fuel) 24 (m, Reach.initial m declared) (m', Reach.initial m' declared')

let falling = { Random_rigid.anything with laws = true; rounds = true }
let fail_on = function None -> true | Some why -> QCheck2.Test.fail_report why

(* {1 Random networks} *)

let rewritten name ~count networks =
  QCheck2.Test.make ~name ~count
    ~print:(fun (n, seed) -> Printf.sprintf "%s, seed %d" (Random_network.print n) seed)
    (Gen.pair networks Gen.(0 -- 1_000_000))
    (fun (network, seed) ->
       fail_on (agree seed (Random_network.model network) (Random_network.declared network)))

let turning name features =
  QCheck2.Test.make ~name ~count:4
    ~print:(fun (n, seed) -> Printf.sprintf "%s, seed %d" (Random_rigid.print n) seed)
    (Gen.pair (Random_rigid.generate features) Gen.(0 -- 1_000_000))
    (fun (network, seed) ->
       fail_on (agree ~fuel:20 seed (Random_rigid.model network) (Random_rigid.declared network)))

(* From a state that waits for nothing on the way of a passing of time: it stops there, and goes on to the end, but
   that it may be proved there already that nothing will ever happen. *)
let comes_to m part s (t : Transition.t) =
  let d = Transition.duration t in
  let there = Rewriting.waiting (Rat.mul part d) s in
  match Reach.successors m there |> passing with
  | Some first when Rat.equal (Transition.duration first) (Rat.mul part d) -> (
      match Reach.successors m first.target with
      | [ rest ] when Rat.equal (Transition.duration rest) (Rat.sub d (Rat.mul part d)) ->
        if alike rest.target t.target then None else Some "time that is cut leads elsewhere"
      | [] when Network.quiescent (standard m) first.target -> None
      | rest -> Some (Printf.sprintf "time that is cut goes on by %s" (labels m rest)))
  | Some _ | None -> Some "an eps that expires does not cut time"

let cut_short name features =
  QCheck2.Test.make ~name ~count:3
    ~print:(fun (n, _) -> Random_rigid.print n)
    (Gen.pair (Random_rigid.generate features) Gen.(1 -- 12))
    (fun (network, k) ->
       let m, states = Rigid_reach.reached network in
       let part = Rat.make (Z.of_int k) (Z.of_int 13) in
       let short (s, _) = Rigid_reach.(bits s <= longest) in
       let broken (s, ts) = Option.bind (passing ts) (comes_to m part s) in
       fail_on (List.find_map broken (List.filter short states)))

(* {1 The models of the project} *)

let folder = "../../../specs/models"

let models () =
  let names = List.filter (fun n -> Filename.check_suffix n ".sc") (Array.to_list (Sys.readdir folder)) in
  let tried = ref 0 in
  List.iter
    (fun name ->
       let e = Scc_test_models.Load.(exactly (file (Filename.concat folder name))) in
       let rigid = Option.is_some e.model.rigid in
       let fuel = if rigid then 20 else 400 in
       List.iter
         (fun seed ->
            incr tried;
            match agree ~fuel seed e.model e.declared with
            | None -> ()
            | Some why -> Alcotest.failf "%s, seed %d: %s" name seed why)
         (if rigid then [ 1; 2 ] else [ 1; 2; 3; 4; 5 ]))
    names;
  Alcotest.(check bool) "there are models" true (!tried > 50)

let suite =
  ("bisimilarity",
   [
     ( "Bisimilarity",
       Scc_test_support.Property.cases
         [
           rewritten "Bisimilarity: behaviours written in another way" ~count:30 (Random_network.generate ());
           rewritten "Bisimilarity: with laws of motion" ~count:30 (Random_network.generate ~steered:true ());
           rewritten "Bisimilarity: with the switches of a model" ~count:16
             (Random_network.switched ~steered:true ());
           turning "Bisimilarity: bodies that turn" Random_rigid.anything;
           turning "Bisimilarity: bodies that turn, with laws and rounding" falling;
           turning "Bisimilarity: bodies that turn, with the switches of a model"
             { falling with switched = true };
           cut_short "Bisimilarity: an eps that expires moves no contact of bodies that turn"
             Random_rigid.anything;
           cut_short "Bisimilarity: an eps that expires, with laws and rounding" falling;
         ]
       @ [ Alcotest.test_case "Bisimilarity: the models of the project" `Quick models ] );
   ])
