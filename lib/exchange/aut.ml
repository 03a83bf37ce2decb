open Scc_verify
open Scc_semantics

type tau = Tau | Cadp

let label text =
  let plain = function '"' -> '\'' | '\x00' .. '\x1f' | '\x7f' -> ' ' | c -> c in
  "\"" ^ String.map plain text ^ "\""

let invisible = function Tau -> "\"tau\"" | Cadp -> "i"

let count (space : Space.t) =
  let rec from i n =
    if i = space.size then n
    else from (i + 1) (n + if space.expanded i then Array.length (space.edges i) else 1)
  in
  from 0 0

let write tau ~hidden (space : Space.t) put =
  let transition i text target = put (Printf.sprintf "(%d, %s, %d)\n" i text target) in
  let edge i (e : Space.edge) =
    let text = Transition.label_to_string space.model e.label in
    transition i (if hidden text then invisible tau else label text) e.target
  in
  put (Printf.sprintf "des (0, %d, %d)\n" (count space) space.size);
  for i = 0 to space.size - 1 do
    if space.expanded i then Array.iter (edge i) (space.edges i) else transition i (label "unexplored") i
  done
