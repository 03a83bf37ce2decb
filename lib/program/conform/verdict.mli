(** The verdict on a recorded trace: whether the semantics of a model allows it. *)

open Scc_base
open Scc_exact
open Scc_calculus
open Scc_semantics

(** The verdict. *)
type answer =
  | Conforms of {
      choices : (int * string) list;  (** numbers and labels of the transitions of a run that it records *)
      ended : Rat.t;  (** the time of the last transition of that run *)
      deviation : Against.deviation;
      widest : int;  (** the greatest number of states that were possible at once *)
    }
  | Diverges of Divergence.t
  | Undecided of { reason : Trace_search.reason; items : int  (** the number of items that were met *) }

val tolerance : Model.t -> Recorded.t -> Rat.t option -> (Rat.t, Diag.t list) result
(** The tolerance of a comparison: the given one, or 0. A trace with floats needs one (SC0804); for a rigid
    model it is 0 or at least the resolution, within which contact times are known. *)

val check :
  Semantics.t ->
  State.t ->
  Recorded.t ->
  tolerance:Rat.t ->
  observed:(string -> bool) ->
  Trace_search.limits ->
  (answer, [ `Invalid of Diag.t list | `Fault of Transition.fault ]) result
(** Compares a trace with the model from its declared state. [`Invalid] lists the names that the model does not
    have. [observed] is true for the texts of the labels that must be recorded. *)
