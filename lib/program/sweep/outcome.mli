(** The result at one point of a sweep. It is plain data, which processes can exchange. *)

open Scc_exact

(** A number that a check requests, or bounds of it. *)
type number = {
  over : string;  (** ["least"] or ["greatest"] *)
  low : Rat.t option;
  high : Rat.t option;  (** [None]: unknown, or infinite *)
  infinite : bool;
}

(** An estimate from runs. Its ends are those of an interval. *)
type estimate = {
  value : Rat.t option;  (** the share of the runs, or their mean, if all of them have one *)
  from : Rat.t option;
  upto : Rat.t option;
  never : bool;  (** infinite: some run never comes to it *)
  approximate : bool;  (** [from] and [upto] are those of a normal mean, and not proved *)
  runs : int;
}

(** The result of one check. *)
type check = {
  name : string;
  verdict : string;  (** as in [scc check --json]; of an estimate, as in [scc estimate --json] *)
  numbers : number list;
  estimate : estimate option;
  reasons : string list;  (** why it is unknown, or not more precise *)
  stopped : bool;  (** true if a limit of resources stopped it ({!Scc_verify.Verdict.resources}) *)
  faults : string list;  (** faults of scc, as in {!Scc_verify.Verdict.outcome} *)
}

(** The result at a point. *)
type t =
  | Checked of { checks : check list; lattices : Scc_elaborate.Lattices.t list }
  | Refused of { code : string; message : string }  (** the model is invalid there *)

val of_outcomes : lattices:Scc_elaborate.Lattices.t list -> Scc_verify.Verdict.outcome list -> t
(** The result of a model that was checked, with the lattices of the bodies that diffuse. *)

val of_answers :
  lattices:Scc_elaborate.Lattices.t list -> stopped:bool -> Scc_estimate.Estimation.answer list -> t
(** The result of a model whose checks were estimated. [stopped] is true if a limit of seconds ended that. *)

val of_diagnostics : Scc_base.Diag.t list -> t
(** The result of an invalid model: its first diagnostic. An empty list is a bug. *)

val checks : t -> check list
(** The results of the checks; none if the model is invalid. *)

val lattices : t -> Scc_elaborate.Lattices.t list
(** The lattices of the bodies that diffuse; none if the model is invalid. *)

val faults : t -> string list
(** The faults of scc in all checks. *)

val is_stopped : t -> bool
(** [is_stopped t] is true if a limit of resources keeps a check from being decided or known more precisely. *)

val is_known : t -> bool
(** [is_known t] is true if all checks are decided, and no default bound cut one of them short. *)
