(** Which model, and with which values of its parameters: what a document about a model says that it is of. *)

open Scc_exact
open Scc_calculus

type t = {
  name : string option;  (** from [model NAME] *)
  digest : string;  (** of the text and of all that was read for it, see {!digest} *)
  parameters : (string * Rat.t) list;  (** with their values, in order *)
  settings : (string * string) list;  (** {!Parameters.listed} *)
}

val digest : text:string -> files:(string * string) list -> string
(** ["md5:…"], the MD5 of the bytes of the model's text and of the mesh files that it reads, each as its
    path as written, its length and its bytes. It tells models apart; it is no defence against somebody
    who wants to deceive. *)

val values :
  recorded:(string * Rat.t) list ->
  overrides:(string * Rat.t) list ->
  narrowed:(string * (Ranges.bound * Ranges.bound)) list ->
  ((string * Rat.t) list * (string * (Ranges.bound * Ranges.bound)) list, string) result
(** The values to run a model with again: those that were recorded, which an override may repeat but not change,
    then the other overrides; and the ranges of what has no value yet. The error is a parameter of which another
    value is recorded than an override gives, or one that is not in the range that it is narrowed to. *)
