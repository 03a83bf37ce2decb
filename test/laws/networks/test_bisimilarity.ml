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

(* After a time up to that of the state's own transition, or any if nothing is to come. *)
let advance m s own d =
  match own with
  | Some (t : Transition.t) when Rat.equal (Transition.duration t) d -> t.target
  | Some _ | None -> Time.pass (standard m) d s

let alike s s' = State.equal (Rewriting.without_behaviours s) (Rewriting.without_behaviours s')

(* What tells two states apart, within some steps. The fuel bounds how many pairs are looked at altogether: beyond
   it they count as the same. *)
let rec difference fuel steps (m, s) (m', s') =
  decr fuel;
  if not (alike s s') then Some "places, motions, bonds, clocks or steps differ"
  else if steps = 0 || !fuel < 0 then None
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

let agree seed m declared =
  let m', declared' = Rewriting.model seed m declared in
  difference (ref 400) 24 (m, Reach.initial m declared) (m', Reach.initial m' declared')

let fail_on = function None -> true | Some why -> QCheck2.Test.fail_report why

(* {1 Random networks} *)

let rewritten steered name =
  QCheck2.Test.make ~name ~count:250
    ~print:(fun (n, seed) -> Printf.sprintf "%s, seed %d" (Random_network.print n) seed)
    (Gen.pair (Random_network.generate ~steered ()) Gen.(0 -- 1_000_000))
    (fun (network, seed) ->
       fail_on (agree seed (Random_network.model network) (Random_network.declared network)))

(* {1 The models of the project} *)

let folder = "../../../specs/models"

let models () =
  let names = List.filter (fun n -> Filename.check_suffix n ".sc") (Array.to_list (Sys.readdir folder)) in
  let tried = ref 0 in
  List.iter
    (fun name ->
       let e = Scc_test_models.Load.(exactly (file (Filename.concat folder name))) in
       if Option.is_none e.model.rigid then
         List.iter
           (fun seed ->
              incr tried;
              match agree seed e.model e.declared with
              | None -> ()
              | Some why -> Alcotest.failf "%s, seed %d: %s" name seed why)
           [ 1; 2; 3; 4; 5 ])
    names;
  Alcotest.(check bool) "there are models" true (!tried > 50)

let () =
  Alcotest.run "bisimilarity"
    [
      ( "Bisimilarity",
        Scc_test_support.Property.cases
          [
            rewritten false "Bisimilarity: behaviours written in another way";
            rewritten true "Bisimilarity: with laws of motion";
          ]
        @ [ Alcotest.test_case "Bisimilarity: the models of the project" `Quick models ] );
    ]
