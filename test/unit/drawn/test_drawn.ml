(* What names of a drawn solid's faces, edges and corners stand for in its convex parts, held against points:
   solids of unit cubes, whose faces come as unit squares, and whose parts are boxes. *)

open Scc_exact
open Scc_geometry
open Scc_concave
open Scc_test_support
open Cubes

(* {1 Points against names} *)

let sign_on (p : Polyhedron.t) f x =
  let corner k = snd p.vertices.((snd p.faces.(f)).(k)) in
  let n = Vec.cross (Vec.sub (corner 1) (corner 0)) (Vec.sub (corner 2) (corner 0)) in
  Rat.sign (Vec.dot n (Vec.sub x (corner 0)))

(* The feature of a part that has the point inside of itself. *)
let at_point (p : Polyhedron.t) x : Feature.t option =
  let faces = List.init (Array.length p.faces) Fun.id in
  if List.exists (fun f -> sign_on p f x > 0) faces then None
  else
    let vertex = List.find_opt (fun v -> Vec.equal (snd p.vertices.(v)) x) (List.init
                                                                              (Array.length p.vertices) Fun.id) in
    let between (u, v) =
      let a = snd p.vertices.(u) and b = snd p.vertices.(v) in
      Vec.is_zero (Vec.cross (Vec.sub b a) (Vec.sub x a)) && Rat.sign (Vec.dot (Vec.sub b x) (Vec.sub x a)) > 0
    in
    let edge = List.find_opt (fun e -> between p.edges.(e)) (List.init (Array.length p.edges) Fun.id) in
    match (vertex, edge, List.filter (fun f -> sign_on p f x = 0) faces) with
    | Some v, _, _ -> Some (Vertex v)
    | None, Some e, _ -> Some (Edge e)
    | None, None, [ f ] -> Some (Face f)
    | None, None, _ -> None

(* Of a square: its corners, the middles of its edges and its own, and points beside these. *)
let samples cells =
  let of_square f =
    let corner k = vec (List.nth f (k mod 4)) in
    let mix s t =
      let a = corner 0 and b = Vec.sub (corner 1) (corner 0) and d = Vec.sub (corner 3) (corner 0) in
      Vec.axpy s b (Vec.axpy t d a)
    in
    let q a b = Rat.div (rat a) (rat b) in
    let values = [ rat 0; q 1 3; rat 1 ] in
    List.concat_map (fun s -> List.map (fun t -> mix s t) values) values
  in
  List.sort_uniq Vec.compare (List.concat_map of_square (squares cells))

let within set f x =
  let corners = List.map (fun v -> snd set.Polyhedron.ifs_vertices.(v)) (Array.to_list (snd set.ifs_faces.(f))) in
  let bounds get =
    let values = List.map get corners in
    let low = List.fold_left Rat.min (List.hd values) values and high =
                                                               List.fold_left Rat.max (List.hd values) values in
    Rat.compare low (get x) <= 0 && Rat.compare (get x) high <= 0
  in
  bounds (fun (v : Vec.t) -> v.x) && bounds (fun v -> v.y) && bounds (fun v -> v.z)

let shown (t : Parts.t) name =
  match Parts.face_or_vertex t name with Shown f -> f | Flat | Turned _ | Nothing -> Alcotest.fail name

let parts cells = 
  match Drawn.make (set_of cells) with
  | None -> Alcotest.fail "no surface"
  | Some drawn -> Option.get (Parts.make ~limit:1000 drawn (List.map Refined.solid (rows cells)))

let decomposed cells =
  match Decomposed.make (set_of cells) with Ok t -> t | Error _ -> Alcotest.fail "refused"

let united cells =
  match Decomposed.united ~names:true (set_of cells) with Ok t -> t | Error _ -> Alcotest.fail "refused"

