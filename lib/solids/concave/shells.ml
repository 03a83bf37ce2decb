open Scc_data
open Scc_exact
open Scc_geometry

type shell = { first : int; faces : int list; low : Vec.t; high : Vec.t }

let place (set : Polyhedron.ifs) v = snd set.ifs_vertices.(v)
let corners (set : Polyhedron.ifs) f = snd set.ifs_faces.(f)

let shell set faces =
  let first = List.hd faces in
  let start = place set (corners set first).(0) in
  let each f (a : Vec.t) (b : Vec.t) = Vec.make (f a.x b.x) (f a.y b.y) (f a.z b.z) in
  let over f = List.fold_left (fun m i -> Array.fold_left (fun m v -> each f m (place set v)) m (corners set i)) in
  { first; faces; low = over Rat.min start faces; high = over Rat.max start faces }

let all (set : Polyhedron.ifs) =
  let n = Array.length set.ifs_faces in
  let joined = Union_find.create n in
  let surface = Surface.make (Array.length set.ifs_vertices) (Array.map snd set.ifs_faces) in
  let join = function
    | _, (f, _) :: rest -> List.iter (fun (g, _) -> ignore (Union_find.union joined f g)) rest
    | _, [] -> ()
  in
  List.iter join (Surface.unordered surface);
  let members = Array.make n [] in
  for f = n - 1 downto 0 do
    let root = Union_find.find joined f in
    members.(root) <- f :: members.(root)
  done;
  Array.of_list (List.filter_map (function [] -> None | faces -> Some (shell set faces)) (Array.to_list members))

(* {1 Which are within which} *)

let boxed (s : shell) (t : shell) =
  let least (a : Vec.t) (b : Vec.t) =
    Rat.compare a.x b.x <= 0 && Rat.compare a.y b.y <= 0 && Rat.compare a.z b.z <= 0
  in
  least t.low s.low && least s.high t.high

(* Shells have no points in common but corners, and so the middle of an edge is on none but its own. *)
let around set shells s =
  let c = corners set shells.(s).first in
  let middle = Vec.middle (place set c.(0)) (place set c.(1)) in
  let is t = t <> s && boxed shells.(s) shells.(t) && Within.surface set shells.(t).faces middle in
  List.filter is (List.init (Array.length shells) Fun.id)

let outward (set : Polyhedron.ifs) s =
  let faces = Array.of_list (List.map (fun f -> set.ifs_faces.(f)) s.faces) in
  Rat.sign (Drawn.volume { set with ifs_faces = faces }) > 0

(* {1 Faults} *)

type fault = Apart of int * int | Island of int * int | Outward of int

let fault set =
  let shells = all set in
  let first s = shells.(s).first in
  let count = Array.length shells in
  let rec from outermost s =
    if s = count then None
    else
      match (around set shells s, outermost) with
      | [], None -> from (Some s) (s + 1)
      | [], Some other -> Some (Apart (first other, first s))
      | [ _ ], _ -> if outward set shells.(s) then Some (Outward (first s)) else from outermost (s + 1)
      | [ one; other ], _ ->
        let outer = if List.mem other (around set shells one) then other else one in
        Some (Island (first s, first outer))
      | _ -> from outermost (s + 1) (* something around it is an island *)
  in
  if count <= 1 then None else from None 0

let message (set : Polyhedron.ifs) =
  let open Scc_base in
  let name f = fst set.ifs_faces.(f) in
  function
  | Apart (f, g) ->
    ( Code.several_solids,
      Printf.sprintf "these are several solids: `%s` is a face of one, and `%s` of another one beside it" (name f)
        (name g) )
  | Island (f, g) ->
    ( Code.several_solids,
      Printf.sprintf
        "these are several solids: `%s` is a face of one that is in a hollow of another one, with the face `%s`"
        (name f) (name g) )
  | Outward f ->
    ( Code.outward_hollow,
      Printf.sprintf
        "`%s` and the faces around it are within the solid, but turned outward: those of a hollow look into it"
        (name f) )

(* {1 Solids by themselves} *)

(* With the vertices that the faces use. *)
let part (set : Polyhedron.ifs) faces : Polyhedron.ifs =
  let numbers = Hashtbl.create 64 and used = Growable.create () in
  let number v =
    match Hashtbl.find_opt numbers v with
    | Some k -> k
    | None ->
      let k = Growable.length used in
      Growable.push used set.ifs_vertices.(v);
      Hashtbl.replace numbers v k;
      k
  in
  let face f = (fst set.ifs_faces.(f), Array.map number (snd set.ifs_faces.(f))) in
  let ifs_faces = Array.of_list (List.map face (List.sort Int.compare faces)) in
  { ifs_vertices = Array.init (Growable.length used) (Growable.get used); ifs_faces }

let solids set =
  let shells = all set in
  if Array.length shells = 1 then [ set ]
  else
    let outer = Array.map (outward set) shells and faces = Array.map (fun s -> s.faces) shells in
    (* Solids around a hollow are within each other, with the innermost one in a hollow of the next. *)
    let innermost s =
      let solids = List.filter (fun t -> outer.(t)) (around set shells s) in
      match List.find_opt (fun t -> List.for_all (fun u -> boxed shells.(t) shells.(u)) solids) solids with
      | Some t -> t
      | None -> Scc_base.Bug.fail __POS__ "a hollow of no solid"
    in
    let hollow s _ =
      if not outer.(s) then begin
        let t = innermost s in
        faces.(t) <- faces.(t) @ shells.(s).faces
      end
    in
    Array.iteri hollow shells;
    let kept = List.filter (fun s -> outer.(s)) (List.init (Array.length shells) Fun.id) in
    List.map (fun s -> part set faces.(s)) kept
