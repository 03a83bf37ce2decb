(* Maximal faces from triangles. *)
open Scc_exact
open Scc_geometry
open Scc_mesh
module G = QCheck2.Gen

let set points faces =
  let name prefix = Array.mapi (fun i x -> (prefix ^ string_of_int i, x)) in
  { Polyhedron.ifs_vertices = name "v" points; ifs_faces = name "f" faces }

(* Each face as its corners' positions from the least on; sorted: the same for equal surfaces. *)
let surface (ifs : Polyhedron.ifs) =
  let position v = snd ifs.ifs_vertices.(v) in
  let face (_, corners) =
    let n = Array.length corners in
    let least = ref 0 in
    Array.iteri
      (fun i v -> if Vec.compare (position v) (position corners.(!least)) < 0 then least := i)
      corners;
    String.concat " " (List.init n (fun i -> Vec.to_string (position corners.((!least + i) mod n))))
  in
  List.sort String.compare (List.map face (Array.to_list ifs.ifs_faces))

let hull points =
  let s = Scc_naive.Naive.hull points in
  set s.points (Array.of_list (List.map Array.of_list s.faces))

let cube =
  let ends = [ -1; 1 ] in
  List.concat_map (fun x -> List.concat_map (fun y -> List.map (fun z -> Vec.of_ints x y z) ends) ends) ends

(* The corners of a cube are always there, so that the hull is solid and has faces to cut. *)
let some_hull =
  let small = G.int_range (-2) 2 in
  let point = G.map3 Vec.of_ints small small small in
  G.map (fun points -> hull (cube @ points)) (G.list_size (G.int_range 0 8) point)

(* Each face as a fan from one of its corners, or from a point within that is a new vertex. *)
let triangulate (ifs : Polyhedron.ifs) choices =
  let points = ref (List.rev (List.map snd (Array.to_list ifs.ifs_vertices))) in
  let count = ref (Array.length ifs.ifs_vertices) in
  let fan choice (_, corners) =
    let n = Array.length corners in
    let at i = corners.((i + choice) mod n) in
    if choice mod 3 = 0 then begin
      let sum = Array.fold_left (fun s v -> Vec.add s (snd ifs.ifs_vertices.(v))) Vec.zero corners in
      let middle = !count in
      points := Vec.scale (Rat.div Rat.one (Rat.of_int n)) sum :: !points;
      incr count;
      List.init n (fun i -> [| middle; at i; at (i + 1) |])
    end
    else List.init (n - 2) (fun i -> [| at 0; at (i + 1); at (i + 2) |])
  in
  let choice i = List.nth choices (i mod List.length choices) in
  let triangles = List.concat (List.mapi (fun i f -> fan (choice i) f) (Array.to_list ifs.ifs_faces)) in
  set (Array.of_list (List.rev !points)) (Array.of_list triangles)

let print (ifs, _) = String.concat "\n" (surface ifs)

let undoes =
  QCheck2.Test.make ~name:"merging undoes any triangulation" ~count:500 ~print
    (G.pair some_hull (G.list_size (G.int_range 1 9) (G.int_bound 20)))
    (fun (ifs, choices) ->
       let merged = Merge_coplanar.merge (triangulate ifs choices) in
       List.equal String.equal (surface ifs) (surface merged)
       && Result.is_ok (Polyhedron.of_ifs merged))

let idempotent =
  QCheck2.Test.make ~name:"merging twice is merging once" ~count:200 ~print
    (G.pair some_hull (G.list_size (G.int_range 1 9) (G.int_bound 20)))
    (fun (ifs, choices) ->
       let once = Merge_coplanar.merge (triangulate ifs choices) in
       List.equal String.equal (surface once) (surface (Merge_coplanar.merge once)))

(* {1 What must stay} *)

let v = Vec.of_ints

(* A flat ring of eight triangles around a square hole: its outline is two lines. *)
let test_ring () =
  let outer = [| v 0 0 0; v 3 0 0; v 3 3 0; v 0 3 0 |] and inner = [| v 1 1 0; v 2 1 0; v 2 2 0; v 1 2 0 |] in
  let faces =
    Array.concat
      (List.init 4 (fun i ->
           let j = (i + 1) mod 4 in
           [| [| i; j; 4 + j |]; [| i; 4 + j; 4 + i |] |]))
  in
  let ifs = set (Array.append outer inner) faces in
  Alcotest.(check (list string)) "as it is" (surface ifs) (surface (Merge_coplanar.merge ifs))

(* A vertex in the middle of an edge that is a true corner of a face below must not go. *)
let test_needed () =
  let points = [| v 0 0 0; v 2 0 0; v 2 2 0; v 0 2 0; v 1 0 0; v 1 0 (-1); v 2 0 (-1) |] in
  let ifs = set points [| [| 0; 4; 2 |]; [| 4; 1; 2 |]; [| 0; 2; 3 |]; [| 4; 5; 6; 1 |] |] in
  let merged = Merge_coplanar.merge ifs in
  let lengths = List.map (fun (_, f) -> Array.length f) (Array.to_list merged.ifs_faces) in
  Alcotest.(check (list int)) "five corners" [ 5; 4 ] lengths;
  Alcotest.(check string) "the name of its first part" "f0" (fst merged.ifs_faces.(0))

let test_back_to_back () =
  let ifs = set [| v 0 0 0; v 1 0 0; v 0 1 0 |] [| [| 0; 1; 2 |]; [| 2; 1; 0 |] |] in
  Alcotest.(check int) "two faces" 2 (Array.length (Merge_coplanar.merge ifs).ifs_faces)

let suite =
  let case name f = Alcotest.test_case name `Quick f in
  ("merge",
   [
     ("triangulations", Scc_test_support.Property.cases [ undoes; idempotent ]);
     ( "what stays",
       [
         case "a ring" test_ring; case "a corner that others need" test_needed;
         case "back to back" test_back_to_back;
       ] );
   ])
