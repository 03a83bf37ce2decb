open Scc_base

(* Positive when a, b, c turn counter-clockwise on the screen. *)
let turn (ax, ay) (bx, by) (cx, cy) = -Front.cross ax ay bx by cx cy

let between (ax, ay) (bx, by) (px, py) =
  Int.min ax bx <= px && px <= Int.max ax bx && Int.min ay by <= py && py <= Int.max ay by

(* Whether two segments have a point in common. *)
let meet a b c d =
  let side = Int.compare 0 in
  let s1 = side (turn a b c) and s2 = side (turn a b d) and s3 = side (turn c d a) and s4 = side (turn c d b) in
  (s1 * s2 < 0 && s3 * s4 < 0)
  || (s1 = 0 && between a b c) || (s2 = 0 && between a b d)
  || (s3 = 0 && between c d a) || (s4 = 0 && between c d b)

(* {1 Holes} *)

(* The corner from which a hole is joined: the one farthest to the right. From there some corner of the polygon
   around can be seen when the holes farther to the right are joined already (Eberly). *)
let rightmost at hole =
  let compare : int * int -> int * int -> int = compare in
  List.fold_left (fun a b -> if compare (at b) (at a) > 0 then b else a) (List.hd hole) hole

let edges loop = List.combine loop (List.tl loop @ [ List.hd loop ])

let rec rotated_to (v : int) = function
  | x :: rest when x = v -> x :: rest
  | x :: rest -> rotated_to v (rest @ [ x ])
  | [] -> Bug.fail __POS__ "no such corner"

(* In the cone of the polygon at the occurrence b of a corner, between its neighbours a and c. *)
let in_cone at (a, b, c) p =
  let a = at a and b = at b and c = at c in
  if turn a b c > 0 then turn a b p > 0 && turn b c p > 0 else not (turn a b p <= 0 && turn b c p <= 0)

let join at walls outer hole =
  let m : int = rightmost at hole in
  let polygon = Array.of_list outer in
  let n = Array.length polygon in
  let distance v =
    let x, y = at v and x0, y0 = at m in
    ((x - x0) * (x - x0)) + ((y - y0) * (y - y0))
  in
  let sees k =
    let v = polygon.(k) in
    in_cone at (polygon.((k + n - 1) mod n), v, polygon.((k + 1) mod n)) (at m)
    && List.for_all
      (fun (a, b) -> a = v || b = v || a = m || b = m || not (meet (at a) (at b) (at v) (at m)))
      walls
    && not (List.exists (fun (a, b) ->
        let beside (e : int) other =
          e = v && turn (at v) (at m) (at other) = 0 && between (at v) (at m) (at other)
        in
        beside a b || beside b a
        || ((a = m || b = m) &&
            let other = if a = m then b else a in
            turn (at v) (at m) (at other) = 0 && between (at v) (at m) (at other)))
        walls)
  in
  let key k = (distance polygon.(k), k) in
  let order = List.sort (fun j k -> compare (key j) (key k)) (List.init n Fun.id) in
  match List.find_opt sees order with
  | None -> Bug.fail __POS__ "a hole that nothing sees"
  | Some k ->
    let first = List.filteri (fun i _ -> i <= k) outer and last = List.filteri (fun i _ -> i >= k) outer in
    (first @ rotated_to m hole @ (m :: last), (polygon.(k), m))

(* {1 Ears} *)

let cut_ears at polygon =
  let corners = Array.of_list polygon in
  let n = Array.length corners in
  let before = Array.init n (fun k -> (k + n - 1) mod n) and after = Array.init n (fun k -> (k + 1) mod n) in
  let place k = at corners.(k) in
  let is_ear k =
    let a = place before.(k) and b = place k and c = place after.(k) in
    turn a b c > 0
    &&
    let rec clear j =
      j = before.(k)
      ||
      let p = place j in
      (p = a || p = b || p = c || turn a b p < 0 || turn b c p < 0 || turn c a p < 0) && clear after.(j)
    in
    clear after.(after.(k))
  in
  let rec go k left missed found =
    if left < 3 then found
    else if missed > left then Bug.fail __POS__ "a polygon without ears"
    else if is_ear k then begin
      let a = before.(k) and c = after.(k) in
      after.(a) <- c;
      before.(c) <- a;
      go after.(c) (left - 1) 0 ((corners.(a), corners.(k), corners.(c)) :: found)
    end
    else go after.(k) left (missed + 1) found
  in
  go 0 n 0 []

let triangles loops =
  let places = Array.concat loops in
  let at v = places.(v) in
  let _, numbered =
    List.fold_left
      (fun (start, found) loop ->
         let m = Array.length loop in
         (start + m, List.init m (fun k -> start + k) :: found))
      (0, []) loops
  in
  match List.rev numbered with
  | [] -> Bug.fail __POS__ "no outline"
  | outer :: holes ->
    let right hole = at (rightmost at hole) in
    let holes = List.sort (fun a b -> compare (right b) (right a)) holes in
    let walls = List.concat_map edges (outer :: holes) in
    let polygon, _ =
      List.fold_left
        (fun (outer, walls) hole ->
           let outer, bridge = join at walls outer hole in
           (outer, bridge :: walls))
        (outer, walls) holes
    in
    (places, cut_ears at polygon)
