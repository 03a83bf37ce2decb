(** Values for parameters that come from outside of the text ([-D NAME=VALUE]). The parameter of a module has
    several names: its global one, which reports use, and those that the model has for it by its imports. *)

open Scc_base
open Scc_exact
open Scc_calculus

type t

type given =
  | Value of Rat.t
  | Within of Ranges.bound * Ranges.bound  (** a range that the parameter is narrowed to *)

val create : narrowed:(string * (Ranges.bound * Ranges.bound)) list -> (string * Rat.t) list -> t

val given : t -> Report.t -> name:string -> also:string list -> given option
(** For the parameter with this global name and these others, if there is something: it is known from here on. A
    value goes before a range that it is in; of a range that it is not in it is reported (SC0217), and so are two
    different things under two names (SC0209). *)

val value : t -> Report.t -> name:string -> also:string list -> Rat.t option
(** Of a parameter that is a number: {!given}, and a range for it is reported (SC0217). *)

val check : t -> Report.t -> Span.t -> unit
(** When all parameters are known: reports values for parameters that there are not, and names of more than one
    (SC0209), at this place. *)
