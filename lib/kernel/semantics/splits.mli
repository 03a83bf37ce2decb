(** Splits of one process (rules WeakSplit and StrongSplit). The pieces keep the motion of the whole
    (readings I-11 and I-23); the split clock of each piece restarts. *)

open Scc_calculus

val weak : Semantics.t -> State.process -> Transition.outcome list
(** Rule WeakSplit: every release of one bond that may happen now, by free choice. That is when the split clock
    is at a multiple of the split step, or at any instant with [Model.Any_time] (readings I-6, I-9). *)

val lots : Semantics.t -> Lots.due -> (Transition.outcome list, Transition.fault) result
(** Rule Lot, while lots are pending: the possible decisions about the next bond, with their probabilities; or,
    once all is decided, the ways to release the bonds. Nothing else may happen meanwhile. Chances of one end
    that sum to more than 1 are a fault. *)

val decisions :
  'c Chances.t -> Model.t -> State.process -> State.bond ->
  ((State.drawn option * 'c) list, Transition.fault) result
(** [decisions n m p b] is what may come of drawing for a bond with a lot: what its ends have drawn, or [None] if
    it is kept, with the probabilities in the numbers [n]. *)

val strong : Semantics.t -> State.process -> Transition.outcome list
(** Rule StrongSplit: every reaction of a connected set of bonds (reading I-7). Each is urgent. *)

val normal_of_push : 'a list -> 'a option
(** [normal_of_push normals] is the direction in which a release pushes two parts apart, given the normals of
    their contact: the only one, if there is only one. Else it is [None], and they are pushed along the line
    between their centroids. *)
