open Scc_exact
open Scc_geometry

type progress = Looking of int | Uniting of int | Cutting of int | Making of int * int | Naming of int
type fault =
  | Unsound of Sound.fault
  | Pieces of Shells.fault
  | Inside_out of { face : int; whole : bool }
  | Nothing
  | Too_many of int

let most_parts = 10_000

(* The parts are cut and joined from so many cells for each of them, at most. *)
let cells_for_part = 20

let message (set : Polyhedron.ifs) : fault -> Scc_base.Code.t * string =
  let open Scc_base in
  function
  | Unsound (Structure _) -> Bug.fail __POS__ "faults of single faces have words of their own"
  | Unsound (Cut (f, g, x)) ->
    let name i = fst set.ifs_faces.(i) in
    ( Code.crossing_faces,
      Printf.sprintf "the faces `%s` and `%s` have the point %s in common, which is at no edge or corner of both"
        (name f) (name g) (Vec.in_short x) )
  | Pieces fault -> Shells.message set fault
  | Inside_out { face; whole = true } ->
    ( Code.inward_faces,
      Printf.sprintf
        "`%s` and the faces around it are turned inward, and are no hollow: no solid is left around them"
        (fst set.ifs_faces.(face)) )
  | Inside_out { face; whole = false } ->
    ( Code.inward_faces,
      Printf.sprintf "a part of the surface with `%s` is turned inward: it goes through itself, or shares faces"
        (fst set.ifs_faces.(face)) )
  | Nothing -> (Code.no_solid, "the faces surround nothing: each is there from both sides")
  | Too_many most ->
    ( Code.too_deep,
      Printf.sprintf "the solid takes more than %s, or more than %d cells on the way to them"
        (Plural.count most "convex part" "convex parts")
        (cells_for_part * most) )

(* {1 The solid} *)

let surface set =
  match Sound.faults set with
  | Some fault -> Error (Unsound fault)
  | None -> (
      match (Shells.fault set, Drawn.make set) with
      | Some fault, _ -> Error (Pieces fault)
      | None, Some drawn -> Ok drawn
      | None, None -> Scc_base.Bug.fail __POS__ "sound faces that are no polygons")

let groups (t : Parts.t) = Array.length t.parts - List.length t.joints

(* {1 Parts} *)

let prism (set : Polyhedron.ifs) =
  let vertices = Array.map snd set.ifs_vertices and faces = Array.map snd set.ifs_faces in
  let solid piece = Refined.solid (List.map (fun v -> vertices.(v)) (Array.to_list piece)) in
  Option.map (List.map solid) (Scc_polygon.Prism.pieces ~vertices ~faces)

exception Too_long

(* To call at each cell, until there are too many. *)
let budget ~most progress =
  let ticks = cells_for_part * most in
  let left = ref ticks in
  fun () ->
    decr left;
    if !left < 0 then raise_notrace Too_long;
    progress (Cutting (ticks - !left))

let cells ~tick progress (drawn : Drawn.t) =
  let surface = List.concat_map (fun (r : Drawn.region) -> r.pieces) (Array.to_list drawn.regions) in
  let list = Scc_decompose.Decompose.parts ~tick surface in
  let count = List.length list in
  let make k cell =
    progress (Making (k + 1, count));
    Refined.of_cell cell
  in
  List.mapi make list

let convex (set : Polyhedron.ifs) = Refined.solid (List.map snd (Array.to_list set.ifs_vertices))

(* A convex solid is one part. A prism over a polygon has the parts of [Prism], any other solid those of
   [Decompose]. A solid that touches itself may look like one of the first two. *)
let of_solid ~tick progress set drawn =
  let whole list = if Volumes.equal set list then Some list else None in
  let simple = if Drawn.reflex_edges drawn = 0 then Some [ convex set ] else prism set in
  match Option.bind simple whole with
  | Some list -> list
  | None -> (
      match whole (cells ~tick progress drawn) with
      | Some list -> list
      | None -> Scc_base.Bug.fail __POS__ "parts that are not the solid")

let at_most most list = if List.compare_length_with list most > 0 then Error (Too_many most) else Ok list

let named ~progress ?names ~most drawn list =
  let tick ~left = progress (Naming left) in
  Option.to_result ~none:(Too_many most) (Parts.make ~tick ?names ~limit:most drawn list)

let make ?(progress = ignore) ?names ?(most = most_parts) set =
  progress (Looking (Array.length set.Polyhedron.ifs_faces));
  let* drawn = surface set in
  match of_solid ~tick:(budget ~most progress) progress set drawn with
  | exception Too_long -> Error (Too_many most)
  | list ->
    let* list = at_most most list in
    let* t = named ~progress ?names ~most drawn list in
    if groups t = 1 then Ok t else Scc_base.Bug.fail __POS__ "parts that are not joined"

let drawn_surface set =
  match Drawn.make set with Some drawn -> drawn | None -> Scc_base.Bug.fail __POS__ "a surface without faces"

let of_union ~progress ~names ~most set =
  let pairs = ref 0 in
  let tick () =
    incr pairs;
    progress (Uniting !pairs)
  in
  match United.surface ~tick set with
  | Error Not_closed -> Error (Unsound (Option.value (Sound.faults set) ~default:(Sound.Structure [ Inward ])))
  | Error (Inside_out { face; whole }) -> Error (Inside_out { face; whole })
  | Ok { ifs_faces = [||]; _ } -> Error Nothing
  | Ok surface -> (
      let tick = budget ~most progress in
      let parts solid = of_solid ~tick progress solid (drawn_surface solid) in
      match List.concat_map parts (Shells.solids surface) with
      | exception Too_long -> Error (Too_many most)
      | list ->
        let* list = at_most most list in
        named ~progress ~names ~most (drawn_surface surface) list)

(* A solid that does not touch itself is its own union. *)
let united ?(progress = ignore) ?(names = false) ?(most = most_parts) set =
  match make ~progress ~names ~most set with
  | Error (Unsound _ | Pieces _) -> of_union ~progress ~names ~most set
  | Ok _ as parts -> parts
  | Error (Inside_out _ | Nothing | Too_many _) as fault -> fault

let convex_whole (t : Parts.t) =
  let corners (_, (p : Polyhedron.t)) = List.map snd (Array.to_list p.vertices) in
  let hull = Refined.solid (List.concat_map corners (Array.to_list t.parts)) in
  if Rat.equal (Drawn.volume t.drawn.set) (Mass_properties.of_polyhedron hull).volume then
    let shown = Shown.make t.drawn in
    Some (Polyhedron.to_ifs (Parts.named t.drawn hull (Shown.faces shown hull)))
  else None
