open Scc_base
open Scc_calculus
open Scc_semantics
open Scc_property
open Scc_graph_search
open Scc_verify
open Scc_state_sets

let named (m : Model.t) values =
  List.mapi (fun i v -> (m.ranges.(i).Ranges.name, v)) (Array.to_list values)

let most_states_of_one_start = 20_000

let run (options : Setup.t) semantics u ~declared (check : Property.check) values =
  let m = Semantics.model semantics in
  if Array.length m.ranges = 0 || Left_open.at_any_time m ~declared then None
  else
    let c = Semantics.with_model semantics (Fixed.model m values) in
    let declared = Fixed.declared m u declared values in
    let check = { check with formula = Rename.known_temporal values check.formula } in
    let { Bounds.seconds; memory; _ } = options.bounds in
    let bounds = { Bounds.default with states = Given most_states_of_one_start; seconds; memory } in
    match Network.initial c declared with
    | Error _ -> None
    | Ok initial -> (
        let options = { Setup.default with bounds; surroundings = options.surroundings } in
        let report = Check.run options c ~initial [ check ] in
        let fixed = { Scc_explain.Witness.values = named m values; semantics = c } in
        let of_start (w : Scc_explain.Witness.t) = { w with fixed = Some fixed } in
        match report.outcomes with
        | [ { lost = what :: _; _ } ] -> Bug.fail __POS__ what
        | [ { verdict = Violated { witness }; _ } ] -> Option.map of_start witness
        | [ { verdict = Holds { bounds = []; _ }; _ } ] ->
          Bug.fail __POS__ "a check that is violated over zones holds for a start of them"
        | _ -> Option.iter (fun stop -> raise (Limits.Over stop)) (options.surroundings.stop ()); None)
