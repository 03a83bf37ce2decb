open Scc_exact
open Scc_verify

type t = {
  name : string option;
  digest : string;
  parameters : (string * Rat.t) list;
  space : Space.t;
}

let unexpanded e =
  let rec from i n =
    if i = e.space.size then n else from (i + 1) (if e.space.expanded i then n else n + 1)
  in
  from 0 0

let transitions e =
  let rec from i n = if i = e.space.size then n else from (i + 1) (n + Array.length (e.space.edges i)) in
  from 0 0

let summary e =
  let parameter (name, value) = Printf.sprintf "%s = %s" name (Rat.to_string value) in
  let model =
    String.concat ", "
      (("model " ^ Option.value e.name ~default:"without a name") :: List.map parameter e.parameters)
  in
  let explored = Printf.sprintf "explored: %d states, %d transitions" e.space.size (transitions e) in
  match unexpanded e with
  | 0 -> [ model; explored ^ "; complete" ]
  | n ->
    let why = List.map Verdict.truncation_to_string e.space.stopped_by @ e.space.faults in
    [ model; explored; Printf.sprintf "TRUNCATED: %d states unexplored, by %s" n (String.concat ", " why) ]

let label_notes l =
  let note k (p : State_predicates.t) =
    let changes =
      match Labelling.changes l k with
      | 0 -> []
      | n when Labelling.size l = (Labelling.space l).size ->
        [ Printf.sprintf "%s changes while time passes after %d states: its label tells of the states alone" p.name n ]
      | _ -> []
    in
    match Labelling.undecided l k with
    | None -> changes
    | Some (i, why) ->
      changes @ [ Printf.sprintf "%s has no truth value in or after state %d: %s" p.name i why ]
  in
  let rounded =
    match Labelling.inexact l with
    | 0 -> []
    | n -> [ Printf.sprintf "%d instants are irrational: the times next to them are within 10^-12" n ]
  in
  List.concat (List.mapi note (Array.to_list (Labelling.predicates l))) @ rounded
