(* Rule Settling: an exploration that ends as soon as all that is asked is settled gives the answers of one that
   goes on to its end. The latter reduces nothing, hides what is said of the time in a choice of which nothing is
   known, and has a check that is never settled. *)

open Scc_semantics
open Scc_verify
open Scc_test_models
module Gen = QCheck2.Gen
module Told = Told_otherwise

(* {1 Questions} *)

(* How a question speaks of the time, and the bound of its operators. *)
type way = { time : string; within : string }

let plain = { time = "time"; within = "" }
let hidden = { time = "(if processes > 0 then time else time)"; within = "" }

(* As long as all of the goals are settled by then. *)
let bounded = { hidden with within = "[<= 8]" }

type text = way -> string

(* [bounded]: nothing after some time matters. *)
type question = { text : text; is_bounded : bool }

let told f words = fun way -> Printf.sprintf f (words way)
let told2 f one two = fun way -> Printf.sprintf f (one way) (two way)
let compared op k w = Printf.sprintf "%s %s %s" w.time op k
let instant = Gen.oneofl [ "0"; "1/2"; "1"; "3/2"; "2"; "5/2" ]
let late : text Gen.t = Gen.map2 compared (Gen.oneofl [ ">"; ">=" ]) instant
let early : text Gen.t = Gen.map2 compared (Gen.oneofl [ "<"; "<="; "=" ]) instant

let fact atoms : text Gen.t = Gen.map (fun f _ -> Told.formula Told.as_it_is f) (Told.formula_of atoms)

let goals atoms =
  let open Gen in
  let p = fact atoms in
  let both f = map2 (told2 f) in
  frequency
    [ (2, late); (4, both "(%s and %s)" p early); (2, both "(%s or %s)" p late);
      (1, both "(not %s and %s)" early late); (1, both "(%s and not (%s))" p late) ]

(* What all of a run satisfies, or what is asked in a state. *)
let safe atoms =
  let open Gen in
  let p = fact atoms in
  let both f = map2 (told2 f) in
  frequency [ (1, early); (3, both "(%s or %s)" p late); (2, both "(%s => %s)" early p); (1, p) ]

let operator atoms goal =
  let open Gen in
  let op f = map (fun text w -> Printf.sprintf f w.within (text w)) in
  let until f left = map2 (fun a b w -> Printf.sprintf f (a w) w.within (b w)) left in
  oneof
    [
      op "EF%s (%s)" goal; op "AF%s (%s)" goal; op "AG%s (%s)" (safe atoms); op "EG%s (%s)" (safe atoms);
      until "E[%s U%s %s]" (safe atoms) goal; until "A[%s U%s %s]" (safe atoms) goal;
      op "P > 1/3 [ eventually%s %s ]" goal; op "P <= 1/2 [ eventually%s %s ]" goal;
    ]

let next atoms =
  let open Gen in
  let p = fact atoms in
  let x f text = map (told f) text in
  oneof [ x "EX (%s)" p; x "AX (%s)" p; x "EX EX (%s)" p; x "EX AX (%s)" p ]

let nested atoms =
  let open Gen in
  let inner = oneof [ operator atoms (goals atoms); next atoms ] in
  let both f = map2 (told2 f) in
  operator atoms (oneof [ both "(%s and %s)" early inner; both "(%s and not %s)" inner late ])

let asked atoms =
  let open Gen in
  let free text = map (fun text -> { text; is_bounded = false }) text in
  let ends text = map (fun text -> { text; is_bounded = true }) text in
  let goal = goals atoms and p = fact atoms in
  let op f = map (fun text w -> Printf.sprintf f w.within (text w)) in
  let until f left = map2 (fun a b w -> Printf.sprintf f (a w) w.within (b w)) left in
  frequency
    [
      (3, free (map (told "E = ? [ event weak U %s ]") goal)); (2, free (map (told "E = ? [ time U %s ]") goal));
      (1, free (map (told "E <= 3/2 [ time U %s ]") goal)); (1, free (map (told "E = ? [ time U %s ]") p));
      (1, free (map2 (told2 "E = ? [ (if %s then 1 else 0) at %s ]") p (map (fun k _ -> k) instant)));
      (2, free (map (told "P = ? [ eventually %s ]") p)); (3, free (operator atoms goal));
      (3, free (nested atoms));
      (2, ends (op "P = ? [ eventually%s %s ]" (map2 (told2 "(%s and %s)") p early)));
      (2, ends (op "P = ? [ always%s %s ]" (map2 (told2 "(%s or %s)") p late)));
      (2, ends (until "P = ? [ %s U%s %s ]" p late)); (2, ends (until "P = ? [ %s U%s %s ]" early p));
      (2, ends (op "EF%s (%s)" (map2 (told2 "(%s and %s)") p early)));
      (2, ends (op "AG%s (%s)" (map2 (told2 "(%s or %s)") p late)));
      (2, ends (op "EF%s (%s)" (map2 (told2 "(%s and %s)") early (next atoms))));
    ]

