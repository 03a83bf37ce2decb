(* Where an octahedron meets a cube that stands in its way (Samples.octahedron). *)
open Scc_regions
open Where_samples.Samples

let () =
  match Plane.view octahedron.ranges ~axes:[] ~fixed:[] with
  | Ok view -> print_string (Drawing.svg octahedron.ranges view [ ("meets", octahedron) ])
  | Error message -> prerr_endline message
