open Scc_data
open Scc_exact
open Scc_geometry
open Scc_decompose
module Places = Hashtbl.Make (Homogeneous)

let place (set : Polyhedron.ifs) v = snd set.ifs_vertices.(v)

(* {1 Places by numbers} *)

type places = { numbers : int Places.t; all : (Homogeneous.t * Float_box.t) Growable.t }

let number t x =
  match Places.find_opt t.numbers x with
  | Some k -> k
  | None ->
    let k = Growable.length t.all in
    Places.add t.numbers x k;
    Growable.push t.all (x, Boxed.of_points [| Homogeneous.to_vec x |]);
    k

let at t k = fst (Growable.get t.all k)
let box t k = snd (Growable.get t.all k)

(* {1 What is given} *)

let in_range (set : Polyhedron.ifs) =
  let inside v = v >= 0 && v < Array.length set.ifs_vertices in
  Array.for_all (fun (_, face) -> Array.length face > 2 && Array.for_all inside face) set.ifs_faces

let closed cycles =
  let balance = Hashtbl.create 256 in
  let add key d = Hashtbl.replace balance key (d + Option.value ~default:0 (Hashtbl.find_opt balance key)) in
  let edge (u, v) = if u < v then add (u, v) 1 else add (v, u) (-1) in
  Array.iter (fun cycle -> List.iter edge (Scc_polygon.Polygon.edges cycle)) cycles;
  Hashtbl.fold (fun _ d all -> d = 0 && all) balance true

let convex_pieces (set : Polyhedron.ifs) (_, face) =
  let n = Drawn.normal set face in
  let flat v = Rat.sign (Vec.dot n (Vec.sub (place set v) (place set face.(0)))) = 0 in
  if Vec.is_zero n || not (Array.for_all flat face) then None else Drawn.convex_corners set face n

(* {1 What is inside and what is outside} *)

type fault = Not_closed | Inside_out of { face : int; whole : bool }

(* At each edge the faces, and if they run from its lesser number to the greater one. *)
let edges cycles =
  let at = Hashtbl.create 256 in
  let enter f cycle =
    let edge (u, v) =
      let key = (Int.min u v, Int.max u v) in
      Hashtbl.replace at key ((f, if u < v then 1 else -1) :: Option.value ~default:[] (Hashtbl.find_opt at key))
    in
    List.iter edge (Scc_polygon.Polygon.edges cycle)
  in
  Array.iteri enter cycles;
  at

(* The pieces of closed surface that faces form, by the first faces: those connected by edges of two faces, by the
   vertices that are given, or else by places. What is not closed is joined at the edges where it is not. *)
let pieces (set : Polyhedron.ifs) cycles =
  let n = Array.length cycles and placed = edges cycles in
  let joined_by at =
    let joined = Union_find.create n in
    let join _ = function [ (f, _); (g, _) ] -> ignore (Union_find.union joined f g) | _ -> () in
    Hashtbl.iter join at;
    joined
  in
  let open_at joined faces =
    let piece f = Union_find.find joined f in
    let sum p = List.fold_left (fun sum (f, way) -> if piece f = p then sum + way else sum) 0 faces in
    List.filter (fun p -> sum p <> 0) (List.sort_uniq Int.compare (List.map (fun (f, _) -> piece f) faces))
  in
  let rec close joined =
    let join _ faces changed =
      match open_at joined faces with
      | [] -> changed
      | p :: others ->
        List.iter (fun q -> ignore (Union_find.union joined p q)) others;
        true
    in
    if Hashtbl.fold join placed false then close joined
  in
  let given = joined_by (edges (Array.map snd set.ifs_faces)) in
  let is_closed = Hashtbl.fold (fun _ faces all -> all && open_at given faces = []) placed true in
  let joined = if is_closed then given else joined_by placed in
  close joined;
  Array.init n (Union_find.find joined)

(* What was seen of the pieces, over all places. *)
type seen = {
  mutable wrong : int list;  (** of places that pieces surround less than no time, and none surrounds: these *)
  left : (int, unit) Hashtbl.t;  (** those of which something is in the union *)
  taken : (int, int) Hashtbl.t;  (** of others that surround a place: one that is inside out there *)
}

let nothing_seen () = { wrong = []; left = Hashtbl.create 16; taken = Hashtbl.create 16 }

