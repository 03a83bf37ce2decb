open Scc_base
open Scc_exact
open Scc_elaborate

type t = { mutable first : Lattices.t list; mutable range : (Rat.t * Rat.t) option; mutable warned : bool }

let chosen = List.filter_map (fun (l : Lattices.t) -> if l.lattice.chosen then Some l.lattice.kick else None)
let over (low, high) kick = (Rat.min low kick, Rat.max high kick)

let enter t lattices =
  let add range kick = Some (over (Option.value range ~default:(kick, kick)) kick) in
  t.range <- List.fold_left add t.range (chosen lattices)

let start first =
  let t = { first; range = None; warned = false } in
  enter t first;
  t

let warning k ((l : Lattices.t), before) =
  Diag.warning Code.changed_lattice l.at
    "the lattice changes over the sweep: the kick is %s at point %d, and was %s at the first point"
    (Rat.to_string l.lattice.kick) k (Rat.to_string before)
    ~hint:
      "what bodies reach depends on the lattice, too, and not on the constant alone: fix the kick, as in \
       `diffuse(d, h = 2)`, to compare points"

let add t k lattices =
  if t.first = [] then t.first <- lattices;
  enter t lattices;
  match Lattices.changed lattices ~from:t.first with
  | Some change when not t.warned ->
    t.warned <- true;
    Some (warning k change)
  | Some _ | None -> None

let conclusion t =
  match t.range with
  | Some (low, high) when t.warned ->
    Some
      (Printf.sprintf "scc: the kicks chosen for diffuse are from %s to %s: h = %s is long enough at all points"
         (Rat.to_string low) (Rat.to_string high) (Rat.to_string high))
  | Some _ | None -> None
