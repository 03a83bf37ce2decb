open Scc_exact
open Scc_geometry
open Scc_polyhedra

type hit = { region : Polyhedron.t; time : Linear.t; tight : int list }

(* A facet as an offset that depends on what is not known sees it. *)
type facet = {
  index : int;
  room : Linear.t;  (** {!Facet_forms.room} *)
  speed : Rat.t;  (** normal . velocity *)
}

let facet offset velocity index (f : Obstacle.facet) =
  { index; room = Facet_forms.room offset f; speed = Vec.dot (Ivec.to_vec f.normal) velocity }

(* When its plane is crossed. *)
let crossing f = Linear.scale (Rat.div Rat.one f.speed) f.room

(* The last of the planes that are entered, and who is entered last: a region for each answer. *)
let entered_last within entered =
  let enter cells f =
    let time = crossing f in
    let one { region; time = last; tight } =
      let on c time tight = List.map (fun region -> { region; time; tight }) (Region.where region [ c ]) in
      on (Constraint.less time last) last tight
      @ on (Constraint.equals time last) last (f.index :: tight)
      @ on (Constraint.greater time last) time [ f.index ]
    in
    List.concat_map one cells
  in
  match entered with
  | [] -> []
  | f :: rest -> List.fold_left enter [ { region = within; time = crossing f; tight = [ f.index ] } ] rest

(* The planes that are entered, left, and gone along. *)
let by_signs o offset velocity =
  let facets = Array.to_list (Array.mapi (facet offset velocity) (Obstacle.facets o)) in
  let by_sign s = List.filter (fun f -> Rat.sign f.speed = s) facets in
  (by_sign (-1), by_sign 1, by_sign 0)

let make o ~offset ~velocity ~limit within =
  let x, _, _ = offset in
  let zero = Linear.constant (Linear.dimension x) Rat.zero in
  let entered, left, parallel = by_signs o offset velocity in
  let in_time f = match limit with None -> [] | Some t -> [ Constraint.at_most (crossing f) t ] in
  let before f g = Constraint.less (crossing f) (crossing g) in
  let conditions =
    List.map (fun f -> Constraint.greater f.room zero) parallel
    @ List.concat_map in_time entered
    (* in the future, as they do not interpenetrate now *)
    @ List.map (fun g -> Constraint.greater (crossing g) zero) left
    @ List.concat_map (fun f -> List.map (before f) left) entered
  in
  match if Vec.is_zero velocity then (None, [ within ]) else Region.split within conditions with
  | None, rest -> ([], rest)
  | Some meet, rest ->
    let hit { region; time; tight } = { region; time; tight = List.sort Int.compare tight } in
    (List.map hit (entered_last meet entered), rest)
