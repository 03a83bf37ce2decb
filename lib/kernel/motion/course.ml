open Scc_exact
open Scc_calculus
open Scc_semantics

type leg = { label : Transition.label; start : Rat.t; before : State.t; after : State.t }
type t = { semantics : Semantics.t; initial : State.t; legs : leg array; rest : Rat.t; over : Rat.t }

let make semantics ~initial transitions ~rest =
  let add (legs, start, before) (label, after) =
    ({ label; start; before; after } :: legs, Rat.add start (Transition.duration_of label), after)
  in
  let legs, over, _ = List.fold_left add ([], Rat.zero, initial) transitions in
  { semantics; initial; legs = Array.of_list (List.rev legs); rest; over }

let semantics c = c.semantics
let initial c = c.initial
let legs c = c.legs
let rest c = c.rest
let duration c = Rat.add c.over c.rest

let last c =
  match Array.length c.legs with
  | 0 -> c.initial
  | n -> c.legs.(n - 1).after

(* The number of legs that are over at a time: they are in order of their ends. *)
let over_at c time =
  let over k = Rat.compare (Rat.add c.legs.(k).start (Transition.duration_of c.legs.(k).label)) time <= 0 in
  let rec search low high =
    if low = high then low
    else
      let middle = (low + high) / 2 in
      if over middle then search (middle + 1) high else search low middle
  in
  search 0 (Array.length c.legs)

let at c time =
  let n = over_at c time in
  let from, start =
    if n < Array.length c.legs then (c.legs.(n).before, c.legs.(n).start) else (last c, c.over)
  in
  let d = Rat.sub time start in
  if Rat.sign d = 0 then from else Time.pass c.semantics d from

let paths c (s : State.t) = Array.map (Path.make (Semantics.model c.semantics)) s.processes
