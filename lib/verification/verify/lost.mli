(** Runs of a verdict that cannot be made again through the rules, or explained. That is a fault of scc. It is
    recorded and reported; the rest of the report is unaffected. *)

open Scc_semantics
open Scc_explain

type t
(** A mutable list of the faults of one check after the other. *)

val make : unit -> t
(** A new, empty list. *)

val run : t -> Semantics.t -> (unit -> Witness.t option) -> Witness.t option
(** [run t m f] is the run [f ()], from a model with the rules [m], once the state at its end has been computed
    as well. If an invariant of scc is broken on the way ({!Scc_base.Bug.broken}), the result is [None], and
    the fault is recorded. All other exceptions pass. *)

val taken : t -> string list
(** The faults recorded since the last call, each once, in order. *)
