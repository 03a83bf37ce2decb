open Scc_base
open Scc_verify
open Scc_session
open Scc_exchange

let where bounds p =
  let l, source = Models.read p in
  let refuse diagnostics = Fault.refuse (Model_refused (Fault.diagnostics ~source diagnostics)) in
  Result.iter_error refuse (Ordinary.has_ranges l);
  (match Zone_check.refused l.model with [] -> () | why -> refuse why);
  let uncertain =
    match l.uncertain with
    | Some uncertain -> uncertain
    | None -> Bug.fail __POS__ "parameters with ranges, and nothing that depends on them"
  in
  let options = Evaluate.options bounds p in
  match Zone_check.run options l.semantics uncertain ~declared:l.declared ~exactly:true l.checks with
  | Error fault -> refuse [ Zone_check.diagnostic l.model fault ]
  | Ok report ->
    let property i outcome = Check_json.property ?where:(List.nth_opt report.where i) l.semantics outcome in
    Reply.Value
      (`Assoc
         [
           ("properties", `List (List.mapi property report.outcomes));
           ("explored", Check_json.explored l.model report.stats);
         ])
