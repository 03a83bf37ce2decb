(** Runs that belong to a verdict and are not shown. Either they cannot be made again through the rules, or
    explained: a fault of scc; or a limit of seconds or memory, or an interruption, came before they were made.
    What was in the way is kept and told, and takes nothing else from the report. *)

open Scc_semantics
open Scc_graph_search
open Scc_explain

type t
(** What was lost of one check after the other. *)

type taken = {
  faults : string list;  (** each once, in order *)
  left_out : Verdict.truncation option;  (** what ended the making of a run, the first time *)
}

val make : Bounds.t -> Limits.attempt -> t

val attempt : t -> (unit -> 'a) -> 'a option
(** What the function concludes; [None], which is kept, where it is given up, or ends with {!Limits.Over}. *)

val run : t -> Semantics.t -> (unit -> Witness.t option) -> Witness.t option
(** An attempt at the run that the function makes, from a model with these rules, once the state that it leads to
    has been made as well. If an invariant of scc is broken on the way ({!Scc_base.Bug.broken}) there is no run,
    and what was broken is kept. All other exceptions pass. *)

val taken : t -> taken
(** What was kept since the last call. *)

val nothing : taken
val together : taken -> taken -> taken
