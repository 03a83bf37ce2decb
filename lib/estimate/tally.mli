(** What was found on many runs of one question. *)

open Scc_exact

type t = {
  runs : int;
  yes : int;
  no : int;
  free : int;  (** it depends on a choice that nothing draws *)
  too_long : int;
  never : int;
  no_value : int;
  why : string option;  (** of the first that has no value *)
  sum : Rat.t;  (** of the numbers *)
  squares : Rat.t;
}

val empty : t
val add : t -> Sample.outcome -> t

val open_ended : t -> int
(** How many leave the question open. *)

val numbers : t -> int

val likelihood : t -> miss:Rat.t -> Rat.t * Rat.t
(** An interval in which the probability is, whatever is chosen where nothing is drawn. That it is not there has at
    most the probability [miss], less than 1: what is open counts for no at its lower end, and for yes at its upper
    one. *)

val mean : t -> z:Rat.t -> (Rat.t * Rat.t * Rat.t) option
(** Of 30 or more numbers the mean, and from where to where it is with z deviations of it to either side. The sum
    is as good as normal where there are many: a rule of thumb, and no proof. *)
