open Scc_base
open Scc_data

(* Of triangle k the corners are at 3 k, 3 k + 1 and 3 k + 2, and so are the triangles beyond the opposite edges,
   or -1 beyond the outline. *)
type t = {
  points : Front.corner Growable.t;
  rim : int;  (** vertices before this one are on the outline *)
  corner : int Growable.t;
  beyond : int Growable.t;
  mutable chord_count : int;
}

let vertices t = Growable.length t.points
let vertex t v = Growable.get t.points v
let on_outline t v = v < t.rim
let triangles t = Growable.length t.corner / 3
let corner t k i = Growable.get t.corner ((3 * k) + (i mod 3))
let beyond t k i = Growable.get t.beyond ((3 * k) + (i mod 3))
let corners t k = (corner t k 0, corner t k 1, corner t k 2)
let both_on_outline t a b = on_outline t a && on_outline t b

let turn t a b c =
  let a = vertex t a and b = vertex t b and c = vertex t c in
  -Front.cross a.x a.y b.x b.y c.x c.y

let set t k (a, b, c) (na, nb, nc) =
  let put array values = List.iteri (fun i v -> Growable.set array ((3 * k) + i) v) values in
  put t.corner [ a; b; c ];
  put t.beyond [ na; nb; nc ]

let fresh t =
  for _ = 1 to 3 do
    Growable.push t.corner (-1);
    Growable.push t.beyond (-1)
  done;
  triangles t - 1

(* The edge of triangle k beyond which there is triangle n. *)
let side t k n =
  if beyond t k 0 = n then 0
  else if beyond t k 1 = n then 1
  else if beyond t k 2 = n then 2
  else Bug.fail __POS__ "triangles that are no neighbours"

let relink t k ~was ~now = if k >= 0 then Growable.set t.beyond ((3 * k) + side t k was) now

(* {1 Flips} *)

(* Whether d is inside the circle of a, b, c: places are less than 2^14 in size, so that all fits. *)
let in_circle t a b c d =
  let p = vertex t d in
  let row v =
    let q = vertex t v in
    let x = q.x - p.x and y = q.y - p.y in
    (x, y, (x * x) + (y * y))
  in
  let ax, ay, a2 = row a and bx, by, b2 = row b and cx, cy, c2 = row c in
  (* With y downward the determinant has the other sign. *)
  (a2 * ((bx * cy) - (by * cx))) + (b2 * ((cx * ay) - (cy * ax))) + (c2 * ((ax * by) - (ay * bx))) < 0

let should_flip t a b c d =
  turn t a d c > 0
  && turn t d b c > 0
  &&
  match (both_on_outline t a b, both_on_outline t c d) with
  | true, false -> true
  | false, true -> false
  | true, true | false, false -> in_circle t a b c d

(* The edge opposite to corner i of k becomes the other diagonal, where that is better; its new neighbours are
   looked at in turn. Each flip leaves fewer chords, or is one of Delaunay among as many: this ends. *)
let legalize t start =
  let changed = Hashtbl.create 16 in
  let rec go = function
    | [] -> ()
    | (k, c) :: rest -> (
        Hashtbl.replace changed k ();
        let is i = corner t k i = c in
        let i = if is 0 then 0 else if is 1 then 1 else if is 2 then 2 else 3 in
        let n = if i = 3 then -1 else beyond t k i in
        if n < 0 then go rest
        else
          let a = corner t k (i + 1) and b = corner t k (i + 2) in
          let j = side t n k in
          let d = corner t n j in
          if not (should_flip t a b c d) then go rest
          else begin
            (* k = (c, a, b) and n = (d, b, a) become k = (c, a, d) and n = (d, b, c). *)
            let k_a = beyond t k (i + 1) and k_b = beyond t k (i + 2) in
            let n_b = beyond t n (j + 1) and n_a = beyond t n (j + 2) in
            set t k (c, a, d) (n_b, n, k_b);
            set t n (d, b, c) (k_a, k, n_a);
            relink t n_b ~was:n ~now:k;
            relink t k_a ~was:k ~now:n;
            if both_on_outline t a b then t.chord_count <- t.chord_count - 1;
            if both_on_outline t c d then t.chord_count <- t.chord_count + 1;
            go ((k, c) :: (k, d) :: (n, c) :: (n, d) :: (k, a) :: (n, b) :: rest)
          end)
  in
  go start;
  Hashtbl.fold (fun k () found -> k :: found) changed [] |> List.sort Int.compare

