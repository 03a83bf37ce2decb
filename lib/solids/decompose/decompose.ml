open Scc_exact

let normal polygon =
  let n = Array.length polygon and sum = ref Vec.zero in
  for i = 0 to n - 1 do
    sum := Vec.add !sum (Vec.cross polygon.(i) polygon.((i + 1) mod n))
  done;
  Ivec.primitive (fst (Ivec.of_vec !sum))

let around polygons =
  let points = List.concat_map Array.to_list polygons in
  let over choose f = List.fold_left (fun m p -> choose m (f p)) (f (List.hd points)) points in
  let corner choose step =
    let part f = Rat.add (over choose f) step in
    Vec.make (part (fun (p : Vec.t) -> p.x)) (part (fun p -> p.y)) (part (fun p -> p.z))
  in
  Cell.box (corner Rat.min (Rat.of_int (-1))) (corner Rat.max Rat.one)

let parts ?(tick = ignore) polygons =
  let box = around polygons in
  let surface polygon =
    let corners = Array.map Homogeneous.of_vec polygon in
    (Plane.make (normal polygon) corners.(0), corners)
  in
  let cells = Cut.parts ~tick box (List.map surface polygons) in
  List.map (fun cell -> List.map Homogeneous.to_vec (Cell.corners cell)) (Union.merge ~tick box cells)
