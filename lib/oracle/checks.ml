open Scc_verify
open Scc_session
open Scc_exchange

let ( let* ) = Result.bind

(* Of a model with ranges, or whose bonds may be released at any time. *)
let over_zones options (l : Loaded.t) ~exactly =
  let known () = Scc_symbolic.Start.known l.model l.declared in
  let uncertain = match l.uncertain with Some uncertain -> uncertain | None -> known () in
  match Zone_check.refused l.model with
  | _ :: _ as why -> Error why
  | [] ->
    Zone_check.run options l.semantics uncertain ~declared:l.declared ~exactly l.checks
    |> Result.map_error (Ill_formed.diagnostics l)

let report options (l : Loaded.t) ~where =
  let* () = if where then Ordinary.has_ranges l else Ok () in
  if Zone_check.is_for l.model ~declared:l.declared then over_zones options l ~exactly:where
  else
    let* initial = Loaded.initial l in
    Ok (Check.run options l.semantics ~initial l.checks)

let check bounds p =
  let where = Option.value (Read.optional p "where" Read.truth) ~default:false in
  let l, source = Models.read ~more:[ "where" ] p in
  match report (Evaluate.options bounds p) l ~where with
  | Error diagnostics -> Fault.refuse (Model_refused (Fault.diagnostics ~source diagnostics))
  | Ok report ->
    let property i outcome =
      let where = if where then List.nth_opt report.where i else None in
      Check_json.property ?where l.semantics outcome
    in
    Reply.Value
      (`Assoc
         [
           ("properties", `List (List.mapi property report.outcomes));
           ("explored", Check_json.explored l.model report.stats);
         ])
