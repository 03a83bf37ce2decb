open Scc_data
open Scc_geometry
open Scc_decompose

type t = {
  sheets : Sheets.t array;
  met : Sheets.met array;
  tree : Scc_broad_phase.Box_tree.t;
  patches : Union_find.t;
}

(* Two polygons with an edge that no other one has divide the same parts of space, if all that they have in common
   with others are edges and corners of both. *)
let patches (sheets : Sheets.t array) (met : Sheets.met array) =
  let joined = Union_find.create (Array.length sheets) and at = Hashtbl.create 1024 in
  let owners key = Option.value ~default:[] (Hashtbl.find_opt at key) in
  let enter k (s : Sheets.t) =
    let edge (u, v) =
      let key = (Int.min u v, Int.max u v) in
      Hashtbl.replace at key (k :: owners key)
    in
    List.iter edge (Scc_polygon.Polygon.edges s.ids)
  in
  Array.iteri enter sheets;
  let join _ = function
    | [ i; j ] when not (met.(i).touched || met.(j).touched) -> ignore (Union_find.union joined i j)
    | _ -> ()
  in
  Hashtbl.iter join at;
  joined

let make ~tick sheets =
  let met = Sheets.met ~tick sheets and tree = Scc_broad_phase.Box_tree.create () in
  Array.iteri (fun k (s : Sheets.t) -> Scc_broad_phase.Box_tree.insert tree k s.box) sheets;
  { sheets; met; tree; patches = patches sheets met }

let met space k = space.met.(k)
let patch space k = Union_find.find space.patches k

type count = (int * int) list
type sides = { behind : count; front : count }

(* The count beyond a point of the surface, on the way up. *)
let above space x =
  let own = Boxed.of_points [| Homogeneous.to_vec x |] in
  let side f = Array.init 3 (f own) in
  let high = side Float_box.high and found = ref [] in
  high.(2) <- infinity;
  let ray = Float_box.make ~low:(side Float_box.low) ~high in
  let add k = match Sheets.over space.sheets.(k) x with 0 -> () | n -> found := (k, n) :: !found in
  Scc_broad_phase.Box_tree.iter_meeting space.tree ray add;
  !found

(* The place above is in front if the polygon looks upward. *)
let sides space k polygon =
  let s = space.sheets.(k) and x = Sheets.inner polygon in
  let same j = Plane.equal space.sheets.(j).plane s.plane in
  let here = List.filter (fun j -> Sheets.holds space.sheets.(j) x) space.met.(k).over in
  if List.exists (fun j -> j < k && same j) here then None
  else
    let times = (k, 1) :: List.map (fun j -> (j, if same j then 1 else -1)) here in
    let upward = [ s.plane.c; s.plane.a; s.plane.b ] in
    let up = List.fold_left (fun sign z -> if sign <> 0 then sign else Z.sign z) 0 upward in
    let there = above space x in
    if up > 0 then Some { behind = List.rev_append times there; front = there }
    else Some { behind = there; front = List.rev_append (List.map (fun (j, n) -> (j, -n)) times) there }

let total count = List.fold_left (fun sum (_, n) -> sum + n) 0 count

let of_pieces pieces count =
  let by_piece = List.sort compare (List.map (fun (k, n) -> (pieces.(k), n)) count) in
  let add sums (p, n) =
    match sums with (q, m) :: rest when Int.equal p q -> (q, m + n) :: rest | _ -> (p, n) :: sums
  in
  List.filter (fun (_, n) -> n <> 0) (List.rev (List.fold_left add [] by_piece))
