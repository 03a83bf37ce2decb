(** What is known at one point of a sweep. Plain data, for other processes. *)

open Scc_exact

type number = {
  over : string;  (** ["least"] or ["greatest"] *)
  low : Rat.t option;
  high : Rat.t option;  (** none: not known, or infinite *)
  infinite : bool;
}

type check = {
  name : string;
  verdict : string;  (** as in [scc check --json] *)
  numbers : number list;
  reasons : string list;  (** why it is not known, or not better *)
  stopped : bool;  (** by a limit of resources, as {!Scc_verify.Verdict.resources} *)
  faults : string list;  (** of scc, as {!Scc_verify.Verdict.outcome} *)
}

type t =
  | Checked of check list
  | Refused of { code : string; message : string }  (** the model is invalid there *)

val of_outcomes : Scc_verify.Verdict.outcome list -> t
val of_diagnostics : Scc_base.Diag.t list -> t

val faults : t -> string list
(** Of all checks. *)

val is_stopped : t -> bool
(** A limit of resources keeps something from being better known. *)

val is_known : t -> bool
(** All is decided, without a default bound that cut it short. *)
