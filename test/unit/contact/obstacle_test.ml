open Scc_exact
open Scc_geometry
open Solids

let same_relation (x : Obstacle.relation) (y : Naive.relation) =
  match (x, y) with
  | Apart, Apart | Touching, Touching | Interpenetrating, Interpenetrating -> true
  | _ -> false

let same_cast (x : Obstacle.cast) (y : Naive.cast) =
  match (x, y) with
  | Never, Never | Inside, Inside -> true
  | At s, At t -> Rat.equal s t
  | _ -> false

let relation =
  property "the relation is that of all separating axes" ~count:200 (fun s ->
      same_relation
        (Obstacle.relation (obstacle s.a s.b) s.r)
        (Naive.relation (placed s.a Vec.zero) (placed s.b s.r)))

let cast_agrees s =
  let a = placed s.a Vec.zero and b = placed s.b s.r in
  let o = obstacle s.a s.b in
  same_cast (Obstacle.first_time_of_contact o s.r s.w) (Naive.first_time_of_contact a b s.w)
  && same_interval (Obstacle.meeting o s.r s.w) (Naive.meeting a b s.w)

let cast = property "casts are those of all separating axes" ~count:150 cast_agrees
let aimed_cast = property "also where most of them hit" ~count:100 ~gen:aimed cast_agrees

let primitive (v : Vec.t) = Ivec.primitive (fst (Ivec.of_vec v))

(* The facets as a set, and each once. *)
let same_facets o a b =
  let ours = List.map (fun (f : Obstacle.facet) -> f.normal) (Array.to_list (Obstacle.facets o)) in
  let theirs = List.sort_uniq Ivec.compare (List.map primitive (Naive.facets a b)) in
  List.equal Ivec.equal (List.sort Ivec.compare ours) theirs

let facets =
  property "the facets are those of the Minkowski difference, each once" ~count:75 (fun s ->
      same_facets (obstacle s.a s.b) (placed s.a Vec.zero) (placed s.b Vec.zero))

(* Random hulls of up to 14 points on a coarse grid, with many coplanar and parallel ones. *)
let random_hulls =
  let point = Gen.triple Gen.(-2 -- 2) Gen.(-2 -- 2) Gen.(-2 -- 2) in
  let corners = [ (0, 0, 0); (1, 0, 0); (0, 1, 0); (0, 0, 1) ] in
  let body =
    Gen.map2
      (fun ps turn -> { name = "hull"; plain = hull (corners @ ps); turn })
      (Gen.list_size Gen.(0 -- 10) point) turn
  in
  let scene = Gen.map2 (fun (a, b) (r, w) -> { a; b; r; w }) (Gen.pair body body) (Gen.pair offset velocity) in
  property "random hulls: facets and casts" ~count:20 ~gen:scene (fun s ->
      same_facets (obstacle s.a s.b) (placed s.a Vec.zero) (placed s.b Vec.zero) && cast_agrees s)

let offsets =
  property "every offset is the distance of the supports" (fun s ->
      let a = solid ~id:0 s.a and b = solid ~id:1 s.b in
      let o = Obstacle.make a b in
      let extreme choose n (s : Solid.t) =
        let h = Array.init (Array.length s.vertices) (fun i -> Vec.dot n (Solid.vertex s i)) in
        Array.fold_left choose h.(0) h
      in
      Array.for_all
        (fun (f : Obstacle.facet) ->
           let n = Ivec.to_vec f.normal in
           Rat.equal (Rat.make f.num f.den) (Rat.sub (extreme Rat.max n a) (extreme Rat.min n b)))
        (Obstacle.facets o))

let at_collision =
  property "at the first time of contact the bodies touch and approach" ~gen:aimed (fun s ->
      match collision s with
      | None -> true
      | Some (o, r) ->
        Obstacle.relation o r = Touching
        && Obstacle.approaching o r s.w
        && equal_cast (Obstacle.first_time_of_contact o r s.w) (At Rat.zero)
        && not (Obstacle.approaching o r (Vec.neg s.w)))

let approaching_is_at_zero =
  property "approaching iff the cast is at 0" ~count:300 (fun s ->
      let o = obstacle s.a s.b in
      Obstacle.relation o s.r <> Touching
      || Bool.equal (Obstacle.approaching o s.r s.w)
        (equal_cast (Obstacle.first_time_of_contact o s.r s.w) (At Rat.zero)))

(* {1 Closer than floats can tell} *)

