open Scc_loading
open Scc_verdicts
open Scc_reports
open Scc_json.Json_format

let report options (l : Loaded.t) ~where =
  let* () = if where then Ordinary.has_ranges l else Ok () in
  let* initial = Loaded.initial l in
  Verdicts.report options l ~initial ~exactly:where ~premises:[] l.checks

type found = { loaded : Loaded.t; found : Scc_verify.Check.report; where : bool }

let result =
  let properties f =
    let property i outcome =
      let where = if f.where then List.nth_opt f.found.where i else None in
      Check_json.judged ?where f.loaded.semantics outcome
    in
    List.mapi property f.found.outcomes
  in
  fields
    [
      field "properties" (list Check_json.property_format) properties;
      field "explored" Explored_json.format (fun f -> (f.loaded.model, f.found.stats));
      within (fun f -> (f.loaded.model, f.found)) Check_json.invariants_member;
    ]

let check =
  let where = Read.member "where" Read.truth and prove = Read.member "prove" Read.truth in
  let params = Models.members @ Read.[ may where; may prove; may Method.all_limits ] in
  let work (bounds, store) p =
    let where = Option.value (Read.optional p where) ~default:false in
    let prove = Option.value (Read.optional p prove) ~default:false in
    let l, source = Models.read store ~params p in
    match report { (Evaluate.options bounds p) with prove } l ~where with
    | Error diagnostics -> Fault.refuse (Model_refused (Fault.diagnostics ~source diagnostics))
    | Ok found -> Reply.of_format result { loaded = l; found; where }
  in
  { Method.name = "model.check"; params; result = schema result; work }
