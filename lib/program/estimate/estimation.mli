(** Properties judged by samples: how many runs are needed, and their results. No answer is a proof. *)

open Scc_exact

(** The number of runs. *)
type size =
  | Exactly of int  (** so many runs, no less and no more *)
  | At_most of int  (** as many as are needed for the width, or to decide *)

(** The precision that is required. *)
type aim = {
  confidence : Rat.t;  (** of each answer: less than 1 *)
  width : Rat.t;  (** of the interval of a probability; for a mean, as a share of the mean *)
  size : size;
  free : Sample.free;
  normal : bool;  (** means without a known range may be approximated ({!Normal_mean}) *)
}

(** The result for a number. *)
type value =
  | Probability of Rat.t * Rat.t
  | Mean of { mean : Rat.t option; low : Rat.t option; high : Rat.t option }
  (** for a number whose range has an end; [mean] is that over the runs, if each has a number. There is a bound for
      each end of the range. *)
  | Approximate of { mean : Rat.t; low : Rat.t; high : Rat.t }
  (** for a number whose range lacks an end, if that was asked for: not proved ({!Normal_mean}) *)
  | Sample of { mean : Rat.t; deviation : Rat.t option }
  (** for a number without a known range: statistics of the runs, from which nothing follows *)
  | Infinite  (** some runs never reach the event on which the number depends *)
  | Unknown

(** The verdict on a property. *)
type verdict =
  | Estimated  (** the property requests a number *)
  | Sampled  (** the property requests a number of which no range is known *)
  | Holds
  | Violated
  | Undecided

(** The answer to a property. *)
type answer = {
  path : Path.t;
  verdict : verdict;
  value : value;
  tally : Tally.t;
  chosen : bool;  (** choices that are not drawn have been made, uniformly *)
  reasons : string list;  (** why it is undecided, or wider than required *)
  splitting : Splitting.summary option;  (** how it was found, if it was by splitting *)
}

(** An estimation in progress. *)
type t

val start : aim -> Path.t list -> t
(** An estimation of these properties without any runs. *)

val next : t -> int option
(** The total number of runs at which {!judge} is due; [None] if all properties are settled. *)

val add : t -> Sample.run -> unit
(** Adds the next run. A run that was interrupted is left out for a mean without a known range, if it has no
    number; the reasons of the answer say so. *)

val judge : t -> last:bool -> unit
(** Settles the properties that the runs so far decide. [last] is true if there will be no more runs.

    For each question, the answers of all looks together are wrong with at most the probability that the
    confidence leaves. For probabilities, look j, from 1 on, has the share 1/(j (j + 1)) of it; the sum of all
    shares is 1. With {!Exactly} there is one look, which has all of it. The bounds of means hold at all looks by
    themselves ({!Tally.mean}). So each answer is what its look and all earlier ones have in common. *)

val answers : t -> answer list
(** The answers of the properties that are settled. *)

val of_splitting : Path.t -> Splitting.summary -> answer
(** The answer of a splitting. Its tally has the number of repetitions alone. *)
