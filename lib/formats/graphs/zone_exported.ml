open Scc_exact
open Scc_calculus
open Scc_symbolic
open Scc_verify
open Scc_loading
open Scc_zones

type t = { loaded : Loaded.t; space : Zone_space.t }

let bounds e = List.map Verdict.truncation_to_string e.space.stopped_by

let summary e =
  let parameter (name, value) = Printf.sprintf "%s = %s" name (Rat.to_string value) in
  let range r = Ranges.range_to_string r in
  let { Origin.name; parameters; settings; _ } = e.loaded.origin in
  let model =
    String.concat ", "
      (("model " ^ Option.value name ~default:"without a name")
       :: List.map parameter parameters
       @ List.map range (Array.to_list e.loaded.model.ranges))
  in
  let explored =
    Printf.sprintf "explored: %d zones, %d edges" (Zone_graph.size e.space.graph) (Zone_space.edges e.space)
  in
  let of_graph =
    if Zone_space.complete e.space then [ explored ^ "; complete" ]
    else
      let why = bounds e @ List.map (fun (f : Scc_base.Diag.t) -> f.message) e.space.faults in
      let missing =
        match Zone_space.unexpanded e.space with
        | 0 -> "TRUNCATED"
        | n -> Printf.sprintf "TRUNCATED: %d zones unexplored" n
      in
      [ explored; Printf.sprintf "%s, by %s" missing (String.concat ", " why) ]
  in
  [ model; Parameters.line settings ] @ of_graph
