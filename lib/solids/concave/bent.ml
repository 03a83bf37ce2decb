open Scc_base
open Scc_exact
open Scc_geometry
open Scc_polygon

let place (set : Polyhedron.ifs) v = snd set.ifs_vertices.(v)

(* The axes, the one first that is nearest to the normal. Along another one a face that is not quite flat may cross
   itself. *)
let axes (n : Vec.t) =
  let zero = Rat.zero in
  let all = [ (n.z, { n with x = zero; y = zero }); (n.x, { n with y = zero; z = zero });
              (n.y, { n with x = zero; z = zero }) ] in
  let by_size = List.stable_sort (fun (a, _) (b, _) -> Rat.compare (Rat.abs b) (Rat.abs a)) all in
  List.filter (fun v -> not (Vec.is_zero v)) (List.map snd by_size)

(* Seen along an axis, the outline of the face is that of triangles, which are not flat together. *)
let ears set face n =
  let along axis =
    let corners = Array.map (fun v -> Grid.seen_along axis (place set v)) face in
    let ring = Array.init (Array.length face) Fun.id in
    match Polygon.make corners [ ring ] with
    | Error _ -> None
    | Ok polygon -> Some (List.map (Array.map (fun k -> face.(k))) (Ears.triangles polygon.grid ring))
  in
  List.find_map along (axes n)

(* The squared distance of the corner that is farthest from the plane through the first one. *)
let squared_distance set face n =
  let off v = Rat.abs (Vec.dot n (Vec.sub (place set v) (place set face.(0)))) in
  let most = Array.fold_left (fun m v -> Rat.max m (off v)) Rat.zero face in
  Rat.div (Rat.mul most most) (Vec.norm2 n)

let bent (set : Polyhedron.ifs) (_, face) =
  let outside v = v < 0 || v >= Array.length set.ifs_vertices in
  if Array.length face < 4 || Array.exists outside face then None
  else
    let n = Drawn.normal set face in
    if Vec.is_zero n then None
    else
      let squared = squared_distance set face n in
      if Rat.sign squared = 0 then None else Option.map (fun list -> (squared, list)) (ears set face n)

let triangulated (set : Polyhedron.ifs) =
  let found = Array.map (bent set) set.ifs_faces in
  let all = List.filter_map Fun.id (Array.to_list found) in
  if all = [] then None
  else
    let names = Fresh.besides set in
    let pieces k (name, face) =
      let triangle i corners = ((if i = 0 then name else Fresh.next names ~from:2 (name ^ "_")), corners) in
      match found.(k) with None -> [ (name, face) ] | Some (_, list) -> List.mapi triangle list
    in
    let faces = List.concat (Array.to_list (Array.mapi pieces set.ifs_faces)) in
    let squared = List.fold_left (fun m (d, _) -> Rat.max m d) Rat.zero all in
    let line =
      Printf.sprintf "triangles: %s not planar, with corners up to %s off the plane"
        (Plural.count (List.length all) "face was" "faces were")
        (Decimal.significant ~digits:3 (Rat.root squared))
    in
    Some ({ set with ifs_faces = Array.of_list faces }, line)
