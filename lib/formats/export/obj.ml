open Scc_exact
open Scc_geometry
open Scc_rigid
open Scc_calculus

(* Names end at a blank. *)
let word s = String.map (fun c -> if c <= ' ' then '_' else c) s

let corner put color v =
  put "v";
  Array.iter (fun x -> put (" " ^ Floats.text x)) (Floats.point v);
  Option.iter
    (fun (r, g, b) ->
       List.iter (fun c -> put (" " ^ Floats.text (Float.of_int (c * 1000 / 255) /. 1000.))) [ r; g; b ])
    color;
  put "\n"

let solid put ~first ~name ?color (p : Polyhedron.t) corners =
  put (Printf.sprintf "o %s\n" (word name));
  Array.iter (corner put color) corners;
  Array.iter
    (fun (face, around) ->
       put (Printf.sprintf "g %s.%s\n" (word name) (word face));
       put "f";
       Array.iter (fun i -> put (Printf.sprintf " %d" (first + i))) around;
       put "\n")
    p.faces;
  first + Array.length corners

let state (f : Film.t) ~time put =
  let m = Film.model f in
  let figure = Figure.make m in
  put (Printf.sprintf "# %s at time %s\n" (word f.title) (Rat.to_string time));
  let leaf first (l : State.leaf) =
    let color = (Figure.families figure).(Figure.family figure ~leaf:l.leaf).rgb in
    let part (first, i) (p : Model.part) =
      let placed = State.placed m l i in
      (solid put ~first ~name:p.name ~color placed.solid.polyhedron (Placed.vertices placed), i + 1)
    in
    fst (Array.fold_left part (first, 0) m.leaves.(l.leaf).parts)
  in
  let leaves = Array.map (fun (p : State.process) -> p.leaves) (Film.at f time).processes in
  ignore (Array.fold_left leaf 1 (Array.concat (Array.to_list leaves)))

let form (m : Model.t) ~leaf put =
  let part first (p : Model.part) =
    let corner i = Vec.add p.offset (Solid.vertex p.solid i) in
    let corners = Array.init (Array.length p.solid.vertices) corner in
    solid put ~first ~name:p.template p.solid.polyhedron corners
  in
  ignore (Array.fold_left part 1 m.leaves.(leaf).parts)
