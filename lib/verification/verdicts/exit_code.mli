(** The exit codes, the same for every command, and the results that lead to them. *)

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
(** All exit codes, in the order of their numbers. *)

val to_int : t -> int
(** The number that the process returns, as listed at the constructors. *)

val equal : t -> t -> bool
(** [equal a b] is true if both are one code. *)

val meaning : t -> string
(** The condition under which a command ends with the code, unless its manual says otherwise: ["if …"]. *)

val worst : t list -> t
(** The code of a run in which several apply: the first of 70, 74, 64, 3, 1, 4 and 2 that applies, else 0. *)

val of_bounds : Verdict.truncation list -> t
(** The code of a result that is known up to these bounds. A limit of resources gives [Stopped], a default
    bound [Undecided]. Bounds that the user gave leave [Holds]. *)

val of_verdict : Verdict.t -> t
(** The code of a verdict. A question for numbers gives [Holds] if its answer has no reasons for doubt.
    Other answers and undecided verdicts give [Stopped] if a limit of resources is among their reasons, else
    [Undecided]. A verdict that holds up to bounds gives {!of_bounds}. *)

val of_exploration : complete:bool -> faults:Scc_base.Diag.t list -> stopped_by:Verdict.truncation list -> t
(** The code of an exploration without properties: [Holds] if it is complete, [Undecided] if it has faults,
    else {!of_bounds}. *)

val of_fault : Transition.fault -> t
(** The code of a single run that ended because its transitions could not be computed. *)
