open Scc_syntax

type t = { bodies : Ast.name list; checks : Ast.name list }

let indexed (s : Ast.segment) = match s.indices with [] -> [] | _ :: _ -> [ s.name ]

let body name (first : Ast.leaf) rest =
  let label (l : Ast.leaf) = Option.fold ~none:[] ~some:indexed l.label in
  indexed name @ List.concat_map label (first :: List.map snd rest)

let rec in_loop (i : Ast.item) =
  match i.it with
  | For (_, items) ->
    let all = List.map in_loop items in
    { bodies = List.concat_map (fun f -> f.bodies) all; checks = List.concat_map (fun f -> f.checks) all }
  | Process (name, first, rest) | Fixed (name, first, rest) -> { bodies = body name first rest; checks = [] }
  | Check (name, _) -> { bodies = []; checks = [ name ] }
  | _ -> { bodies = []; checks = [] }

let of_model model =
  let loops = List.filter (fun (i : Ast.item) -> match i.it with For _ -> true | _ -> false) model in
  let all = List.map in_loop loops in
  { bodies = List.concat_map (fun f -> f.bodies) all; checks = List.concat_map (fun f -> f.checks) all }

let is_among (names : Ast.name list) name = List.exists (fun (n : Ast.name) -> String.equal n.it name) names
let has_body t name = is_among t.bodies name
let has_check t name = is_among t.checks name
