let where region constraints =
  let p = Polyhedron.add_all region constraints in
  if Polyhedron.is_empty p then [] else [ p ]

let split region constraints =
  let needed = List.filter (fun c -> not (Polyhedron.implies region c)) constraints in
  match where region needed with
  | [] -> (None, [ region ])
  | p :: _ ->
    let step (left, rest) c =
      (Polyhedron.add left c, rest @ List.concat_map (fun n -> where left [ n ]) (Constraint.negation c))
    in
    (Some p, snd (List.fold_left step (region, []) needed))
