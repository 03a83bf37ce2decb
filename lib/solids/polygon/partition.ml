let convex (p : Polygon.t) =
  let pieces = Optimal.pieces (Cycle.of_polygon p) in
  match p.holes with [] -> pieces | _ :: _ -> Merging.merged p.grid pieces
