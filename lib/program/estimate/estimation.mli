(** Properties judged by samples: how many runs are needed, and what they say. No answer is a proof. *)

open Scc_exact

type size =
  | Exactly of int  (** so many runs, no less and no more *)
  | At_most of int  (** as many as are needed for the width, or to decide *)

type aim = {
  confidence : Rat.t;  (** of each answer: less than 1 *)
  width : Rat.t;  (** of the interval of a probability; of that of a mean, as a share of the mean *)
  size : size;
  free : Sample.free;
}

type value =
  | Probability of Rat.t * Rat.t
  | Mean of { mean : Rat.t option; low : Rat.t; high : Rat.t }
  (** of a number that is always in some range; the mean over the runs, if each has come to a number *)
  | Sample of { mean : Rat.t; deviation : Rat.t option }
  (** of a number of which no range is known: what the runs came to, from which nothing follows *)
  | Infinite  (** runs never come to where the number would be known *)
  | Unknown

type verdict =
  | Estimated  (** a number was asked for *)
  | Holds
  | Violated
  | Undecided

type answer = {
  path : Path.t;
  verdict : verdict;
  value : value;
  tally : Tally.t;
  chosen : bool;  (** choices that nothing draws have been taken, evenly *)
  reasons : string list;  (** why it is undecided, or not as narrow as was asked for *)
}

type t

val start : aim -> Path.t list -> t

val next : t -> int option
(** How many runs there should be in all before the next {!judge}; [None]: nothing is open any more. *)

val add : t -> Sample.outcome list * bool -> unit
(** The next run. *)

val judge : t -> last:bool -> unit
(** Looks at what there is. The answers of all looks together are wrong, for one question, with at most the
    probability that the confidence leaves: look j, from 1 on, has the share 1/(j (j + 1)) of it, and all of them
    together 1. With
    {!Exactly} there is one look, which has all. [last]: there will be no more of them. *)

val answers : t -> answer list
