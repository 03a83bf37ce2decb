(* Convex parts of solids with slanted faces: stars, whose surface is that of an octahedron in many triangles, each
   corner moved along its ray. Which points are inside is known: a star is the union of the tetrahedra over its
   triangles, with the middle as apex. *)

open Scc_exact
open Scc_geometry
open Scc_concave
open Scc_test_support

let q a b = Rat.make (Z.of_int a) (Z.of_int b)

(* {1 Stars} *)

(* The points with |x| + |y| + |z| = n, and the triangles between neighbours, counter-clockwise from outside. *)
let triangles n =
  let sign s (x, y, z) = match s with `X -> (-x, y, z) | `Y -> (x, -y, z) | `Z -> (x, y, -z) in
  let octant =
    let point i j = (i, j, n - i - j) in
    let cell i j =
      let up = [ (point i j, point (i + 1) j, point i (j + 1)) ] in
      if i + j + 2 <= n then (point (i + 1) j, point (i + 1) (j + 1), point i (j + 1)) :: up else up
    in
    List.concat (List.init n (fun i -> List.concat (List.init (n - i) (cell i))))
  in
  let mirror s list = List.map (fun (a, b, c) -> (sign s a, sign s c, sign s b)) list in
  let half = octant @ mirror `X octant in
  let upper = half @ mirror `Y half in
  upper @ mirror `Z upper

let n = 2

(* [radius] tells of each point how far it is moved, in eighths. *)
let star radius =
  let at (x, y, z) = Vec.scale (q (radius (x, y, z)) 8) (Vec.of_ints x y z) in
  List.map (fun (a, b, c) -> (at a, at b, at c)) (triangles n)

let points = List.sort_uniq compare (List.concat_map (fun (a, b, c) -> [ a; b; c ]) (triangles n))

let random_star =
  let open QCheck2.Gen in
  let+ radii = list_repeat (List.length points) (int_range 4 12) in
  star (fun p -> List.assoc p (List.combine points radii))

let parts star = Scc_decompose.Decompose.parts (List.map (fun (a, b, c) -> [| a; b; c |]) star)
let solids star = List.map Refined.of_cell (parts star)

(* {1 Laws} *)

let det a b c = Vec.dot a (Vec.cross b c)
let sum f list = List.fold_left (fun total x -> Rat.add total (f x)) Rat.zero list
let six_volumes star = sum (fun (a, b, c) -> det a b c) star
let volume p = (Mass_properties.of_polyhedron p).volume
let same_volume star = Rat.equal (Rat.mul (Rat.of_int 6) (sum volume (solids star))) (six_volumes star)

let same_surface star =
  let surface = List.map (fun (a, b, c) -> [| a; b; c |]) star in
  Planes.areas surface = Planes.areas (List.concat_map Planes.faces (solids star))

(* What is taken from the facets of a cell, without a check, is what a hull makes of its corners, and checks. *)
let same_as_hulls star =
  let same cell =
    let points = List.map Scc_decompose.Homogeneous.to_vec (Scc_decompose.Cell.corners cell) in
    Polyhedron.equal (Refined.of_cell cell) (Refined.solid points)
  in
  List.for_all same (parts star)

(* A volume that differs by the least part is told from the right one, also where a prime divides denominators. *)
let volumes_compared (star, k) =
  let corners = Array.of_list (List.concat_map (fun (a, b, c) -> [ a; b; c ]) star) in
  let by = if k mod 2 = 0 then Rat.one else Rat.make Z.one (Z.pred (Z.shift_left Z.one 61)) in
  let set by : Polyhedron.ifs =
    {
      ifs_vertices = Array.map (fun x -> ("", Vec.scale by x)) corners;
      ifs_faces = Array.of_list (List.mapi (fun k _ -> ("", [| 3 * k; (3 * k) + 1; (3 * k) + 2 |])) star);
    }
  in
  let solids = List.map (Polyhedron.transform (Mat.scale by Mat.identity)) (solids star) in
  let other = Rat.mul by (Rat.add Rat.one (q 1 (1_000_003 + k))) in
  Volumes.equal (set by) solids && not (Volumes.equal (set other) solids)

type place = Inside | Outside | Border

(* In the tetrahedron over a triangle: behind it, and on the inner side of the planes through the middle. *)
let in_star star x =
  let signs (a, b, c) =
    let over = Rat.sub (det a b c) (Vec.dot (Vec.cross (Vec.sub b a) (Vec.sub c a)) x) in
    List.map Rat.sign [ det x b c; det a x c; det a b x; over ]
  in
  let least t = List.fold_left Int.min 1 (signs t) in
  match List.fold_left Int.max (-1) (List.map least star) with 1 -> Inside | 0 -> Border | _ -> Outside

let in_part x (p : Polyhedron.t) =
  let side corners =
    Rat.sign (Vec.dot (Planes.area_vector corners) (Vec.sub x corners.(0)))
  in
  match List.fold_left Int.max (-1) (List.map side (Planes.faces p)) with -1 -> Inside | 0 -> Border | _ -> Outside