let see seen of_sheet count =
  let sums = Surrounded.of_pieces of_sheet count and total = Surrounded.total count in
  let solid, inward = List.partition (fun (_, n) -> n > 0) sums in
  if total > 0 then List.iter (fun (p, _) -> Hashtbl.replace seen.left p ()) solid
  else
    match (solid, inward) with
    | [], _ -> seen.wrong <- List.map fst inward @ seen.wrong
    | _, (q, _) :: _ -> List.iter (fun (p, _) -> Hashtbl.replace seen.taken p q) solid
    | _, [] -> ()

(* Pieces that are inside out where no solid is around them, or that take a solid away whole: the first face of
   one. A piece of positive volume goes through itself. *)
let inside_out (set : Polyhedron.ifs) of_face seen =
  let lost p q all = if Hashtbl.mem seen.left p then all else q :: all in
  let whole = if Hashtbl.length seen.left > 0 then Hashtbl.fold lost seen.taken [] else [] in
  match List.sort_uniq Int.compare (whole @ seen.wrong) with
  | [] -> Ok ()
  | wrong -> (
      let turned piece =
        let own = List.filteri (fun f _ -> of_face.(f) = piece) (Array.to_list set.ifs_faces) in
        Rat.sign (Drawn.volume { set with ifs_faces = Array.of_list own }) < 0
      in
      match List.find_opt turned wrong with
      | Some face -> Error (Inside_out { face; whole = true })
      | None -> Error (Inside_out { face = List.hd wrong; whole = false }))

(* {1 What is left of faces} *)

(* The greatest pieces of a polygon all of which is shown. *)
let left ~tick ~shows space (sheets : Sheets.t array) k =
  let pieces = Sheets.pieces ~tick sheets.(k) (Surrounded.met space k) in
  let shown = Array.map (fun _ -> true) pieces in
  for i = Array.length pieces - 1 downto 0 do
    let p = pieces.(i) in
    if p.leaf then shown.(i) <- shows k p.polygon;
    if p.parent >= 0 && not shown.(i) then shown.(p.parent) <- false
  done;
  let greatest i (p : Sheets.piece) =
    if shown.(i) && (p.parent < 0 || not shown.(p.parent)) then Some p.polygon else None
  in
  List.filter_map Fun.id (Array.to_list (Array.mapi greatest pieces))

type rest = Whole | Pieces of Homogeneous.t array list

(* Of each polygon: a piece of it is in the surface of the union if what is behind is inside, and what is in front
   is not. [see] is called with the counts of all places. *)
let rests ~tick ~see sheets =
  let space = Surrounded.make ~tick sheets in
  let shows k polygon =
    match Surrounded.sides space k polygon with
    | None -> false
    | Some { behind; front } ->
      let look count =
        see count;
        Surrounded.total count > 0
      in
      let inside = look behind and beyond = look front in
      inside && not beyond
  in
  let of_patch = Hashtbl.create 64 in
  let shown k =
    let root = Surrounded.patch space k in
    match Hashtbl.find_opt of_patch root with
    | Some shown -> shown
    | None ->
      tick ();
      let shown = shows root sheets.(root).Sheets.corners in
      Hashtbl.replace of_patch root shown;
      shown
  in
  let touched k = (Surrounded.met space k).touched in
  let rest k (s : Sheets.t) =
    if touched k then
      match left ~tick ~shows space sheets k with [ one ] when one == s.corners -> Whole | list -> Pieces list
    else if shown k then Whole
    else Pieces []
  in
  let rests = Array.mapi rest sheets in
  (rests, Array.mapi (fun k _ -> touched k) sheets)

(* {1 The surface} *)

(* Corners on an edge of others become corners of it. They are those of polygons that others touch. *)
let conforming places corners cycles =
  let tree = Scc_broad_phase.Box_tree.create () in
  List.iter (fun k -> Scc_broad_phase.Box_tree.insert tree k (box places k)) corners;
  let on_edge (u, v) =
    let a = at places u and b = at places v and found = ref [] in
    let look k = if k <> u && k <> v && Sheets.on_edge a b (at places k) then found := k :: !found in
    Scc_broad_phase.Box_tree.iter_meeting tree (Float_box.hull [| box places u; box places v |]) look;
    u :: List.sort (fun k l -> Sheets.farther a b (at places k) (at places l)) !found
  in
  let whole cycle = Array.of_list (List.concat_map on_edge (Scc_polygon.Polygon.edges cycle)) in
  List.map (fun (face, cycle) -> (face, whole cycle)) cycles

