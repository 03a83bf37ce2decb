open Scc_exact
open Scc_geometry
open Solids

let check_vec what a b = Alcotest.(check string) what (Vec.to_string a) (Vec.to_string b)
let v = Vec.of_ints
let body ?(turn = Mat.identity) plain = { name = ""; plain; turn }

(* The touching pairs of a body at [r] with parts of the first body, each a body and its place. *)
let against parts b r : Response.touching list =
  List.filter_map
    (fun (part, at) ->
       let obstacle = obstacle part b and offset = Vec.sub r at in
       if Obstacle.relation obstacle offset = Touching then Some { Response.obstacle; offset } else None)
    parts

let check_directions what touching w expected =
  let ours = List.map (fun n -> Ivec.primitive (fst (Ivec.of_vec n))) (Response.directions touching w) in
  Alcotest.(check (list string)) what
    (List.map Ivec.to_string (List.sort Ivec.compare expected))
    (List.map Ivec.to_string (List.sort Ivec.compare ours))

let i = Ivec.of_ints

(* A square bar with its lower edge along y: corners at distance 1 from its axis. *)
let bar =
  hull [ (1, -1, 0); (1, 1, 0); (-1, -1, 0); (-1, 1, 0); (0, -1, 1); (0, 1, 1); (0, -1, -1); (0, 1, -1) ]

(* Two flush tiles whose tops are at z = 0 and whose seam is x = 0; and the same as one. *)
let tile = box 2 2 1
let tiles = [ (body tile, v (-2) 0 (-1)); (body tile, v 2 0 (-1)) ]
let one_tile = [ (body (box 4 2 1), v 0 0 (-1)) ]

let seam () =
  let r = v 0 0 1 and w = v 2 1 (-3) in
  let on_two = against tiles (body bar) r and on_one = against one_tile (body bar) r in
  Alcotest.(check int) "touches both tiles" 2 (List.length on_two);
  check_directions "only up" on_two w [ i 0 0 1 ];
  check_directions "as on one tile" on_one w [ i 0 0 1 ];
  check_vec "bounces straight up" (v 2 1 3) (Response.bounce on_two w)

(* A wall beside a floor of two tiles is no inner corner: all three parts of the true corner count. *)
let corner () =
  let wall = (body (box 1 2 4), v 5 0 3) in
  let r = v 3 0 1 in
  let touching = against (wall :: tiles) (body cube) r in
  let w = v 1 0 (-1) in
  check_directions "floor and wall" touching w [ i 0 0 1; i (-1) 0 0 ];
  check_vec "out of the corner" (v (-1) 0 1) (Response.bounce touching w)

(* A fourfold seam under the vertex of a cube that stands on its tip. *)
let four_tiles () =
  let at x y = (body (box 2 2 1), v x y (-1)) in
  let octahedron = body octahedron in
  let touching = against [ at 2 2; at (-2) 2; at 2 (-2); at (-2) (-2) ] octahedron (v 0 0 1) in
  Alcotest.(check int) "touches all" 4 (List.length touching);
  check_directions "only up" touching (v 1 1 (-5)) [ i 0 0 1 ];
  check_vec "straight up" (v 1 1 5) (Response.bounce touching (v 1 1 (-5)))

(* A gap or a step between the tiles is a true edge. *)
let step () =
  let raised = [ (body tile, v (-2) 0 (-1)); (body tile, v 2 0 0) ] in
  let touching = against raised (body cube) (v (-1) 0 1) in
  check_directions "floor and step" touching (v 1 0 (-1)) [ i 0 0 1; i (-1) 0 0 ]

(* A gap in a wall exactly as high as the cube in front of it: no way in, and nothing to catch on. *)
let gap () =
  let wall = [ (body (box 1 2 1), v (-2) 0 (-2)); (body (box 1 2 1), v (-2) 0 2) ] in
  let touching = against wall (body cube) Vec.zero in
  check_directions "the wall alone" touching (v (-1) 0 (-1)) [ i 1 0 0 ];
  check_vec "glances off" (v 1 0 (-1)) (Response.bounce touching (v (-1) 0 (-1)))

(* Between floor and ceiling every facet is covered: then all count. *)
let wedged () =
  let parts = [ (body slab, v 0 0 (-2)); (body slab, v 0 0 2) ] in
  let touching = against parts (body cube) Vec.zero in
  check_directions "the floor" touching (v 1 0 (-1)) [ i 0 0 1 ];
  check_directions "the ceiling" touching (v 1 0 1) [ i 0 0 (-1) ];
  check_directions "along them" touching (v 1 0 0) []

let vertex_vertex () =
  let touching = against [ (body cube, Vec.zero) ] (body cube) (v 2 2 2) in
  let bounce what w expected = check_vec what expected (Response.bounce touching w) in
  bounce "head on" (v (-1) (-1) (-1)) (v 1 1 1);
  bounce "slanted" (v (-1) (-2) (-3)) (v 1 2 3)

