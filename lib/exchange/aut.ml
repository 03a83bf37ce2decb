open Scc_verify
open Scc_semantics

type tau = Tau | Cadp

let label text =
  let plain = function '"' -> '\'' | '\x00' .. '\x1f' | '\x7f' -> ' ' | c -> c in
  "\"" ^ String.map plain text ^ "\""

let invisible = function Tau -> "\"tau\"" | Cadp -> "i"

(* The loop of a state without transitions, if it has one. *)
let loop (space : Space.t) i =
  if not (space.expanded i) then Some "unexplored"
  else if space.rests i then Some "time(forever)"
  else None

let count (space : Space.t) =
  let rec from i n =
    if i = space.size then n
    else
      match Array.length (space.edges i) with
      | 0 -> from (i + 1) (if Option.is_some (loop space i) then n + 1 else n)
      | k -> from (i + 1) (n + k)
  in
  from 0 0

let write tau ~hidden (space : Space.t) put =
  let transition i text target = put (Printf.sprintf "(%d, %s, %d)\n" i text target) in
  let shown text = if hidden text then invisible tau else label text in
  let edge i (e : Space.edge) =
    transition i (shown (Transition.label_to_string space.model e.label)) e.target
  in
  put (Printf.sprintf "des (0, %d, %d)\n" (count space) space.size);
  for i = 0 to space.size - 1 do
    match space.edges i with
    | [||] -> Option.iter (fun text -> transition i (shown text) i) (loop space i)
    | edges -> Array.iter (edge i) edges
  done
