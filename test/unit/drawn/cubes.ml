(* Solids of unit cubes, whose faces come as unit squares. *)

open Scc_exact
open Scc_geometry

let rat = Rat.of_int
let vec (x, y, z) = Vec.of_ints x y z

let axes = [ (1, 0, 0); (0, 1, 0); (0, 0, 1); (-1, 0, 0); (0, -1, 0); (0, 0, -1) ]
let plus (a, b, c) (x, y, z) = (a + x, b + y, c + z)

(* Counter-clockwise from outside, as corners of the unit cube. *)
let square = function
  | 1, 0, 0 -> [ (1, 0, 0); (1, 1, 0); (1, 1, 1); (1, 0, 1) ]
  | -1, 0, 0 -> [ (0, 0, 0); (0, 0, 1); (0, 1, 1); (0, 1, 0) ]
  | 0, 1, 0 -> [ (0, 1, 0); (0, 1, 1); (1, 1, 1); (1, 1, 0) ]
  | 0, -1, 0 -> [ (0, 0, 0); (1, 0, 0); (1, 0, 1); (0, 0, 1) ]
  | 0, 0, 1 -> [ (0, 0, 1); (1, 0, 1); (1, 1, 1); (0, 1, 1) ]
  | _ -> [ (0, 0, 0); (0, 1, 0); (1, 1, 0); (1, 0, 0) ]

let squares cells =
  let of_cell c = List.filter_map (fun d -> if List.mem (plus c d) cells
                                    then None else Some (List.map (plus c) (square d))) axes in
  List.concat_map of_cell cells

let set_of cells : Polyhedron.ifs =
  let faces = squares cells in
  let points = List.sort_uniq compare (List.concat faces) in
  let index p =
    let rec find k = function q :: rest -> if q = p then k else find (k + 1) rest | [] -> assert false in
    find 0 points
  in
  {
    ifs_vertices = Array.of_list (List.mapi (fun i p -> (Printf.sprintf "v%d" i, vec p)) points);
    ifs_faces =
      Array.of_list
        (List.mapi (fun i f -> (Printf.sprintf "f%d" i, Array.of_list (List.map index f))) faces);
  }

(* Each edge in two squares, and the squares at each point in one ring: cubes do not touch by an edge or corner
   alone. *)
let manifold cells =
  let faces = squares cells in
  let edges f = List.mapi (fun k p -> (p, List.nth f ((k + 1) mod 4))) f in
  let all = List.concat_map edges faces in
  let twice (p, q) = List.length (List.filter (fun e -> e = (p, q) || e = (q, p)) all) = 2 in
  let ring p =
    let at = List.filter (List.mem p) faces in
    let rec grow found =
      let near f = List.exists (fun g -> List.length (List.filter (fun q -> List.mem q g) f) >= 2
                                         && List.exists (fun q -> q <> p && List.mem q g
                                                                  && List.mem q f) f) found in
      let more = List.filter (fun f -> (not (List.mem f found)) && near f) at in
      if more = [] then found else grow (more @ found)
    in
    List.length (grow [ List.hd at ]) = List.length at
  in
  List.for_all twice all && List.for_all ring (List.sort_uniq compare (List.concat faces))

(* The cells in boxes: rows along x, as long as they go. *)
let rows cells =
  let starts = List.filter (fun c -> not (List.mem (plus c (-1, 0, 0)) cells)) cells in
  let rec stop c = if List.mem (plus c (1, 0, 0)) cells then stop (plus c (1, 0, 0)) else c in
  let box c =
    let d = plus (stop c) (1, 1, 1) in
    let (x, y, z), (x', y', z') = (c, d) in
    List.concat_map
      (fun x -> List.concat_map (fun y -> List.map (fun z -> vec (x, y, z)) [ z; z' ]) [ y; y' ])
      [ x; x' ]
  in
  List.map box starts

let grown most =
  let open QCheck2.Gen in
  let* n = int_range 1 most in
  let rec grow n cells =
    if n = 0 then return cells
    else
      let* c = oneofl cells and* d = oneofl axes in
      let next = plus c d in
      if List.mem next cells then grow (n - 1) cells
      else if manifold (next :: cells) then grow (n - 1) (next :: cells)
      else grow (n - 1) cells
  in
  grow n [ (0, 0, 0) ]

let random_cells = grown 9
