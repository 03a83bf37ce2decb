(** What is said of an exploration that met a bound, besides its verdicts. *)

type t = {
  slow : Verdict.convergence option;  (** runs whose instants converge *)
  likely : Growth.cause list;  (** likely causes why it did not close *)
  long : Scc_base.Diag.t option;  (** a number that is too long *)
  ended : Verdict.truncation option;  (** the bound that ended the search for these *)
}

val none : t
(** Nothing is said. *)

val find : Unsettled.t -> Bounds.cause list -> t
(** [find r met] is what is said of the exploration of [r], which met these bounds; {!none} if it met none. *)
