(* Verdicts on random crowds do not depend on how a model is written down. *)

open Scc_semantics
open Scc_exact
open Scc_verify
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

let report text =
  match Scc_test_models.Load.text text with
  | Error _ -> None
  | Ok e -> (
      match Network.initial (standard e.model) e.declared with
      | Error _ -> None
      | Ok initial ->
        let options = { Check.default with bounds; reductions = [ Scc_space.Reduction.Jump ] } in
        Some (Check.run options (standard e.model) ~initial e.checks))

let definite (v : Verdict.t) =
  match v with
  | Holds { bounds = []; _ } -> Some true
  | Violated _ -> Some false
  | Holds _ | Undecided _ -> None

let in_full (r : Check.report) = r.stats.complete && not r.stats.decided_early

let same (a : Check.report) (b : Check.report) =
  let differ (x : Verdict.outcome) (y : Verdict.outcome) =
    match (definite x.verdict, definite y.verdict) with
    | Some x, Some y -> not (Bool.equal x y)
    | None, _ | _, None -> false
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

let enough () = Alcotest.(check bool) "many are explored in full" true (!compared > 50)

let () =
  let cases = Scc_test_support.Property.cases [ congruent ] in
  Alcotest.run "verdicts" [ ("Congruence", cases @ [ Alcotest.test_case "enough is explored" `Quick enough ]) ]
