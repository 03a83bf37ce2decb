(** Values for parameters that come from outside of the text ([-D NAME=VALUE]). The parameter of a module has
    several names: its global one, which reports use, and those that the model has for it by its imports. *)

open Scc_base
open Scc_exact

type t

val create : (string * Rat.t) list -> t

val value : t -> Report.t -> name:string -> also:string list -> Rat.t option
(** Of the parameter with this global name and these others, if there is one: it is known from here on. Two
    different values under two names are reported (SC0209). *)

val check : t -> Report.t -> Span.t -> unit
(** When all parameters are known: reports values for parameters that there are not, and names of more than one
    (SC0209), at this place. *)