let random_points =
  QCheck2.Gen.(list_size (return 60) (triple (int_range (-35) 35) (int_range (-35) 35) (int_range (-35) 35)))

let near_points =
  QCheck2.Gen.(list_size (return 60) (triple (int_range (-12) 12) (int_range (-12) 12) (int_range (-12) 12)))

let same_points (star, points) =
  let solids = solids star in
  let right (x, y, z) =
    let x = Vec.make (q x 11) (q y 11) (q z 11) in
    let where = List.map (in_part x) solids in
    let inside = List.length (List.filter (fun p -> p = Inside) where) and border = List.mem Border where in
    match in_star star x with
    | Inside -> (inside = 1 && not border) || (inside = 0 && border)
    | Outside -> inside = 0 && not border
    | Border -> inside <= 1
  in
  List.for_all right points

(* Points in eighths, as the corners are: rays go through corners and edges. *)
let ray_agrees (star, points) =
  let corners = List.concat_map (fun (a, b, c) -> [ a; b; c ]) star in
  let set : Polyhedron.ifs =
    {
      ifs_vertices = Array.of_list (List.map (fun x -> ("", x)) corners);
      ifs_faces = Array.of_list (List.mapi (fun k _ -> ("", [| 3 * k; (3 * k) + 1; (3 * k) + 2 |])) star);
    }
  in
  let faces = List.init (List.length star) Fun.id in
  let right (x, y, z) =
    let x = Vec.make (q x 8) (q y 8) (q z 8) in
    match in_star star x with
    | Border -> true
    | (Inside | Outside) as place -> Bool.equal (place = Inside) (Within.surface set faces x)
  in
  List.for_all right points

(* {1 By hand} *)

let count star = List.length (parts star)
let convex_stays () = Alcotest.(check int) "parts of an octahedron" 1 (count (star (fun _ -> 8)))

(* One corner of the octahedron pulled in as far as the plane of its neighbours and beyond. *)
let dented () =
  let dent k = star (fun p -> if p = (0, 0, n) then k else 8) in
  Alcotest.(check int) "a flat tip is convex" 1 (count (dent 4));
  Alcotest.(check bool) "a dent is not" true (count (dent 2) > 1);
  Alcotest.(check bool) "and keeps its volume" true (same_volume (dent 2) && same_surface (dent 2))

(* Two frusta on each other by their smaller squares: no plane of a face goes through all four reflex edges, but
   the one between them does. *)
let hourglass split =
  let corner s z k = Vec.of_ints (if k = 1 || k = 2 then s else -s) (if k >= 2 then s else -s) z in
  let square s z = Array.init 4 (corner s z) in
  let side (s, z) (t, y) k =
    let next = (k + 1) mod 4 in
    split [| corner s z k; corner s z next; corner t y next; corner t y k |]
  in
  let sides low high = List.concat (List.init 4 (side low high)) in
  let bottom = Array.of_list (List.rev (Array.to_list (square 3 (-2)))) in
  (bottom :: square 2 2 :: sides (3, -2) (1, 0)) @ sides (1, 0) (2, 2)

let one_cut () =
  let parts = Scc_decompose.Decompose.parts (hourglass (fun side -> [ side ])) in
  Alcotest.(check int) "parts" 2 (List.length parts)

(* The upper sides in two pieces each, so that below no polygon has the same edge. *)
let edges_unmatched () =
  let halves side =
    let middle a b = Vec.scale (q 1 2) (Vec.add side.(a) side.(b)) in
    let m = middle 0 1 and n = middle 2 3 in
    if Rat.sign side.(0).z < 0 then [ side ]
    else [ [| side.(0); m; n; side.(3) |]; [| m; side.(1); side.(2); n |] ]
  in
  let solids = List.map Refined.of_cell (Scc_decompose.Decompose.parts (hourglass halves)) in
  Alcotest.(check string) "volume" "160/3" (Rat.to_string (sum volume solids))

let property name gen holds = QCheck2.Test.make ~count:25 ~name gen holds

let () =
  Alcotest.run "decompose"
    [
      ( "by hand",
        [
          Alcotest.test_case "what is convex stays whole" `Quick convex_stays;
          Alcotest.test_case "a dent" `Quick dented;
          Alcotest.test_case "an hourglass needs one cut" `Quick one_cut;
          Alcotest.test_case "an hourglass whose edges do not match" `Quick edges_unmatched;
        ] );
      ( "laws",
        Property.cases
          [
            property "the volume is that of the solid" random_star same_volume;
            property "so is the area in each plane" random_star same_surface;
            property "parts are hulls of their corners" random_star same_as_hulls;
            property "volumes are compared" (QCheck2.Gen.pair random_star QCheck2.Gen.nat) volumes_compared;
            property "each point is in one part, or in none" (QCheck2.Gen.pair random_star random_points)
              same_points;
            property "a ray tells what is within" (QCheck2.Gen.pair random_star near_points) ray_agrees;
          ] );
    ]
