open Scc_exact
open Scc_geometry
open Scc_polyhedra

type t = { index : int; room : Linear.t; speed : Rat.t }

(* {1 Making} *)

let room (x, y, z) (f : Obstacle.facet) =
  let n = Ivec.to_vec f.normal in
  let less rest (a, form) = if Rat.sign a = 0 then rest else Linear.sub rest (Linear.scale a form) in
  let plane = Linear.constant (Linear.dimension x) (Rat.make f.num f.den) in
  List.fold_left less plane [ (n.x, x); (n.y, y); (n.z, z) ]

let of_facets o offset ~speed =
  let of_facet index (f : Obstacle.facet) = { index; room = room offset f; speed = speed f.normal } in
  Array.to_list (Array.mapi of_facet (Obstacle.facets o))

let still o offset = of_facets o offset ~speed:(fun _ -> Rat.zero)
let moving o offset velocity = of_facets o offset ~speed:(fun normal -> Vec.dot (Ivec.to_vec normal) velocity)

let of_closed set offset (velocity : Vec.t) =
  let x, y, z = offset in
  let dimension = Linear.dimension x in
  let half index c =
    let beyond = Constraint.to_form c in
    let speed = Linear.eval beyond [| velocity.x; velocity.y; velocity.z |] in
    {
      index;
      room = Linear.neg (Linear.compose beyond ~dimension [| x; y; z |]);
      speed = Rat.sub speed beyond.constant;
    }
  in
  List.mapi half (List.concat_map Constraint.halves (Polyhedron.constraints set))

(* {1 Conditions at one instant} *)

let zero h = Linear.constant (Linear.dimension h.room) Rat.zero

let needs (need : Side.need) h =
  match need with
  | Positive -> Constraint.greater h.room (zero h)
  | Not_negative -> Constraint.at_least h.room (zero h)

let on_border h = Constraint.equals h.room (zero h)
let contact = List.map (needs Side.contact)
let overlap = List.map (needs Side.overlap)
let collision = List.map (fun h -> needs (Side.collision ~speed:(Rat.sign h.speed)) h)

(* {1 Time} *)

let after time h = { h with room = Linear.sub h.room (Linear.scale h.speed time) }
let crossing h = Linear.scale (Rat.div Rat.one h.speed) h.room

type passage = { entered : t list; left : t list; along : t list }

let passage all =
  let kind times = List.filter (fun h -> Side.times ~speed:(Rat.sign h.speed) = times) all in
  { entered = kind From; left = kind Until; along = kind Always_or_never }

let first_collision { entered; left; along } ~limit =
  let in_time f = match limit with None -> [] | Some t -> [ Constraint.at_most (crossing f) t ] in
  let before f g = Constraint.less (crossing f) (crossing g) in
  let conditions =
    overlap along
    @ List.concat_map in_time entered
    (* in the future, as they do not interpenetrate now *)
    @ List.map (fun g -> Constraint.greater (crossing g) (zero g)) left
    @ List.concat_map (fun f -> List.map (before f) left) entered
  in
  (List.map crossing entered, conditions)

let first_meeting { entered; left; along } ~now ~limit =
  let from = now :: List.map crossing entered and until = Option.to_list limit @ List.map crossing left in
  (from, contact along @ List.concat_map (fun f -> List.map (Constraint.at_most f) until) from)
