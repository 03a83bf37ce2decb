(** Verdicts: what is known of a property, and how well (rule Verdict). *)

open Scc_exact
open Scc_calculus
open Scc_explain

(** A bound that was met. *)
type limit =
  | Depth of int
  | Time of Rat.t
  | Instant of int  (** the guard against runs that go on for ever within one instant *)
  | States of int
  | Bits of int  (** the length of a number *)
  | Seconds of float
  | Memory of int  (** words *)
  | Interrupted
  | Omission of float
  (** hash compaction: some state may have been left out unseen, with a probability of at most this *)

(** Whose bound. *)
type origin = By_default | By_user | By_property | By_system

type truncation = { limit : limit; origin : origin }

type reason =
  | Truncated of truncation  (** the exploration did not go far enough *)
  | Unevaluated of truncation  (** it was not evaluated to the end on what was explored *)
  | Unexplored of { count : int; nearest : Witness.t }
  (** so many of the states that were not expanded matter; a shortest run to one of them *)
  | Undefined of string  (** the property has no truth value somewhere: a division by zero *)
  | Fault of string  (** the transitions of a state cannot be computed *)

type t =
  | Holds of {
      bounds : truncation list;
      (** empty: exhaustively, as a proof; otherwise up to these bounds, within which nothing speaks against
          it *)
      witness : Witness.t option;
    }
  | Violated of { witness : Witness.t option  (** [None] when all of what counts was explored in vain *) }
  | Measured of {
      values : (Scc_property.Property.side * Scc_ctl.Eval.measured) list;
      reasons : reason list;  (** why they are not better known than that; empty: nothing was left out *)
      witness : Witness.t option;  (** of the last of them, a run that counts *)
    }  (** the answer to a question for numbers *)
  | Undecided of reason list  (** not empty *)

(** What a verdict is about at once: all that is not known of a model. *)
type over = {
  instants : bool;  (** all instants at which weak splits may happen *)
  ranges : Ranges.t;  (** all values of these parameters *)
  example : (string * Rat.t) list;  (** where it is violated, and no run shows it: values for which it is *)
  by_invariant : bool;
  (** it rests on a set of states that no run leaves, and not on what was explored alone (rule Invariants) *)
}

(** What a decided verdict is meant at, and says nothing about anything finer. *)
type scale = {
  resolution : Rat.t option;  (** of a rigid model: contacts are known within it *)
  split_step : Rat.t option;
  (** where the exploration saw weak splits enabled: they happen at multiples of it only, and the calculus lets
      them happen at any time (reading I-9) *)
  over : over option;  (** of explorations over zones (rule Zones) *)
}

(** Runs in which time does not go on are runs (rule Run); what rests on one of them says so. *)
type rest =
  | By of Witness.halt  (** the run that decides is such a run *)
  | Among of Witness.halt  (** no run decides by itself, and among all there are such runs *)

(** What is known of runs whose instants converge: from what they look like, or for certain (rule Run). *)
type convergence = Named of Slowing.t | Proved of Quickening.t

type outcome = {
  check : Scc_property.Property.check;
  verdict : t;
  scale : scale;
  rests : rest list;
  converges : convergence option;  (** where a bound kept it from being decided *)
  lost : string list;
  (** faults of scc, by which a run that belongs to the verdict could not be rebuilt, and is not shown *)
  left_out : truncation option;  (** what ended the making of a run that belongs to it, and is not shown *)
}

val distinct : truncation list -> truncation list
(** Each kind of limit once. *)

val together : truncation list -> truncation list -> truncation list
(** Of two explorations, likewise: the chances that a state was left out add up. *)

val by_invariant : outcome -> bool

val over_zones : outcome -> bool
(** Of all starts, or all instants of splits, at once. *)

val is_open : t -> bool
(** Undecided, or holds up to a bound. *)

val exhaustive : t -> bool
(** Holds, as a proof. *)

val conjunction : t list -> t
val disjunction : t list -> t

val truncated : t -> truncation list
(** The limits that kept it from being decided, or from being a proof. *)

val resources : t -> bool
(** A limit of the machine or an interruption (seconds, memory, Ctrl-C) has kept it from being better
    known. *)

val by_default : t -> bool
(** It holds up to a bound that nobody gave. *)

val at_most : float -> string
(** A probability, rounded up to one digit. *)

val truncation_to_string : truncation -> string
(** E.g. ["the depth bound 100 (a default)"]. *)

val reason_to_string : reason -> string

val scale_to_string : scale -> string
(** [", at resolution 1/1024, at split step 1"], or nothing. *)

val values_to_string : (string * Rat.t) list -> string
(** ["x = 3, y = 1/2"]. *)

val unshown : outcome -> string
(** Why a run that belongs to it is not shown: ["; its run could not be rebuilt: this is a fault of scc"],
    ["; its run is left out: making it ended at the interruption"], or nothing. *)

val rest_to_string : rest -> string
(** [" by a run that goes round within one instant"], [", of runs some of which end in a dead end"]. *)

val to_string : t -> string
(** ["holds (exhaustive)"], ["holds up to the bound: ..."], ["violated"], ["undecided: ..."]. *)

val outcome_to_string : outcome -> string
(** The same with what it rests on and its scale, unless it is undecided. *)

val shown : t -> Witness.t option
(** The run that shows it, or of an undecided one a run to where exploring has ended. *)

val if_unshown : t -> truncation option -> truncation option
(** What ended the making of a run, unless there is another one that is shown. *)
