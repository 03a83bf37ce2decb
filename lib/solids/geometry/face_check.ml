open Scc_exact

type problem = Off_plane of int list | Not_left of int | Crossing

(* Corners relative to the first, which keeps the numbers small and makes planes pass through zero. *)
let relative points corners =
  let origin = points.(corners.(0)) in
  Array.map (fun v -> Ivec.sub points.(v) origin) corners

let area_vector p =
  let sum = ref Ivec.zero in
  for i = 1 to Array.length p - 2 do
    sum := Ivec.add !sum (Ivec.cross p.(i) p.(i + 1))
  done;
  !sum

let normal points corners = area_vector (relative points corners)

let find_index from test p =
  let n = Array.length p in
  let rec go i = if i >= n then None else if test p.(i) then Some i else go (i + 1) in
  go from

(* The places (besides 0) of two corners that span a plane with the first, and its normal. *)
let span p =
  match find_index 1 (fun v -> not (Ivec.is_zero v)) p with
  | None -> None
  | Some a ->
    find_index (a + 1) (fun v -> not (Ivec.is_zero (Ivec.cross p.(a) v))) p
    |> Option.map (fun b -> (a, b, Ivec.cross p.(a) p.(b)))

let on_plane n v = Z.sign (Ivec.dot n v) = 0
let all_on_plane n p = Array.for_all (on_plane n) p

let planar p =
  match span p with
  | None -> true
  | Some (_, _, n) -> all_on_plane n p

let planar_without p i =
  let keep = List.filter (fun j -> j <> i) (List.init (Array.length p) Fun.id) in
  match keep with
  | [] -> true
  | j :: _ -> planar (Array.of_list (List.rev_map (fun k -> Ivec.sub p.(k) p.(j)) keep))

(* If one corner alone is off the plane of all the others, it is the first one off the plane of the spanning
   triple, or one of that triple: so four trials are enough. *)
let blame p =
  match span p with
  | None -> []
  | Some (a, b, n) -> (
      match find_index 0 (fun v -> not (on_plane n v)) p with
      | None -> []
      | Some d -> (
          match List.filter (planar_without p) [ d; b; a; 0 ] with
          | [] -> [ d ]
          | several -> List.sort_uniq (fun i j -> Int.compare j i) several))

(* The polygon seen from the tip of [n], dropping the coordinate in which [n] is longest. *)
let project (n : Ivec.t) p =
  let ax = Z.abs n.x and ay = Z.abs n.y and az = Z.abs n.z in
  let plane (v : Ivec.t) =
    if Z.geq az ax && Z.geq az ay then if Z.sign n.z > 0 then (v.x, v.y) else (v.y, v.x)
    else if Z.geq ax ay then if Z.sign n.x > 0 then (v.y, v.z) else (v.z, v.y)
    else if Z.sign n.y > 0 then (v.z, v.x)
    else (v.x, v.z)
  in
  Array.map plane p

let orient (ax, ay) (bx, by) (cx, cy) =
  Z.sign
    (Z.sub
       (Z.mul (Z.sub bx ax) (Z.sub cy ay))
       (Z.mul (Z.sub by ay) (Z.sub cx ax)))

(* How often the sides of a polygon that only turns left go round: each round enters the upper half plane
   of directions once, as no turn reaches 180 degrees. *)
let winding q =
  let n = Array.length q in
  let upper i =
    let x, y = q.(i) and x', y' = q.((i + 1) mod n) in
    let c = Z.compare y' y in
    c > 0 || (c = 0 && Z.gt x' x)
  in
  let count = ref 0 in
  for i = 0 to n - 1 do
    if upper ((i + 1) mod n) && not (upper i) then incr count
  done;
  !count

let sides_cross q i j =
  let n = Array.length q in
  let a = q.(i) and b = q.((i + 1) mod n) and c = q.(j) and d = q.((j + 1) mod n) in
  orient a b c * orient a b d < 0 && orient c d a * orient c d b < 0

let some_sides_cross q =
  let n = Array.length q in
  let rec pair i j =
    if i >= n then false
    else if j >= n then pair (i + 1) (i + 3)
    else sides_cross q i j || pair i (j + 1)
  in
  n <= 64 && pair 0 2

let check points corners =
  let p = relative points corners in
  let area = area_vector p in
  let n = Array.length p in
  let flat = if Ivec.is_zero area then planar p else all_on_plane area p in
  if not flat then Error (Off_plane (blame p))
  else
    let turns_left i =
      let before = p.((i + n - 1) mod n) and here = p.(i) and after = p.((i + 1) mod n) in
      Z.sign (Ivec.det (Ivec.sub here before) (Ivec.sub after here) area) > 0
    in
    let rec wrong i = if i >= n then None else if turns_left i then wrong (i + 1) else Some i in
    let seen_along =
      if Ivec.is_zero area then Option.map (fun (_, _, n) -> n) (span p) else Some area
    in
    match (wrong 0, seen_along) with
    | None, _ -> if winding (project area p) > 1 then Error Crossing else Ok area
    | Some _, Some view when some_sides_cross (project view p) -> Error Crossing
    | Some i, _ -> Error (Not_left i)
