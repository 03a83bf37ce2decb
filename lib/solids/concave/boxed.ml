open Scc_exact
open Scc_geometry

let of_points points =
  let along get =
    let over round choose start = Array.fold_left (fun m p -> choose m (round (get p))) start points in
    (over Float_box.down Float.min infinity, over Float_box.up Float.max neg_infinity)
  in
  let x, x' = along (fun (v : Vec.t) -> v.x) and y, y' = along (fun v -> v.y) and z, z' = along (fun v -> v.z) in
  Float_box.make ~low:[| x; y; z |] ~high:[| x'; y'; z' |]
