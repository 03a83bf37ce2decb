open Scc_polyhedra
open Scc_calculus

let rec behaviour values (b : Behaviour.t) =
  let at = behaviour values in
  match b with
  | Nil | Call _ -> b
  | Open (polarity, c, rest) -> Behaviour.open_ polarity c (at rest)
  | Weak (c, push, rest) -> Behaviour.weak ~push c (at rest)
  | Strong (l, push, rest) -> Behaviour.strong ~push l (at rest)
  | Delay (t, rest) -> Behaviour.delay t (at rest)
  | Wait (t, rest) -> Behaviour.delay (Linear.eval t values) (at rest)
  | Sum (x, y) -> Behaviour.sum (at x) (at y)

let model (m : Model.t) values =
  let definition (d : Behaviour.definition) = { d with body = behaviour values d.body } in
  { m with ranges = [||]; definitions = Array.map definition m.definitions }

let declared (u : Uncertain.t) (s : State.t) values =
  let leaf (l : State.leaf) =
    {
      l with
      State.position = Place.eval u.places.(l.leaf) values;
      behaviour = Behaviour.fresh (behaviour values l.behaviour.term);
    }
  in
  let processes = List.map (State.map_leaves leaf) (Array.to_list s.processes) in
  State.make ~processes ~step:s.step ~time:s.time
