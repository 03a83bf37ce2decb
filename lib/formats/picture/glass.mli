(** Which walls are drawn as glass: the near walls of a room, so that a picture shows what is inside. *)

(** A body of the picture: some solids of the view. *)
type body = {
  solids : int list;  (** their indices, at least one *)
  wall : bool;  (** it may be of glass *)
  content : bool;  (** it must be visible *)
}

val find : Camera.t -> View.solid array -> Hidden.t -> body array -> int -> bool
(** [find camera solids hidden bodies i] is true if the solid [i] is drawn as glass. [hidden] is the view of all
    [solids] without glass. Let [b] be a content of which nothing is visible. All solids of walls that hide a part
    of [b] are of glass. So are the other solids of such a wall with [b] beyond a face that is turned away from the
    camera: all near walls of a room are of glass, whichever of them hides [b]. *)
