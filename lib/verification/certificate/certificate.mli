(** The independent check of an invariant (rule Invariants): no run leaves the set of states, and no state in
    it satisfies a predicate that should never hold. The set is cut along every plane that could matter. The
    ordinary rules ({!Scc_semantics.Network}) are then applied to single states, at as many points of each
    piece as determine the whole piece. The rest is linear arithmetic. The code of the search for invariants is
    not used. *)

open Scc_calculus
open Scc_semantics

val not_for : Model.t -> string option
(** A reason, for readers, why invariants of this model cannot be checked; [None] if they can. *)

val check :
  Semantics.t -> Uncertain.t -> declared:State.t -> Invariant.t -> Invariant.claim list -> stop:(unit -> bool) ->
  (unit, string) result
(** [Ok ()] if the invariant and all claims are proved. The error is a reason for readers: a condition that
    does not hold, or that cannot be decided in this way. [stop] is called regularly; if it returns true, that
    is also an error. *)
