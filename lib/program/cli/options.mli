(** The options that several commands share. *)

open Scc_exact
open Cmdliner

val rational : Rat.t Arg.conv

val not_negative : string -> Rat.t Arg.conv
(** The text tells what a negative number is not: ["tolerance"]. *)

val positive : string -> Rat.t Arg.conv

val integer : ?least:int -> ?most:int -> string -> int Arg.conv
(** From [least] to [most]; the text tells what anything else is not one of. *)

val transitions : int Arg.conv
(** A number of them. *)

val model_file : string Term.t
val override : (string * Rat.t) Arg.conv
(** [name=value]. *)

(** Values and ranges for parameters. *)
type definitions = {
  values : (string * Rat.t) list;
  narrowed : (string * (Scc_calculus.Ranges.bound * Scc_calculus.Ranges.bound)) list;
}

val definitions : definitions Term.t
(** [-D NAME=VALUE], [-D NAME=1..3], [-D NAME=\[1,3)]: for commands that take models with ranges. *)

val overrides : (string * Rat.t) list Term.t
val color : Console.color Term.t
val json : bool Term.t

val full : string -> bool Term.t
(** [--full], with what it means for the command. *)

val sdocs : string
(** The section of the manual for {!color}. *)

val diagnostics_man : Manpage.block list
(** What the manual of every command says about diagnostics and files. *)
