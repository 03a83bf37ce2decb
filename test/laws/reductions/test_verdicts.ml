(* Verdicts on random crowds do not depend on how a model is written down. *)

open Scc_semantics
open Scc_exact
open Scc_verify
open Scc_zones
module Gen = QCheck2.Gen

let standard = Scc_engine.Standard.of_model

(* {1 Other names and another order} *)

let is_letter = function 'a' .. 'z' | 'A' .. 'Z' | '_' | '0' .. '9' -> true | _ -> false

(* p0, p1, ... become other names, whose order is another one. *)
let renamed text =
  let n = String.length text in
  let buffer = Buffer.create n in
  for i = 0 to n - 1 do
    let starts = i = 0 || not (is_letter text.[i - 1]) in
    let numbered = i + 1 < n && text.[i + 1] >= '0' && text.[i + 1] <= '9' in
    if text.[i] = 'p' && starts && numbered then
      Buffer.add_string buffer (Printf.sprintf "body_%c_" (Char.chr (Char.code 'z' - Char.code text.[i + 1])))
    else Buffer.add_char buffer text.[i]
  done;
  Buffer.contents buffer

let declares line = String.length line > 8 && String.equal (String.sub line 0 8) "process "

(* The processes in the order that the keys say. *)
let reordered keys text =
  let lines = String.split_on_char '\n' text in
  let key i line = ((List.nth keys (i mod List.length keys), i), line) in
  let keyed = List.mapi key (List.filter declares lines) in
  let moved = List.map snd (List.sort Stdlib.compare keyed) in
  let place (left, found) line =
    match left with
    | next :: left when declares line -> (left, next :: found)
    | _ -> (left, line :: found)
  in
  String.concat "\n" (List.rev (snd (List.fold_left place (moved, []) lines)))

(* {1 The comparison} *)

let bounds = { Bounds.default with states = Default 2000; time = Given (Rat.of_int 12); instant = Default 60 }

let checked model declared checks =
  match Network.initial (standard model) declared with
  | Error _ -> None
  | Ok initial ->
    let options = { Setup.default with bounds; reductions = [ Scc_state_space.Reduction.Jump ] } in
    Some (Check.run options (standard model) ~initial checks)

let report text =
  match Scc_test_models.Load.text text with
  | Error _ -> None
  | Ok e -> checked e.model e.declared e.checks

let definite (v : Verdict.t) =
  match v with
  | Holds { bounds = []; _ } -> Some true
  | Violated _ -> Some false
  | Holds _ | Measured _ | Depends _ | Undecided _ -> None

let in_full (r : Check.report) = r.stats.complete && not r.stats.decided_early

let same (a : Check.report) (b : Check.report) =
  let differ (x : Verdict.outcome) (y : Verdict.outcome) =
    match (x.verdict, y.verdict) with
    | Measured x, Measured y -> x.reasons = [] && y.reasons = [] && x.values <> y.values
    | v, w -> (
        match (definite v, definite w) with
        | Some x, Some y -> not (Bool.equal x y)
        | None, _ | _, None -> false)
  in
  if List.exists2 differ a.outcomes b.outcomes then QCheck2.Test.fail_report "verdicts differ"
  else if in_full a && in_full b && a.stats.states <> b.stats.states then
    QCheck2.Test.fail_reportf "%d states, and %d" a.stats.states b.stats.states
  else true

let compared = ref 0

let congruent =
  QCheck2.Test.make ~name:"Congruence: verdicts, and how many states there are" ~count:150 ~print:fst
    (Gen.pair Crowds.case_gen Gen.(list_repeat 8 (0 -- 100)))
    (fun (text, keys) ->
       match (report text, report (reordered keys (renamed text))) with
       | Some a, Some b ->
         if in_full a && in_full b then incr compared;
         same a b
       | None, None -> true
       | Some _, None | None, Some _ -> QCheck2.Test.fail_report "one of the two is refused")

(* {1 Other behaviours, bisimilar to those that were there} *)

(* Only `behaviour(p) = K` sees how a behaviour is written. *)
let blind (c : Scc_property.Property.check) =
  let definition = function Scc_property.Atom.Definition _ -> true | _ -> false in
  let sees (a : Scc_property.Atom.t) = List.exists definition a.arguments in
  not (List.exists sees (Scc_property.Formula.atoms c.formula))

let decided = ref 0

let bisimilar seed (e : Scc_elaborate.Elaborate.t) =
  let model, declared = Scc_test_networks.Rewriting.model seed e.model e.declared in
  let checks = List.filter blind e.checks in
  match (checked e.model e.declared checks, checked model declared checks) with
  | Some a, Some b ->
    let both (x : Verdict.outcome) (y : Verdict.outcome) =
      Option.is_some (definite x.verdict) && Option.is_some (definite y.verdict)
    in
    if a.outcomes <> [] && List.for_all2 both a.outcomes b.outcomes then incr decided;
    List.for_all2
      (fun (x : Verdict.outcome) (y : Verdict.outcome) ->
         (not (both x y)) || Option.equal Bool.equal (definite x.verdict) (definite y.verdict))
      a.outcomes b.outcomes
  | None, None -> true
  | Some _, None | None, Some _ -> false

let rewritten =
  QCheck2.Test.make ~name:"Bisimilarity: verdicts on random crowds" ~count:100 ~print:fst
    (Gen.pair Crowds.case_gen Gen.(0 -- 1_000_000)) (fun (text, seed) ->
        match Scc_test_models.Load.text text with
        | Error _ -> true
        | Ok e -> bisimilar seed e)

let folder = "../../../specs/models"

let rewritten_models () =
  Sys.readdir folder |> Array.to_list |> List.sort String.compare
  |> List.filter (fun name -> Filename.check_suffix name ".sc")
  |> List.iter (fun name ->
      let e = Scc_test_models.Load.(exactly (file (Filename.concat folder name))) in
      let ordinary = Option.is_none e.model.rigid && not (Zone_check.is_for e.model ~declared:e.declared) in
      if ordinary && not (bisimilar 7 e) then Alcotest.failf "%s: verdicts differ" name);
  Alcotest.(check bool) "many are decided" true (!decided > 30)

let enough () = Alcotest.(check bool) "many are explored in full" true (!compared > 50)

let () =
  let case name f = Alcotest.test_case name `Quick f in
  Alcotest.run "verdicts"
    [
      ("Congruence", Scc_test_support.Property.cases [ congruent ] @ [ case "enough is explored" enough ]);
      ( "Bisimilarity",
        Scc_test_support.Property.cases [ rewritten ]
        @ [ case "Bisimilarity: verdicts on the models of the project" rewritten_models ] );
    ]
