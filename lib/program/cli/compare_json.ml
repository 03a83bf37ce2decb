open Scc_equivalence
open Scc_json
open Scc_verdicts
open Scc_runs
open Scc_reports
open Json_format

type t = { report : Compare_report.t; source : Diag_json.source; diagnostics : Scc_base.Diag.t list }

(* {1 What was compared} *)

(* Members that are about a model. *)
let identity =
  let of_model f (c : Compared.t) =
    match c.source with File -> None | Model { model; _ } -> Some (f model.origin)
  in
  let list f c = Option.value (of_model f c) ~default:[] in
  all
    [
      field "model" (nullable text) (fun c -> Option.join (of_model (fun (o : Scc_loading.Origin.t) -> o.name) c));
      field "digest" (nullable Shared.digest) (of_model (fun o -> o.digest));
      field "parameters" Origin_json.parameters_format (list (fun o -> o.parameters));
      field "settings" Origin_json.settings_format (list (fun o -> o.settings));
    ]

let side =
  let kind (c : Compared.t) = match c.source with File -> "graph" | Model _ -> "model" in
  let faults (c : Compared.t) =
    match c.source with
    | File -> []
    | Model { space; _ } -> List.map (fun (f : Scc_base.Diag.t) -> f.message) space.faults
  in
  let compared part = within (fun (_, (s : Compare.side)) -> s) part in
  fields
    [
      within fst
        (all
           [
             field "file" text (fun (c : Compared.t) -> c.path);
             field "kind" (word Fun.id [ "model"; "graph" ]) kind;
             identity;
             field "states" Shared.from_one (fun c -> fst (Compared.size c)) ~about:"As explored or read.";
             field "transitions" natural (fun c -> snd (Compared.size c));
             field "complete" bool (fun (c : Compared.t) -> c.complete)
               ~about:"All transitions of all states are known.";
             field "stopped_by" (list Explored_json.truncation) Compared.stopped_by;
             field "faults" Shared.texts faults;
           ]);
      compared
        (field "compared_states" natural (fun (s : Compare.side) -> s.states)
           ~about:
             "What can be reached of the graph as the relation sees it; 0 if the comparison was stopped before \
              it was found.");
      compared (field "compared_transitions" natural (fun (s : Compare.side) -> s.transitions));
      compared
        (field "classes" (nullable (integer ())) (fun (s : Compare.side) -> s.classes)
           ~about:
             "Of equivalent states among those compared (of branching bisimilar ones for trace); null when \
              they were not computed.");
    ]
  |> named ~file:"compare" "side"

(* {1 The verdict} *)

let verdict t : string =
  match t.Compare_report.report.verdict with
  | Equivalent -> "equivalent"
  | Different _ -> "different"
  | Undecided _ -> "undecided"

let difference (t : Compare_report.t) =
  match t.report.verdict with Different d -> Some d | Equivalent | Undecided _ -> None

let reason (t : Compare_report.t) =
  match t.report.verdict with
  | Undecided reason -> Some (Compare_report.reason_text reason)
  | Equivalent | Different _ -> None

let trace =
  let which first = if first then "first" else "second" in
  fields
    [
      field "of" (from which (word Fun.id [ "first"; "second" ])) snd ~about:"Which one has it.";
      field "labels" (list ~least:1 text) fst;
    ]

let trace_known (t : Compare_report.t) =
  match t.report.verdict with Equivalent -> true | Different d -> not d.trace_open | Undecided _ -> false

let formula =
  let shown ((t : Compare_report.t), f) =
    if Modal_formula.size f <= Compare_report.most_written then Some (t.report.show f) else None
  in
  fields
    [
      field "operators" Shared.from_one (fun (_, f) -> Modal_formula.size f);
      field "text" (nullable text) shown ~about:"null when it is too large to write.";
    ]

let format =
  let of_report part = within (fun t -> t.report) part in
  let formula_of t = Option.bind (difference t) (fun d -> Option.map (fun f -> (t, f)) d.formula) in
  let relations = List.map snd Compare_report.relations in
  fields
    (Shared.head "scc-compare" 1
     @ [
       Shared.semantics ();
       of_report
         (all
            [
              field "relation" (word Compare_report.name relations) (fun (t : Compare_report.t) -> t.relation);
              field "verdict" (word Fun.id [ "equivalent"; "different"; "undecided" ]) verdict;
              field "exit" Shared.exit (fun (t : Compare_report.t) -> Exit_code.to_int t.exit);
              field "trace" (nullable trace) (fun t -> Option.bind (difference t) (fun d -> d.trace))
                ~about:
                  "A shortest trace that one of the two has and the other has not; null when there is none or \
                   none is known. Silent labels are left out unless the relation sees them.";
              field "trace_known" bool trace_known
                ~about:"Whether it is known that the traces are the same or that they are not.";
              field "formula" (nullable formula) formula_of
                ~about:
                  "True of the first, false of the second; null when there is none or it would be too large to \
                   make.";
              field "reason" (nullable text) reason ~about:"Why it is undecided.";
              field "first" side (fun (t : Compare_report.t) -> (t.first, t.report.first));
              field "second" side (fun (t : Compare_report.t) -> (t.second, t.report.second));
            ]);
       field "diagnostics" Diag_json.formats (fun t -> (t.source, t.diagnostics));
     ])

let json console report =
  write format { report; source = Console.source console; diagnostics = Console.kept console }
