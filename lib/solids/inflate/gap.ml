open Front

(* |n/d| rounded up, for d > 0. *)
let up n d = (abs n + d - 1) / d

(* Corners of the surface in or on a triangle; [covered] remembers them. *)
let corners_in (r : Relief.t) t ~columns covered k =
  let s = r.shape in
  let va, vb, vc = Triangulation.corners t k in
  let a = Triangulation.vertex t va and b = Triangulation.vertex t vb and c = Triangulation.vertex t vc in
  let area = -cross a.x a.y b.x b.y c.x c.y in
  let half = unit / 2 in
  let low p q s = (min p (min q s) + half - 1) / half and high p q s = max p (max q s) / half in
  let greatest = ref 0 in
  for j = low a.y b.y c.y to high a.y b.y c.y do
    for i = low a.x b.x c.x to high a.x b.x c.x do
      (* Where both are odd there is a corner of four pixels, and none of the surface. *)
      if i land j land 1 = 0 then begin
        let x = half * i and y = half * j in
        let u = -cross a.x a.y b.x b.y x y and v = -cross b.x b.y c.x c.y x y in
        let w = area - u - v in
        let height =
          if i land 1 = 0 && j land 1 = 0 then Some r.heights.((j / 2 * s.width) + (i / 2))
          else
            let inside i j = Silhouette.is_inside s i j in
            if inside (i / 2) (j / 2) <> inside ((i + 1) / 2) ((j + 1) / 2) then Some 0 else None
        in
        match height with
        | Some z when u >= 0 && v >= 0 && w >= 0 ->
          Bytes.set covered ((j * columns) + i) '\001';
          greatest := max !greatest (up ((z * area) - ((v * a.z) + (w * b.z) + (u * c.z))) area)
        | _ -> ()
      end
    done
  done;
  !greatest

(* Crossings of an edge of the triangulation with the edges of the surface in the cells that its box meets, row by
   row: only those columns that the edge has in the row. *)
let crossings r t (va, vb) =
  let a = Triangulation.vertex t va and b = Triangulation.vertex t vb in
  let greatest = ref 0 in
  let with_edge (p : corner) (q : corner) =
    (* a + (b - a) s/d = p + (q - p) u/d *)
    let d = ((b.x - a.x) * (q.y - p.y)) - ((b.y - a.y) * (q.x - p.x)) in
    if d <> 0 then begin
      let s = ((p.x - a.x) * (q.y - p.y)) - ((p.y - a.y) * (q.x - p.x)) in
      let u = ((p.x - a.x) * (b.y - a.y)) - ((p.y - a.y) * (b.x - a.x)) in
      let d, s, u = if d < 0 then (-d, -s, -u) else (d, s, u) in
      if 0 <= s && s <= d && 0 <= u && u <= d then
        greatest := max !greatest (up ((d * (a.z - p.z)) + (s * (b.z - a.z)) - (u * (q.z - p.z))) d)
    end
  in
  let cell i j =
    List.iter (fun (p, q, s) -> with_edge p q; with_edge q s; with_edge s p) (triangles r i j)
  in
  let upper, lower = if a.y <= b.y then (a, b) else (b, a) in
  let height = lower.y - upper.y in
  for j = (upper.y / unit) - 1 to lower.y / unit do
    let x_at y =
      if height = 0 then (min a.x b.x, max a.x b.x)
      else
        let y = max upper.y (min lower.y y) in
        let x = upper.x + ((lower.x - upper.x) * (y - upper.y) / height) in
        (x - 1, x + 1)
    in
    let l0, h0 = x_at (unit * j) and l1, h1 = x_at (unit * (j + 1)) in
    for i = ((min l0 l1) / unit) - 1 to max h0 h1 / unit do
      cell i j
    done
  done;
  !greatest

let between (r : Relief.t) t =
  let s = r.shape in
  let greatest = ref 0 in
  let see gap = greatest := max !greatest gap in
  let columns = 2 * s.width in
  let covered = Bytes.make (columns * 2 * s.height) '\000' in
  for k = 0 to Triangulation.triangles t - 1 do
    see (corners_in r t ~columns covered k)
  done;
  (* Centres beyond the outline of the triangulation; corners of the outline of the surface are 0, as it is
     there. *)
  Array.iteri
    (fun i z ->
       if Bytes.get covered ((2 * (i / s.width) * columns) + (2 * (i mod s.width))) = '\000' then see z)
    r.heights;
  for v = 0 to Triangulation.vertices t - 1 do
    let p = Triangulation.vertex t v in
    let n, d = height r p.x p.y in
    see (up ((p.z * d) - n) d)
  done;
  List.iter (fun e -> see (crossings r t e)) (Triangulation.edges t);
  !greatest
