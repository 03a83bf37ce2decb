open Scc_base
open Scc_data
open Scc_exact

(* {1 Heights, in floats where these are certain}

   Let m bound the coordinates, and u be 2^-53. In floats a coordinate is off by at most 2 m u. The difference of
   two is at most 2 m, and off by 6 m u: by both of them, and its own rounding. A product of two differences is at
   most 4 m^2, and off by 28 m^2 u. A coordinate of the normal is at most 8 m^2, and off by 64 m^2 u. Its product
   with a difference is at most 16 m^3, and off by 192 m^3 u. The sum of three is off by 656 m^3 u, with its two
   roundings. With terms of order u^2 that is less than 2^-43 m^3. *)

type points = {
  exact : Ivec.t array;
  xs : float array;
  ys : float array;
  zs : float array;
  error : float;  (* of heights *)
}

(* Of coordinates in floats, so that their third power is a float. What is cut off is far less than m u. *)
let most_bits = 300

let points_of exact =
  let larger m (v : Ivec.t) = List.fold_left (fun m c -> Int.max m (Z.numbits c)) m [ v.x; v.y; v.z ] in
  let bits = Array.fold_left larger 1 exact in
  let cut = Int.max 0 (bits - most_bits) in
  let floats axis = Array.map (fun v -> Z.to_float (Z.shift_right (axis v) cut)) exact in
  let m = ldexp 1. (bits - cut) in
  {
    exact;
    xs = floats (fun v -> v.Ivec.x);
    ys = floats (fun v -> v.Ivec.y);
    zs = floats (fun v -> v.Ivec.z);
    error = 0x1p-43 *. m *. m *. m;
  }

(* A triangle of the surface so far, counter-clockwise from outside. It keeps the points that are strictly in front
   of it and seen through it from the middle, and the farthest of these. *)
type facet = {
  a : int;
  b : int;
  c : int;
  nx : float;
  ny : float;
  nz : float;
  plane : (Ivec.t * Z.t) Lazy.t;  (* n . x = d *)
  mutable outside : int list;
  mutable far : int;
  mutable there : bool;  (* still a part of the surface *)
}

let facet p a b c =
  let plane =
    lazy
      (let at = p.exact.(a) in
       let n = Ivec.cross (Ivec.sub p.exact.(b) at) (Ivec.sub p.exact.(c) at) in
       (n, Ivec.dot n at))
  in
  let bx = p.xs.(b) -. p.xs.(a) and by = p.ys.(b) -. p.ys.(a) and bz = p.zs.(b) -. p.zs.(a) in
  let cx = p.xs.(c) -. p.xs.(a) and cy = p.ys.(c) -. p.ys.(a) and cz = p.zs.(c) -. p.zs.(a) in
  let nx = (by *. cz) -. (bz *. cy) and ny = (bz *. cx) -. (bx *. cz) and nz = (bx *. cy) -. (by *. cx) in
  { a; b; c; nx; ny; nz; plane; outside = []; far = 0; there = true }

(* In floats, off by at most [p.error]. *)
let near_height p f i =
  (f.nx *. (p.xs.(i) -. p.xs.(f.a))) +. (f.ny *. (p.ys.(i) -. p.ys.(f.a))) +. (f.nz *. (p.zs.(i) -. p.zs.(f.a)))

let height p f i =
  let n, d = Lazy.force f.plane in
  Z.sub (Ivec.dot n p.exact.(i)) d

let side_of p f i =
  let near = near_height p f i in
  if near > p.error then 1 else if near < -.p.error then -1 else Z.sign (height p f i)

let compare_heights p f i j =
  let near = near_height p f i -. near_height p f j in
  (* a rounding more, of less than the errors of both *)
  if near > 4. *. p.error then 1
  else if near < -4. *. p.error then -1
  else Z.compare (height p f i) (height p f j)

let edges_of f = [ (f.a, f.b); (f.b, f.c); (f.c, f.a) ]

(* {1 Four points that are not in one plane} *)

let find n test =
  let rec go i = if i >= n then None else if test i then Some i else go (i + 1) in
  go 0

let first_four p =
  let n = Array.length p in
  let*? a = if n > 0 then Some 0 else None in
  let*? b = find n (fun i -> not (Ivec.equal p.(i) p.(a))) in
  let across i = Ivec.cross (Ivec.sub p.(b) p.(a)) (Ivec.sub p.(i) p.(a)) in
  let*? c = find n (fun i -> not (Ivec.is_zero (across i))) in
  let normal = across c in
  let ahead i = Z.sign (Ivec.dot normal (Ivec.sub p.(i) p.(a))) in
  let*? d = find n (fun i -> ahead i <> 0) in
  (* d is to be behind the triangle of the others *)
  Some (if ahead d < 0 then (a, b, c, d) else (a, c, b, d))

(* All points, four times as far apart, about the middle of these four, which is inside of the solid for good. *)
let about_the_middle p (a, b, c, d) =
  let sum = Ivec.add (Ivec.add p.(a) p.(b)) (Ivec.add p.(c) p.(d)) in
  let four = Z.of_int 4 in
  Array.map (fun v -> Ivec.sub (Ivec.scale four v) sum) p

(* {1 The facet through which a point is seen from the middle}

   A point is outside of the solid just when it is strictly in front of that one, so that each point has to be with
   one facet only. *)