let power k = Rat.make (Z.pow (Z.of_int 10) k) Z.one
let hairs = Gen.oneofl [ 12; 15; 16; 17; 30; 400 ]

(* The offset of a collision, displaced by a hair; and everything made large and moved far, so that the integers
   behind are long. *)
let hair =
  QCheck2.Test.make ~name:"a hair off a contact" ~count:150
    ~print:(fun (s, _, _) -> show s)
    (Gen.triple aimed hairs velocity)
    (fun (s, k, d) ->
       match collision s with
       | None -> true
       | Some (o, r) ->
         let r = Vec.axpy (Rat.div Rat.one (power k)) d r in
         let a = placed s.a Vec.zero and b = placed s.b r in
         same_relation (Obstacle.relation o r) (Naive.relation a b)
         && same_cast (Obstacle.first_time_of_contact o r s.w) (Naive.first_time_of_contact a b s.w))

let far_away =
  QCheck2.Test.make ~name:"from far away, past a corner by a hair" ~count:100
    ~print:(fun (s, _, _) -> show s)
    (Gen.triple aimed hairs velocity)
    (fun (s, k, d) ->
       match collision s with
       | None -> true
       | Some (o, r) ->
         let r = Vec.axpy (Rat.div Rat.one (power k)) d (Vec.axpy (Rat.neg (power 6)) s.w r) in
         let w = Vec.scale (power k) s.w in
         same_cast
           (Obstacle.first_time_of_contact o r w)
           (Naive.first_time_of_contact (placed s.a Vec.zero) (placed s.b r) w))

(* {1 Longer than floats can hold}

   Cubes with a face of each in one plane, turned by a quaternion of four numbers of about 480 bits: their normals
   have about 960. They are made as large as it takes for the terms of a product of a normal and a corner to be
   about as great as the greatest float, so that now one and now another of them overflows, and the bound on the
   error of the sum does not. *)

let long_number =
  let digit = Gen.(0 -- 0x3fffffff) in
  let of_digits = List.fold_left (fun n d -> Z.add (Z.shift_left n 30) (Z.of_int d)) Z.one in
  Gen.map2
    (fun digits minus -> Rat.make (if minus then Z.neg (of_digits digits) else of_digits digits) Z.one)
    (Gen.list_repeat 16 digit) Gen.bool

let long_turn =
  Gen.map2
    (fun (w, x) (y, z) -> Option.get (Mat.of_quaternion (w, x, y, z)))
    (Gen.pair long_number long_number) (Gen.pair long_number long_number)

let overflowing =
  QCheck2.Test.make ~name:"normals as long as the greatest float" ~count:100
    ~print:(fun (m, _) -> Vec.to_string (Mat.apply m (Vec.of_ints 1 0 0)))
    (Gen.pair long_turn (Gen.triple (Gen.oneofl cube_turns) offset Gen.(-2 -- 2)))
    (fun (m, (side, along, more)) ->
       let n = primitive (Mat.apply (Mat.mul m side) (Vec.of_ints 1 0 0)) in
       let bits = Z.numbits (Z.max (Z.abs n.x) (Z.max (Z.abs n.y) (Z.abs n.z))) in
       let size = Rat.make (Z.shift_left Z.one (1024 + more - bits)) Z.one in
       let turned = { name = "cube"; plain = cube; turn = Mat.mul m (Mat.scale size side) } in
       let o = obstacle turned turned in
       let at x = Mat.apply turned.turn { (Vec.scale (Rat.make Z.one (Z.of_int 4)) along) with Vec.x = x } in
       let two = Rat.of_int 2 and hair = Rat.div Rat.one (power 30) in
       let out = Mat.apply turned.turn (Vec.of_ints 1 0 0) in
       let cast r w = Obstacle.first_time_of_contact o r w in
       Obstacle.relation o (at two) = Touching
       && Obstacle.relation o (at (Rat.add two hair)) = Apart
       && Obstacle.relation o (at (Rat.sub two hair)) = Interpenetrating
       && List.exists (Ivec.equal n) (Obstacle.separating o (at two))
       && equal_cast (cast (at (Rat.of_int 5)) (Vec.neg out)) (At (Rat.of_int 3))
       && equal_cast (cast (at two) (Vec.neg out)) (At Rat.zero)
       && equal_cast (cast (at two) out) Never)

(* {1 Known obstacles} *)

let body plain = { name = ""; plain; turn = Mat.identity }
let facet_count a b = Array.length (Obstacle.facets (obstacle (body a) (body b)))

