(** Runs that belong to a verdict and cannot be made again through the rules, or explained: a fault of scc,
    which is kept and told, and takes nothing else from the report. *)

open Scc_semantics
open Scc_explain

type t
(** What was lost of one check after the other. *)

val make : unit -> t

val run : t -> Semantics.t -> (unit -> Witness.t option) -> Witness.t option
(** The run that the function makes, from a model with these rules, once the state that it leads to has been
    made as well. If an invariant of scc is broken on the way ({!Scc_base.Bug.broken}) there is no run, and what
    was broken is kept. All other exceptions pass. *)

val taken : t -> string list
(** What was kept since the last call, each once, in order. *)
