(** Where the code says by which rule a transition is made. *)

type t = { rule : string;  (** its id in the rule book *) file : string; line : int }

val find : unit -> t list
(** All constructors of {!Scc_semantics.Rule.t} that expressions of [lib] name. Those of patterns are left out:
    they only ask which it was. *)
