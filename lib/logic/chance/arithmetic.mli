(** Kinds of numbers of at least 0 in which means over branches are computed. The branches of one choice have
    integer weights over a common denominator. So a mean is a sum of products by small integers, without a
    greatest common divisor. *)

open Scc_exact

(** Positive integers with their sum: the probability of branch [i] is [weight.(i)] / [sum]. *)
type weights = { weight : Z.t array; sum : Z.t }

val weights : Rat.t array -> weights
(** [weights p] is the probabilities [p], which are positive and have the sum 1, over their least common
    denominator. *)

exception Too_long
(** A number has more bits than allowed. *)

(** One kind of numbers. *)
type 'a t = {
  zero : 'a;
  one : 'a;
  integer : Z.t -> 'a;  (** of at least 0 *)
  mean : weights -> (int -> 'a) -> 'a;
  (** [mean w value] is the sum of [value i] times the probability of branch [i]. It may raise {!Too_long}. *)
  compare : 'a -> 'a -> int;
  to_rat : 'a -> Rat.t;
}

type powers
(** Numbers n / b^e for one integer b. *)

val exact : base:Z.t -> bits:int -> powers t
(** [exact ~base ~bits] is exact numbers whose denominators are powers of [base]. The base is a common multiple of
    the sums of all weights that occur. A number has at most [bits] bits ({!Rat.bits}). *)

val rational : bits:int -> Rat.t t
(** [rational ~bits] is exact numbers in lowest terms, of at most [bits] bits each. *)

(** The end of an interval that is computed. *)
type direction = Down | Up

val rounded : direction -> Z.t t
(** [rounded direction] is multiples of 2^-128. Each mean is rounded down to one, or up, by less than 2^-128. So a
    value that is made by n means differs from the exact one by less than n 2^-128. *)

val nothing : unit t
(** [nothing] has one number. It serves where only the graph of the branches matters. *)