let face_face () =
  let touching = against [ (body slab, Vec.zero) ] (body cube) (v 1 0 2) in
  check_directions "the common normal" touching (v 5 7 (-2)) [ i 0 0 1 ];
  check_vec "a mirror" (v 5 7 2) (Response.bounce touching (v 5 7 (-2)))

(* Textbook: w+ = w - 2 (n.w / n.n) n for a slanted face. *)
let slanted_face () =
  let o = obstacle (body octahedron) (body octahedron) in
  let third = Rat.make (Z.of_int 2) (Z.of_int 3) in
  let r = Vec.scale third (v 1 1 1) in
  let w = v 0 0 (-1) in
  let n = v 1 1 1 in
  let expected = Vec.axpy (Rat.div (Rat.of_int 2) (Vec.norm2 n)) n w in
  check_vec "mirrored" expected (Response.bounce [ { obstacle = o; offset = r } ] w)

(* {1 Properties} *)

let at_collision f s =
  match collision s with None -> true | Some (o, r) -> f [ { Response.obstacle = o; offset = r } ] s.w

let energy =
  property "the speed is kept" ~gen:aimed
    (at_collision (fun touching w -> Rat.equal (Vec.norm2 w) (Vec.norm2 (Response.bounce touching w))))

let parting =
  property "afterwards no direction approaches" ~gen:aimed
    (at_collision (fun touching w ->
         let after = Response.bounce touching w in
         List.for_all (fun n -> Rat.sign (Vec.dot n after) > 0) (Response.directions touching w)))

let impulse_in_cone =
  property "the change of velocity has a share of every direction it uses" ~gen:aimed
    (at_collision (fun touching w ->
         let change = Vec.sub (Response.bounce touching w) w in
         Vec.equal change (Nnls.project_cone (Response.directions touching w) change)))

(* {1 Cutting a body into flush parts}

   A box of 4 x 4 x 2 as it is, and cut along x, along x and y, or into a T of three. The union is the same,
   so are the directions and the bounce. *)
let whole = [ (body (box 2 2 1), Vec.zero) ]

let cuts =
  let h = halves in
  let half_box = { (body (box 2 2 1)) with turn = Mat.diagonal (Vec.make (half 1) Rat.one Rat.one) } in
  let quarter = { (body (box 2 2 1)) with turn = Mat.diagonal (Vec.make (half 1) (half 1) Rat.one) } in
  [ [ (half_box, h (-2, 0, 0)); (half_box, h (2, 0, 0)) ];
    [ (quarter, h (-2, -2, 0)); (quarter, h (2, -2, 0)); (quarter, h (-2, 2, 0)); (quarter, h (2, 2, 0)) ];
    [ (half_box, h (-2, 0, 0)); (quarter, h (2, -2, 0)); (quarter, h (2, 2, 0)) ] ]

let cut_scene =
  let from = Gen.map halves Gen.(triple (-8 -- 8) (-8 -- 8) (10 -- 12)) in
  let goal = Gen.map (fun (x, y) -> halves (2 * x, 2 * y, 2)) Gen.(pair (-2 -- 2) (-2 -- 2)) in
  let b = Gen.pair Solids.body Gen.(0 -- 13) in
  Gen.quad from goal b (Gen.oneofl cuts)

(* Sends a vertex of the body towards a point of the top on the seams. *)
let cut =
  QCheck2.Test.make ~name:"Cutting: flush parts, with seams through faces and edges, change no bounce"
    ~count:200 cut_scene
    (fun (from, goal, (b, k), parts) ->
       let s = solid ~id:1 b in
       let tip = Solid.vertex s (k mod Array.length s.vertices) in
       let r = Vec.sub from tip and w = Vec.sub goal from in
       let o = obstacle (fst (List.hd whole)) b in
       match Obstacle.first_time_of_contact o r w with
       | Never | Inside -> true
       | At t ->
         let r = Vec.axpy t w r in
         let one = against whole b r and many = against parts b r in
         List.equal Vec.equal (Response.directions one w) (Response.directions many w)
         && Vec.equal (Response.bounce one w) (Response.bounce many w))

let suite =
  let case name f = Alcotest.test_case name `Quick f in
  ("response",
   [ ( "known",
       [ case "edge down on a seam (reading I-13)" seam; case "a corner" corner;
         case "four tiles under a tip" four_tiles; case "a step" step; case "a gap" gap; case "wedged" wedged;
         case "vertex-vertex" vertex_vertex;
         case "face-face" face_face; case "a slanted face" slanted_face ] );
     ("properties", Scc_test_support.Property.cases [ energy; parting; impulse_in_cone; cut ]) ])
