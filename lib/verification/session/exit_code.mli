(** The exit codes, the same for every command, and what leads to which. *)

open Scc_semantics
open Scc_verify

type t =
  | Holds  (** 0: all is well *)
  | Violated  (** 1: some property is violated *)
  | Undecided  (** 2: something is undecided, a default bound that truncates included *)
  | Invalid  (** 3: the model or another input is invalid *)
  | Stopped  (** 4: a resource limit or an interruption *)
  | Usage  (** 64: the command line is wrong *)
  | Bug  (** 70: a fault of scc itself *)
  | Unwritten  (** 74: an output could not be written *)

val all : t list
(** In the order of their numbers. *)

val to_int : t -> int
val equal : t -> t -> bool

val meaning : t -> string
(** When a command ends with it, unless it says otherwise: ["if …"]. *)

val worst : t list -> t
(** The code of a run in which several apply: a bug, a wrong command line or an invalid input first, then
    1, 4, 2 and 0. *)

val of_bounds : Verdict.truncation list -> t
(** Of something that is known up to these bounds: a limit of resources stopped it, a default bound leaves it
    undecided, and other bounds are what was asked for. *)

val of_verdict : Verdict.t -> t

val of_exploration : complete:bool -> faults:Scc_base.Diag.t list -> stopped_by:Verdict.truncation list -> t
(** What an exploration alone tells. *)

val of_fault : Transition.fault -> t
(** Of a run that went on until its transitions could not be computed. *)
