open Scc_data
open Scc_exact
open Scc_geometry

type site = { part : int; face : int }
type side = { site : site; normal : Ivec.t; corners : Vec.t array; box : Float_box.t }

let side (p : Polyhedron.t) part face =
  let corners = Array.map (fun v -> snd p.vertices.(v)) (snd p.faces.(face)) in
  let n = Vec.cross (Vec.sub corners.(1) corners.(0)) (Vec.sub corners.(2) corners.(0)) in
  { site = { part; face }; normal = Ivec.primitive (fst (Ivec.of_vec n)); corners; box = Boxed.of_points corners }

let plane n x = (Ivec.to_string n, Rat.to_string (Vec.dot (Ivec.to_vec n) x))

let forest parts =
  let sides k (p : Polyhedron.t) = List.init (Array.length p.faces) (side p k) in
  let all = List.concat (Array.to_list (Array.mapi sides parts)) in
  let at = Hashtbl.create 256 in
  List.iter (fun s -> Hashtbl.add at (plane s.normal s.corners.(0)) s) all;
  let joined = Union_find.create (Array.length parts) in
  let joints = ref [] in
  let join s =
    let back = Ivec.neg s.normal in
    let meet other =
      if Union_find.find joined s.site.part <> Union_find.find joined other.site.part
      && Float_box.meet other.box s.box
      && Shown.share (Ivec.to_vec back) other.corners s.corners
      && Union_find.union joined s.site.part other.site.part
      then joints := (s.site, other.site) :: !joints
    in
    List.iter meet (List.rev (Hashtbl.find_all at (plane back s.corners.(0))))
  in
  List.iter join all;
  List.rev !joints
