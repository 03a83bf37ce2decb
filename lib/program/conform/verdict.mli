(** Whether the semantics of a model allows a recorded trace. *)

open Scc_base
open Scc_exact
open Scc_calculus
open Scc_semantics

type answer =
  | Conforms of {
      choices : (int * string) list;  (** numbers and labels of a run that it is of *)
      ended : Rat.t;  (** the time of the last transition of that run *)
      deviation : Against.deviation;
      widest : int;  (** states that it could be in at once, at most *)
    }
  | Diverges of Divergence.t
  | Undecided of { reason : Search.reason; items : int  (** that were met *) }

val tolerance : Model.t -> Recorded.t -> Rat.t option -> (Rat.t, Diag.t list) result
(** The tolerance that is asked for; 0 when none is, unless the trace has floats (SC0804). Floats of a rigid model
    take one that is not less than its resolution, within which its contact times are known. *)

val check :
  Semantics.t ->
  State.t ->
  Recorded.t ->
  tolerance:Rat.t ->
  observed:(string -> bool) ->
  Search.limits ->
  (answer, [ `Invalid of Diag.t list | `Fault of Transition.fault ]) result
(** For the declared state. Invalid when the trace names what the model does not have. *)
