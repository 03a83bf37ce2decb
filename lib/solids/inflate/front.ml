type corner = { x : int; y : int; z : int }

let unit = 8
let cross ax ay bx by cx cy = ((bx - ax) * (cy - ay)) - ((by - ay) * (cx - ax))

(* The four centres in the order a (left, top), b (right, top), c (right, bottom), d (left, bottom), which is
   clockwise on the screen; triangles are listed the other way round at the end. *)
let clockwise (r : Relief.t) i j =
  let s = r.shape in
  let at i j =
    let inside = Silhouette.is_inside s i j in
    ({ x = unit * i; y = unit * j; z = (if inside then r.heights.((j * s.width) + i) else 0) }, inside)
  in
  let middle (p, _) (q, _) = { x = (p.x + q.x) / 2; y = (p.y + q.y) / 2; z = 0 } in
  let a = at i j and b = at (i + 1) j and c = at (i + 1) (j + 1) and d = at i (j + 1) in
  (* Of what is turned so that: one is inside, the first; two, the first two; three, all but the last. *)
  let one p next last = [ (fst p, middle p next, middle p last) ] in
  let two p q after last =
    let m = middle q after and n = middle p last in
    if (fst p).z >= (fst q).z then [ (fst p, fst q, m); (fst p, m, n) ] else [ (fst p, fst q, n); (fst q, m, n) ]
  in
  let three p q r last =
    let m = middle r last and n = middle last p in
    [ (fst q, fst r, m); (fst q, m, n); (fst q, n, fst p) ]
  in
  match (snd a, snd b, snd c, snd d) with
  | false, false, false, false -> []
  | true, true, true, true ->
    let a = fst a and b = fst b and c = fst c and d = fst d in
    if a.z + c.z >= b.z + d.z then [ (a, b, c); (a, c, d) ] else [ (a, b, d); (b, c, d) ]
  | true, false, false, false -> one a b d
  | false, true, false, false -> one b c a
  | false, false, true, false -> one c d b
  | false, false, false, true -> one d a c
  | true, false, true, false -> one a b d @ one c d b
  | false, true, false, true -> one b c a @ one d a c
  | true, true, false, false -> two a b c d
  | false, true, true, false -> two b c d a
  | false, false, true, true -> two c d a b
  | true, false, false, true -> two d a b c
  | true, true, true, false -> three a b c d
  | false, true, true, true -> three b c d a
  | true, false, true, true -> three c d a b
  | true, true, false, true -> three d a b c

let triangles r i j = List.map (fun (p, q, s) -> (p, s, q)) (clockwise r i j)

let floor_div a b = if a >= 0 then a / b else -((b - 1 - a) / b)

let height r x y =
  let i = floor_div x unit and j = floor_div y unit in
  let within (p, q, s) =
    let u = cross p.x p.y q.x q.y x y and v = cross q.x q.y s.x s.y x y and w = cross s.x s.y p.x p.y x y in
    if u <= 0 && v <= 0 && w <= 0 then Some (-((v * p.z) + (w * q.z) + (u * s.z)), -(u + v + w)) else None
  in
  match List.find_map within (triangles r i j) with Some found -> found | None -> (0, 1)

