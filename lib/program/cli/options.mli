(** The options that several commands share. *)

open Scc_exact
open Cmdliner

val rational : Rat.t Arg.conv
(** A rational number: [3], [1/4], [0.125] or [1e-3]. *)

val not_negative : string -> Rat.t Arg.conv
(** A rational that is at least zero. The text names its kind in messages, such as ["tolerance"]. *)

val positive : string -> Rat.t Arg.conv
(** A rational greater than zero. The text names its kind in messages. *)

val integer : ?least:int -> ?most:int -> string -> int Arg.conv
(** An integer from [least] to [most]. The text describes it in messages. *)

(** {1 Making options}

    The names of an option are without dashes, as in [["j"; "jobs"]]. [docv] is the name of its value in the
    manual, and the last argument is its text there. [docs] is the section of the manual, if it has one of
    its own. *)

val flag : ?docs:string -> string list -> string -> bool Term.t
(** [flag names doc] is an option without a value: true if it is given. *)

val maybe : ?docs:string -> 'a Arg.conv -> string list -> docv:string -> string -> 'a option Term.t
(** [maybe kind names ~docv doc] is an option that may be given once. *)

val default : ?docs:string -> 'a Arg.conv -> 'a -> string list -> docv:string -> string -> 'a Term.t
(** [default kind otherwise names ~docv doc] is an option whose value is [otherwise] if it is not given. *)

val repeated : 'a Arg.conv -> string list -> docv:string -> string -> 'a list Term.t
(** [repeated kind names ~docv doc] is an option that may be given several times: its values in order. *)

val argument : int -> docv:string -> string -> string Term.t
(** [argument index ~docv doc] is the argument at this place, from 0, which is needed. *)

(** {1 Options} *)

val output : ?docv:string -> string -> string option Term.t
(** [output doc] is the option [-o] of a command whose output goes to a file or to standard output. [doc] is its
    text in the manual, and [docv], by default [FILE], the name of its value there. ["-"] stands for standard
    output ({!Console.with_output}). *)

val named : string Arg.conv
(** The path of a file or folder that is written or read beside standard input and output. ["-"] is refused. *)

val transitions : int Arg.conv
(** A number of transitions, at least 0. *)

val processes : int Arg.conv
(** A number of processes, from 1 to 1024. *)

val model_file : string Term.t
(** The argument [MODEL]: the path of a model, or ["-"] for standard input. *)

val override : (string * Rat.t) Arg.conv
(** A value for a parameter: [name=value]. *)

(** Values and ranges for parameters. *)
type definitions = {
  values : (string * Rat.t) list;
  narrowed : (string * (Scc_calculus.Ranges.bound * Scc_calculus.Ranges.bound)) list;
}

val definitions : definitions Term.t
(** The option [-D NAME=VALUE], [-D NAME=1..3] or [-D NAME=\[1,3)], for commands that take models with
    ranges. *)

val overrides : (string * Rat.t) list Term.t
(** The option [-D NAME=VALUE], repeatable. *)

val color : Console.color Term.t
(** The option [--color]. *)

val progress : (phase:bool -> string -> unit) option Term.t
(** The flag [--progress]: the function that writes lines of progress, for {!Console.make}. *)

val json : bool Term.t
(** The flag [--json]. *)

val full : string -> bool Term.t
(** The flag [--full], with its meaning for the command. *)
