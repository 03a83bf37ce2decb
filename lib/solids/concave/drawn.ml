open Scc_data
open Scc_exact
open Scc_geometry
open Scc_polygon

type region = { name : string; normal : Ivec.t; level : Rat.t; pieces : Vec.t array list }
type border = { segments : (Vec.t * Vec.t) list; between : int list; ends : int list }
type feature = Region of int | Border of int | Corner of int

type t = {
  set : Polyhedron.ifs;
  regions : region array;
  borders : border array;
  region_of_face : int array;
  border_of_edge : (int * int, int) Hashtbl.t;
  corners : bool array;
  corners_of_region : int list array;
  borders_of_region : int list array;
}

(* {1 Faces} *)

let place (set : Polyhedron.ifs) v = snd set.ifs_vertices.(v)

(* Twice the area, along the normal. *)
let area_vector corner n =
  let sum = ref Vec.zero in
  for k = 0 to n - 1 do
    sum := Vec.add !sum (Vec.cross (corner k) (corner ((k + 1) mod n)))
  done;
  !sum

let normal set face = area_vector (fun k -> place set face.(k)) (Array.length face)

let convex_corners set face n =
  if Array.length face = 3 then Some [ face ]
  else
    let corners = Array.map (fun v -> Grid.seen_along n (place set v)) face in
    match Polygon.make corners [ Array.init (Array.length face) Fun.id ] with
    | Error _ -> None
    | Ok polygon -> Some (List.map (Array.map (fun k -> face.(k))) (Partition.quick polygon))

let convex_pieces set face n = Option.map (List.map (Array.map (place set))) (convex_corners set face n)

(* By pairs, as few sums have long numbers then. *)
let rec sum = function
  | [] -> Rat.zero
  | [ x ] -> x
  | list ->
    let rec pairs found = function
      | x :: y :: rest -> pairs (Rat.add x y :: found) rest
      | [ x ] -> x :: found
      | [] -> found
    in
    sum (pairs [] list)

let volume (set : Polyhedron.ifs) =
  let of_face (_, face) =
    let a = place set face.(0) in
    let sum = ref Rat.zero in
    for k = 1 to Array.length face - 2 do
      let b = place set face.(k) and c = place set face.(k + 1) in
      sum := Rat.add !sum (Vec.dot a (Vec.cross b c))
    done;
    !sum
  in
  Rat.div (sum (List.map of_face (Array.to_list set.ifs_faces))) (Rat.of_int 6)

(* {1 Edges} *)

let edge_key u v = (Int.min u v, Int.max u v)

(* The faces at each edge, in the order of their numbers. *)
let faces_of_edges (set : Polyhedron.ifs) =
  let table = Hashtbl.create 256 in
  Array.iteri
    (fun i (_, face) ->
       List.iter
         (fun (u, v) ->
            let key = edge_key u v in
            Hashtbl.replace table key (i :: Option.value ~default:[] (Hashtbl.find_opt table key)))
         (Polygon.edges face))
    set.ifs_faces;
  table

let sorted_keys table =
  let order (a, b) (c, d) = if a <> c then Int.compare a c else Int.compare b d in
  List.sort order (Hashtbl.fold (fun key _ all -> key :: all) table [])

let same_direction n m = Ivec.equal n m

(* Numbers from 0 for classes, in the order of their first members. *)
let numbered joined count =
  let number = Hashtbl.create 64 in
  Array.init count (fun i ->
      let root = Union_find.find joined i in
      match Hashtbl.find_opt number root with
      | Some k -> k
      | None ->
        let k = Hashtbl.length number in
        Hashtbl.add number root k;
        k)

let count_of numbers = Array.fold_left (fun most k -> Int.max most (k + 1)) 0 numbers

(* The members of each class, in order. *)
let members numbers =
  let classes = Array.make (count_of numbers) [] in
  for i = Array.length numbers - 1 downto 0 do
    classes.(numbers.(i)) <- i :: classes.(numbers.(i))
  done;
  classes

let regions_of set normals edges =
  let faces = Array.length set.Polyhedron.ifs_faces in
  let joined = Union_find.create faces in
  Hashtbl.iter
    (fun _ at ->
       match at with
       | [ i; j ] -> if same_direction normals.(i) normals.(j) then ignore (Union_find.union joined i j)
       | _ -> ())
    edges;
  numbered joined faces