let names_are_right parts cells =
  let set = set_of cells in
  let t : Parts.t = parts cells in
  let faces = List.init (Array.length set.ifs_faces) Fun.id in
  let region f = shown t (fst set.ifs_faces.(f)) in
  let regions = List.sort_uniq compare (List.map region faces) in
  let right x =
    let here = List.filter (fun f -> within set f x) faces in
    let around = List.sort_uniq compare (List.map region here) in
    let features =
      List.concat
        (List.mapi
           (fun k (_, p) -> match at_point p x with Some f -> [ (k, f) ] | None -> [])
           (Array.to_list t.parts))
    in
    (* At a reflex edge a face of one part goes on under another part, so that it need not show both sides. *)
    let some list = List.exists (fun site -> List.mem site list) features in
    let interior r = match around with [ s ] -> s = r | _ -> false in
    List.for_all
      (fun r ->
         let closed = some (Parts.closed t r) and inside = some (Parts.inside t r) in
         closed = List.mem r around && (inside || not (interior r)) && (closed || not inside))
      regions
  in
  List.for_all right (samples cells)

let volume_is_kept parts cells =
  let t : Parts.t = parts cells in
  let volume (_, p) = (Mass_properties.of_polyhedron p).volume in
  let sum = Array.fold_left (fun sum p -> Rat.add sum (volume p)) Rat.zero t.parts in
  Rat.equal sum (rat (List.length cells)) && Rat.equal sum (Drawn.volume (set_of cells))

(* Faces as large as they can be: those with notches have several convex pieces, some of which meet others in one
   point. *)
let merged_keep_the_volume cells =
  match Decomposed.make (Scc_mesh.Merge_coplanar.merge (set_of cells)) with
  | Error fault -> QCheck2.Test.fail_reportf "refused: %s" (snd (Decomposed.message (set_of cells) fault))
  | Ok t ->
    let volume (_, p) = (Mass_properties.of_polyhedron p).volume in
    Rat.equal (rat (List.length cells)) (Array.fold_left (fun sum p -> Rat.add sum (volume p)) Rat.zero t.parts)

(* Boxes that overlap, touch or are apart, each with faces and corners of its own. Cells say what is inside. *)
let random_boxes =
  let open QCheck2.Gen in
  let box =
    let* x = int_range 0 3 and* y = int_range 0 3 and* z = int_range 0 3 in
    let+ a = int_range 1 2 and+ b = int_range 1 2 and+ c = int_range 1 2 in
    ((x, y, z), (x + a, y + b, z + c))
  in
  list_size (int_range 1 5) box