(* {1 Edges} *)

let fold_edges t f start =
  let found = ref start in
  for k = 0 to triangles t - 1 do
    for i = 0 to 2 do
      let n = beyond t k i in
      if n < k then found := f !found (corner t k (i + 1)) (corner t k (i + 2)) n
    done
  done;
  !found

let edges t = fold_edges t (fun found a b _ -> (a, b) :: found) []

let chords t =
  fold_edges t (fun found a b n -> if n >= 0 && both_on_outline t a b then (a, b) :: found else found) []

let chord_count t = t.chord_count

(* {1 The outline alone} *)

let make loops =
  let places, found = Polygon.triangles loops in
  let t =
    { points = Growable.create (); rim = Array.length places; corner = Growable.create ();
      beyond = Growable.create (); chord_count = 0 }
  in
  Array.iter (fun (x, y) -> Growable.push t.points { Front.x; y; z = 0 }) places;
  let beyond = Hashtbl.create 64 in
  List.iter
    (fun (a, b, c) ->
       let k = fresh t in
       set t k (a, b, c) (-1, -1, -1);
       List.iter (fun e -> Hashtbl.replace beyond e k) [ (a, b); (b, c); (c, a) ])
    found;
  for k = 0 to triangles t - 1 do
    let a, b, c = corners t k in
    let other e = Option.value (Hashtbl.find_opt beyond e) ~default:(-1) in
    set t k (a, b, c) (other (c, b), other (a, c), other (b, a))
  done;
  t.chord_count <- List.length (chords t);
  let holes = List.length loops - 1 in
  if triangles t <> t.rim - 2 + (2 * holes) then Bug.fail __POS__ "triangles are missing";
  let all = List.init (triangles t) (fun k -> let a, b, c = corners t k in [ (k, a); (k, b); (k, c) ]) in
  ignore (legalize t (List.concat all));
  t

(* {1 Points} *)

let locate t x y =
  let within k =
    let a, b, c = corners t k in
    let side a b =
      let a = vertex t a and b = vertex t b in
      Front.cross a.x a.y b.x b.y x y <= 0
    in
    side a b && side b c && side c a
  in
  let rec go k = if k >= triangles t then None else if within k then Some k else go (k + 1) in
  go 0

let insert t k (p : Front.corner) =
  let v = vertices t in
  Growable.push t.points p;
  let a, b, c = corners t k in
  let flat a b = turn t a b v = 0 in
  let edge = if flat b c then Some 0 else if flat c a then Some 1 else if flat a b then Some 2 else None in
  match edge with
  | None ->
    let n_a = beyond t k 0 and n_b = beyond t k 1 and n_c = beyond t k 2 in
    let l = fresh t in
    let m = fresh t in
    set t k (v, b, c) (n_a, l, m);
    set t l (v, c, a) (n_b, m, k);
    set t m (v, a, b) (n_c, k, l);
    relink t n_b ~was:k ~now:l;
    relink t n_c ~was:k ~now:m;
    legalize t [ (k, v); (l, v); (m, v) ]
  | Some i ->
    let n = beyond t k i in
    if n < 0 then Bug.fail __POS__ "a point on the outline";
    let c = corner t k i and a = corner t k (i + 1) and b = corner t k (i + 2) in
    let j = side t n k in
    let d = corner t n j in
    (* k = (c, a, b) and n = (d, b, a) become (c, a, v), (c, v, b), (d, b, v) and (d, v, a). *)
    let k_a = beyond t k (i + 1) and k_b = beyond t k (i + 2) in
    let n_b = beyond t n (j + 1) and n_a = beyond t n (j + 2) in
    if both_on_outline t a b then t.chord_count <- t.chord_count - 1;
    let l = fresh t in
    let m = fresh t in
    set t k (c, a, v) (m, l, k_b);
    set t l (c, v, b) (n, k_a, k);
    set t n (d, b, v) (l, m, n_a);
    set t m (d, v, a) (k, n_b, n);
    relink t k_a ~was:k ~now:l;
    relink t n_b ~was:n ~now:m;
    legalize t [ (k, v); (l, v); (n, v); (m, v) ]
