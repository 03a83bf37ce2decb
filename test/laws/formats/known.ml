open Scc_base
open Scc_json
open Scc_runs
open Scc_reports

type format = Format : ('w, 'r) Json_format.t * ('r -> 'w) option -> format
type file = { schema : Json_schema.file; format : format option }

let file ?again ?(parts = []) name title t =
  let schema = { Json_schema.name; title; root = Some (Json_format.schema t); parts } in
  { schema; format = Some (Format (t, again)) }

let common =
  let title = "What the documents of scc share" in
  { schema = { name = "common"; title; root = None; parts = [] }; format = None }

let all =
  [
    common;
    { schema = Scc_oracle.Oracle.schema_file; format = None };
    file "schedule" "A schedule: the choices that lead a model through one run" Schedule.format
      ~again:(fun place -> (1, place (fun _ -> Span.none)));
    file "trace" "A line of a trace (JSON Lines): header, state, transitions, instant (at most one), end"
      Trace.format;
    file "diagnostics" "What a command with --json prints when it cannot make its report"
      Diag_json.document_format;
    file "conform" "The report of scc conform" Scc_conform.Report_json.format;
    file "diff" "The report of scc diff" Scc_conform.Difference_json.format;
    file "explain" "The report of scc explain: which events of a run the facts at its end depend on"
      Explain_json.format;
    file "compare" "The report of scc compare" Scc_cli.Compare_json.format;
    file "inflate" "The report of scc inflate" Scc_cli.Inflate_command.format;
    file "simulation" "A line of scc simulate --format jsonl: header, run; with --summary header, moment"
      Scc_simulate.Report.format;
    file "estimate" "The report of scc estimate" Scc_estimate.Estimate_report.format;
    file "sweep" "A line of scc sweep --format jsonl: header, point" Scc_sweep.Table.format;
    file "view" "What a page of scc view shows: scc view --data" Scc_view.Document.format;
    (let parts =
       Json_format.
         [
           schema Scc_successors.Told.moves_text; schema Scc_successors.Told.targets_text;
           schema Scc_owners.Said.format;
         ]
     in
     let title = "What scc successors tells: header, answers in lines, texts in frames, lines of owners" in
     file "successors" title Scc_successors.Told.format ~parts);
    file "graph" "The state space of a model: scc explore --format json" Scc_graphs.Graph_json.format;
    file "zones" "The zones of a model with ranges or split_step any (rule Zones): scc explore --format json"
      Scc_graphs.Zone_json.format;
    file "names" "What the names in explicit files stand for: FILE.names.json of scc explore --format tra"
      Scc_graphs.Explicit_files.names_format;
    file "check" "The report of scc check" Check_json.format;
    file "shape" "The report of scc shape" Shape_json.format;
    file "decomposition" "The report of scc decompose" Decomposition_json.format;
  ]
