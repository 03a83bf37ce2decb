open Scc_exact
open Scc_geometry
open Scc_rigid
open Bodies

let resolution = ratio 1 1048576
let eps = ratio 1 4194304
let find = Near_contact.find ~resolution

let the what = function Some c -> c | None -> Alcotest.failf "%s: no contact" what

(* {1 Against the exact reading}

   From two solids that touch, the second is moved away along the sum n of the directions that separate them. That
   is in the relative interior of their normal cone, so that the gap is exactly what it was moved by, and whatever
   is near the plane was in the common plane before. *)

let compare_pairs (p : Contact.pair) (q : Contact.pair) =
  let c = Feature.compare p.first q.first in
  if c <> 0 then c
  else
    let c = Feature.compare p.second q.second in
    if c <> 0 then c else Int.compare p.dimension q.dimension

let same_pair p q = compare_pairs p q = 0
let same_pairs = List.equal same_pair
let same_points p q = List.equal Vec.equal (List.sort Vec.compare p) (List.sort Vec.compare q)
let same_normals p q = List.equal Ivec.equal (List.sort Ivec.compare p) (List.sort Ivec.compare q)

type exact = { obstacle : Obstacle.t; r : Vec.t; normals : Ivec.t list }

let exact (a : Placed.t) (b : Placed.t) =
  let obstacle = Obstacle.make (Placed.fixed_solid a) (Placed.fixed_solid b) in
  let r = Vec.sub b.at a.at in
  { obstacle; r; normals = Obstacle.separating obstacle r }

let length_bound n = Rat.of_int (3 * Z.to_int (List.fold_left Z.max Z.one (List.map Z.abs n)))

let lifted a b =
  let e = exact a b in
  let n = Ivec.primitive (List.fold_left Ivec.add Ivec.zero e.normals) in
  let gap = Vec.scale (Rat.div eps (length_bound [ n.x; n.y; n.z ])) (Ivec.to_vec n) in
  (e, n, gap, { b with Placed.at = Vec.add b.at gap })

let as_exact (a, b) =
  let e, n, gap, above = lifted a b in
  match find a above with
  | None -> false
  | Some c ->
    let middle p = Vec.axpy (ratio 1 2) gap (Vec.add a.at p) in
    Vec.equal c.gap gap
    && same_normals c.normals [ n ]
    && same_pairs c.pairs (Contact.touching e.obstacle e.r)
    && same_pair c.highest (Contact.highest e.obstacle e.r)
    && same_points c.corners (List.map middle (Contact.region e.obstacle e.r))

let exactly (a, b) =
  let e = exact a b in
  match find a b with
  | None -> false
  | Some c ->
    Vec.is_zero c.gap
    && same_normals c.normals e.normals
    && same_pairs c.pairs (Contact.touching e.obstacle e.r)
    && same_pair c.highest (Contact.highest e.obstacle e.r)
    && List.equal Vec.equal c.corners (List.map (Vec.add a.at) (Contact.region e.obstacle e.r))

let in_plane (c : Near_contact.t) =
  let n, h = c.plane in
  List.for_all (fun x -> Rat.equal (Vec.dot (Ivec.to_vec n) x) h) c.corners

(* {1 Laws} *)

let transpose (p : Contact.pair) : Contact.pair = { p with first = p.second; second = p.first }

let from_both_sides (a, b) =
  match (find a b, find b a) with
  | None, None -> true
  | Some c, Some d ->
    let n, h = c.plane and m, k = d.plane in
    Vec.equal c.gap (Vec.neg d.gap)
    && same_normals c.normals (List.map Ivec.neg d.normals)
    && same_pairs c.pairs (List.sort compare_pairs (List.map transpose d.pairs))
    && same_pair c.highest (transpose d.highest)
    && same_points c.corners d.corners
    && Ivec.equal n (Ivec.neg m) && Rat.equal h (Rat.neg k) && in_plane c
  | Some _, None | None, Some _ -> false

let moved_along m (a, b) =
  match (find a b, find (move m a) (move m b)) with
  | None, None -> true
  | Some c, Some d ->
    let turned n = Ivec.primitive (Quaternion.turn m.by n) in
    Vec.equal (Quaternion.apply m.by c.gap) d.gap
    && same_normals (List.map turned c.normals) d.normals
    && same_pairs c.pairs d.pairs && same_pair c.highest d.highest
    && same_points (List.map (move_point m) c.corners) d.corners
  | Some _, None | None, Some _ -> false

