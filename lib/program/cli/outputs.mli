(** The files that a command is asked to write, and whether two of them, or one of them and a file that the command
    reads, are one file. *)

type output

type t
(** The outputs of a command. *)

val none : t
(** No files. *)

val file : ?over:string option -> string -> string option -> output list
(** [file option path] is the output that [option] ([-o]) asks for. It is none without a path, and for ["-"]. It
    may replace the input [over], if that is the same file and their names have the same ending: this is a rewrite
    in place. *)

val folder : string -> string option -> output list
(** [folder option path] is a folder that [option] asks for, in which the command writes files. *)

val store : string option -> output list
(** [store path] is the folder of [--store]. All files in it are those of the store. It is no output that is
    written beside others: it has what was done, whenever a command ends. *)

val add : t -> output list -> (t, string) result
(** [add t outputs] are the outputs of a command with further ones. If two of them are one file, or one of them is
    in the store, the result is a sentence that says so. Paths are one file if they lead to one, by links of either
    kind, whether or not it is there. Devices and pipes are no files in this sense. *)

val some : t -> bool
(** [some t] is true if there are outputs, but for a store. *)

val others : t -> string -> bool
(** [others t path] is true if there are outputs besides that with this path and a store. *)

val refusal : t -> string -> string option
(** [refusal t path] is the sentence that an output would overwrite the input [path], or is nothing. *)
