(** The identity of a model and of the values of its parameters, for documents about a model. *)

open Scc_exact
open Scc_calculus

type t = {
  name : string option;  (** from [model NAME] *)
  digest : string;  (** of the text and of all files that were read for it, see {!val-digest} *)
  parameters : (string * Rat.t) list;  (** with their values, in order *)
  settings : (string * string) list;  (** {!Scc_calculus.Parameters.listed} *)
}

val digest : text:string -> files:(string * string) list -> string
(** ["md5:…"], the MD5 of the bytes of the model's text and of the mesh files that it reads. Each file counts
    as its path as written, its length and its bytes. It distinguishes models; it does not protect against
    deliberate collisions. *)

val values :
  recorded:(string * Rat.t) list ->
  overrides:(string * Rat.t) list ->
  narrowed:(string * (Ranges.bound * Ranges.bound)) list ->
  ((string * Rat.t) list * (string * (Ranges.bound * Ranges.bound)) list, string) result
(** The values with which to run a recorded model again, and the ranges of parameters that have no value yet.
    The values are the recorded ones, then the other overrides. An override may repeat a recorded value. The
    error is the name of a parameter: its override differs from its recorded value, or that value is outside of
    its narrowed range. *)
