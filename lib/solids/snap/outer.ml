open Scc_data
open Scc_exact
open Scc_geometry
open Scc_mesh

type t = { solid : Polyhedron.ifs; faces : int; beyond : Rat.t }

let direction (hull : Polyhedron.ifs) f =
  let points, _ = Ivec.of_vecs (Array.map (fun v -> snd hull.ifs_vertices.(v)) (snd hull.ifs_faces.(f))) in
  Ivec.primitive (Ivec.cross (Ivec.sub points.(1) points.(0)) (Ivec.sub points.(2) points.(0)))

(* Numbers of at most so many bits, as near as may be; rounded down, which moves all of them alike. *)
let short bits (n : Ivec.t) =
  let longest = List.fold_left (fun m c -> Int.max m (Z.numbits c)) 0 [ n.x; n.y; n.z ] in
  if longest <= bits then n
  else
    let half = Z.shift_left Z.one (longest - bits - 1) in
    let cut c = Z.shift_right (Z.add c half) (longest - bits) in
    Ivec.primitive (Ivec.make (cut n.x) (cut n.y) (cut n.z))

(* {1 The solid of some half-spaces}

   As the dual of the hull of the points n/d, about a point inside. *)

let named prefix points = Array.mapi (fun i v -> (prefix ^ string_of_int i, v)) points
let cloud points = { Polyhedron.ifs_vertices = named "v" points; ifs_faces = [||] }

let corner_of (dual : Polyhedron.ifs) (_, f) =
  let at k = snd dual.ifs_vertices.(f.(k)) in
  let n = Vec.cross (Vec.sub (at 1) (at 0)) (Vec.sub (at 2) (at 0)) in
  let e = Vec.dot n (at 0) in
  if Rat.sign e > 0 then Some (Vec.scale (Rat.div Rat.one e) n) else None

(* The solid: the face of a corner v of the dual has the corners of the dual's faces around v. Those are in
   counter-clockwise order: after a face in which p comes before v is the face in which v comes before p. *)
let polar (dual : Polyhedron.ifs) corners =
  let by_edge = Int_pairs.create 256 and some = Hashtbl.create 256 in
  let enter f (_, cycle) =
    let n = Array.length cycle in
    let edge k v =
      let next = cycle.((k + 1) mod n) in
      Int_pairs.replace by_edge (v, next) (f, cycle.((k + n - 1) mod n));
      Hashtbl.replace some v next
    in
    Array.iteri edge cycle
  in
  Array.iteri enter dual.ifs_faces;
  let face v start =
    let rec around next found =
      let f, before = Int_pairs.find by_edge (v, next) in
      if before = start then List.rev (f :: found) else around before (f :: found)
    in
    ("", Array.of_list (around start []))
  in
  let faces = Hashtbl.fold (fun v start all -> face v start :: all) some [] in
  Hull_of.in_order { Polyhedron.ifs_vertices = named "v" corners; ifs_faces = Array.of_list faces }

let within middle planes =
  let point (n, d) =
    let n = Ivec.to_vec n in
    Vec.scale (Rat.div Rat.one (Rat.sub d (Vec.dot n middle))) n
  in
  match Hull_of.hull (cloud (Array.of_list (List.map point planes))) with
  | None -> None
  | Some dual ->
    let corners = Array.map (corner_of dual) dual.ifs_faces in
    if Array.for_all Option.is_some corners then
      Some (polar dual (Array.map (fun c -> Vec.add middle (Option.get c)) corners))
    else None

(* {1 Around a hull} *)

let around hull kept =
  let positions = Array.map snd hull.Polyhedron.ifs_vertices in
  let whole, denominator = Ivec.of_vecs positions in
  let count = Rat.of_int (Array.length positions) in
  let middle = Vec.scale (Rat.div Rat.one count) (Array.fold_left Vec.add Vec.zero positions) in
  let touching n =
    let most = Array.fold_left (fun m v -> Z.max m (Ivec.dot n v)) (Ivec.dot n whole.(0)) whole in
    (n, Rat.make most denominator)
  in
  let with_bits bits =
    within middle (List.map (fun f -> touching (short bits (direction hull f))) kept)
  in
  List.find_map with_bits [ 15; 30; max_int ]

let renamed (solid : Polyhedron.ifs) = { solid with ifs_vertices = named "v" (Array.map snd solid.ifs_vertices) }

let of_hull ~faces (hull : Polyhedron.ifs) =
  let count = Array.length hull.ifs_faces in
  if count <= faces then Ok { solid = hull; faces = count; beyond = Rat.zero }
  else
    match Thinned.keep ~most:faces hull with
    | Error least -> Error least
    | Ok kept -> (
        match around hull kept with
        | None -> Error (faces + 1)  (* bounded by a hair, which was rounded away *)
        | Some solid ->
          let solid = renamed solid in
          Ok { solid; faces = count; beyond = Rat.root (Beyond.distance2 ~hull solid) })
