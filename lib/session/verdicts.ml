open Scc_verify

let over_zones (l : Loaded.t) = Zone_check.is_for l.model ~declared:l.declared

let uncertain (l : Loaded.t) =
  match l.uncertain with Some uncertain -> uncertain | None -> Scc_symbolic.Start.known l.model l.declared

let ordinarily (options : Check.options) (l : Loaded.t) ~initial checks =
  if options.prove then
    let decided, end_ = Zone_proof.prove options l.semantics (uncertain l) ~declared:l.declared checks in
    { (Check.run_without options l.semantics ~initial checks ~decided) with invariants = [ end_ ] }
  else Check.run options l.semantics ~initial checks

let refused (l : Loaded.t) ~prove =
  let because = if over_zones l then Some Zone_check.Zones else if prove then Some Invariants else None in
  match Option.map (Zone_check.refused l.model) because with None | Some [] -> Ok () | Some why -> Error why

let report (options : Check.options) (l : Loaded.t) ~initial ~exactly ~premises checks =
  let of_all () =
    if over_zones l then
      Zone_check.run options l.semantics (uncertain l) ~declared:l.declared ~exactly ~premises checks
      |> Result.map_error (Ill_formed.diagnostics l)
    else Ok (ordinarily options l ~initial (checks @ premises))
  in
  Result.bind (refused l ~prove:options.prove) of_all
