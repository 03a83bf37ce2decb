let convex (p : Polygon.t) =
  let pieces = Optimal.pieces (Cycle.of_polygon p) in
  match p.holes with [] -> pieces | _ :: _ -> Merging.merged p.grid pieces

let most_optimal = 64

let quick (p : Polygon.t) =
  let ring = (Cycle.of_polygon p).at in
  if Array.length ring <= most_optimal || p.holes <> [] then convex p
  else Merging.merged p.grid (Ears.triangles p.grid ring)
