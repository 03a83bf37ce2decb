(** Which model, and with which values of its parameters: what a document about a model says that it is of. *)

open Scc_exact

type t = {
  name : string option;  (** from [model NAME] *)
  digest : string;  (** of the text and of all that was read for it, see {!digest} *)
  parameters : (string * Rat.t) list;  (** with their values, in order *)
  settings : (string * string) list;  (** {!Scc_calculus.Parameters.listed} *)
}

val digest : text:string -> files:(string * string) list -> string
(** ["md5:…"], the MD5 of the bytes of the model's text and of the mesh files that it reads, each as its
    path as written, its length and its bytes. It tells models apart; it is no defence against somebody
    who wants to deceive. *)

val values :
  recorded:(string * Rat.t) list ->
  overrides:(string * Rat.t) list ->
  ((string * Rat.t) list, string) result
(** The values to run a model with again: those that were recorded, which an override may repeat but not change,
    then the other overrides. The error is the first parameter that an override would change. *)
