open Scc_exact
open Scc_geometry
open Scc_rigid
open Scc_calculus

type family = { name : string; solid : bool; rgb : int * int * int; linear : float array }

type t = {
  families : family array;
  of_leaf : int array;
  meshes : (Solid.t * int) array;
  of_part : int array array;
  forms : int array;
}

(* Told apart by those who see few colours, too. *)
let palette =
  [|
    ((230, 158, 0), [| 0.7913; 0.3419; 0. |]);
    ((87, 181, 232), [| 0.0953; 0.4621; 0.8070 |]);
    ((0, 158, 115), [| 0.; 0.3419; 0.1714 |]);
    ((214, 94, 0), [| 0.6724; 0.1119; 0. |]);
    ((204, 120, 166), [| 0.6038; 0.1878; 0.3813 |]);
    ((0, 115, 178), [| 0.; 0.1714; 0.4452 |]);
    ((224, 209, 66), [| 0.7454; 0.6376; 0.0545 |]);
    ((140, 107, 217), [| 0.2623; 0.1470; 0.6939 |]);
    ((153, 153, 153), [| 0.3185; 0.3185; 0.3185 |]);
    ((178, 64, 89), [| 0.4452; 0.0513; 0.0999 |]);
  |]

let absorbing = ((158, 115, 191), [| 0.3419; 0.1714; 0.5210 |])
let fixed = ((148, 161, 176), [| 0.2961; 0.3564; 0.4342 |])

(* Numbers for what differs, in the order in which it comes. *)
let numbering () =
  let known = Hashtbl.create 16 and items = ref [] in
  let number key item =
    match Hashtbl.find_opt known key with
    | Some i -> i
    | None ->
      let i = Hashtbl.length known in
      Hashtbl.add known key i;
      items := item i :: !items;
      i
  in
  (number, fun () -> Array.of_list (List.rev !items))

let make (m : Model.t) =
  let family_number, families = numbering () and mesh_number, meshes = numbering () in
  let form_number, forms = numbering () in
  let alike = Families.of_model m in
  let family leaf (l : Model.leaf) =
    let number = alike.of_leaf.(leaf) in
    family_number (number, l.fixed, l.absorbs) (fun _ ->
        let rgb, linear =
          if l.absorbs then absorbing
          else if l.fixed then fixed
          else palette.(number mod Array.length palette)
        in
        { name = alike.names.(number); solid = not l.fixed; rgb; linear })
  in
  let of_leaf = Array.mapi family m.leaves in
  let part leaf (p : Model.part) = mesh_number (p.solid.id, of_leaf.(leaf)) (fun _ -> (p.solid, of_leaf.(leaf))) in
  let of_part = Array.mapi (fun leaf (l : Model.leaf) -> Array.map (part leaf) l.parts) m.leaves in
  let form leaf (l : Model.leaf) =
    let look i (p : Model.part) = (of_part.(leaf).(i), Vec.to_string p.offset) in
    form_number (Array.to_list (Array.mapi look l.parts)) (fun _ -> leaf)
  in
  let numbers = Array.mapi form m.leaves in
  let firsts = forms () in
  {
    families = families ();
    of_leaf;
    meshes = meshes ();
    of_part;
    forms = Array.map (fun n -> firsts.(n)) numbers;
  }

let families t = t.families
let family t ~leaf = t.of_leaf.(leaf)

let hex f =
  let r, g, b = f.rgb in
  Printf.sprintf "#%02x%02x%02x" r g b

let opacity f = if f.solid then 1. else 0.35
let meshes t = t.meshes
let mesh t ~leaf ~part = t.of_part.(leaf).(part)
let forms t = t.forms

let extent (m : Model.t) (s : State.t) =
  let join f (a : Vec.t) (b : Vec.t) = Vec.make (f a.x b.x) (f a.y b.y) (f a.z b.z) in
  let widen box x =
    match box with None -> Some (x, x) | Some (low, high) -> Some (join Rat.min low x, join Rat.max high x)
  in
  let part box (placed : Placed.t) = Array.fold_left widen box (Placed.vertices placed) in
  let leaf box (l : State.leaf) =
    let parts = List.init (Array.length m.leaves.(l.leaf).parts) (State.placed m l) in
    List.fold_left part box parts
  in
  let process box (p : State.process) = Array.fold_left leaf box p.leaves in
  Array.fold_left process None s.processes

let far = Rat.of_int 256

let centre m s =
  match extent m s with
  | None -> Vec.zero
  | Some (low, high) ->
    let middle = Vec.middle low high in
    if Rat.compare (Vec.norm2 middle) (Rat.mul far (Vec.norm2 (Vec.sub high low))) <= 0 then Vec.zero
    else
      let whole r = Q.of_bigint (Rat.floor r) in
      Vec.make (whole middle.x) (whole middle.y) (whole middle.z)
