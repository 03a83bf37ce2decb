open Scc_geometry

(* Each trial looks at all faces. *)
let most_tried = 100_000

module By_place = Map.Make (Scc_exact.Vec)

(* The vertices by the first one at their place. *)
let numbers (set : Polyhedron.ifs) =
  let known = ref By_place.empty in
  let number v (_, x) =
    match By_place.find_opt x !known with
    | Some first -> first
    | None ->
      known := By_place.add x v !known;
      v
  in
  Array.mapi number set.ifs_vertices

(* The faces at each edge, and if they run from its lesser number to the greater one. *)
let edges (set : Polyhedron.ifs) =
  let numbers = numbers set and edges = Hashtbl.create 256 in
  let enter f (u, v) =
    let edge = (Int.min u v, Int.max u v) in
    Hashtbl.replace edges edge ((f, u < v) :: Option.value ~default:[] (Hashtbl.find_opt edges edge))
  in
  let of_face f (_, corners) =
    List.iter (enter f) (Scc_polygon.Polygon.edges (Array.map (fun v -> numbers.(v)) corners))
  in
  Array.iteri of_face set.ifs_faces;
  List.sort (fun (e, _) (e', _) -> compare e e') (Hashtbl.fold (fun e faces all -> (e, faces) :: all) edges [])

(* {1 Edges of several solids} *)

let shared_edge ~union (set : Polyhedron.ifs) edges =
  match List.find_opt (fun (_, faces) -> List.compare_length_with faces 3 > 0) edges with
  | Some ((u, v), _) when United.takes set && not (Scc_mesh.Mend.has_faces_twice set) ->
    let name v = Scc_base.Visible.line (fst set.ifs_vertices.(v)) in
    Some
      (Printf.sprintf "solids have an edge in common, from %s to %s; for all of them: %s" (name u) (name v)
         (union ~orient:false))
  | Some _ | None -> None

(* {1 Walls} *)

(* Faces that are connected by edges of two faces, each as the list of its faces. *)
let patches (set : Polyhedron.ifs) edges =
  let of_face = Array.mapi (fun f _ -> f) set.ifs_faces in
  let rec root f = if of_face.(f) = f then f else begin
      of_face.(f) <- of_face.(of_face.(f));
      root of_face.(f)
    end
  in
  let join = function _, [ (f, _); (g, _) ] -> of_face.(root f) <- root g | _ -> () in
  List.iter join edges;
  let ends = Array.map (fun _ -> true) of_face in
  let look (_, faces) =
    if List.compare_length_with faces 1 = 0 then List.iter (fun (f, _) -> ends.(root f) <- false) faces
  in
  List.iter look edges;
  let members = Array.map (fun _ -> []) of_face in
  for f = Array.length of_face - 1 downto 0 do
    members.(root f) <- f :: members.(root f)
  done;
  (* Walls end at other faces everywhere. *)
  List.filteri (fun f list -> ends.(f) && list <> []) (Array.to_list members)

let some_faces (set : Polyhedron.ifs) wanted =
  let faces = List.filteri (fun f _ -> wanted f) (Array.to_list set.ifs_faces) in
  { set with ifs_faces = Array.of_list faces }

(* Flat patches without all of which the other faces are closed. *)
let walls (set : Polyhedron.ifs) edges =
  let faces patch = Array.of_list (List.map (Array.get set.ifs_faces) patch) in
  let is_flat patch = Flat_mesh.is_flat { set with ifs_faces = faces patch } in
  let inner = Array.map (fun _ -> false) set.ifs_faces in
  let all = List.concat (List.filter is_flat (patches set edges)) in
  List.iter (fun f -> inner.(f) <- true) all;
  if all <> [] && United.takes (some_faces set (fun f -> not inner.(f))) then List.sort Int.compare all else []

let wall (set : Polyhedron.ifs) edges =
  let name f = Scc_base.Visible.line (fst set.ifs_faces.(f)) in
  let text faces is = Printf.sprintf "%s %s within the solid: without it the other faces are closed" faces is in
  match walls set edges with
  | [] -> None
  | [ f ] -> Some (text (name f) "is a wall")
  | first :: rest ->
    let more = Scc_base.Plural.count (List.length rest) "more face" "more faces" in
    Some (text (Printf.sprintf "%s and %s" (name first) more) "are a wall")

(* {1 Closed pieces} *)

(* Each has vertices of its own. *)
let closed_pieces ~union set =
  if not (Oriented.pieces set > 1 && Option.is_some (Sound.faults set)) then None
  else
    let text orient = Some ("each of several pieces is closed; for all of them: " ^ union ~orient) in
    match United.surface ~tick:ignore set with
    | Ok _ -> text false
    | Error (Inside_out { whole = true; _ }) -> text true
    | Error (Not_closed | Inside_out { whole = false; _ }) -> None

(* {1 All} *)

let in_range (set : Polyhedron.ifs) =
  let inside v = v >= 0 && v < Array.length set.ifs_vertices in
  Array.for_all (fun (_, face) -> Array.length face > 2 && Array.for_all inside face) set.ifs_faces

let ( <|> ) found next = match found with Some _ -> found | None -> next ()

let of_several ?union (set : Polyhedron.ifs) =
  let tried = Array.length set.ifs_faces <= most_tried && in_range set in
  let with_union f = match union with Some union -> f union | None -> None in
  if tried && Mended.one_side_each set then None
  else
    with_union (fun union -> Shared_face.advice ~union:(union ~orient:false) set)
    <|> fun () ->
      if not tried then None
      else
        let edges = edges set in
        let crowded (_, faces) = List.compare_length_with faces 2 > 0 in
        let crowded = List.exists crowded edges in
        with_union (fun union -> if crowded then shared_edge ~union set edges else None)
        <|> (fun () -> if crowded then wall set edges else None)
        <|> fun () -> with_union (fun union -> closed_pieces ~union set)

let advice ?union set =
  match Flat_mesh.advice set with Some _ as flat -> flat | None -> of_several ?union set
