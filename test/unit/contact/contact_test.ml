open Scc_exact
open Scc_geometry
open Solids

(* Where two bodies are in contact: where they collide, or the offset of a scene at which they touch as
   it is. *)
let contact s =
  let o = obstacle s.a s.b in
  if Obstacle.relation o s.r = Touching then Some (o, s.r) else collision s

let when_touching f s = match contact s with None -> true | Some (o, r) -> f s o r

let corners (s : Solid.t) = function
  | Feature.Vertex i -> [ i ]
  | Feature.Edge i ->
    let v, w = s.polyhedron.edges.(i) in
    [ v; w ]
  | Feature.Face i -> List.sort Int.compare (Array.to_list (snd s.polyhedron.faces.(i)))

let compare_lists = List.compare Int.compare

let compare_triple (f, g, d) (f', g', d') =
  let c = compare_lists f f' in
  if c <> 0 then c
  else
    let c = compare_lists g g' in
    if c <> 0 then c else Int.compare d d'

let by_corners (o : Obstacle.t) (p : Contact.pair) = (corners o.a p.first, corners o.b p.second, p.dimension)

let all_pairs s o r =
  let ours = List.map (by_corners o) (Contact.touching o r) in
  let theirs = Naive.touching (placed s.a Vec.zero) (placed s.b r) in
  let same x y = compare_triple x y = 0 in
  List.equal same (List.sort compare_triple ours) (List.sort compare_triple theirs)

let touching =
  property "the touching pairs of features are those found by trying all" ~count:60 ~gen:aimed
    (when_touching all_pairs)

let touching_aligned =
  property "also for aligned bodies" ~count:75 ~gen:resting (when_touching all_pairs)

(* Reading I-4. *)
let highest =
  property "the highest pair is of the greatest dimension, and has all others in its closures" ~count:100
    ~gen:resting
    (when_touching (fun _ o r ->
         let h = Contact.highest o r and all = Contact.touching o r in
         let below (p : Contact.pair) = p.dimension <= h.dimension in
         let same (p : Contact.pair) = Feature.equal p.first h.first && Feature.equal p.second h.second in
         List.for_all below all
         && List.length (List.filter same all) = 1
         && List.for_all
           (fun (p : Contact.pair) ->
              List.exists (Feature.equal p.first) (Polyhedron.closure o.a.polyhedron [ h.first ])
              && List.exists (Feature.equal p.second) (Polyhedron.closure o.b.polyhedron [ h.second ]))
           all))

let points_a (o : Obstacle.t) f = List.map (Solid.vertex o.a) (corners o.a f)
let points_b (o : Obstacle.t) r f = List.map (fun i -> Vec.add r (Solid.vertex o.b i)) (corners o.b f)

let mean points =
  Vec.scale (Rat.make Z.one (Z.of_int (List.length points))) (List.fold_left Vec.add Vec.zero points)

(* A corner of A n B is all that its pair of features have in common; so the corners are the touching pairs
   of dimension 0. *)
let region_is_right (o : Obstacle.t) r =
  let region = Contact.region o r and h = Contact.highest o r in
  let meets p x q = Naive.relative_interiors_meet p [ x ] && Naive.relative_interiors_meet [ x ] q in
  let corner_pairs = List.filter (fun (p : Contact.pair) -> p.dimension = 0) (Contact.touching o r) in
  let has (p : Contact.pair) =
    List.exists (fun x -> meets (points_a o p.first) x (points_b o r p.second)) region
  in
  List.length region = List.length corner_pairs
  && List.for_all has corner_pairs
  && Int.equal h.dimension (Int.min 2 (List.length region - 1))
  && meets (points_a o h.first) (mean region) (points_b o r h.second)

(* The corners of a polygon go around it. *)
let in_order region =
  match region with
  | a :: b :: c :: _ ->
    let n = Vec.cross (Vec.sub b a) (Vec.sub c a) in
    let k = List.length region in
    let p = Array.of_list region in
    let side i j = Vec.sub p.((i + j) mod k) p.(i) in
    let turn i = Rat.sign (Vec.dot n (Vec.cross (side i 1) (side i 2))) in
    List.for_all (fun i -> turn i > 0) (List.init k Fun.id)
  | _ -> true

let region gen count name =
  property name ~count ~gen
    (when_touching (fun _ o r -> region_is_right o r && in_order (Contact.region o r)))

let transpose (p : Contact.pair) : Contact.pair = { p with first = p.second; second = p.first }

let symmetric =
  property "B and A see what A and B see" ~count:75 ~gen:resting
    (when_touching (fun s o r ->
         let back = Vec.neg r and p = obstacle s.b s.a in
         let compare (x : Contact.pair) (y : Contact.pair) =
           let c = Feature.compare x.first y.first in
           if c <> 0 then c else Feature.compare x.second y.second
         in
         let there = Contact.touching o r and here = List.map transpose (Contact.touching p back) in
         let same x y = compare x y = 0 && Int.equal x.Contact.dimension y.Contact.dimension in
         List.equal same there (List.sort compare here)))

(* {1 Known contacts} *)

let body plain = { name = ""; plain; turn = Mat.identity }
let cubes = lazy (obstacle (body cube) (body cube))

let dimensions () =
  let o = Lazy.force cubes in
  let v = Vec.of_ints in
  let check what r (first, second, dimension) pairs corners =
    let h = Contact.highest o r in
    Alcotest.(check (list int)) what
      [ first; second; dimension; pairs; corners ]
      [ Feature.dimension h.first; Feature.dimension h.second; h.dimension;
        List.length (Contact.touching o r); List.length (Contact.region o r) ]
  in
  let h x y z = halves (x, y, z) in
  check "whole faces" (v 2 0 0) (2, 2, 2) 9 4;
  check "faces, shifted both ways" (h 4 1 1) (2, 2, 2) 9 4;
  check "faces, shifted one way" (h 4 1 0) (2, 2, 2) 9 4;
  check "whole edges" (v 2 2 0) (1, 1, 1) 3 2;
  check "edges, shifted" (h 4 4 1) (1, 1, 1) 3 2;
  check "vertices" (v 2 2 2) (0, 0, 0) 1 1

(* A wide slab on the top of a cube: the highest pair are the faces, and the upper edges of the cube touch the
   face of the slab, but the sides of the cube below those edges do not (reading I-3). *)
let edge_not_its_other_face () =
  let o = obstacle (body cube) (body (box 3 3 1)) in
  let pairs = Contact.touching o (Vec.of_ints 0 0 2) in
  let face_pairs = List.filter (fun (p : Contact.pair) -> p.dimension = 2) pairs in
  Alcotest.(check int) "one pair of faces" 1 (List.length face_pairs);
  Alcotest.(check int) "its face, four edges, four vertices" 9 (List.length pairs)

let suite =
  ("contact",
   [ ( "known",
       [ Alcotest.test_case "two cubes" `Quick dimensions;
         Alcotest.test_case "reading I-3" `Quick edge_not_its_other_face ] );
     ( "properties",
       Scc_test_support.Property.cases
         [ touching; touching_aligned; highest; region aimed 200 "the region, where bodies collide";
           region resting 200 "the region, for aligned bodies"; symmetric ] ) ])