let counts () =
  let check what n a b = Alcotest.(check int) what n (facet_count a b) in
  check "aligned cubes" 6 cube cube;
  check "a cube and a slab" 6 cube slab;
  check "a tetrahedron and itself: a cuboctahedron" 14 tetrahedron tetrahedron;
  check "octahedra" 8 octahedron octahedron;
  check "a cube and an octahedron" 26 cube octahedron

let touching_cubes () =
  let o = obstacle (body cube) (body cube) in
  let v = Vec.of_ints in
  let relation what r (x : Obstacle.relation) = Alcotest.(check bool) what true (Obstacle.relation o r = x) in
  relation "face to face" (v 2 0 1) Touching;
  relation "edge to edge" (v 2 2 0) Touching;
  relation "vertex to vertex" (v 2 2 2) Touching;
  relation "overlapping" (v 1 1 1) Interpenetrating;
  let hair = Rat.make Z.one (Z.of_int 1000000) in
  relation "apart by a hair" (Vec.make (Rat.add (Rat.of_int 2) hair) Rat.zero Rat.zero) Apart;
  Alcotest.(check int) "a vertex has three directions" 3 (List.length (Obstacle.separating o (v 2 2 2)));
  Alcotest.(check bool) "sliding along a face" false (Obstacle.approaching o (v 2 0 0) (v 0 1 0));
  Alcotest.(check bool) "vertex-vertex, straight on" true (Obstacle.approaching o (v 2 2 2) (v (-1) (-1) (-1)));
  Alcotest.(check bool) "vertex-vertex, past" false (Obstacle.approaching o (v 2 2 2) (v (-1) (-1) 0));
  let cast what r w expected =
    Alcotest.(check bool) what true (equal_cast (Obstacle.first_time_of_contact o r w) expected)
  in
  cast "a graze is no collision" (v 5 2 0) (v (-1) 0 0) Never;
  cast "at rest inside" (v 1 0 0) Vec.zero Inside;
  cast "at rest and touching" (v 2 0 0) Vec.zero Never;
  cast "leaving" (v 2 0 0) (v 1 0 0) Never;
  cast "entering" (v 2 0 0) (v (-1) 0 0) (At Rat.zero);
  cast "later" (v 5 1 0) (v (-2) 0 0) (At (Rat.make (Z.of_int 3) (Z.of_int 2)));
  let meeting what r w expected =
    Alcotest.(check bool) what true (same_interval (Obstacle.meeting o r w) expected)
  in
  let some n = Some (Rat.of_int n) in
  meeting "a graze is a meeting" (v 5 2 0) (v (-1) 0 0) (Some (some 3, some 7));
  meeting "in the past" (v 5 2 0) (v 1 0 0) (Some (some (-7), some (-3)));
  meeting "at rest" (v 2 2 2) Vec.zero (Some (None, None));
  meeting "at rest, apart" (v 3 2 2) Vec.zero None;
  meeting "at one instant" (v 3 1 0) (v (-1) 1 0) (Some (some 1, some 1))

(* What is turned has the key of nobody: neither solid is taken for the other. *)
let turned_solids () =
  let body = { name = "cube"; plain = List.assoc "cube" named; turn = Mat.identity } in
  let a = solid ~id:0 body and b = solid ~id:1 body in
  let eighth = Quaternion.to_mat (Quaternion.make (Z.of_int 5) Z.zero Z.zero (Z.of_int 2)) in
  let turned = Solid.turned eighth b in
  let cache = Scc_broad_phase.Obstacle_cache.create () in
  let facets s = Array.length (Obstacle.facets (Scc_broad_phase.Obstacle_cache.find cache a s)) in
  let expected s = Array.length (Obstacle.facets (Obstacle.make a s)) in
  let check what s = Alcotest.(check int) what (expected s) (facets s) in
  Alcotest.(check bool) "they differ" true (expected b <> expected turned);
  check "as it is" b;
  check "turned" turned;
  check "turned again" (Solid.turned eighth turned);
  check "as it is, after that" b

let suite =
  ("obstacle",
   [ ( "known",
       [ Alcotest.test_case "numbers of facets" `Quick counts;
         Alcotest.test_case "two cubes" `Quick touching_cubes;
         Alcotest.test_case "turned solids in a cache" `Quick turned_solids ] );
     ( "properties",
       Scc_test_support.Property.cases
         [ relation; cast; aimed_cast; facets; random_hulls; offsets; at_collision; approaching_is_at_zero;
           hair; far_away; overflowing ] ) ])
