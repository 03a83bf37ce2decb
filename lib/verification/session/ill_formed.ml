open Scc_base
open Scc_verify
open Scc_loading

(* The model of these values alone is refused as any model is, at the places that are at fault. *)
let diagnostics (l : Loaded.t) (fault : Zone_check.fault) =
  let told = Zone_check.diagnostic l.model fault in
  let same (d : Diag.t) = String.equal d.code told.code in
  match Loaded.at l fault.at with
  | Ok _ -> [ told ]
  | Error refused -> (
      match List.find_opt same refused with
      | Some at -> [ { told with span = at.span; notes = at.notes; hint = at.hint } ]
      | None -> [ told ])
