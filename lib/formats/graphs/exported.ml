open Scc_exact
open Scc_verify
open Scc_loading

type t = {
  loaded : Loaded.t;
  space : Explored.t;
}

let summary e =
  let parameter (name, value) = Printf.sprintf "%s = %s" name (Rat.to_string value) in
  let { Origin.name; parameters; _ } = e.loaded.origin in
  let model =
    String.concat ", "
      (("model " ^ Option.value name ~default:"without a name") :: List.map parameter parameters)
  in
  let model = [ model; Scc_calculus.Parameters.line e.loaded.origin.settings ] in
  let explored =
    Printf.sprintf "explored: %d states, %d transitions" e.space.size (Explored.transitions e.space)
  in
  match Explored.unexpanded e.space with
  | 0 -> model @ [ explored ^ "; complete" ]
  | n ->
    let faults = List.map (fun (f : Scc_base.Diag.t) -> f.message) e.space.faults in
    let why = List.map Verdict.truncation_to_string e.space.stopped_by @ faults in
    model @ [ explored; Printf.sprintf "TRUNCATED: %d states unexplored, by %s" n (String.concat ", " why) ]

let label_notes l =
  let predicates = Array.to_list (Labelling.predicates l) in
  let without_stretches = Labelling.size l = (Labelling.space l).size in
  let changing = List.filteri (fun k _ -> without_stretches && Labelling.changes l k > 0) predicates in
  let changes =
    match changing with
    | [] -> []
    | _ :: _ ->
      let names = String.concat ", " (List.map (fun (p : State_predicates.t) -> p.name) changing) in
      [ "labels that change while time passes, and tell of the states alone: " ^ names ]
  in
  let undecided k (p : State_predicates.t) =
    Option.map
      (fun (i, why) -> Printf.sprintf "%s has no truth value in or after state %d: %s" p.name i why)
      (Labelling.undecided l k)
  in
  let rounded =
    match Labelling.inexact l with
    | 0 -> []
    | n -> [ Printf.sprintf "%d instants are irrational: the times next to them are within 10^-12" n ]
  in
  changes @ List.filter_map Fun.id (List.mapi undecided predicates) @ rounded
