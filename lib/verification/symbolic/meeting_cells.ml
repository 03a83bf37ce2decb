open Scc_exact
open Scc_polyhedra

(* What a constraint on the offset says of the time: that it is not less or not more than a form, or if it is met
   at all. *)
type condition = From of Linear.t | Until of Linear.t | Needed of Constraint.t

let speed (velocity : Vec.t) (f : Linear.t) =
  Rat.sub (Linear.eval f [| velocity.x; velocity.y; velocity.z |]) f.constant

let conditions ~dimension (x, y, z) velocity c =
  let of_half (c : Constraint.t) =
    let f = Constraint.to_form c in
    let now = Linear.compose f ~dimension [| x; y; z |] and speed = speed velocity f in
    let crossing () = Linear.scale (Rat.div (Rat.of_int (-1)) speed) now in
    match Rat.sign speed with
    | 0 -> Needed (Constraint.of_form now At_most)
    | s when s > 0 -> Until (crossing ())
    | _ -> From (crossing ())
  in
  List.map of_half (Constraint.halves c)

(* The greatest of some forms: a region for each. *)
let greatest within = function
  | [] -> []
  | f :: rest ->
    let more cells f =
      let one (region, greatest) =
        let on c g = List.map (fun region -> (region, g)) (Region.where region [ c ]) in
        on (Constraint.at_most f greatest) greatest @ on (Constraint.greater f greatest) f
      in
      List.concat_map one cells
    in
    List.fold_left more [ (within, f) ] rest

let make offsets ~offset ~velocity ~limit within =
  let x, _, _ = offset in
  let dimension = Linear.dimension x in
  let all = List.concat_map (conditions ~dimension offset velocity) (Polyhedron.constraints offsets) in
  let from = List.filter_map (function From f -> Some f | Until _ | Needed _ -> None) all in
  let until = List.filter_map (function Until f -> Some f | From _ | Needed _ -> None) all in
  let needed = List.filter_map (function Needed c -> Some c | From _ | Until _ -> None) all in
  let from = Linear.constant dimension Rat.zero :: from and until = Option.to_list limit @ until in
  let in_time = List.concat_map (fun f -> List.map (Constraint.at_most f) until) from in
  match Region.split within (needed @ in_time) with
  | None, rest -> ([], rest)
  | Some meet, rest -> (greatest meet from, rest)
