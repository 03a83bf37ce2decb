open Scc_base
open Scc_data
open Scc_exact

(* A triangle of the surface so far, counter-clockwise from outside, with the plane n . x = d. It keeps the points
   that are strictly in front of it and seen through it from the middle, and the farthest of these. *)
type facet = {
  a : int;
  b : int;
  c : int;
  n : Ivec.t;
  d : Z.t;
  mutable outside : int list;
  mutable far : int;
  mutable height : Z.t;
  mutable there : bool;  (* still a part of the surface *)
}

let facet (p : Ivec.t array) a b c =
  let n = Ivec.cross (Ivec.sub p.(b) p.(a)) (Ivec.sub p.(c) p.(a)) in
  { a; b; c; n; d = Ivec.dot n p.(a); outside = []; far = 0; height = Z.zero; there = true }

let height f p = Z.sub (Ivec.dot f.n p) f.d
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
  let f = facet p a b c in
  let*? d = find n (fun i -> Z.sign (height f p.(i)) <> 0) in
  (* d is to be behind the triangle of the others *)
  Some (if Z.sign (height f p.(d)) < 0 then (a, b, c, d) else (a, c, b, d))

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
  let h = height f points.(i) in
  if Z.sign h > 0 then begin
    let c = if f.outside = [] then 1 else Z.compare h f.height in
    if c > 0 || (c = 0 && i < f.far) then begin
      f.far <- i;
      f.height <- h
    end;
    f.outside <- i :: f.outside
  end

(* Facets around a new corner, by angle about the line to it from the middle: from the plane of [sides.(i)] to that
   of the next one. In [upper] are those less than half a turn from the first. All angles between neighbours are
   less than that, as the middle is inside. *)
type fan = { facets : facet array; sides : Ivec.t array; upper : bool array }

let fan points p border =
  let line = Array.of_list border in
  let sides = Array.map (fun (v, _) -> Ivec.cross points.(p) points.(v)) line in
  let upper = Array.mapi (fun i (v, _) -> i = 0 || Z.sign (Ivec.dot sides.(0) points.(v)) > 0) line in
  { facets = Array.map (fun (v, w) -> facet points v w p) line; sides; upper }

let through fan point =
  let left i = Z.sign (Ivec.dot fan.sides.(i) point) >= 0 in
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
        else if Z.sign (height g points.(p)) > 0 then begin
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
  List.iter (fun f -> List.iter (fun i -> put points (through fan points.(i)) i) f.outside) gone;
  Array.to_list fan.facets

(* {1 All of them}

   With the farthest point of a facet first, as Barber et al. do (The quickhull algorithm for convex hulls, 1996),
   most of the others are inside soon, and what is in the plane of a face never becomes a corner. *)

let start points (a, b, c, d) =
  let facets = [ facet points a b c; facet points a d b; facet points b d c; facet points c d a ] in
  let sides f = List.map (fun (v, w) -> Ivec.cross points.(v) points.(w)) (edges_of f) in
  let cones = List.map (fun f -> (f, sides f)) facets in
  let place i point =
    let within (_, sides) = List.for_all (fun side -> Z.sign (Ivec.dot side point) >= 0) sides in
    match List.find_opt within cones with
    | Some (f, _) -> put points f i
    | None -> Bug.fail __POS__ "a point is seen through no facet of a tetrahedron"
  in
  Array.iteri place points;
  facets

let triangles positions =
  let points, _ = Ivec.of_vecs positions in
  let*? four = first_four points in
  let points = about_the_middle points four in
  let edges = Int_pairs.create 1024 in
  let first = start points four in
  List.iter (enter edges) first;
  let rec grow = function
    | [] -> ()
    | f :: rest -> grow (if f.there && f.outside <> [] then List.rev_append (add points edges f) rest else rest)
  in
  grow first;
  Some (Int_pairs.fold (fun (v, _) f all -> if v = f.a then [| f.a; f.b; f.c |] :: all else all) edges [])
