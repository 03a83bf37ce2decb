(** Numbers of properties as functions of up to three quantities that may grow without bound, affine in them. *)

open Scc_exact
open Scc_calculus

type case = { rate : Vec.t; least : Rat.t; greatest : Rat.t }
(** The scalar product of [rate] with the three quantities, plus some number from [least] to [greatest]. *)

val cases : Model.t -> variable:(Property.quantity -> Vec.t option) -> Property.num -> case list option
(** [cases m ~variable n] is what [n] may be: one of these cases at each instant. [variable q] is the rate of the
    quantity [q], for example 1 along its own axis; [None] for all others. The result is [None] if there are more
    than 64 cases, or if [n] contains one of these:
    - another quantity without bounds;
    - a product of two numbers that vary;
    - a quotient by a number that varies, or by 0. *)

val zeros : case -> (Vec.t * (Rat.t * Rat.t)) option
(** [zeros c] is where [c] may be 0: [(n, (low, high))] if it needs a scalar product of [n] with the quantities
    from [low] to [high]. [n] is the multiple of the rate with first component 1 among those that are not 0. The
    result is [None] if the rate is 0. *)

val conditions : Property.num -> Property.prop list
(** The predicates of [count] and [if] within a number, in order. Predicates inside of these are not listed. *)

val values : Property.num -> Property.quantity list
(** The quantities that a number is computed from, in order: all except those within its {!conditions}. *)
