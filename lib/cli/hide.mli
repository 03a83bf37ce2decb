(** Which transitions an export does not show. *)

type pattern

val matches : pattern -> string -> bool
(** The whole text of a label. *)

val patterns : pattern list Cmdliner.Term.t
(** [--hide PATTERN], repeatable: a pattern of {!Scc_equivalence.Label}, or a kind of labels such as [bounce]. *)
