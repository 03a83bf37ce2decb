(** Runs of a slice as runs of the whole network (see {!Slice}). *)

open Scc_calculus
open Scc_semantics

val timed : Semantics.t -> initial:State.t -> Witness.t -> Witness.t
(** [timed m ~initial w], for a witness [w] of a slice of the state [initial] that ends [At_state] or [During] a
    time transition, at an instant up to the horizon of the slice: the same discrete transitions at the same
    times, and the same instant at the end. The processes that were left out make their urgent transitions, the
    first one of the instant, when time could not pass otherwise, and never a weak split; time stops wherever
    the whole network stops. Facts and argument stay. When the interval at the end (see {!Witness.finish})
    begins before the last state, the sample is shown as the instant itself. It is a bug if this cannot be done.
*)
