(** Numbers of properties as functions of one quantity that may grow without bound. *)

open Scc_exact
open Scc_calculus

(** [rate] times the quantity, and something from [least] to [greatest]. *)
type case = { rate : Rat.t; least : Rat.t; greatest : Rat.t }

val cases : Model.t -> variable:(Property.quantity -> bool) -> Property.num -> case list option
(** What a number may be: one of these at each instant. [None] where there is more to it: another quantity without
    bounds, products of what varies, too many cases. *)

val zeros : case -> (Rat.t * Rat.t) option
(** The least and the greatest value of the quantity at which the number may be 0; [None] where it does not depend
    on the quantity. *)

val conditions : Property.num -> Property.prop list
(** Those within a number, of [count] and [if], but not those within these. *)

val values : Property.num -> Property.quantity list
(** The quantities that it is computed from: all but those within conditions. *)
