open Scc_exact

(* The extreme point of a polygon, in the order of coordinates, is a corner of its hull. Seen from there the others
   lie within half a turn, and a convex polygon has them by angle. *)
let order points corners =
  let least a v = if Ivec.compare points.(v) points.(a) < 0 then v else a in
  let start = Array.fold_left least corners.(0) corners in
  let from v = Ivec.sub points.(v) points.(start) in
  let others = List.filter (fun v -> v <> start) (Array.to_list corners) in
  let normal =
    match others with
    | [] -> Ivec.zero
    | v :: rest ->
      let crosses = List.map (fun w -> Ivec.cross (from v) (from w)) rest in
      Option.value ~default:Ivec.zero (List.find_opt (fun n -> not (Ivec.is_zero n)) crosses)
  in
  let turn v w = Z.sign (Ivec.det (from v) (from w) normal) in
  let round = Array.of_list (start :: List.sort (fun v w -> turn w v) others) in
  let n = Array.length round in
  let at i = points.(round.(i mod n)) in
  let left i =
    Z.sign (Ivec.det (Ivec.sub (at (i + 1)) (at i)) (Ivec.sub (at (i + 2)) (at (i + 1))) normal) > 0
  in
  let whole = n = Array.length corners && List.for_all left (List.init n Fun.id) in
  let rec place i = if round.(i) = corners.(0) then i else place (i + 1) in
  if whole then
    let first = place 0 in
    Some (Array.init n (fun i -> round.((first + i) mod n)))
  else None

let turned corners =
  let n = Array.length corners in
  Array.init n (fun i -> corners.((n - i) mod n))

let outward points faces =
  let used = Array.concat (Array.to_list faces) in
  let sum = Array.fold_left (fun s v -> Ivec.add s points.(v)) Ivec.zero used in
  let count = Z.of_int (Array.length used) in
  fun corners ->
    let beyond = Ivec.sub (Ivec.scale count points.(corners.(0))) sum in
    if Z.sign (Ivec.dot (Face_check.normal points corners) beyond) < 0 then turned corners else corners

let sides corners =
  let n = Array.length corners in
  List.init n (fun i ->
      let v = corners.(i) and w = corners.((i + 1) mod n) in
      (Int.min v w, Int.max v w))

let none = function [] -> true | _ :: _ -> false

let repair points faces wrong =
  if none wrong then faces else
    let outward = outward points faces in
    let tried = Array.copy faces in
    List.iter (fun f -> Option.iter (fun o -> tried.(f) <- outward o) (order points faces.(f))) wrong;
    let owners = Hashtbl.create 64 in
    Array.iteri (fun f corners -> List.iter (fun side -> Hashtbl.add owners side f) (sides corners)) tried;
    let shared f corners =
      let with_another side = List.exists (fun g -> g <> f) (Hashtbl.find_all owners side) in
      List.length (List.filter with_another (sides corners))
    in
    let better f corners = if shared f tried.(f) > shared f corners then tried.(f) else corners in
    Array.mapi (fun f corners -> if tried.(f) == corners then corners else better f corners) faces
