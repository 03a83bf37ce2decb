(** The option that hides transitions. *)

(** A pattern of labels. *)
type pattern

val matches : pattern -> string -> bool
(** [matches p text] is true if the whole text of a label fits the pattern. *)

val pattern : pattern Cmdliner.Arg.conv
(** A pattern of {!Scc_equivalence.Label}, or a kind of labels such as [bounce]. *)

val patterns : ?also:string -> unit -> pattern list Cmdliner.Term.t
(** The option [--hide PATTERN], repeatable. [also] is the last sentence of its manual text. *)
