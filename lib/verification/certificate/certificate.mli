(** Whether a set of states is one that no run leaves, and has nothing in it that should never come (rule
    Invariants): checked by cutting it along every plane that could matter, asking the ordinary rules
    ({!Scc_semantics.Network}) for single states, in as many points of each piece as it takes to know all of it,
    and by linear arithmetic. The search that found it has no part in this. *)

open Scc_calculus
open Scc_semantics
open Scc_symbolic

val not_for : Model.t -> string option
(** Why invariants of this model cannot be checked, for a person. *)

val check :
  Semantics.t -> Uncertain.t -> declared:State.t -> Invariant.t -> Proof.claim list -> stop:(unit -> bool) ->
  (unit, string) result
(** The error: what does not hold, or cannot be seen this way, for a person. [stop] is asked now and then: so is an
    answer that it did not wait for. *)