(* Pieces of a face have its name, a number at the end of all but one of them. *)
let named (set : Polyhedron.ifs) places at_vertex polygons : Polyhedron.ifs =
  let fresh = Fresh.besides set and given = Hashtbl.create 256 and names = Hashtbl.create 256 in
  let enter v k = if not (Hashtbl.mem names k) then Hashtbl.replace names k (fst set.ifs_vertices.(v)) in
  Array.iteri enter at_vertex;
  let numbers = Hashtbl.create 256 and vertices = Growable.create () in
  let vertex k =
    match Hashtbl.find_opt numbers k with
    | Some v -> v
    | None ->
      let v = Growable.length vertices in
      let name = match Hashtbl.find_opt names k with Some name -> name | None -> Fresh.next fresh "w" in
      Growable.push vertices (name, Homogeneous.to_vec (at places k));
      Hashtbl.replace numbers k v;
      v
  in
  let face (f, cycle) =
    let name = fst set.ifs_faces.(f) and corners = Array.map vertex cycle in
    if Hashtbl.mem given f then (Fresh.next fresh ~from:2 (name ^ "_"), corners)
    else begin
      Hashtbl.replace given f ();
      (name, corners)
    end
  in
  let ifs_faces = Array.of_list (List.map face polygons) in
  { ifs_vertices = Array.init (Growable.length vertices) (Growable.get vertices); ifs_faces }

(* The places of the vertices, and the faces by these and in convex pieces, if a union can be had of them. *)
let prepared (set : Polyhedron.ifs) =
  if Array.length set.ifs_faces = 0 || not (in_range set) then None
  else
    let places = { numbers = Places.create 1024; all = Growable.create () } in
    let at_vertex = Array.map (fun (_, x) -> number places (Homogeneous.of_vec x)) set.ifs_vertices in
    let cycles = Array.map (fun (_, face) -> Array.map (fun v -> at_vertex.(v)) face) set.ifs_faces in
    if not (closed cycles) then None
    else
      let*? pieces = Option.all (convex_pieces set) (Array.to_list set.ifs_faces) in
      Some (places, at_vertex, cycles, pieces)

let sheets_of (places, at_vertex, _, pieces) =
  let sheet face corners =
    Sheets.make ~face ~ids:(Array.map (fun v -> at_vertex.(v)) corners) (at places) (box places)
  in
  Array.of_list (List.concat (List.mapi (fun f list -> List.map (sheet f) list) pieces))

let sheets set = Option.map sheets_of (prepared set)
let takes set = Option.is_some (prepared set) && Rat.sign (Drawn.volume set) > 0

let surface ~tick (set : Polyhedron.ifs) =
  let* ((places, at_vertex, cycles, _) as prepared) = Option.to_result ~none:Not_closed (prepared set) in
  let sheets = sheets_of prepared in
  let of_face = pieces set cycles and seen = nothing_seen () in
  let of_sheet = Array.map (fun (s : Sheets.t) -> of_face.(s.face)) sheets in
  let rests, touched = rests ~tick ~see:(see seen of_sheet) sheets in
  let* () = inside_out set of_face seen in
  let whole = Array.map (fun _ -> true) set.ifs_faces in
  let look k (s : Sheets.t) = match rests.(k) with Whole -> () | Pieces _ -> whole.(s.face) <- false in
  Array.iteri look sheets;
  let polygons k (s : Sheets.t) =
    match rests.(k) with
    | Whole -> [ s.ids ]
    | Pieces list -> List.map (Array.map (number places)) list
  in
  let left = List.mapi polygons (Array.to_list sheets) in
  let corners = List.concat (List.filteri (fun k _ -> touched.(k)) left) in
  let corners = List.sort_uniq Int.compare (List.concat_map Array.to_list corners) in
  let started = Array.map (fun _ -> false) set.ifs_faces in
  let of_face k list =
    let f = sheets.(k).face in
    if not whole.(f) then List.map (fun cycle -> (f, cycle)) list
    else if started.(f) then []
    else begin
      started.(f) <- true;
      [ (f, cycles.(f)) ]
    end
  in
  Ok (named set places at_vertex (conforming places corners (List.concat (List.mapi of_face left))))