(* Of two points at one place the first one is taken. *)
let put points f i =
  if side_of points f i > 0 then begin
    let c = if f.outside = [] then 1 else compare_heights points f i f.far in
    if c > 0 || (c = 0 && i < f.far) then f.far <- i;
    f.outside <- i :: f.outside
  end

(* Facets around a new corner, by angle about the line to it from the middle: from the plane of [sides.(i)] to that
   of the next one. In [upper] are those less than half a turn from the first. All angles between neighbours are
   less than that, as the middle is inside. *)
type fan = { apex : int; facets : facet array; line : int array; upper : bool array }

(* The sign of the volume of the middle and three points: 1 if they are counter-clockwise, seen from outside. In
   floats it is less in error than a height is. *)
let turn p i j k =
  let nx = (p.ys.(i) *. p.zs.(j)) -. (p.zs.(i) *. p.ys.(j))
  and ny = (p.zs.(i) *. p.xs.(j)) -. (p.xs.(i) *. p.zs.(j))
  and nz = (p.xs.(i) *. p.ys.(j)) -. (p.ys.(i) *. p.xs.(j)) in
  let near = (nx *. p.xs.(k)) +. (ny *. p.ys.(k)) +. (nz *. p.zs.(k)) in
  if near > p.error then 1
  else if near < -.p.error then -1
  else Z.sign (Ivec.dot (Ivec.cross p.exact.(i) p.exact.(j)) p.exact.(k))

let fan points p border =
  let facets = Array.of_list (List.map (fun (v, w) -> facet points v w p) border) in
  let line = Array.of_list (List.map fst border) in
  { apex = p; facets; line; upper = Array.mapi (fun i v -> i = 0 || turn points p line.(0) v > 0) line }

let through points fan k =
  let left i = turn points fan.apex fan.line.(i) k >= 0 in
  let begins_before =
    if left 0 then fun i -> fan.upper.(i) && left i else fun i -> fan.upper.(i) || left i
  in
  (* the last one that does *)
  let rec last low high =
    if high - low <= 1 then low
    else
      let middle = (low + high) / 2 in
      if begins_before middle then last middle high else last low middle
  in
  fan.facets.(last 0 (Array.length fan.facets))

(* {1 One more point}

   The facets that see the point strictly from their fronts go; they hang together, and their border is one closed
   line, which is joined to the point. It is in the plane of no facet that goes, so that no new triangle is
   degenerate. *)

(* The facets that go, from one of them on, and the directed edges at their border. *)
let seen points edges f p =
  let rec go gone border = function
    | [] -> (gone, border)
    | f :: rest ->
      let look (border, rest) (v, w) =
        let g = Int_pairs.find edges (w, v) in
        if not g.there then (border, rest)
        else if side_of points g p > 0 then begin
          g.there <- false;
          (border, g :: rest)
        end
        else ((v, w) :: border, rest)
      in
      let border, rest = List.fold_left look (border, rest) (edges_of f) in
      go (f :: gone) border rest
  in
  f.there <- false;
  go [] [] [ f ]

(* As one closed line. *)
let in_order border =
  let after : (int, int) Hashtbl.t = Hashtbl.create 16 in
  List.iter (fun (v, w) -> Hashtbl.replace after v w) border;
  let start = fst (List.hd border) in
  let rec follow line v =
    match Hashtbl.find_opt after v with
    | Some w when w = start -> List.rev ((v, w) :: line)
    | Some w -> follow ((v, w) :: line) w
    | None -> Bug.fail __POS__ "the border of what a point sees is not closed"
  in
  follow [] start

let enter edges f = List.iter (fun e -> Int_pairs.replace edges e f) (edges_of f)

let add points edges f =
  let p = f.far in
  let gone, border = seen points edges f p in
  List.iter (fun f -> List.iter (Int_pairs.remove edges) (edges_of f)) gone;
  let fan = fan points p (in_order border) in
  Array.iter (enter edges) fan.facets;
  List.iter (fun f -> List.iter (fun i -> put points (through points fan i) i) f.outside) gone;
  Array.to_list fan.facets

(* {1 All of them}

   With the farthest point of a facet first, as Barber et al. do (The quickhull algorithm for convex hulls, 1996),
   most of the others are inside soon, and what is in the plane of a face never becomes a corner. *)

let start points (a, b, c, d) =
  let facets = [ facet points a b c; facet points a d b; facet points b d c; facet points c d a ] in
  let place i =
    match List.find_opt (fun f -> List.for_all (fun (v, w) -> turn points v w i >= 0) (edges_of f)) facets with
    | Some f -> put points f i
    | None -> Bug.fail __POS__ "a point is seen through no facet of a tetrahedron"
  in
  for i = 0 to Array.length points.exact - 1 do
    place i
  done;
  facets

let triangles positions =
  let points, _ = Ivec.of_vecs positions in
  let*? four = first_four points in
  let points = points_of (about_the_middle points four) in
  let edges = Int_pairs.create 1024 in
  let first = start points four in
  List.iter (enter edges) first;
  let rec grow = function
    | [] -> ()
    | f :: rest -> grow (if f.there && f.outside <> [] then List.rev_append (add points edges f) rest else rest)
  in
  grow first;
  Some (Int_pairs.fold (fun (v, _) f all -> if v = f.a then [| f.a; f.b; f.c |] :: all else all) edges [])
