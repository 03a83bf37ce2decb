open Scc_polyhedra
open Scc_offsets
open Scc_calculus

(* As if it were written with these values. *)
let rec written values (b : Behaviour.t) =
  let at = written values in
  match b with
  | Nil | Call _ -> b
  | Open (polarity, c, rest) -> Behaviour.open_ polarity c (at rest)
  | Weak (c, { push; odds }, rest) -> Behaviour.weak ~push ?odds c (at rest)
  | Strong (l, push, rest) -> Behaviour.strong ~push l (at rest)
  | Delay (t, rest) -> Behaviour.delay t (at rest)
  | Wait (t, rest) -> Behaviour.written (Linear.constant 0 (Linear.eval t values)) (at rest)
  | Sum (x, y) -> Behaviour.sum (at x) (at y)

let written_definitions (m : Model.t) values =
  Array.map (fun (d : Behaviour.definition) -> { d with body = written values d.body }) m.definitions

let behaviour m values =
  let canonical = Behaviour.canonical (written_definitions m values) in
  fun b -> canonical (written values b)

let is_open (p : Model.part) = Option.is_some p.open_offset
let has_open_offsets (m : Model.t) = Array.exists (fun (l : Model.leaf) -> Array.exists is_open l.parts) m.leaves

let offsets (m : Model.t) values =
  let part (p : Model.part) =
    match p.open_offset with
    | None -> p
    | Some forms -> { p with offset = Place.eval forms values; open_offset = None }
  in
  let leaf (l : Model.leaf) = { l with parts = Array.map part l.parts } in
  if has_open_offsets m then { m with leaves = Array.map leaf m.leaves } else m

let model (m : Model.t) values =
  let definitions = Behaviour.canonical_definitions (written_definitions m values) in
  { (offsets m values) with ranges = [||]; definitions }

let declared m (u : Uncertain.t) (s : State.t) values =
  let known = behaviour m values in
  let leaf (l : State.leaf) =
    {
      l with
      State.position = Place.eval u.places.(l.leaf) values;
      behaviour = Behaviour.fresh (known l.behaviour.term);
    }
  in
  State.mapi (fun _ -> State.map_leaves leaf) s
