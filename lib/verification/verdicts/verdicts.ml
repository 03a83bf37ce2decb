open Scc_verify
open Scc_zones
open Scc_loading

let over_zones (l : Loaded.t) = Zone_check.is_for l.model ~declared:l.declared

let uncertain (l : Loaded.t) =
  match l.uncertain with Some uncertain -> uncertain | None -> Scc_symbolic.Start.known l.model l.declared

(* A short search for an invariant; what it leaves open is explored; and what that leaves open, a longer search may
   decide, if it was not the model that ended the short one. *)
let with_invariants options (l : Loaded.t) ~initial checks =
  let decide effort = By_invariant.decide options effort l.semantics (uncertain l) ~declared:l.declared in
  let decided, first = decide Briefly checks in
  let exploring = By_invariant.leaving_time options (Some first) in
  let report = Check.run_without exploring l.semantics ~initial checks ~decided in
  let open_ =
    List.filter_map
      (fun (o : Verdict.outcome) -> if Verdict.is_open o.verdict then Some o.check else None)
      report.outcomes
  in
  match first with
  | Given_up _ when open_ <> [] ->
    let decided, second = decide Longer open_ in
    let outcome (o : Verdict.outcome) =
      if List.memq o.check open_ then Option.value (decided o.check) ~default:o else o
    in
    { report with outcomes = List.map outcome report.outcomes; invariants = [ second ] }
  | Proved _ | None_found _ | Given_up _ -> { report with invariants = [ first ] }

let ordinarily (options : Setup.t) (l : Loaded.t) ~initial checks =
  (if options.prove then with_invariants options l else Check.run options l.semantics) ~initial checks

let unless_refused (l : Loaded.t) use =
  match Option.map (Zone_check.refused l.model) use with None | Some [] -> Ok () | Some why -> Error why

let refused (l : Loaded.t) ~prove =
  unless_refused l (if over_zones l then Some Zone_check.Zones else if prove then Some Invariants else None)

let graph_refused (l : Loaded.t) = unless_refused l (if over_zones l then Some Zone_check.Graph else None)

let report (options : Setup.t) (l : Loaded.t) ~initial ~exactly ~premises checks =
  let of_all () =
    if over_zones l then
      Zone_check.run options l.semantics (uncertain l) ~declared:l.declared ~exactly ~premises checks
      |> Result.map_error (Ill_formed.diagnostics l)
    else Ok (ordinarily options l ~initial (checks @ premises))
  in
  Result.bind (refused l ~prove:options.prove) of_all
