open Scc_exact

(* A triangle of the surface so far, counter-clockwise from outside, with the plane n . x = d. *)
type facet = { a : int; b : int; c : int; n : Ivec.t; d : Z.t }

let facet (p : Ivec.t array) a b c =
  let n = Ivec.cross (Ivec.sub p.(b) p.(a)) (Ivec.sub p.(c) p.(a)) in
  { a; b; c; n; d = Ivec.dot n p.(a) }

let side f p = Z.compare (Ivec.dot f.n p) f.d

(* {1 Four points that are not in one plane} *)

let find n test =
  let rec go i = if i >= n then None else if test i then Some i else go (i + 1) in
  go 0

let ( let* ) = Option.bind

let first_four p =
  let n = Array.length p in
  let* a = if n > 0 then Some 0 else None in
  let* b = find n (fun i -> not (Ivec.equal p.(i) p.(a))) in
  let across i = Ivec.cross (Ivec.sub p.(b) p.(a)) (Ivec.sub p.(i) p.(a)) in
  let* c = find n (fun i -> not (Ivec.is_zero (across i))) in
  let f = facet p a b c in
  let* d = find n (fun i -> side f p.(i) <> 0) in
  (* d is to be behind the triangle of the others *)
  Some (if side f p.(d) < 0 then (a, b, c, d) else (a, c, b, d))

(* {1 One more point}

   The facets that see the point strictly from their fronts go; their border is joined to it. The point is in the
   plane of no facet that goes, so that no new triangle is degenerate. Points in the planes of facets are inside,
   or seen by other facets. *)

module Edges = Hashtbl.Make (struct
    type t = int * int

    let equal (a, b) (c, d) = Int.equal a c && Int.equal b d
    let hash (a, b) = (a * 1000003) lxor b
  end)

let add points facets p =
  let seen, hidden = List.partition (fun f -> side f points.(p) > 0) facets in
  if seen = [] then facets
  else begin
    let edges = Edges.create 16 in
    let note f = List.iter (fun e -> Edges.replace edges e ()) [ (f.a, f.b); (f.b, f.c); (f.c, f.a) ] in
    List.iter note seen;
    let border f =
      List.filter (fun (v, w) -> not (Edges.mem edges (w, v))) [ (f.a, f.b); (f.b, f.c); (f.c, f.a) ]
    in
    let join (v, w) = facet points v w p in
    List.rev_append (List.map join (List.concat_map border seen)) hidden
  end

let triangles positions =
  let points, _ = Ivec.of_vecs positions in
  let* a, b, c, d = first_four points in
  let start = [ facet points a b c; facet points a d b; facet points b d c; facet points c d a ] in
  let all = List.init (Array.length points) Fun.id in
  let facets = List.fold_left (add points) start all in
  Some (List.rev_map (fun f -> [| f.a; f.b; f.c |]) facets)
