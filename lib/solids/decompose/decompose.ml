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

let surface polygon =
  let corners = Array.map Homogeneous.of_vec polygon in
  (Plane.make (normal polygon) corners.(0), corners)

let fewest = function
  | [] -> []
  | first :: rest ->
    let fewer least list = if List.compare_lengths list least < 0 then list else least in
    List.fold_left fewer first rest

let parts ?(tick = ignore) polygons =
  let box = around polygons in
  fewest (List.map (Union.merge ~tick box) (Cut.parts ~tick box (List.map surface polygons)))
