open Scc_exact

(* How far an offset is beyond the plane of a facet, up to a positive factor. *)
let beyond (f : Obstacle.facet) r = Rat.sub (Vec.dot (Ivec.to_vec f.normal) r) (Rat.make f.num f.den)

(* What of a convex polygon, given by its corners in order, is not beyond the plane. *)
let clipped f corners =
  let heights = List.map (fun r -> (r, beyond f r)) corners in
  let edge (r, h) (next, h') =
    let crossing () = Vec.axpy (Rat.div h (Rat.sub h h')) (Vec.sub next r) r in
    (if Rat.sign h <= 0 then [ r ] else []) @ if Rat.sign h * Rat.sign h' < 0 then [ crossing () ] else []
  in
  match heights with
  | [] -> []
  | first :: rest -> List.concat (List.map2 edge heights (rest @ [ first ]))

(* The mean of the corners is within the polygon: if it is on a plane that has the polygon on one side, all of the
   polygon is. *)
let mean corners =
  let sum = List.fold_left Vec.add Vec.zero corners in
  Vec.scale (Rat.make Z.one (Z.of_int (List.length corners))) sum

(* The offsets of the two solids at any two times make a parallelogram. *)
let meet o r v u =
  let facets = Obstacle.facets o in
  let along = Vec.sub r v in
  let corners = [ r; Vec.add r u; Vec.add along u; along ] in
  match Array.fold_left (fun corners f -> clipped f corners) corners facets with
  | [] -> false
  | left ->
    let inside = mean left in
    Array.for_all (fun f -> Rat.sign (beyond f inside) < 0) facets
