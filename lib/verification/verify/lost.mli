(** Runs of a verdict that are missing from a report. Either they cannot be made again through the rules, or
    explained: a fault of scc. Or a limit of seconds or memory, or an interruption, ended making them. The cause is
    recorded and reported; the rest of the report is unaffected. *)

open Scc_semantics
open Scc_graph_search
open Scc_explain

type t
(** A mutable list of such causes, for one check after the other. *)

(** Why runs are missing. *)
type taken = {
  faults : string list;  (** each once, in order *)
  left_out : Verdict.truncation option;  (** the first bound that ended making a run *)
}

val make : Bounds.t -> Limits.attempt -> t
(** An empty list for checks under these bounds, whose runs are made by these attempts. *)

val attempt : t -> (unit -> 'a) -> 'a option
(** [attempt t f] is the result of [f], or [None] if it is given up or ends with [Limits.Over]; that is recorded.
*)

val run : t -> Semantics.t -> (unit -> Witness.t option) -> Witness.t option
(** [run t m f] attempts the run [f ()], from a model with the rules [m], and the state at its end. If an invariant
    of scc is broken on the way ({!Scc_base.Bug.broken}), the result is [None], and the fault is recorded. All
    other exceptions pass. *)

val stopped : t -> Limits.stop -> Verdict.truncation
(** The bound that ended an attempt. *)

val taken : t -> taken
(** The causes recorded since the last call. *)

val nothing : taken
(** No causes. *)

val together : taken -> taken -> taken
(** The causes of two checks: the faults of both, in order, and the first bound. *)
