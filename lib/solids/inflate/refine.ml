open Front

(* A centre of a pixel strictly inside the triangle or on an edge that is no part of the outline, where the surface
   and the triangle differ most, with 1/256 of a quantum as the least difference that counts. *)
type candidate = { gap : int; pixel : int * int }

let none = { gap = 0; pixel = (0, 0) }

let worst_in (r : Relief.t) t k =
  let va, vb, vc = Triangulation.corners t k in
  let a = Triangulation.vertex t va and b = Triangulation.vertex t vb and c = Triangulation.vertex t vc in
  let area = -cross a.x a.y b.x b.y c.x c.y in
  let low p q s = (min p (min q s) + unit - 1) / unit and high p q s = max p (max q s) / unit in
  let rim p q = Triangulation.on_outline t p && Triangulation.on_outline t q in
  let ab = rim va vb and bc = rim vb vc and ca = rim vc va in
  let best = ref none in
  for j = low a.y b.y c.y to high a.y b.y c.y do
    for i = low a.x b.x c.x to high a.x b.x c.x do
      let x = unit * i and y = unit * j in
      let u = -cross a.x a.y b.x b.y x y and v = -cross b.x b.y c.x c.y x y in
      let w = area - u - v in
      if
        u >= 0 && v >= 0 && w >= 0
        && not ((u = 0 && ab) || (v = 0 && bc) || (w = 0 && ca))
        && u < area && v < area && w < area
        && Silhouette.is_inside r.shape i j
      then begin
        let there = (v * a.z) + (w * b.z) + (u * c.z) in
        let gap = abs ((r.heights.((j * r.shape.width) + i) * area) - there) * 256 / area in
        if gap > !best.gap then best := { gap; pixel = (i, j) }
      end
    done
  done;
  !best

(* {1 What has to be there} *)

let height_or_least r x y =
  let n, d = Front.height r x y in
  max 1 (((2 * n) + d) / (2 * d))

let split_chord r t (a, b) =
  let a = Triangulation.vertex t a and b = Triangulation.vertex t b in
  let x = (a.x + b.x) / 2 and y = (a.y + b.y) / 2 in
  match Triangulation.locate t x y with
  | None -> Scc_base.Bug.fail __POS__ "a chord outside of its polygon"
  | Some k -> Triangulation.insert t k { x; y; z = height_or_least r x y }

(* A polygon that is a triangle has neither chords nor vertices within: it gets one, nearer to its first corner.
   The corners are at multiples of four. *)
let fill r t =
  if Triangulation.triangles t = 1 then begin
    let a, b, c = Triangulation.corners t 0 in
    let a = Triangulation.vertex t a and b = Triangulation.vertex t b and c = Triangulation.vertex t c in
    let x = ((2 * a.x) + b.x + c.x) / 4 and y = ((2 * a.y) + b.y + c.y) / 4 in
    ignore (Triangulation.insert t 0 { x; y; z = height_or_least r x y })
  end

(* {1 All of it} *)

let reaching ~progress r loops ~most =
  let least = Outline.corners loops - 2 + (2 * (List.length loops - 1)) in
  (* Each triangle of the outline alone needs a corner within; four edges of the outline share one at best. *)
  if least + 1 > most then Error (least + 2)
  else begin
    let t = Triangulation.make loops in
    let best = ref (Array.init (Triangulation.triangles t) (worst_in r t)) in
    let update k =
      if k >= Array.length !best then begin
        let longer = Array.make (2 * (k + 1)) none in
        Array.blit !best 0 longer 0 (Array.length !best);
        best := longer
      end;
      !best.(k) <- worst_in r t k
    in
    (* Each chord that is left takes one vertex more, and so two triangles. *)
    let rec add () =
      let used = Triangulation.triangles t + (2 * Triangulation.chord_count t) in
      progress (float_of_int used /. float_of_int most);
      let worst = ref 0 in
      for k = 1 to Triangulation.triangles t - 1 do
        if !best.(k).gap > !best.(!worst).gap then worst := k
      done;
      let { gap; pixel = i, j } = !best.(!worst) in
      if used + 2 <= most && gap > 0 then begin
        let z = r.Relief.heights.((j * r.shape.width) + i) in
        List.iter update (Triangulation.insert t !worst { x = unit * i; y = unit * j; z });
        add ()
      end
      else
        match Triangulation.chords t with
        | [] -> fill r t
        | chord :: _ ->
          List.iter update (split_chord r t chord);
          add ()
    in
    add ();
    let used = Triangulation.triangles t in
    if used > most then Error used else Ok t
  end
