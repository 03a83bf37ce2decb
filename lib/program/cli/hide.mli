(** Which transitions are not to be seen. *)

type pattern

val matches : pattern -> string -> bool
(** The whole text of a label. *)

val pattern : pattern Cmdliner.Arg.conv
(** A pattern of {!Scc_equivalence.Label}, or a kind of labels such as [bounce]. *)

val patterns : ?also:string -> unit -> pattern list Cmdliner.Term.t
(** [--hide PATTERN], repeatable. [also] ends the text of the manual. *)
