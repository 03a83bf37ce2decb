(** Values for parameters from outside of the text ([-D NAME=VALUE]). The parameter of a module has several
    names: a global one, which reports use, and those of the imports of the model. *)

open Scc_base
open Scc_exact
open Scc_calculus

(** Values and ranges from outside, and the parameters read so far. *)
type t

type given =
  | Value of Rat.t
  | Within of Ranges.bound * Ranges.bound  (** a range that the parameter is narrowed to *)

val create :
  narrowed:(string * (Ranges.bound * Ranges.bound)) list -> ?parametric:Asked.given -> (string * Rat.t) list -> t
(** [create ~narrowed ?parametric values] has these values and ranges, by name, and the parameter of
    [--parametric]. No parameters are known yet. *)

val asked : t -> Asked.t
(** [asked t] is the parameter of [--parametric]. *)

val given : t -> Report.t -> name:string -> also:string list -> given option
(** The value or range for the parameter with this global name and these other names. The parameter is known
    from here on. A value goes before a range that contains it.

    A value outside a range of the same name is SC0217. Different values under two names are SC0209. *)

val value : t -> Report.t -> name:string -> also:string list -> Rat.t option
(** The value for a parameter that is a number, as by {!val-given}. A range for it is an error (SC0217). *)

val check : t -> Report.t -> Span.t -> unit
(** Checks the names after all parameters are known. Names of no parameter, and names of more than one, are
    SC0209 at this place. *)
