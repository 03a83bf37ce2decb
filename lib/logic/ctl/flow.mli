(** "f until g" along one flow, of which f and g are given strictly inside. A position satisfies g by itself,
    but to go into an open interval on which g holds takes f there as well, since the interval has no first
    instant. *)

open Scc_exact

(** What happens first to who leaves the node and lets time pass. *)
type first =
  | Reached of Timeline.moment  (** g, and f all the time before *)
  | Lost of Timeline.moment  (** f fails, before there was g: the moment since when *)
  | Passes  (** neither, to the end of the flow *)

val entering : f:Pieces.t -> g:Pieces.t -> first

val from : f:Pieces.t -> g:Pieces.t -> Algebraic.t -> first
(** The same for who is at a positive offset already; [Reached] and [Lost] may be there and then. *)

val inside : f:Pieces.t -> g:Pieces.t -> bool -> Pieces.t
(** Where inside the flow f until g holds, when it is known whether it does at the end. *)

val within :
  bound:Rat.t ->
  limit:Algebraic.t option ->
  f:Pieces.t ->
  g:Pieces.t ->
  Timeline.moment option ->
  Pieces.t
(** Where inside a flow that ends at the limit g comes within the bound, when the moment (counted from the start
    of the flow) is that of g after the end. *)