(* Edges between regions, of which those that meet at a vertex, two in all, and go straight on are one. *)
let borders_of set region_of_face edges =
  let between key = List.sort_uniq Int.compare (List.map (fun i -> region_of_face.(i)) (Hashtbl.find edges key)) in
  let inner key = match between key with [ _ ] -> true | _ -> false in
  let all = Array.of_list (List.filter (fun key -> not (inner key)) (sorted_keys edges)) in
  let at = Array.make (Array.length set.Polyhedron.ifs_vertices) [] in
  Array.iteri
    (fun k (u, v) ->
       at.(u) <- (k, v) :: at.(u);
       at.(v) <- (k, u) :: at.(v))
    all;
  let joined = Union_find.create (Array.length all) in
  let straight v u w =
    let one = Vec.sub (place set u) (place set v) and other = Vec.sub (place set w) (place set v) in
    Vec.is_zero (Vec.cross one other) && Rat.sign (Vec.dot one other) < 0
  in
  let flat =
    Array.mapi
      (fun v edges ->
         match edges with
         | [ (k, u); (l, w) ] when straight v u w ->
           ignore (Union_find.union joined k l);
           true
         | [] -> true
         | _ -> false)
      at
  in
  (all, numbered joined (Array.length all), between, Array.map not flat)

let make (set : Polyhedron.ifs) =
  let whole = Array.map (fun (_, face) -> normal set face) set.ifs_faces in
  if Array.exists Vec.is_zero whole then None
  else
    let normals = Array.map (fun n -> Ivec.primitive (fst (Ivec.of_vec n))) whole in
    let edges = faces_of_edges set in
    let region_of_face = regions_of set normals edges in
    let pieces = Array.mapi (fun i (_, face) -> convex_pieces set face whole.(i)) set.ifs_faces in
    if Array.exists Option.is_none pieces then None
    else begin
      let all, numbers, between, corners = borders_of set region_of_face edges in
      let faces_of = members region_of_face and edges_of = members numbers in
      let region r =
        let members = faces_of.(r) in
        let first = List.hd members in
        let name, face = set.ifs_faces.(first) in
        {
          name;
          normal = normals.(first);
          level = Vec.dot (Ivec.to_vec normals.(first)) (place set face.(0));
          pieces = List.concat_map (fun i -> Option.value ~default:[] pieces.(i)) members;
        }
      in
      let border b =
        let members = List.map (fun k -> all.(k)) edges_of.(b) in
        {
          segments = List.map (fun (u, v) -> (place set u, place set v)) members;
          between = List.sort_uniq Int.compare (List.concat_map between members);
          ends =
            List.sort_uniq Int.compare
              (List.concat_map (fun (u, v) -> List.filter (fun w -> corners.(w)) [ u; v ]) members);
        }
      in
      let regions = Array.init (count_of region_of_face) region in
      let borders = Array.init (count_of numbers) border in
      let border_of_edge = Hashtbl.create 256 in
      Array.iteri (fun k key -> Hashtbl.replace border_of_edge key numbers.(k)) all;
      let corners_of_region = Array.make (Array.length regions) [] in
      Array.iteri
        (fun i (_, face) ->
           let r = region_of_face.(i) in
           let here = List.filter (fun v -> corners.(v)) (Array.to_list face) in
           corners_of_region.(r) <- List.sort_uniq Int.compare (here @ corners_of_region.(r)))
        set.ifs_faces;
      let borders_of_region = Array.make (Array.length regions) [] in
      Array.iteri
        (fun b border -> List.iter (fun r -> borders_of_region.(r) <- b :: borders_of_region.(r)) border.between)
        borders;
      Some
        { set; regions; borders; region_of_face; border_of_edge; corners; corners_of_region; borders_of_region }
    end

let closure t = function
  | Region r ->
    (Region r :: List.map (fun b -> Border b) t.borders_of_region.(r))
    @ List.map (fun v -> Corner v) t.corners_of_region.(r)
  | Border b -> Border b :: List.map (fun v -> Corner v) t.borders.(b).ends
  | Corner v -> [ Corner v ]

let reflex_edges t =
  let reflex = Array.make (Array.length t.borders) false in
  let face i (_, face) =
    let r = t.region_of_face.(i) in
    let edge (u, v) =
      match Hashtbl.find_opt t.border_of_edge (edge_key u v) with
      | None -> ()
      | Some b -> (
          match List.find_opt (fun other -> other <> r) t.borders.(b).between with
          | None -> ()
          | Some other ->
            let turn = Ivec.to_vec (Ivec.cross t.regions.(r).normal t.regions.(other).normal) in
            if Rat.sign (Vec.dot turn (Vec.sub (place t.set v) (place t.set u))) < 0 then reflex.(b) <- true)
    in
    List.iter edge (Polygon.edges face)
  in
  Array.iteri face t.set.ifs_faces;
  Array.fold_left (fun n r -> if r then n + 1 else n) 0 reflex
