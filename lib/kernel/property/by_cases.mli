(** Numbers of properties as functions of up to three quantities that may grow without bound, affine in them. *)

open Scc_exact
open Scc_calculus

type case = { rate : Vec.t; least : Rat.t; greatest : Rat.t }
(** The quantities, each times the component of [rate] that is its own, and something from [least] to [greatest].
*)

val cases : Model.t -> variable:(Property.quantity -> Vec.t option) -> Property.num -> case list option
(** What a number may be: one of these at each instant. [variable] tells the rate of one of the quantities: 1 along
    its own axis. [None] where there is more to it: another quantity without bounds, products of what varies, too
    many cases. *)

val zeros : case -> (Vec.t * (Rat.t * Rat.t)) option
(** A multiple of the rate, of which the first component that is not 0 is 1, and the least and the greatest value
    of the quantities, so combined, at which the number may be 0; [None] where it does not depend on them. *)

val conditions : Property.num -> Property.prop list
(** Those within a number, of [count] and [if], but not those within these. *)

val values : Property.num -> Property.quantity list
(** The quantities that it is computed from: all but those within conditions. *)
