open Scc_exact
open Scc_geometry
open Scc_calculus

type neighbours = {
  within : Rat.t -> Part.t array -> (Part.t * Part.t) list;
  along : Rat.t -> Part.t array -> (Part.t * Part.t) list;
  earliest :
    margin:Rat.t -> limit:Rat.t option ->
    (before:Rat.t option -> Part.t -> Part.t -> Rat.t option) -> Part.t array -> Rat.t option;
}

let pairs parts =
  let parts = Array.to_list parts in
  let with_later (a : Part.t) (b : Part.t) = if a.process < b.process then Some (a, b) else None in
  List.concat_map (fun a -> List.filter_map (with_later a) parts) parts

let everyone =
  let earlier time best (a, b) =
    if Part.in_relative_motion a b then Option.merge Rat.min best (time ~before:best a b) else best
  in
  {
    within = (fun _ parts -> pairs parts);
    along = (fun _ parts -> pairs parts);
    earliest =
      (fun ~margin:_ ~limit time parts ->
         match (List.fold_left (earlier time) None (pairs parts), limit) with
         | Some t, Some l when Rat.compare t l > 0 -> None
         | t, _ -> t);
  }

type shares = ((Given.t * Rat.t) list, Law.fault) result
type laws = int -> Law.t -> (unit -> shares) -> shares

let ask_again _ _ ask = ask ()

type setting = { model : Model.t; geometry : Geometry.t; neighbours : neighbours; laws : laws }
type contact = Apart | Touching | Colliding
type meeting = { first : int; second : int; collide : bool; touching : (Part.t * Part.t) list }

module type S = sig
  val parts : setting -> int -> State.process -> Part.t list
  val margin : setting -> Rat.t
  val contact : setting -> Part.t -> Part.t -> contact
  val touching : setting -> Part.t -> Part.t -> Contact.pair list
  val near : setting -> Part.t -> Part.t -> Scc_rigid.Near_contact.t option
  val bonded : setting -> Part.t * Feature.t -> Part.t * Feature.t -> bool
  val first_time_of_contact : setting -> Part.t array -> limit:Rat.t option -> Rat.t option
  val none_ahead : setting -> Part.t array -> bool
  val bounce : setting -> State.process array -> meeting list -> State.process array option
  val joined : setting -> State.process -> State.process -> State.process -> State.process
  val piece : setting -> whole:State.process -> State.process -> State.process
  val pushed : setting -> at:Vec.t -> Vec.t -> State.process -> State.process
  val start : setting -> State.process -> State.process
  val time_rules : Rule.t list
  val renewed : setting -> State.process -> State.process
  val at_contact : setting -> colliding:(State.t -> (int * int) list) -> State.t -> State.t

  val begin_turns :
    setting ->
    parts:(State.t -> Part.t array) ->
    colliding:(State.t -> (int * int) list) ->
    State.t -> State.t * State.t option
  val turns_rightly : setting -> State.process -> bool
  val settled : setting -> State.process -> bool
end
