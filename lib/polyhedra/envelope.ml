let halves p = List.concat_map Constraint.halves (Polyhedron.constraints p)

let kept constraints p = List.filter (Polyhedron.implies p) constraints

(* Where a strict constraint does not hold, it may hold with its border. *)
let with_borders constraints =
  List.sort_uniq Constraint.compare (constraints @ List.map Constraint.closed constraints)

let join p q =
  if Polyhedron.is_empty p then q
  else if Polyhedron.is_empty q then p
  else
    let from p q = kept (with_borders (halves p)) q in
    Polyhedron.minimal (Polyhedron.of_constraints (Polyhedron.dimension p) (from p q @ from q p))

let widen old next =
  if Polyhedron.is_empty old then next
  else Polyhedron.minimal (Polyhedron.of_constraints (Polyhedron.dimension old) (kept (halves old) next))

let merge p q =
  if Polyhedron.included p q then Some q
  else if Polyhedron.included q p then Some p
  else
    let whole = join p q in
    let left = List.concat_map (fun piece -> Difference.pieces piece q) (Difference.pieces whole p) in
    if left = [] then Some whole else None
