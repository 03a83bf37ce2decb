let pieces p q =
  (* the part of p in which the constraints so far hold, and what has been cut off *)
  let cut (inside, pieces) c =
    if Polyhedron.is_empty inside || Polyhedron.implies inside c then (inside, pieces)
    else
      let outside = List.map (Polyhedron.add inside) (Constraint.negation c) in
      let outside = List.filter (fun piece -> not (Polyhedron.is_empty piece)) outside in
      (Polyhedron.add inside c, List.rev_append outside pieces)
  in
  if Polyhedron.is_empty p then []
  else if Polyhedron.disjoint p q then [ p ]
  else List.rev (snd (List.fold_left cut (p, []) (Polyhedron.constraints q)))
