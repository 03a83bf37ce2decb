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

type space = { sheets : Sheets.t array; met : Sheets.met array; tree : Scc_broad_phase.Box_tree.t }

(* How often the place beyond a point of the surface is surrounded, on the way up. *)
let above space x =
  let own = Boxed.of_points [| Homogeneous.to_vec x |] in
  let side f = Array.init 3 (f own) in
  let high = side Float_box.high and sum = ref 0 in
  high.(2) <- infinity;
  let ray = Float_box.make ~low:(side Float_box.low) ~high in
  let add k = sum := !sum + Sheets.over space.sheets.(k) x in
  Scc_broad_phase.Box_tree.iter_meeting space.tree ray add;
  !sum

(* For a piece of a polygon that no other one cuts: true if it is in the surface of the union. Where several
   polygons cover it, it is a piece of the first one. The place above is in front if the polygon looks upward. *)
let shows space k polygon =
  let s = space.sheets.(k) and x = Sheets.inner polygon in
  let same j = Plane.equal space.sheets.(j).plane s.plane in
  let here = List.filter (fun j -> Sheets.holds space.sheets.(j) x) space.met.(k).over in
  (not (List.exists (fun j -> j < k && same j) here))
  &&
  let times = List.fold_left (fun sum j -> if same j then sum + 1 else sum - 1) 1 here in
  let upward = [ s.plane.c; s.plane.a; s.plane.b ] in
  let up = List.fold_left (fun sign z -> if sign <> 0 then sign else Z.sign z) 0 upward in
  let there = above space x in
  let behind, front = if up > 0 then (there + times, there) else (there, there - times) in
  behind > 0 && front <= 0

(* {1 What is left of faces} *)

(* The greatest pieces of a polygon all of which is shown. *)
let left ~tick space k =
  let pieces = Sheets.pieces ~tick space.sheets.(k) space.met.(k) in
  let shown = Array.map (fun _ -> true) pieces in
  for i = Array.length pieces - 1 downto 0 do
    let p = pieces.(i) in
    if p.leaf then shown.(i) <- shows space k p.polygon;
    if p.parent >= 0 && not shown.(i) then shown.(p.parent) <- false
  done;
  let greatest i (p : Sheets.piece) =
    if shown.(i) && (p.parent < 0 || not shown.(p.parent)) then Some p.polygon else None
  in
  List.filter_map Fun.id (Array.to_list (Array.mapi greatest pieces))

type rest = Whole | Pieces of Homogeneous.t array list

(* Of each polygon. *)
let rests ~tick sheets =
  let met = Sheets.met ~tick sheets and tree = Scc_broad_phase.Box_tree.create () in
  Array.iteri (fun k (s : Sheets.t) -> Scc_broad_phase.Box_tree.insert tree k s.box) sheets;
  let space = { sheets; met; tree } and patches = patches sheets met in
  let of_patch = Hashtbl.create 64 in
  let shown k =
    let root = Union_find.find patches k in
    match Hashtbl.find_opt of_patch root with
    | Some shown -> shown
    | None ->
      tick ();
      let shown = shows space root sheets.(root).corners in
      Hashtbl.replace of_patch root shown;
      shown
  in
  let rest k (s : Sheets.t) =
    if met.(k).touched then
      match left ~tick space k with [ one ] when one == s.corners -> Whole | list -> Pieces list
    else if shown k then Whole
    else Pieces []
  in
  (Array.mapi rest sheets, Array.map (fun (m : Sheets.met) -> m.touched) met)

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

let takes set = Option.is_some (prepared set) && Rat.sign (Drawn.volume set) > 0

let surface ~tick (set : Polyhedron.ifs) =
  let*? places, at_vertex, cycles, pieces = prepared set in
  let sheet face corners =
    Sheets.make ~face ~ids:(Array.map (fun v -> at_vertex.(v)) corners) (at places) (box places)
  in
  let sheets = Array.of_list (List.concat (List.mapi (fun f list -> List.map (sheet f) list) pieces)) in
  let rests, touched = rests ~tick sheets in
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
  Some (named set places at_vertex (conforming places corners (List.concat (List.mapi of_face left))))
