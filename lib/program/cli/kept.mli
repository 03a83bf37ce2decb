(** Stores of commands: what they are of, and how they are spoken of. *)

open Scc_base
open Scc_store

val identity :
  digest:string -> parameters:(string * Scc_exact.Rat.t) list -> (string * string) list -> (string * string) list
(** Of this build, of a model with this digest and these values of parameters, and of what else it depends on, by
    names and values ({!Store.openly}). *)

val openly : Console.t -> folder:string -> (string * string) list -> (Store.t, Diag.t list) result
(** With an identity. When something cannot be kept any more, a warning (SC0103) tells so at once, on standard
    error also where all else is told in a document. *)

val code : Diag.t list -> Scc_session.Exit_code.t list
(** Of what went wrong with a store, at the end. *)

val conclude : Console.t -> Diag.t list -> unit
(** Tells of it, like the warning. *)

val option : doc:string -> string option Cmdliner.Term.t
(** [--store DIR]. *)

val man : Cmdliner.Manpage.block list
(** Of commands that keep runs, or points: what a store is. *)
