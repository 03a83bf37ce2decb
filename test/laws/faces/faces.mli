(** Models whose parameters have ranges, held against their own points where the two are most likely to differ: on
    faces of the ranges, where delays are 0, arrivals tie, offsets only touch and parameters coincide. *)

type case = {
  text : string;  (** a model *)
  any : bool;  (** of which bonds may be released at any time: runs of its points, on a grid, are some of all *)
  bounds : Scc_verify.Setup.t;  (** of the exploration over sets, which may end it before all is known *)
}

val generate : Random.State.t -> case
(** A model that may have faults, such as bodies that overlap for some values. *)

type counts = {
  mutable refused : int;  (** models with faults, which their points have as well *)
  mutable models : int;
  mutable points : int;  (** pairs of a check and a point of which both verdicts are known *)
  mutable faces : int;  (** those on a piece of a set that has no volume, or on an end of a range *)
  mutable unknown : int;
  mutable partial : int;  (** points of formulas that no search decides, where not all was explored *)
}

val counts : unit -> counts

val differences : counts -> Random.State.t -> case -> string list
(** What sets and points do not agree in; a [Bug] is a difference, too. *)
