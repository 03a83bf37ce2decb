(** Verdicts: the knowledge of a property, and its certainty (rule Verdict). *)

open Scc_exact
open Scc_calculus
open Scc_explain

(** A bound that was met. *)
type limit =
  | Depth of int
  | Time of Rat.t
  | Instant of int  (** the guard against runs that go on for ever within one instant *)
  | States of int
  | Draws of { states : int; bodies : int }
  (** a bound of states that draws of so many bodies at one instant exceed: it was known before it was met *)
  | Bits of int  (** the length of a number *)
  | Seconds of float
  | Memory of int  (** words *)
  | Interrupted
  | Omission of float
  (** hash compaction: some state may have been left out unseen, with a probability of at most this *)

(** The origin of a bound. Of seconds with the origin [By_share] other checks had the rest. *)
type origin = By_default | By_user | By_share | By_property | By_system

type truncation = { limit : limit; origin : origin }

type reason =
  | Truncated of truncation  (** the exploration did not go far enough *)
  | Unevaluated of truncation  (** it was not evaluated to the end on what was explored *)
  | Unexplored of { count : int; nearest : Witness.t }
  (** the number of unexpanded states that matter, and a shortest run to one of them *)
  | Undefined of string  (** the property has no truth value somewhere: a division by zero *)
  | Fault of string  (** the transitions of a state cannot be computed *)

(** Why a number is an interval, though nothing was left out. *)
type inexact =
  | Cut of truncation  (** a part of the seconds was over before its fraction was found *)
  | Too_long  (** numbers of the fraction have more bits than are worked with *)
  | Too_much  (** the fraction takes more work than is done for it *)

(** The answer from one end T of the bound of time on. *)
type point = {
  moment : Scc_ctl.Timeline.moment;  (** T; if it is not attained, the answer counts for all T shortly after it *)
  answer : (Scc_property.Property.side * Scc_ctl.Eval.measured) list;  (** as [values] of a verdict *)
}

(** An answer that depends on a parameter of chances: on its open range (rule Parametric). *)
type dependence = {
  parameter : Ranges.range;
  values : Depending.values;
  (** the probability or the mean; of a claim, the one that it tests, if it is a single test *)
  holds : Scc_chance.Dependence.set option;  (** of a claim: where it holds *)
}

type t =
  | Holds of {
      bounds : truncation list;
      (** empty: exhaustively, as a proof; otherwise up to these bounds, within which nothing refutes
          it *)
      witness : Witness.t option;
    }
  | Violated of { witness : Witness.t option  (** [None] if the property fails because an exhaustive search
                                                  found nothing *) }
  | Measured of {
      values : (Scc_property.Property.side * Scc_ctl.Eval.measured) list;
      reasons : reason list;  (** the reasons why they are not known better; empty: nothing was left out *)
      inexact : inexact option;  (** why they are no fractions, where no reasons are given *)
      witness : Witness.t option;  (** of the last of them, a run that counts *)
      curve : point list;  (** how it depends on the end of the bound of time, where that was asked for *)
      starts : (Scc_property.Property.side * Scc_regions.Chances.t) list;
      (** of explorations over zones: how it depends on the start. [values] are then bounds for all starts. *)
    }  (** the answer to a question for numbers *)
  | Depends of dependence
  | Undecided of reason list  (** not empty *)

(** The range of a verdict over zones: all that a model leaves open. *)
type over = {
  instants : bool;  (** all instants at which weak splits may happen *)
  ranges : Ranges.t;  (** all values of these parameters *)
  example : (string * Rat.t) list;  (** if it is violated, and no run shows it: values for which it is
                                        violated *)
  everywhere : bool;  (** if it is violated: it is so for all values of the parameters *)
  by_invariant : bool;
  (** it rests on a set of states that no run leaves, and not on exploration alone (rule Invariants) *)
}

(** The scale of a decided verdict, which says nothing about anything finer. *)
type scale = {
  resolution : Rat.t option;  (** of a rigid model: contacts are known within it *)
  split_step : Rat.t option;
  (** if the exploration saw weak splits enabled: they happen only at multiples of it. In the calculus they
      happen at any time (reading I-9). *)
  over : over option;  (** of explorations over zones (rule Zones) *)
}

(** Runs in which time does not go on are runs (rule Run). A verdict that rests on one of them says so. *)
type rest =
  | By of Witness.halt  (** the run that decides is such a run *)
  | Among of Witness.halt  (** no run decides by itself, and among all there are such runs *)