let print = function Some p -> show_pair p | None -> "none"
let of_touching f = function None -> true | Some p -> f p
let property name ~count f = QCheck2.Test.make ~name ~count ~print touching_pair (of_touching f)

let above (a, b) =
  let _, _, _, b = lifted a b in
  (a, b)

(* Also slightly turned from where it was, so that some features are within resolution and some are not. *)
let nearly =
  let slight = Gen.oneofl [ 4; 10; 16; 20; 22; 24 ] in
  let by bits (x, y, z) = quaternion (1 lsl bits, x, y, z) in
  let turn = Gen.map2 by slight Gen.(triple (-2 -- 2) (-2 -- 2) (-2 -- 2)) in
  let turn_b q (a, b) = (a, { b with Placed.turned = Quaternion.mul q b.Placed.turned }) in
  let turned q = Option.map (turn_b q) in
  let apart = function
    | Some (a, b) when Solids.Naive.relation (plain a) (plain b) = Apart -> Some (a, b)
    | Some _ | None -> None
  in
  Gen.map2 (fun q pair -> apart (turned q (Option.map above pair))) turn touching_pair

let nearly_property name ~count f = QCheck2.Test.make ~name ~count ~print nearly (of_touching f)

(* What is promised of the result: the region is not empty, has the dimension of the highest pair, and the features
   of the highest pair are within twice the resolution, and all pairs are in their closures. *)
let sound (a, b) =
  match find a b with
  | None -> true
  | Some c ->
    let in_closure (s : Placed.t) f g =
      List.exists (Feature.equal f) (Polyhedron.closure s.solid.polyhedron [ g ])
    in
    let two = Rat.mul (Rat.of_int 2) resolution in
    Int.equal c.highest.dimension (min 2 (List.length c.corners - 1))
    && in_plane c
    && Near_contact.within ~resolution:two (Placed.corners a c.highest.first) (Placed.corners b c.highest.second)
    && List.for_all
      (fun (p : Contact.pair) ->
         p.dimension <= c.highest.dimension
         && (p.dimension < c.highest.dimension || same_pair p c.highest)
         && (in_closure a p.first c.highest.first || p.dimension < 2))
      c.pairs
    && List.exists (same_pair c.highest) c.pairs

let transported =
  QCheck2.Test.make ~name:"a motion of the whole world moves all with it" ~count:30
    ~print:(fun (p, _) -> print p)
    (Gen.pair (Gen.oneof [ nearly; touching_pair ]) motion)
    (fun (p, m) -> of_touching (moved_along m) p)

(* {1 Flat shapes} *)

let flat_points =
  let point = Gen.map (fun (x, y) -> { Flat.x = Z.of_int x; y = Z.of_int y }) Gen.(pair (-3 -- 3) (-3 -- 3)) in
  Gen.list_size Gen.(1 -- 6) point

let show_points ps =
  let show (p : Flat.point) = Printf.sprintf "(%s, %s)" (Z.to_string p.x) (Z.to_string p.y) in
  String.concat " " (List.map show ps)

let in_space (p : Flat.point) = Vec.make (Q.of_bigint p.x) (Q.of_bigint p.y) Rat.zero

(* Relative interiors as {!Solids.Naive} has them; and the corners of the region are those of the other order. *)
let flat =
  QCheck2.Test.make ~name:"flat shapes" ~count:200
    ~print:(fun (p, q) -> show_points p ^ "; " ^ show_points q)
    (Gen.pair flat_points flat_points)
    (fun (p, q) ->
       let s = Flat.hull p and t = Flat.hull q in
       let ends s = List.map in_space (Flat.corners s) in
       let region s t = Flat.region ~normal:(v 0 0 1) (s, ends s) (t, ends t) in
       let meet = Solids.Naive.relative_interiors_meet (List.map in_space p) (List.map in_space q) in
       Bool.equal (Flat.meet s t) meet
       && Bool.equal (Flat.meet t s) meet
       && ((not meet)
           || Int.equal (Flat.dimension s t) (min 2 (List.length (region s t) - 1))
              && same_points (region s t) (region t s)))

(* {1 Known contacts} *)

let dims (c : Near_contact.t) =
  [ Feature.dimension c.highest.first; Feature.dimension c.highest.second; c.highest.dimension;
    List.length c.pairs; List.length c.corners ]

let check what expected a b = Alcotest.(check (list int)) what expected (dims (the what (find a b)))

let place ?(turned = Quaternion.identity) name at = { Placed.solid = named name; turned; at }
let up k = Vec.make Rat.zero Rat.zero (Rat.add (Rat.of_int k) eps)

