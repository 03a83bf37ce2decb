open Scc_loading
open Scc_verdicts
open Scc_reports

let report options (l : Loaded.t) ~where =
  let* () = if where then Ordinary.has_ranges l else Ok () in
  let* initial = Loaded.initial l in
  Verdicts.report options l ~initial ~exactly:where ~premises:[] l.checks

let check bounds store p =
  let where = Option.value (Read.optional p "where" Read.truth) ~default:false in
  let prove = Option.value (Read.optional p "prove" Read.truth) ~default:false in
  let l, source = Models.read store ~more:[ "where"; "prove" ] p in
  match report { (Evaluate.options bounds p) with prove } l ~where with
  | Error diagnostics -> Fault.refuse (Model_refused (Fault.diagnostics ~source diagnostics))
  | Ok report ->
    let property i outcome =
      let where = if where then List.nth_opt report.where i else None in
      Check_json.property ?where l.semantics outcome
    in
    Reply.Value
      (`Assoc
         ([
           ("properties", `List (List.mapi property report.outcomes));
           ("explored", Scc_json.Json_format.write Explored_json.format (l.model, report.stats));
         ]
           @ Check_json.invariants l.model report))