(** The knowledge of runs whose instants converge: by their appearance, or for certain (rule Run). *)
type convergence = Named of Slowing.t | Proved of Quickening.t

type outcome = {
  check : Scc_property.Property.check;
  verdict : t;
  scale : scale;
  rests : rest list;
  converges : convergence option;  (** if a bound prevented a decision *)
  lost : string list;
  (** faults of scc, by which a run that belongs to the verdict could not be rebuilt, and is not shown *)
  left_out : truncation option;  (** the bound that ended making a run of the verdict, which is not shown *)
}

val distinct : truncation list -> truncation list
(** The truncations with each kind of limit once: the first of it. *)

val together : truncation list -> truncation list -> truncation list
(** The truncations of two explorations, each kind of limit once. Probabilities that a state was omitted add
    up, to 1 at most. *)

val by_invariant : outcome -> bool
(** [by_invariant o] is true if the verdict rests on an invariant (rule Invariants). *)

val over_zones : outcome -> bool
(** [over_zones o] is true if the verdict is about all starts, or all instants of splits, at once. *)

val is_open : t -> bool
(** [is_open v] is true if [v] is undecided, or holds only up to a bound. *)

val exhaustive : t -> bool
(** [exhaustive v] is true if [v] holds without bounds, as a proof. *)

val everywhere : dependence -> bool option
(** [everywhere d] is true if a claim holds for all values of the parameter, and false if it fails for some;
    [None] for a number. *)

val conjunction : t list -> t
(** The verdict for the conjunction: violated if one is, else undecided if one is, else it holds within all
    bounds. A measured value is a bug. The conjunction of none holds. *)

val disjunction : t list -> t
(** The verdict for the disjunction: the best of them. It holds if one does, else it is undecided if one is,
    else violated. A measured value is a bug. The disjunction of none is violated. *)

val truncated : t -> truncation list
(** The limits that prevented a decision or a proof. *)

val had_share : t -> bool
(** [had_share v] is true if a share of the seconds ended the work on [v], so that more of them might decide it. *)

val resources : t -> bool
(** [resources v] is true if a limit of the machine or an interruption (seconds, memory, Ctrl-C) is among
    {!truncated}. *)

val by_default : t -> bool
(** [by_default v] is true if [v] holds up to a default bound. *)

val at_most : float -> string
(** A probability as text, rounded up to one digit. *)

val truncation_to_string : truncation -> string
(** A truncation as ["the depth bound 100 (a default)"]. *)

val reason_to_string : reason -> string
(** A reason as a clause: ["3 unexplored states matter"]. *)

val scale_to_string : scale -> string
(** A scale as [", at resolution 1/1024, at split step 1"], or the empty text. *)

val values_to_string : (string * Rat.t) list -> string
(** Values of parameters as ["x = 3, y = 1/2"]. *)

val unshown : outcome -> string
(** Why a run of the outcome is not shown, as a clause: ["; its run could not be rebuilt: this is a fault of scc"],
    ["; its run is left out: making it ended at the interruption"], or the empty
    text. *)

val inexact_to_string : inexact -> string
(** Why a number is an interval, as a clause, and what may be done about it. *)

val inexact : t -> string option
(** [inexact v] is the reason why a measured number is an interval, in words; [None] for fractions, and where
    [reasons] says it. *)

val rest_to_string : rest -> string
(** A rest as [" by a run that goes round within one instant"] or [", of runs some of which end in a dead
    end"]. *)

val to_string : t -> string
(** A verdict as ["holds (exhaustive)"], ["holds up to the bound: ..."], ["violated"] or ["undecided: ..."]. *)

val asks_number : Scc_property.Property.check -> bool
(** [asks_number c] is true if [c] asks how likely something is, or for a mean ([= ?]): no values of the parameters
    are those for which it holds. *)

val outcome_to_string : outcome -> string
(** The verdict of an outcome as a text, with the runs it rests on and its scale, unless it is undecided.
    Convergence and lost runs are always added. *)

val shown : t -> Witness.t option
(** The run that shows a verdict. For an undecided one it is a run to an unexplored state. *)

val if_unshown : t -> truncation option -> truncation option
(** [if_unshown v bound] is [bound], which ended making a run, unless [v] shows another run. *)
