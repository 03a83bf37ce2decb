open Scc_exact
open Scc_geometry

let area_vector corners =
  let k = Array.length corners in
  let edge i = Vec.cross corners.(i) corners.((i + 1) mod k) in
  List.fold_left Vec.add Vec.zero (List.init k edge)

let areas polygons =
  let table = Hashtbl.create 64 in
  let add corners =
    let a = area_vector corners in
    let normal = Ivec.primitive (fst (Ivec.of_vec a)) in
    let normal = if Ivec.compare normal Ivec.zero < 0 then Ivec.neg normal else normal in
    let direction = Ivec.to_vec normal in
    let key = (Ivec.to_string normal, Rat.to_string (Vec.dot direction corners.(0))) in
    let before = Option.value ~default:Rat.zero (Hashtbl.find_opt table key) in
    Hashtbl.replace table key (Rat.add before (Vec.dot direction a))
  in
  List.iter add polygons;
  let all = Hashtbl.fold (fun key a list -> (key, a) :: list) table [] in
  List.sort compare
    (List.filter_map (fun (key, a) -> if Rat.sign a = 0 then None else Some (key, Rat.to_string a)) all)

let faces (p : Polyhedron.t) =
  List.map (fun (_, corners) -> Array.map (fun v -> snd p.vertices.(v)) corners) (Array.to_list p.faces)
