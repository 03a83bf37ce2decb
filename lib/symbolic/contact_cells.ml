open Scc_exact
open Scc_geometry
open Scc_polyhedra

type hit = { region : Polyhedron.t; time : Linear.t; tight : int list }
type t = { hits : hit list; misses : Polyhedron.t list; inside : Polyhedron.t list }

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

let where region constraints =
  let p = Polyhedron.add_all region constraints in
  if Polyhedron.is_empty p then [] else [ p ]

(* The last of the planes that are entered, and who is entered last: a region for each answer. *)
let entered_last within entered =
  let enter cells f =
    let time = crossing f in
    let one { region; time = last; tight } =
      let on c time tight = List.map (fun region -> { region; time; tight }) (where region [ c ]) in
      on (Constraint.less time last) last tight
      @ on (Constraint.equals time last) last (f.index :: tight)
      @ on (Constraint.greater time last) time [ f.index ]
    in
    List.concat_map one cells
  in
  match entered with
  | [] -> []
  | f :: rest -> List.fold_left enter [ { region = within; time = crossing f; tight = [ f.index ] } ] rest

(* What is left of a region where all of the constraints hold, and disjoint pieces for the rest of it. *)
let split region constraints =
  let step (left, rest) c =
    match left with
    | [] -> ([], rest)
    | p :: _ -> (where p [ c ], rest @ List.concat_map (fun n -> where p [ n ]) (Constraint.negation c))
  in
  List.fold_left step ([ region ], []) constraints

let make o ~offset ~velocity within =
  let x, _, _ = offset in
  let zero = Linear.constant (Linear.dimension x) Rat.zero in
  let facets = Array.to_list (Array.mapi (facet offset velocity) (Obstacle.facets o)) in
  let by_sign s = List.filter (fun f -> Rat.sign f.speed = s) facets in
  let parallel = List.map (fun f -> Constraint.greater f.room zero) (by_sign 0) in
  let left = by_sign 1 in
  let collide { region; time; tight } =
    (* Through the interior, if they are before the first plane that is left. *)
    let through = parallel @ List.map (fun f -> Constraint.less time (crossing f)) left in
    let meet, misses = split region through in
    let of_meeting region =
      let to_come, past = split region [ Constraint.at_least time zero ] in
      let still_in = List.map (fun f -> Constraint.greater (crossing f) zero) left in
      let now = List.map (fun p -> split p still_in) past in
      {
        hits = List.map (fun region -> { region; time; tight = List.sort Int.compare tight }) to_come;
        inside = List.concat_map fst now;
        misses = List.concat_map snd now;
      }
    in
    { hits = []; inside = []; misses } :: List.map of_meeting meet
  in
  let found =
    if Polyhedron.is_empty within then []
    else if Vec.is_zero velocity then
      let inside, misses = split within parallel in
      [ { hits = []; inside; misses } ]
    else List.concat_map collide (entered_last within (by_sign (-1)))
  in
  {
    hits = List.concat_map (fun c -> c.hits) found;
    misses = List.concat_map (fun c -> c.misses) found;
    inside = List.concat_map (fun c -> c.inside) found;
  }
