(* Which faces bound a solid, and where it is that they do not. *)

open Scc_exact
open Scc_geometry
open Scc_concave
open Scc_test_support
open Cubes

(* {1 What is refused} *)

let box name (x, y, z) (x', y', z') =
  let p k = [| (x, y, z); (x', y, z); (x', y', z); (x, y', z); (x, y, z'); (x', y, z'); (x', y', z');
               (x, y', z') |].(k) in
  let vertices = List.init 8 (fun k -> (Printf.sprintf "%s%d" name k, vec (p k))) in
  let faces =
    [ ("bottom", [ 0; 3; 2; 1 ]); ("top", [ 4; 5; 6; 7 ]); ("left", [ 0; 4; 7; 3 ]); ("right", [ 1; 2; 6; 5 ]);
      ("front", [ 0; 1; 5; 4 ]); ("back", [ 3; 7; 6; 2 ]) ]
  in
  (vertices, List.map (fun (n, f) -> (name ^ n, f)) faces)

let set_of_boxes list : Polyhedron.ifs =
  let faces (count, all) (vertices, faces) =
    let moved = List.map (fun (n, f) -> (n, Array.of_list (List.map (fun v -> count + v) f))) faces in
    (count + List.length vertices, all @ moved)
  in
  {
    ifs_vertices = Array.of_list (List.concat_map fst list);
    ifs_faces = Array.of_list (snd (List.fold_left faces (0, []) list));
  }

let turned (vertices, faces) = (vertices, List.map (fun (n, f) -> (n, List.rev f)) faces)

let verdict (set : Polyhedron.ifs) =
  let face f = fst set.ifs_faces.(f) in
  match Decomposed.make set with
  | Ok t -> Printf.sprintf "%d parts" (Array.length t.parts)
  | Error (Pieces (Apart (f, g))) -> Printf.sprintf "%s apart from %s" (face f) (face g)
  | Error (Pieces (Island (f, g))) -> Printf.sprintf "%s in a hollow of %s" (face f) (face g)
  | Error (Pieces (Outward f)) -> face f ^ " outward"
  | Error (Inside_out { face = f; _ }) -> face f ^ " inside out"
  | Error Nothing -> "nothing at all"
  | Error (Too_many _) -> "too many"
  | Error (Unsound (Cut (f, g, x))) ->
    Printf.sprintf "%s and %s at %s" (fst set.ifs_faces.(f)) (fst set.ifs_faces.(g)) (Vec.to_string x)
  | Error (Unsound (Structure (fault :: _))) -> Polyhedron_fault.kind fault
  | Error (Unsound (Structure [])) -> "nothing"

let refused name expected set =
  Alcotest.test_case name `Quick (fun () -> Alcotest.(check string) name expected (verdict set))

let cube = box "a" (0, 0, 0) (4, 4, 4)
let large = box "l" (-1, -1, -1) (9, 9, 9)
let small = box "s" (1, 1, 1) (2, 2, 2)
let beside = box "c" (5, 1, 1) (6, 2, 2)

(* Its first corner is that of the cube. *)
let wedge =
  let corners = [ (0, 0, 0); (3, 1, 1); (1, 3, 1); (1, 1, 3) ] in
  (List.mapi (fun i x -> (Printf.sprintf "w%d" i, vec x)) corners,
   [ ("x", [ 0; 2; 1 ]); ("y", [ 0; 1; 3 ]); ("z", [ 0; 3; 2 ]); ("slope", [ 1; 2; 3 ]) ])

(* Corners at one place are one vertex. *)
let welded (set : Polyhedron.ifs) : Polyhedron.ifs =
  let points = Array.to_list (Array.map snd set.ifs_vertices) in
  let distinct = List.sort_uniq Vec.compare points in
  let same x k y = if Vec.equal x y then [ k ] else [] in
  let into = Array.of_list (List.map (fun x -> List.hd (List.concat (List.mapi (same x) distinct))) points) in
  {
    ifs_vertices = Array.of_list (List.mapi (fun k x -> (Printf.sprintf "v%d" k, x)) distinct);
    ifs_faces = Array.map (fun (n, f) -> (n, Array.map (fun v -> into.(v)) f)) set.ifs_faces;
  }

(* Seven cubes of eight, with a small one where the eighth would be. *)
let notched =
  let cells = [ (0, 0, 0); (1, 0, 0); (0, 1, 0); (0, 0, 1); (1, 1, 0); (1, 0, 1); (0, 1, 1) ] in
  let set = set_of cells in
  let faces = List.map (fun (n, f) -> (n, Array.to_list f)) (Array.to_list set.ifs_faces) in
  let middle (n, x) = (n, Vec.scale (Rat.make Z.one (Z.of_int 3)) (Vec.add (vec (3, 3, 3)) x)) in
  let vertices, squares = small in
  set_of_boxes [ (Array.to_list set.ifs_vertices, faces); (List.map middle vertices, squares) ]

let without n (set : Polyhedron.ifs) = { set with ifs_faces =
                                                    Array.sub set.ifs_faces 0 (Array.length set.ifs_faces - n) }

let moved v x (set : Polyhedron.ifs) =
  { set with ifs_vertices = Array.mapi (fun i (n, y) -> (n, if i = v then vec x else y)) set.ifs_vertices }

let sheet (set : Polyhedron.ifs) : Polyhedron.ifs =
  let n = Array.length set.ifs_vertices in
  let more = [| ("s", vec (6, 0, 0)); ("t", vec (7, 0, 0)); ("u", vec (6, 1, 0)) |] in
  {
    ifs_vertices = Array.append set.ifs_vertices more;
    ifs_faces =
      Array.append set.ifs_faces [| ("one", [| n; n + 1; n + 2 |]); ("two", [| n + 2; n + 1; n |]) |];
  }

let verdicts =
  let boxes = set_of_boxes in
  let two x y = boxes [ cube; box "b" x y ] in
  [
    refused "a box" "1 parts" (boxes [ cube ]);
    refused "a hollow" "6 parts" (boxes [ cube; turned (box "b" (1, 1, 1) (3, 3, 3)) ]);
    refused "no faces" "no-faces" (without 6 (boxes [ cube ]));
    refused "without a lid" "open-edge" (without 1 (boxes [ cube ]));
    refused "inside out" "inward" (boxes [ turned cube ]);
    refused "two boxes" "abottom apart from bbottom" (two (6, 0, 0) (7, 4, 4));
    refused "a box in a box" "bbottom outward" (two (1, 1, 1) (3, 3, 3));
    refused "a box in a hollow" "sbottom in a hollow of lbottom" (boxes [ turned cube; small; large ]);
    refused "a hollow in a hollow" "sbottom in a hollow of lbottom" (boxes [ large; turned cube; turned small ]);
    refused "a hollow in a box in a hollow" "abottom in a hollow of mbottom"
      (boxes [ turned small; cube; box "m" (-2, -2, -2) (10, 10, 10); turned large ]);
    refused "hollows beside each other" "11 parts" (boxes [ turned cube; large; turned beside ]);
    refused "one of them turned outward" "cbottom outward" (boxes [ turned cube; beside; large ]);
    refused "boxes with a corner in common" "abottom apart from lbottom"
      (welded (boxes [ cube; box "l" (4, 4, 4) (9, 9, 9) ]));
    refused "a hollow that touches the outside" "4 parts" (welded (boxes [ cube; turned wedge ]));
    refused "a box in the notch of another solid" "f0 apart from sbottom" notched;
    refused "boxes that cut each other" "aright and bbottom at (4, 2, 1)" (two (3, 1, 1) (5, 3, 3));
    refused "boxes with a face on a face" "atop and bbottom at (2, 2, 4)" (two (1, 1, 4) (3, 3, 5));
    refused "boxes that touch in an edge" "aback and bbottom at (4, 4, 1)" (two (4, 4, 1) (5, 5, 3));
    refused "a sheet of two faces beside a box" "one and two at (19/3, 1/3, 0)" (sheet (boxes [ cube ]));
    refused "one place twice" "same-position" (moved 1 (0, 0, 0) (boxes [ cube ]));
    refused "a corner that is off its faces" "off-plane" (moved 6 (5, 5, 5) (boxes [ cube ]));
    refused "a corner through a face" "off-plane" (moved 6 (4, 4, -1) (boxes [ cube ]));
  ]

(* {1 Within} *)

(* Points between cells and inside of them; on the surface, nothing is said. *)
let within_is_right (cells, points) =
  let set = set_of cells in
  let faces = List.init (Array.length set.ifs_faces) Fun.id in
  let near k = if k mod 3 = 0 then [ (k / 3) - 1; k / 3 ] else [ (k + 60) / 3 - 20 ] in
  let right (x, y, z) =
    let upon a b = List.map (fun c -> (a, b, c)) (near z) in
    let around = List.concat_map (fun a -> List.concat_map (upon a) (near y)) (near x) in
    let inside = List.filter (fun c -> List.mem c cells) around in
    let third k = Rat.div (rat k) (rat 3) in
    let found = Within.surface set faces (Vec.make (third x) (third y) (third z)) in
    if inside = [] then not found else List.length inside < List.length around || found
  in
  List.for_all right points

let points =
  let open QCheck2.Gen in
  let third = int_range (-12) 12 in
  list_size (return 60) (triple third third third)

(* Boxes in each other and beside each other, in any order, each turned in some way or other. *)
let nested =
  [ box "m" (-2, -2, -2) (20, 20, 20); large; cube; small; beside; box "d" (11, 0, 0) (19, 9, 9);
    box "e" (12, 1, 1) (18, 8, 8); box "n" (30, 0, 0) (31, 1, 1) ]

let some_boxes =
  let open QCheck2.Gen in
  let* list = shuffle_l nested and* flags = list_repeat (List.length nested) (pair bool bool) in
  let some b (there, over) = if not there then None else Some (if over then turned b else b) in
  return (List.filter_map Fun.id (List.map2 some list flags))

let orienting_is_right list =
  list = []
  ||
  let parts = [ (fun (v : Vec.t) -> v.x); (fun v -> v.y); (fun v -> v.z) ] in
  let corner (vertices, _) k = snd (List.nth vertices k) in
  let less (a : Vec.t) (b : Vec.t) = List.for_all (fun of_ -> Rat.compare (of_ a) (of_ b) < 0) parts in
  let within b c = less (corner c 0) (corner b 0) && less (corner b 6) (corner c 6) in
  let set = match Oriented.make (set_of_boxes list) with Ok t -> t.set | Error why -> Alcotest.fail why in
  let right i b =
    let faces = Array.sub set.ifs_faces (6 * i) 6 in
    let depth = List.length (List.filter (within b) list) in
    Bool.equal (depth mod 2 = 0) (Rat.sign (Drawn.volume { set with ifs_faces = faces }) > 0)
  in
  List.for_all Fun.id (List.mapi right list)

(* {1 Triangles} *)

let triangles_are_right cells =
  let set = Scc_mesh.Merge_coplanar.merge (set_of cells) in
  let cut = Triangles.make set in
  let faces = Array.map snd cut.ifs_faces in
  let right f = Array.length f = 3 && not (Vec.is_zero (Drawn.normal cut f)) in
  Array.for_all right faces
  && Surface.edge_faults (Surface.make (Array.length cut.ifs_vertices) faces) = []
  && Rat.equal (Drawn.volume cut) (rat (List.length cells))

let () =
  Alcotest.run "shells"
    [
      ("verdicts", verdicts);
      ( "properties",
        Property.cases
          [
            QCheck2.Test.make ~count:60 ~name:"points within, and points beside"
              (QCheck2.Gen.pair random_cells points) within_is_right;
            QCheck2.Test.make ~count:60 ~name:"faces in triangles" random_cells triangles_are_right;
            QCheck2.Test.make ~count:200 ~name:"hollows and solids in them are turned" some_boxes
              orienting_is_right;
          ] );
    ]
