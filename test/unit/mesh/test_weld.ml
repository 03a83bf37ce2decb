(* Welding: what is there twice, and faces without an area, as a share of a greater sweep. *)
open Scc_exact
open Scc_geometry
open Scc_mesh

let box (a, b, c) (d, e, f) : Vec.t array * int list list =
  let v x y z = Vec.of_ints x y z in
  let corners = [| v a b c; v d b c; v d e c; v a e c; v a b f; v d b f; v d e f; v a e f |] in
  (corners, [ [ 0; 3; 2; 1 ]; [ 4; 5; 6; 7 ]; [ 0; 1; 5; 4 ]; [ 1; 2; 6; 5 ]; [ 2; 3; 7; 6 ]; [ 3; 0; 4; 7 ] ])

let set solids : Polyhedron.ifs =
  let join (points, faces) (corners, own) =
    let n = Array.length points in
    (Array.append points corners, faces @ List.map (List.map (( + ) n)) own)
  in
  let points, faces = List.fold_left join ([||], []) solids in
  {
    ifs_vertices = Array.mapi (fun i v -> (Printf.sprintf "v%d" i, v)) points;
    ifs_faces = Array.of_list (List.mapi (fun i c -> (Printf.sprintf "f%d" i, Array.of_list c)) faces);
  }

(* How many faces run more one way than the other, over all edges. *)
let unbalanced (s : Polyhedron.ifs) =
  let sum = Hashtbl.create 64 in
  let add (_, corners) =
    let n = Array.length corners in
    let side i a =
      let b = corners.((i + 1) mod n) in
      let key = (min a b, max a b) in
      Hashtbl.replace sum key (Option.value (Hashtbl.find_opt sum key) ~default:0 + if a < b then 1 else -1)
    in
    Array.iteri side corners
  in
  Array.iter add s.ifs_faces;
  Hashtbl.fold (fun _ n total -> total + abs n) sum 0

let boxes () =
  let random = Random.State.make [| 4 |] in
  let int n = Random.State.int random n in
  for k = 1 to 300 do
    let one _ =
      let a = int 2 and b = int 2 and c = int 2 in
      box (a, b, c) (a + 1 + int 2, b + 1 + int 2, c + 1 + int 2)
    in
    let solids = List.init (2 + int 2) one in
    if unbalanced (fst (Mend.weld (set solids))) > 0 then Alcotest.failf "the boxes %d are open" k
  done

let count s = Array.length s.Polyhedron.ifs_faces

(* What is there twice without need goes. *)
let doubled () =
  let cube = box (0, 0, 0) (1, 1, 1) in
  let welded s = fst (Mend.weld s) in
  Alcotest.(check int) "a cube twice" 6 (count (welded (set [ cube; cube ])));
  let points, faces = cube in
  let again n = set [ (points, List.filteri (fun i _ -> i < n) faces @ faces) ] in
  for n = 1 to 6 do
    let s = welded (again n) in
    Alcotest.(check (pair int int)) (Printf.sprintf "%d faces twice" n) (6, 0) (count s, unbalanced s)
  done;
  let shared = welded (set [ cube; box (0, 0, 0) (1, 1, 2); box (0, 0, 0) (1, 1, 3) ]) in
  Alcotest.(check (pair int int)) "three that share a face" (18, 0) (count shared, unbalanced shared)

(* A cube with points on its edges that one of both faces has, with triangles between. *)
let slivers () =
  let random = Random.State.make [| 5 |] in
  let third k = Rat.make (Z.of_int k) (Z.of_int 3) in
  for k = 1 to 60 do
    let points, faces = box (0, 0, 0) (1, 1, 1) in
    let more = ref [] and extra = ref [] in
    let count = ref (Array.length points) in
    let side a b =
      (* The edge belongs to this face from [a] to [b]. *)
      let new_point q =
        more := Vec.axpy q (Vec.sub points.(b) points.(a)) points.(a) :: !more;
        incr count;
        !count - 1
      in
      match if a < b then Random.State.int random 4 else 0 with
      | 1 ->
        let c = new_point (third 1) in
        extra := [ a; b; c ] :: !extra;
        [ a; c ]
      | 2 ->
        let c = new_point (third 1) in
        let d = new_point (third 2) in
        extra := [ a; b; d ] :: [ a; d; c ] :: !extra;
        [ a; c; d ]
      | 3 ->
        let c = new_point (third 2) in
        let d = new_point (third 1) in
        extra := [ a; b; c; d ] :: !extra;
        [ a; d; c ]
      | _ -> [ a ]
    in
    let face corners =
      let n = List.length corners in
      List.concat (List.mapi (fun i a -> side a (List.nth corners ((i + 1) mod n))) corners)
    in
    let faces = List.map face faces in
    let s = set [ (Array.append points (Array.of_list (List.rev !more)), faces @ !extra) ] in
    Alcotest.(check int) "closed before" 0 (unbalanced s);
    let welded = fst (Mend.weld s) in
    let found = (Array.length welded.ifs_faces, unbalanced welded) in
    Alcotest.(check (pair int int)) (Printf.sprintf "welded %d" k) (6, 0) found;
    let merged = fst (Mend.merge welded) in
    let found = (Array.length merged.ifs_faces, Array.length merged.ifs_vertices) in
    Alcotest.(check (pair int int)) (Printf.sprintf "merged %d" k) (6, 8) found
  done

let suite =
  let case name f = Alcotest.test_case name `Quick f in
  ("weld", [ ("weld", [ case "boxes" boxes; case "there twice" doubled; case "faces without an area" slivers ]) ])
