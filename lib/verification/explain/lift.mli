(** Runs of a slice as runs of the whole network (see {!Scc_state_space.Slice}). *)

open Scc_calculus
open Scc_semantics

val timed : Semantics.t -> initial:State.t -> Witness.t -> Witness.t
(** [timed m ~initial w] is the run of the whole network for a witness [w] of a slice of the state [initial].
    The witness ends [At_state] or [During] a time transition, at an instant up to the horizon of the slice.
    The lifted run has the same discrete transitions at the same times, and the same instant at the end.

    The processes outside of the slice make their urgent transitions when time could not pass otherwise: always
    the first one of the instant. They never make a weak split. Time stops wherever the whole network stops.
    Facts and argument are those of [w]. If the interval at the end (see {!Witness.type-finish}) begins before the
    last state, the sample is shown as the instant itself. It is a bug if this cannot be done. *)
