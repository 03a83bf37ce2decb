open Scc_verify

let named verdicts (report : Check.report) =
  match report.where with
  | [] -> []
  | where -> List.map2 (fun (o : Verdict.outcome) w -> (o.check.name, w)) verdicts where

let with_side = Printf.sprintf "%s (%s)"

let split ?(name = with_side) verdicts named =
  let numbers (o : Verdict.outcome) =
    match o.verdict with
    | Measured { starts = (_, first) :: rest; _ }
      when List.for_all (fun (_, c) -> Scc_regions.Chances.equal first c) rest ->
      [ (o.check.name, first) ]
    | Measured { starts; _ } ->
      let named (side, c) = (name o.check.name (Scc_explain.Likelihoods.side side), c) in
      List.map named starts
    | Holds _ | Violated _ | Depends _ | Undecided _ -> []
  in
  let is_claim (name, _) =
    let same (o : Verdict.outcome) = String.equal o.check.name name in
    match List.find_opt same verdicts with Some o -> numbers o = [] | None -> true
  in
  (List.filter is_claim named, List.concat_map numbers verdicts)