let cubes () =
  let a = place "cube" Vec.zero in
  let at x y z = Vec.make x y z in
  let two = Rat.add (Rat.of_int 2) eps and h = ratio 1 2 in
  check "whole faces" [ 2; 2; 2; 9; 4 ] a (place "cube" (up 2));
  check "faces, shifted" [ 2; 2; 2; 9; 4 ] a (place "cube" (at h h two));
  check "edges" [ 1; 1; 1; 3; 2 ] a (place "cube" (at two Rat.zero two));
  check "vertices" [ 0; 0; 0; 1; 1 ] a (place "cube" (at two two two));
  (* straight above, but the faces have only an edge in common, seen from above *)
  check "faces, side by side" [ 1; 1; 1; 3; 2 ] a (place "cube" (at (Rat.of_int 2) Rat.zero two));
  check "faces, corner to corner" [ 0; 0; 0; 1; 1 ] a (place "cube" (at (Rat.of_int 2) (Rat.of_int 2) two));
  let far = place "cube" (Vec.make Rat.zero Rat.zero (Rat.add (Rat.of_int 2) (Rat.add eps resolution))) in
  Alcotest.(check bool) "beyond the resolution" true (Option.is_none (find a far))

(* The tip of an octahedron over a face; an edge of a cube over a face; crossing edges. *)
let mixed () =
  let a = place "cube" Vec.zero in
  check "a vertex over a face" [ 2; 0; 0; 1; 1 ] a (place "octahedron" (up 2));
  let on_edge = quaternion (0, 1, 1, 0) in
  check "faces again" [ 2; 2; 2; 9; 4 ] a (place ~turned:on_edge "cube" (up 2));
  (* turned by 2 atan(1/2) about x: (y, z) to (3 y - 4 z, 4 y + 3 z)/5, whose lowest points are edges at -7/5 *)
  let turned = quaternion (2, 1, 0, 0) in
  let b = place ~turned "cube" (Vec.make Rat.zero Rat.zero (Rat.add (ratio 12 5) eps)) in
  check "an edge over a face" [ 2; 1; 1; 3; 2 ] a b;
  let c = place ~turned "cube" Vec.zero in
  let at = Vec.make (ratio 2 5) (ratio 2 5) (Rat.add (ratio 14 5) eps) in
  let d = place ~turned:(quaternion (2, 0, 1, 0)) "cube" at in
  check "crossing edges" [ 1; 1; 0; 1; 1 ] c d

(* A cube over a slab, turned by about 2^-k about y, its lowest edge at the gap. *)
let tilted () =
  let slab = place "slab" Vec.zero in
  let over k =
    let q = quaternion (1 lsl k, 0, 1, 0) in
    let low =
      List.fold_left
        (fun m i -> Rat.min m (Quaternion.apply q (Solid.vertex (named "cube") i)).z)
        Rat.zero (List.init 8 Fun.id)
    in
    place ~turned:q "cube" (Vec.make Rat.zero Rat.zero (Rat.sub (Rat.add Rat.one eps) low))
  in
  check "within" [ 2; 2; 2; 9; 4 ] slab (over 24);
  (* 2 sides of 2 * 2^-21 to the far edge *)
  check "beyond" [ 2; 1; 1; 3; 2 ] slab (over 18);
  check "far beyond" [ 2; 1; 1; 3; 2 ] slab (over 4)

(* As in Figure 7: the plank is wider, so the upper edges of the cube touch its face, and the sides of the cube do
   not. *)
let figure_7 () =
  let wide = place "plank" (up 2) in
  let c = the "figure 7" (find (place "cube" Vec.zero) wide) in
  let count d = List.length (List.filter (fun (p : Contact.pair) -> p.dimension = d) c.pairs) in
  Alcotest.(check (list int)) "face, edges, vertices" [ 1; 4; 4 ] [ count 2; count 1; count 0 ]

let suite =
  ("near contact",
   [ ( "known",
       [ Alcotest.test_case "two cubes" `Quick cubes; Alcotest.test_case "a vertex, an edge" `Quick mixed;
         Alcotest.test_case "a tilted cube" `Quick tilted;
         Alcotest.test_case "projections (reading I-3)" `Quick figure_7 ] );
     ( "properties",
       Scc_test_support.Property.cases
         [ property "hardly apart is as touching" ~count:60 as_exact;
           property "touching is what it is without turns" ~count:40 exactly;
           nearly_property "from both sides the same" ~count:40 from_both_sides;
           property "from both sides the same, touching" ~count:20 from_both_sides;
           nearly_property "nearly touching" ~count:60 sound; transported; flat ] ) ])