type case = { model : Told.model; questions : question list }

let generate =
  let open Gen in
  let* laws = frequencyl [ (3, false); (1, true) ] in
  let* model = Told.model ~laws in
  let model = { model with questions = [] } in
  let+ questions = list_repeat 5 (asked (Told.atoms model.clusters ~laws)) in
  { model; questions }

let whole c way questions =
  let check i q = Printf.sprintf "check c%d : %s" i (q.text way) in
  String.concat "\n" (Told.to_text Told.as_it_is c.model :: List.mapi check questions) ^ "\n"

let print c = whole c plain c.questions

(* {1 Answers} *)

let exact : Scc_chance.Answer.t -> bool = function Exact _ | Infinite -> true | Within _ | At_least _ -> false

let answer (o : Verdict.outcome) =
  match o.verdict with
  | Holds { bounds = []; _ } -> Some "holds"
  | Violated _ -> Some "violated"
  | Measured { values; reasons = []; _ }
    when List.for_all (fun (_, (v : Scc_ctl.Eval.measured)) -> exact v.least && exact v.most) values ->
    let value (_, ({ least; most } : Scc_ctl.Eval.measured)) =
      Scc_chance.Answer.to_string least ^ " " ^ Scc_chance.Answer.to_string most
    in
    Some (String.concat " " (List.map value values))
  | Holds _ | Measured _ | Depends _ | Undecided _ -> None

(* One check for each kind of time that is seen: none of them is ever known. *)
let never = "check never : AG EF 1 / (processes - processes) > 0\n"
let never_timed time =
  Printf.sprintf "check never_timed : AG EF (1 / (processes - processes) > 0 or %s < 0)\n" time

let run options text =
  let e = Load.exactly (Load.text text) in
  let semantics = Scc_engine.Standard.of_model e.model in
  match Network.initial semantics e.declared with
  | Error _ -> failwith "no initial state"
  | Ok initial ->
    let report = Check.run options semantics ~initial e.checks in
    (List.map answer report.outcomes, report.stats)

let few = { Setup.default with bounds = { Bounds.default with states = Default 1500 } }
let all = { few with reductions = [] }

type count = {
  mutable asked : int;
  mutable compared : int;
  mutable more : int;  (** known early alone *)
  mutable unknown : int;
  mutable ended : int;  (** explorations that ended before all was explored *)
}

let count = { asked = 0; compared = 0; more = 0; unknown = 0; ended = 0 }

let compare_all c found way questions =
  let known, _ = run all (whole c way questions ^ never ^ never_timed hidden.time) in
  let one (q, early) full =
    match (early, full) with
    | _, None -> if Option.is_some early then count.more <- count.more + 1 else count.unknown <- count.unknown + 1
    | Some a, Some b when String.equal a b -> count.compared <- count.compared + 1
    | _, Some b ->
      QCheck2.Test.fail_reportf "%s: %s, but %s in the end" (q.text plain)
        (Option.value early ~default:"not known") b
  in
  let answers = List.filteri (fun i _ -> i < List.length questions) known in
  List.iter2 one (List.combine questions found) answers

let same c =
  let found, stats = run few (whole c plain c.questions) in
  count.asked <- count.asked + List.length found;
  if stats.decided_early || not stats.complete then count.ended <- count.ended + 1;
  compare_all c found hidden c.questions;
  let ends = List.filter (fun (q, _) -> q.is_bounded) (List.combine c.questions found) in
  if ends <> [] then compare_all c (List.map snd ends) bounded (List.map fst ends);
  let alone q = List.hd (fst (run few (whole c plain [ q ]))) in
  let agree together q =
    match (alone q, together) with
    | Some a, Some b -> String.equal a b
    | None, Some _ | Some _, None | None, None -> true
  in
  List.for_all2 agree found c.questions

let law =
  QCheck2.Test.make ~name:"Settling: the answers of a whole exploration" ~count:20 ~print generate same

let scope () =
  Printf.printf
    "%d questions: %d answers compared, %d known early alone, %d not known; %d explorations ended early\n"
    count.asked count.compared count.more count.unknown count.ended;
  Alcotest.(check bool) "most are compared" true (2 * count.compared > count.asked);
  Alcotest.(check bool) "some end early" true (count.ended > 10)

let () =
  Alcotest.run "settling"
    [ ("random", Scc_test_support.Property.cases [ law ]); ("scope", [ Alcotest.test_case "scope" `Quick scope ]) ]