let box_faces ((x, y, z), (x', y', z')) =
  let at (a, b, c) = vec ((if a = 0 then x else x'), (if b = 0 then y else y'), if c = 0 then z else z') in
  List.map (fun d -> List.map at (square d)) axes

let soup boxes : Polyhedron.ifs =
  let faces = List.concat_map box_faces boxes in
  {
    ifs_vertices = Array.of_list (List.mapi (fun i x -> (Printf.sprintf "v%d" i, x)) (List.concat faces));
    ifs_faces =
      Array.of_list (List.mapi (fun k _ -> (Printf.sprintf "f%d" k, Array.init 4 (fun i -> (4 * k) + i))) faces);
  }

let union_has_the_cells boxes =
  let cells = List.init 216 (fun k -> (k mod 6, k / 6 mod 6, k / 36)) in
  let within (x, y, z) ((a, b, c), (a', b', c')) = a <= x && x < a' && b <= y && y < b' && c <= z && z < c' in
  let t = match Decomposed.united (soup boxes) with Ok t -> t | Error _ -> QCheck2.Test.fail_report "refused" in
  let strictly (x, y, z) (_, (p : Polyhedron.t)) =
    (* In no plane through few corners of boxes. *)
    let near v k d = Rat.add (rat v) (Rat.make (Z.of_int k) (Z.of_int d)) in
    let at = Vec.make (near x 50 101) (near y 40 103) (near z 15 107) in
    let behind (_, f) =
      let corners = Array.map (fun v -> snd p.vertices.(v)) f in
      let normal = Drawn.area_vector (Array.get corners) (Array.length corners) in
      Rat.sign (Vec.dot normal (Vec.sub at corners.(0))) < 0
    in
    Array.for_all behind p.faces
  in
  let right cell =
    let count = List.length (List.filter (strictly cell) (Array.to_list t.parts)) in
    count = if List.exists (within cell) boxes then 1 else 0
  in
  let covered = List.filter (fun cell -> List.exists (within cell) boxes) cells in
  List.for_all right cells && Rat.equal (rat (List.length covered)) (Drawn.volume t.drawn.set)

(* Hulls of few points, which cross each other at any angle. A point inside of a hull is in a part, a point inside
   of a part is in a hull, and no point is inside of two parts. *)
let random_hulls =
  let open QCheck2.Gen in
  let point =
    let+ x = int_range 0 5 and+ y = int_range 0 5 and+ z = int_range 0 5 in
    (x, y, z)
  in
  list_size (int_range 1 3) (list_size (int_range 4 6) point)

let flat points =
  let first = vec (List.hd points) in
  let ways = List.map (fun x -> Vec.sub (vec x) first) points in
  let spans u v = List.exists (fun w -> Rat.sign (Vec.dot (Vec.cross u v) w) <> 0) ways in
  not (List.exists (fun u -> List.exists (spans u) ways) ways)

let together (bodies : Polyhedron.t list) : Polyhedron.ifs =
  let add (corners, faces) (p : Polyhedron.t) =
    let base = List.length corners in
    let moved = List.map (fun (_, f) -> Array.map (fun v -> base + v) f) (Array.to_list p.faces) in
    (corners @ List.map snd (Array.to_list p.vertices), faces @ moved)
  in
  let corners, faces = List.fold_left add ([], []) bodies in
  let named prefix list = Array.of_list (List.mapi (fun k x -> (Printf.sprintf "%s%d" prefix k, x)) list) in
  { ifs_vertices = named "v" corners; ifs_faces = named "f" faces }

let union_has_the_points hulls =
  let solid points = if flat points then None else Some (Refined.solid (List.map vec points)) in
  let bodies = List.filter_map solid hulls in
  let highest x (p : Polyhedron.t) =
    List.fold_left (fun most f -> Int.max most (sign_on p f x)) (-1) (List.init (Array.length p.faces) Fun.id)
  in
  let right parts k =
    let middle v = Rat.add (rat v) (Rat.make Z.one (Z.of_int 3)) in
    let z = Rat.add (middle (k / 25)) (Rat.make Z.one (Z.of_int 7)) in
    let x = Vec.make (middle (k mod 5)) (middle (k / 5 mod 5)) z in
    let of_bodies = List.map (highest x) bodies and of_parts = List.map (highest x) parts in
    let inside = List.mem (-1) and outside = List.for_all (fun s -> s > 0) in
    not (inside of_bodies && outside of_parts)
    && not (inside of_parts && outside of_bodies)
    && List.length (List.filter (fun s -> s < 0) of_parts) <= 1
  in
  bodies = []
  ||
  match Decomposed.united (together bodies) with
  | Error _ -> QCheck2.Test.fail_report "refused"
  | Ok t -> List.for_all (right (List.map snd (Array.to_list t.parts))) (List.init 125 Fun.id)

let property name holds =
  QCheck2.Test.make ~count:60 ~name
    ~print:QCheck2.Print.(list (triple int int int))
    random_cells holds

(* {1 By hand: a T, of a bar with a stem on it} *)

let tee = [ (0, 0, 0); (1, 0, 0); (2, 0, 0); (1, 0, 1) ]

let shoulders () =
  let t = parts tee in
  let set = set_of tee in
  let half k = Rat.div (rat ((2 * k) + 1)) (rat 2) in
  let face (x, y) z =
    let level f = Array.for_all (fun v -> Rat.equal (snd set.ifs_vertices.(v)).z (rat z))
        (snd set.ifs_faces.(f)) in
    let at f = level f && within set f (Vec.make (half x) (half y) (rat z)) in
    List.find at (List.init (Array.length set.ifs_faces) Fun.id)
  in
  let name k = fst set.ifs_faces.(k) in
  let left = shown t (name (face (0, 0) 1)) and right = shown t (name (face (2, 0) 1)) in
  let common = List.filter (fun s -> List.mem s (Parts.closed t right)) (Parts.closed t left) in
  Alcotest.(check int) "no feature shows both shoulders" 0 (List.length common);
  Alcotest.(check bool) "each is there" true (Parts.inside t left <> [] && Parts.inside t right <> []);
  let bottom = shown t (name (face (0, 0) 0)) in
  Alcotest.(check bool) "squares of one plane are one face" true (bottom = shown t (name (face (2, 0) 0)))

let flat_names () =
  let t = parts [ (0, 0, 0); (1, 0, 0) ] in
  let vertex (x, y, z) =
    let rec find k = if Vec.equal (snd t.drawn.set.ifs_vertices.(k)) (vec (x, y, z)) then k else find (k + 1) in
    find 0
  in
  let kind found = match (found : Parts.found) with
    | Shown (Border _) -> "edge" | Shown (Corner _) -> "corner" | Shown (Region _) -> "face"
    | Flat -> "flat" | Turned _ -> "turned" | Nothing -> "nothing" in
  let check what expected corners =
    Alcotest.(check string) what expected (kind (Parts.tuple t (List.map vertex corners)))
  in
  check "a corner" "corner" [ (0, 0, 0) ];
  check "a point of a long edge" "flat" [ (1, 0, 0) ];
  check "half of a long edge" "edge" [ (0, 0, 0); (1, 0, 0) ];
  check "between two squares of a face" "flat" [ (1, 0, 0); (1, 1, 0) ];
  check "a diagonal" "nothing" [ (0, 0, 0); (1, 1, 0) ];
  check "a square" "face" [ (0, 0, 1); (1, 0, 1); (1, 1, 1); (0, 1, 1) ];
  check "the wrong way round" "turned" [ (0, 0, 1); (0, 1, 1); (1, 1, 1); (1, 0, 1) ]

(* Even halves would make four parts. *)
let few_parts () =
  let cells = [ (0, 1, 1); (0, 2, 0); (0, 2, 1); (1, 0, 1); (1, 0, 2); (1, 1, 1) ] in
  match Decomposed.make ~names:false (set_of cells) with
  | Error _ -> Alcotest.fail "refused"
  | Ok t -> Alcotest.(check int) "parts" 3 (Array.length t.parts)

(* Two cubes touch in an edge, under a slab that joins them. *)
let touching_edge () =
  let t = united [ (0, 0, 0); (1, 1, 0); (0, 0, 1); (1, 0, 1); (0, 1, 1); (1, 1, 1) ] in
  let all = Array.to_list (Array.mapi (fun v (_, x) -> (v, x)) t.drawn.set.ifs_vertices) in
  let at p = fst (List.find (fun (_, x) -> Vec.equal x (vec p)) all) in
  match Parts.tuple t [ at (1, 1, 0); at (1, 1, 1) ] with
  | Shown (Border _ as edge) ->
    let edges = List.filter (function _, Feature.Edge _ -> true | _ -> false) (Parts.inside t edge) in
    Alcotest.(check int) "edges of parts" 2 (List.length edges);
    Array.iteri
      (fun r _ ->
         let inside = Parts.inside t (Region r) in
         Alcotest.(check bool) "no part of a face" false (List.exists (fun e -> List.mem e inside) edges))
      t.drawn.regions
  | _ -> Alcotest.fail "no edge"

(* {1 Prisms} *)

let prism_of cells =
  let set = set_of cells in
  Scc_polygon.Prism.pieces ~vertices:(Array.map snd set.ifs_vertices) ~faces:(Array.map snd set.ifs_faces)

let frame =
  List.filter (fun c -> c <> (1, 1, 0)) (List.concat_map (fun x -> List.map (fun y -> (x, y, 0)) [ 0; 1;
                                                                                                   2 ]) [
                                           0; 1; 2 ])

let prism name expected cells =
  Alcotest.test_case name `Quick (fun () ->
      Alcotest.(check (option int)) name expected (Option.map List.length (prism_of cells)))

let prism_parts_are_right cells =
  match prism_of cells with
  | None -> true
  | Some pieces ->
    let set = set_of cells in
    let points piece = List.map (fun v -> snd set.ifs_vertices.(v)) (Array.to_list piece) in
    let volume piece = (Mass_properties.of_polyhedron (Refined.solid (points piece))).volume in
    let sum = List.fold_left (fun sum piece -> Rat.add sum (volume piece)) Rat.zero pieces in
    Rat.equal sum (rat (List.length cells))

(* Some of three cubes along each side: many touch in an edge or a corner alone. *)
let scattered_cells =
  let open QCheck2.Gen in
  let all = List.init 27 (fun k -> (k mod 3, k / 3 mod 3, k / 9)) in
  let+ wanted = list_repeat 27 (int_range 0 2) in
  match List.filter_map Fun.id (List.map2 (fun c k -> if k = 0 then Some c else None) all wanted) with
  | [] -> [ (0, 0, 0) ]
  | cells -> cells

let flat_cells = QCheck2.Gen.map (List.filter_map (fun (x, y, z) -> if z = 0
                                                    then Some (x, y, 0) else None)) random_cells

let () =
  Alcotest.run "drawn"
    [
      ( "by hand",
        [
          Alcotest.test_case "two shoulders of one bar" `Quick shoulders;
          Alcotest.test_case "what is no feature" `Quick flat_names;
          Alcotest.test_case "an edge in which a solid touches itself" `Quick touching_edge;
          Alcotest.test_case "both ways of cutting are tried" `Quick few_parts;
        ] );
      ( "prisms",
        [
          prism "a box" (Some 1) [ (0, 0, 0); (1, 0, 0) ];
          prism "a T" (Some 2) tee;
          prism "with a hole" (Some 4) frame;
          prism "three cubes around a corner are none" None [ (0, 0, 0); (1, 0, 0); (0, 1, 0); (0, 0, 1) ];
        ] );
      ( "properties",
        Property.cases
          [
            property "points and names, in rows" (names_are_right parts);
            property "points and names, decomposed" (names_are_right decomposed);
            QCheck2.Test.make ~count:30 ~name:"points and names, where cubes touch in edges and corners"
              ~print:QCheck2.Print.(list (triple int int int))
              scattered_cells (names_are_right united);
            property "rows have the volume of the whole" (volume_is_kept parts);
            property "what is decomposed has the volume of the whole" (volume_is_kept decomposed);
            QCheck2.Test.make ~count:40 ~name:"merged faces keep the volume"
              ~print:QCheck2.Print.(list (triple int int int))
              (grown 40) merged_keep_the_volume;
            QCheck2.Test.make ~count:40 ~name:"a union of boxes has their cells"
              ~print:QCheck2.Print.(list (pair (triple int int int) (triple int int int)))
              random_boxes union_has_the_cells;
            QCheck2.Test.make ~count:40 ~name:"a union of hulls has their points"
              ~print:QCheck2.Print.(list (list (triple int int int)))
              random_hulls union_has_the_points;
            QCheck2.Test.make ~count:60 ~name:"prisms keep the volume"
              ~print:QCheck2.Print.(list (triple int int int))
              flat_cells
              (fun cells -> (not (manifold cells)) || prism_parts_are_right cells);
          ] );
    ]
