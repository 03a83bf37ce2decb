(* Hulls of clouds beside those that are made by adding one point after the other to all facets so far. *)
open Scc_exact
open Scc_geometry
open Scc_mesh
module G = QCheck2.Gen

(* {1 Point by point} *)

let side points (a, b, c) p =
  let at i = points.(i) in
  Rat.sign (Vec.dot (Vec.cross (Vec.sub (at b) (at a)) (Vec.sub (at c) (at a))) (Vec.sub p (at a)))

let add points facets p =
  let seen, hidden = List.partition (fun f -> side points f points.(p) > 0) facets in
  let edges (a, b, c) = [ (a, b); (b, c); (c, a) ] in
  let all = List.concat_map edges seen in
  let border = List.filter (fun (v, w) -> not (List.mem (w, v) all)) all in
  List.map (fun (v, w) -> (v, w, p)) border @ hidden

let point_by_point points =
  let indices = List.init (Array.length points) Fun.id in
  let is_line i j k =
    Vec.is_zero (Vec.cross (Vec.sub points.(j) points.(i)) (Vec.sub points.(k) points.(i)))
  in
  let find = List.find_opt in
  let ( let* ) = Option.bind in
  let* b = find (fun i -> not (Vec.equal points.(0) points.(i))) indices in
  let* c = find (fun i -> not (is_line 0 b i)) indices in
  let* d = find (fun i -> side points (0, b, c) points.(i) <> 0) indices in
  let a, b, c = if side points (0, b, c) points.(d) < 0 then (0, b, c) else (0, c, b) in
  let start = [ (a, b, c); (a, d, b); (b, d, c); (c, d, a) ] in
  let triangles = List.map (fun (a, b, c) -> [| a; b; c |]) (List.fold_left (add points) start indices) in
  let turned t = List.hd (List.sort compare [ t; [| t.(1); t.(2); t.(0) |]; [| t.(2); t.(0); t.(1) |] ]) in
  Some (List.sort compare (List.map turned triangles))

let cloud points =
  let named i p = ("v" ^ string_of_int i, p) in
  { Polyhedron.ifs_vertices = Array.mapi named points; ifs_faces = [||] }

let plain points =
  let named triangles = Array.of_list (List.mapi (fun i f -> ("f" ^ string_of_int i, f)) triangles) in
  let merged triangles = Merge_coplanar.merge { (cloud points) with ifs_faces = named triangles } in
  Option.map merged (point_by_point points)

(* {1 The same} *)

let corners (set : Polyhedron.ifs) f = List.map (fun v -> fst set.ifs_vertices.(v)) (Array.to_list (snd f))
let faces set = List.map (corners set) (Array.to_list set.Polyhedron.ifs_faces)

let from_least l =
  let rec go k l = if k = 0 then [] else l :: go (k - 1) (List.tl l @ [ List.hd l ]) in
  List.hd (List.sort compare (go (List.length l) l))

let unordered list = List.sort compare (List.map from_least list)

let points most = G.map3 Vec.of_ints (G.int_range 0 most) (G.int_range 0 most) (G.int_range 0 most)

(* In a slanted plane, but for a hair: no float tells on which side of three of them a fourth one is. *)
let nearly_flat digits =
  let large = Rat.make (Z.add (Z.pow (Z.of_int 10) digits) Z.one) Z.one in
  let at (i, j) hair =
    let i = Rat.of_int i and j = Rat.of_int j in
    let slanted = Rat.add (Rat.mul (Rat.of_int 3) i) (Rat.mul (Rat.of_int 7) j) in
    Vec.make (Rat.mul large i) (Rat.mul large j) (Rat.add (Rat.mul large slanted) (Rat.of_int hair))
  in
  G.map2 at G.(pair (int_range 0 5) (int_range 0 5)) (G.int_range (-1) 1)

let on_a_grid =
  let sized points = G.array_size (G.int_range 1 40) points in
  G.oneof (List.map sized (List.map points [ 1; 2; 3; 9; 1000 ] @ List.map nearly_flat [ 9; 40; 400 ]))

let print points = String.concat " " (List.map Vec.to_string (Array.to_list points))

let same_faces =
  QCheck2.Test.make ~name:"the faces of clouds are those that come point by point" ~count:600 ~print on_a_grid
    (fun points ->
       match (Hull_of.hull (cloud points), plain points) with
       | None, None -> true
       | Some found, Some expected -> unordered (faces found) = unordered (faces expected)
       | Some _, None | None, Some _ -> false)

(* Of a cloud that has only corners. *)
let same_order =
  QCheck2.Test.make ~name:"and in the same order" ~count:600 ~print on_a_grid (fun points ->
      match plain points with
      | None -> true
      | Some solid -> (
          let corners = Array.map snd solid.ifs_vertices in
          match (Hull_of.hull (cloud corners), plain corners) with
          | Some found, Some expected ->
            faces found = faces expected
            && Array.map fst found.ifs_faces = Array.init (Array.length found.ifs_faces) (Printf.sprintf "f%d")
          | _ -> false))

(* {1 Many points} *)

let turn i = float_of_int i *. 2.399963229728653

let on_a_sphere n =
  Array.init n (fun i ->
      let z = 1. -. (2. *. (float_of_int i +. 0.5) /. float_of_int n) in
      let r = sqrt (1. -. (z *. z)) in
      let at x = int_of_float (Float.round (1000. *. x)) in
      Vec.of_ints (at (r *. cos (turn i))) (at (r *. sin (turn i))) (at z))

(* The round base of a cone, and as many points about its apex. *)
let cone n =
  Array.init n (fun i ->
      let at x = int_of_float (Float.round (1e9 *. x)) in
      let x = cos (turn i) and y = sin (turn i) in
      if i land 1 = 0 then Vec.of_ints (at x) (at y) 0
      else Vec.of_ints (at (x *. 1e-3)) (at (y *. 1e-3)) (at (1. +. (1e-3 *. cos (float_of_int i)))))

(* A solid, and no point is in front of some of its faces. *)
let large name points () =
  match Hull_of.hull (cloud points) with
  | None -> Alcotest.fail "flat"
  | Some hull ->
    Alcotest.(check bool) (name ^ ": a solid") true (Result.is_ok (Polyhedron.of_ifs hull));
    let behind i =
      let f = snd hull.ifs_faces.(i) and at v = snd hull.ifs_vertices.(v) in
      let normal = Vec.cross (Vec.sub (at f.(1)) (at f.(0))) (Vec.sub (at f.(2)) (at f.(0))) in
      Array.for_all (fun p -> Rat.sign (Vec.dot normal (Vec.sub p (at f.(0)))) <= 0) points
    in
    let some = List.init 20 (fun k -> k * Array.length hull.ifs_faces / 20) in
    Alcotest.(check bool) (name ^ ": all points are behind") true (List.for_all behind some)

let suite =
  let case name points = Alcotest.test_case name `Quick (large name points) in
  ("hull",
   [
     ("clouds", Scc_test_support.Property.cases [ same_faces; same_order ]);
     ("many points", [ case "a sphere" (on_a_sphere 20000); case "a cone" (cone 6000) ]);
   ])
