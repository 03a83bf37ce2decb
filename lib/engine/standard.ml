open Scc_broad_phase
open Scc_semantics

let of_model model =
  let memory = Obstacle_cache.create () in
  let geometry = Geometry.exact ~obstacle:(Obstacle_cache.find memory) in
  Semantics.make ~geometry ~neighbours:Neighbours.boxes model
