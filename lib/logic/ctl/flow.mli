(** "f until g" along one flow; f and g are given strictly inside the flow. At a position g alone suffices. To
    enter an open interval on which g holds, f must hold there as well, since the interval has no first instant. *)

open Scc_exact

(** The first event as time passes along the flow. *)
type first =
  | Reached of Timeline.moment  (** g holds, and f held at all times before *)
  | Lost of Timeline.moment  (** f fails from this moment on, and g did not hold before *)
  | Passes  (** neither, to the end of the flow *)

val entering : f:Pieces.t -> g:Pieces.t -> first
(** [entering ~f ~g] is the first event after the start of the flow. *)

val from : f:Pieces.t -> g:Pieces.t -> Algebraic.t -> first
(** [from ~f ~g offset] is the first event from a positive offset on; it may be at that offset itself. *)

val inside : f:Pieces.t -> g:Pieces.t -> bool -> Pieces.t
(** [inside ~f ~g ending] is the offsets at which f until g holds, if at the end of the flow its truth is [ending].
*)

val within :
  bound:Rat.t ->
  limit:Algebraic.t option ->
  f:Pieces.t ->
  g:Pieces.t ->
  Timeline.moment option ->
  Pieces.t
(** [within ~bound ~limit ~f ~g arrival] is the offsets from which g comes within [bound] through f. The flow ends
    at [limit], or lasts for ever for [None]. [arrival] is the moment of g after the end, counted from the start of
    the flow; [None] if g does not come. *)
