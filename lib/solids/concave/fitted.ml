open Scc_data
open Scc_geometry
open Scc_decompose

(* Edges that do not have as many faces one way as the other way. *)
let unbalanced (set : Polyhedron.ifs) =
  let sums = Hashtbl.create 256 in
  let edge (u, v) =
    let key = (Int.min u v, Int.max u v) in
    Hashtbl.replace sums key ((if u < v then 1 else -1) + Option.value ~default:0 (Hashtbl.find_opt sums key))
  in
  Array.iter (fun (_, c) -> List.iter edge (Scc_polygon.Polygon.edges c)) set.ifs_faces;
  fun (u, v) -> Hashtbl.find_opt sums (Int.min u v, Int.max u v) <> Some 0

let connected (set : Polyhedron.ifs) =
  let joined = Union_find.create (Array.length set.ifs_vertices) in
  Array.iter (fun (_, c) -> Array.iter (fun v -> ignore (Union_find.union joined c.(0) v)) c) set.ifs_faces;
  Union_find.find joined

let make (set : Polyhedron.ifs) =
  let unbalanced = unbalanced set in
  let sides = Array.map (fun (_, c) -> Scc_polygon.Polygon.edges c) set.ifs_faces in
  let ends = Array.make (Array.length set.ifs_vertices) false in
  let enter (u, v) =
    if unbalanced (u, v) then begin
      ends.(u) <- true;
      ends.(v) <- true
    end
  in
  Array.iter (List.iter enter) sides;
  let at v = Homogeneous.of_vec (snd set.ifs_vertices.(v)) in
  let box list = Boxed.of_points (Array.of_list (List.map (fun v -> snd set.ifs_vertices.(v)) list)) in
  let tree = Scc_broad_phase.Box_tree.create () in
  Array.iteri (fun v is -> if is then Scc_broad_phase.Box_tree.insert tree v (box [ v ])) ends;
  let connected = lazy (connected set) in
  let within corners (u, v) =
    let a = at u and b = at v and found = ref [] in
    let look w =
      if Sheets.on_edge a b (at w) && not (Array.exists (Int.equal w) corners) then found := w :: !found
    in
    if unbalanced (u, v) then Scc_broad_phase.Box_tree.iter_meeting tree (box [ u; v ]) look;
    let apart w = if Lazy.force connected w = Lazy.force connected u then 0 else 1 in
    let order w x =
      match Sheets.farther a b (at w) (at x) with
      | 0 -> compare (apart w, w) (apart x, x)
      | order -> order
    in
    let one_each kept w =
      match kept with x :: _ when Homogeneous.equal (at w) (at x) -> kept | _ -> w :: kept
    in
    u :: List.rev (List.fold_left one_each [] (List.sort order !found))
  in
  let taken = ref 0 in
  let face f (name, corners) =
    let fitted = List.concat_map (within corners) sides.(f) in
    if List.compare_length_with fitted (Array.length corners) = 0 then (name, corners)
    else begin
      incr taken;
      (name, Array.of_list fitted)
    end
  in
  let ifs_faces = Array.mapi face set.ifs_faces in
  ({ set with ifs_faces }, !taken)
